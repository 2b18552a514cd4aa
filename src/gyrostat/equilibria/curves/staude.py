"""Staude's cone: the directions about which a body in a field turns permanently."""
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from sympy import Expr, Matrix, S

from ..._cached import cached_property
from ..._display import Shown
from ...algebra.reals.exact import is_identically_zero
from ...algebra.rings.matrices import cross
from ...arguments import checked
from ...errors import ScopeError, ValuesError
from ...mechanics.equilibrium.recognition import recognise
from ...mechanics.scenes.coupled import in_one_direction
from ...mechanics.scenes.system import System, at_numbers, names_of_scene
from ...notation import Stored
from ...stability.criteria.amended_form import dot
from ..finders.heavy_polynomials import DIRECTION
from ..finders.rate_level_tilt import exact_point
from .arc import Arc
from .cone_curves import cone_curves, uniform
from .rate_curves import rate_curves


@dataclass(frozen=True, repr=False)
class StaudeCone(Shown, Stored):
    """The directions of the permanent rotations of a body in a field, as the zeros of a polynomial.

    Parameters
    ----------
    scene : System

    Examples
    --------
    >>> import gyrostat as gs
    >>> body, m0 = gs.Gyrostat((1, 2, 3), (0, 0, 0)), gs.symbol("m0")
    >>> field = gs.general_potential(lambda k1, k2, k3: m0 * k3)
    >>> print(gs.staude_cone(gs.assemble(body, field)))
    Permanent rotations are about the directions k, |k| = 1, with:
    −m₀ k₁ k₂ = 0
    The rate, which is admissible if its square is positive, is:
    ω² = m₀ k₃ (2 k₁² + k₂²)/(k₁² k₂² + 4 k₁² k₃² + k₂² k₃²)
    """

    scene: System

    @cached_property
    def polynomial(self) -> Expr:
        """The polynomial that is 0 if k is the direction of a permanent rotation, with exceptions.

        It is [k, ∇U, Ik] without a rotor; with one [k, Ik, ∇U]² − [k, Ik, l] [k, ∇U, l], on abs(k) = 1.
        """
        along, rotor, slopes = self._vectors
        if not self.turned:
            return _triple(slopes, along).expand()
        self._refuse_sphere()
        a, b, d = (_triple(*pair).expand() for pair in ((along, slopes), (along, rotor), (slopes, rotor)))
        return a**2 - b * d

    @cached_property
    def rate(self) -> Expr:
        """The rate: omega² without a rotor, admissible if it is positive; with one omega [1/T², 1/T]."""
        along, rotor, slopes = self._vectors
        if self.turned:
            self._refuse_sphere()
            return _triple(along, slopes) / _triple(along, rotor)
        lever = cross(along, DIRECTION)
        return dot(cross(slopes, DIRECTION), lever) / dot(lever, lever)

    def _refuse_sphere(self) -> None:
        """Refuse equal moments: then Ik is along k, and the polynomial is 0 for every k."""
        if all(is_identically_zero(x.expand()) for x in cross(self._vectors[0], DIRECTION)):
            raise ScopeError("all moments are equal, and the polynomial of the curve is 0 for every k: ask "
                             "for arcs, or use relative_equilibria at a rate omega; k is the axis of a "
                             "rotation if omega l − ∇U is along k")

    @property
    def turned(self) -> bool:
        """Whether there is a rotor: the cone is then a curve on the sphere."""
        return any(self.scene.body.gyrostatic_momentum)

    @cached_property
    def _vectors(self) -> tuple[list[Expr], Sequence[Expr], list[Expr]]:
        """The vectors Ik, l and ∇U."""
        U = self.scene.potential
        assert U is not None
        slopes = [U.value(d) if U.given and d else d for d in map(S, U.gradient())]
        body = self.scene.body
        return (body.tensor * Matrix(DIRECTION)).flat(), body.gyrostatic_momentum, slopes

    @checked
    def arcs(self, values: Mapping[str, Any]) -> list[Arc]:
        """Return every admissible arc.

        Without a rotor they come in the order of tau, and on each both omega and −omega are rates. With one
        they are over omega, in the order in which they end: from where two rotations become one to the next
        such rate, or to omega → ±∞.

        Parameters
        ----------
        values : mapping of name to number
            for every name of the scene

        Returns
        -------
        list of Arc
            complete; if c, and l, are on a principal axis, that axis is the direction of two of them, of
            every rate

        Raises
        ------
        ScopeError
            U is not c·k, or the body is one of revolution in its field; with a rotor, a number is not
            rational
        ValuesError
            a name is missing or unknown, or a number is not admissible
        """
        needed = {s.name for s in names_of_scene(self.scene)}
        numbers = exact_point(self.scene, values, needed)
        if missing := sorted(needed - values.keys()):
            raise ValuesError(f"the scene needs {', '.join(missing)}: give a number for each")
        here = at_numbers(self.scene, numbers)
        c = uniform(here)
        if not any(c):
            raise ScopeError("U does not depend on k: the body is free; assemble it without a potential, and "
                             "relative_equilibria finds its permanent rotations")
        turned = StaudeCone(here).turned
        if recognise(here):
            rotor = f", l = {here.body.gyrostatic_momentum}" if turned else ""
            raise ScopeError(f"c = {c}{rotor}: the body is one of revolution "
                             "in its field, and the axes of its permanent rotations form whole circles: "
                             "use relative_equilibria")
        return [Arc(*found) for found in (rate_curves(here, c) if turned else cone_curves(here, c))]


@checked
def staude_cone(scene: System) -> StaudeCone:
    """Return the cone of the permanent rotations of a body in a field; with a rotor, a curve on the sphere.

    In a uniform field, U = c·k, without a rotor it is (I2 − I3) c1 k2 k3 + (I3 − I1) c2 k3 k1 + (I1 − I2) c3
    k1 k2 = 0. It contains the principal axes, c and I⁻¹ c. One of k and −k is admissible, that with omega² >
    0.

    Parameters
    ----------
    scene : System
        any body in a field, in symbols or numbers

    Returns
    -------
    StaudeCone

    Raises
    ------
    ScopeError
        there is no field

    References
    ----------
    Staude, J. reine angew. Math. 113 (1894) 318-334; Kharlamov (1965), for gyrostats; derived in
    docs/explanation/derivations/amended-potential.md, section 7.

    Examples
    --------
    >>> import gyrostat as gs
    >>> U = gs.general_potential(lambda k1, k2, k3: k1 + k2 + k3)
    >>> scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)), U)
    >>> cone = gs.staude_cone(scene)
    >>> cone.polynomial
    -k1*k2 + 2*k1*k3 - k2*k3
    >>> [(arc.low, arc.high) for arc in cone.arcs({})]
    [(-oo, -3), (-3, -2), (-2, -1), (-1, oo)]
    """
    in_one_direction(scene.potential, "staude_cone")
    if scene.potential is None:
        raise ScopeError("Staude's cone belongs to a body in a field, and the scene has none: give a "
                         "potential; for a free body relative_equilibria finds every permanent rotation")
    return StaudeCone(scene)


def _triple(a: Sequence[Expr], b: Sequence[Expr]) -> Expr:
    """Return the triple product [k, a, b]."""
    return dot(DIRECTION, cross(a, b))
