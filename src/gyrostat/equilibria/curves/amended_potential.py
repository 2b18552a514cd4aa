"""The amended potential on a level of C1, whose critical points are the permanent rotations."""
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from sympy import Expr, Matrix

from ..._cached import cached_property
from ..._display import Shown
from ...algebra.reals.exact import evaluate
from ...arguments import checked
from ...errors import ScopeError, ValuesError
from ...mechanics.equilibrium.recognition import recognise
from ...mechanics.scenes.coupled import in_one_direction
from ...mechanics.scenes.kind import Kind
from ...mechanics.scenes.potential import DIRECTIONS
from ...mechanics.scenes.system import System, at_numbers, names_of_scene
from ...notation import Stored
from ..finders.heavy import heavy_forms
from ..finders.rate_level_tilt import C1, exact_point, refuse_as_level
from ..relative_equilibrium import RelativeEquilibrium


@dataclass(frozen=True, repr=False)
class CriticalPoint(Shown, Stored):
    """A critical point of the amended potential: a permanent rotation on the level of C1.

    Parameters
    ----------
    rotation : RelativeEquilibrium

    Examples
    --------
    >>> import gyrostat as gs
    >>> U = gs.general_potential(lambda k1, k2, k3: k1 + 2 * k2 + 2 * k3)
    >>> scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)), U)
    >>> for point in gs.amended_potential(scene).critical_points({"C1": 0}):
    ...     print(point)
    maximum of U_c = 3 at k = (1/3, 2/3, 2/3), ω = 0: unstable
    minimum of U_c = −3 at k = (−1/3, −2/3, −2/3), ω = 0: stable
    """

    rotation: RelativeEquilibrium

    @cached_property
    def kind(self) -> str:
        """The kind: minimum, saddle or maximum; degenerate if the second variation is."""
        trace, determinant = self.rotation.form.signs
        if not determinant:
            return "degenerate"
        return "saddle" if determinant == -1 else "minimum" if trace == 1 else "maximum"

    @cached_property
    def value(self) -> Expr:
        """The value of U_c there, exact [M L²/T²]: U + omega² k·Ik/2."""
        scene, k = self.rotation.scene, Matrix(self.rotation.directions[0])
        assert scene.potential is not None
        U = evaluate(scene.potential.expression, dict(zip(DIRECTIONS, k)))
        return evaluate(U + self.rotation.rates["omega"]**2 * k.dot(scene.body.tensor * k) / 2, {})


@dataclass(frozen=True, repr=False)
class AmendedPotential(Shown, Stored):
    """The amended potential U_c(k) = U + (C1 − l·k)²/(2 k·Ik) on abs(k) = 1, of a body in a field.

    Parameters
    ----------
    scene : System

    Examples
    --------
    >>> import gyrostat as gs
    >>> moments = tuple(map(gs.symbol, ("I1", "I2", "I3")))
    >>> body = gs.Gyrostat(moments, (0, 0, gs.symbol("l")))
    >>> scene = gs.assemble(body, gs.uniform_field())
    >>> print(gs.amended_potential(scene))
    U_c = (l k₃ − C₁)²/(2 (I₁ k₁² + I₂ k₂² + I₃ k₃²)) + m₀ k₃
    """

    scene: System

    @cached_property
    def expression(self) -> Expr:
        """The expression in k1, k2, k3 and C1 [M L²/T²]."""
        refuse_as_level(self.scene, C1.name)
        U, body, k = self.scene.potential, self.scene.body, Matrix(DIRECTIONS)
        assert U is not None
        twist = C1 - k.dot(Matrix(body.gyrostatic_momentum))
        return U.expression + twist**2 / (2 * k.dot(body.tensor * k).expand())

    @checked
    def critical_points(self, values: Mapping[str, Any]) -> list[CriticalPoint]:
        """Return all critical points on a level of C1, in the order of k3.

        If none is degenerate, minima − saddles + maxima = 2 (Poincaré-Hopf on the sphere).

        Parameters
        ----------
        values : mapping of name to number
            rational, for every name of the scene, and C1

        Returns
        -------
        list of CriticalPoint

        Raises
        ------
        ScopeError
            a body of revolution in a field along its axis: they are on circles; else as relative_equilibria
        ValuesError
            C1 or a name of the scene is missing, or a name is unknown

        Examples
        --------
        >>> import gyrostat as gs
        >>> U = gs.general_potential(lambda k1, k2, k3: k1 + k2 + k3)
        >>> scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 1)), U)
        >>> points = gs.amended_potential(scene).critical_points({"C1": 5})
        >>> [point.kind for point in points]
        ['minimum', 'maximum', 'maximum', 'saddle', 'saddle', 'minimum']
        """
        refuse_as_level(self.scene, C1.name)
        known = {s.name for s in names_of_scene(self.scene)}
        numbers = exact_point(self.scene, values, known | {C1.name})
        if C1 not in numbers:
            raise ValuesError(f"given were {', '.join(sorted(values)) or 'no numbers'}, and the amended "
                              "potential depends on the level of C1 = M·k: give C1")
        if self.scene.kind is Kind.REVOLUTION or recognise(at_numbers(self.scene, numbers)):
            raise ScopeError("the scene is a body of revolution in a field along its axis, so that the "
                             "critical points are on circles: use relative_equilibria with C1 and the "
                             "momentum about the axis, or reduce")
        return [CriticalPoint(RelativeEquilibrium(form)) for form in heavy_forms(self.scene, values)]


@checked
def amended_potential(scene: System) -> AmendedPotential:
    """Return the amended potential U_c(k) = U + (C1 − l·k)²/(2 k·Ik) on abs(k) = 1, with C1 = M·k.

    Its critical points are the permanent rotations ω = omega k with omega = (C1 − l·k)/(k·Ik). At a minimum
    the rotation is stable, at a saddle unstable; at a maximum only gyroscopic forces can stabilise it.

    Parameters
    ----------
    scene : System
        any body in a field, in symbols or numbers

    Returns
    -------
    AmendedPotential

    Raises
    ------
    ScopeError
        the scene has no field

    References
    ----------
    Simo, Lewis & Marsden, Arch. Rational Mech. Anal. 115 (1991) 15-59; derived in
    docs/explanation/derivations/amended-potential.md, sections 1 to 5.

    Examples
    --------
    >>> import gyrostat as gs
    >>> U = gs.general_potential(lambda k1, k2, k3: k1)
    >>> scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 1)), U)
    >>> gs.amended_potential(scene).expression
    k1 + (C1 - k3)**2/(2*k1**2 + 4*k2**2 + 6*k3**2)
    """
    in_one_direction(scene.potential, "amended_potential")
    if scene.potential is None:
        raise ScopeError("the scene has no field, and so no vertical: give a potential; the rotations of a "
                         "free body lie on spheres of M, and relative_equilibria finds them with M")
    return AmendedPotential(scene)
