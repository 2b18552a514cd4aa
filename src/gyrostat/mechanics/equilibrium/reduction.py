"""Reduces a body of revolution in U(k3) to one degree of freedom: k3 moves by itself, I1² k̇3² = g(k3)."""
from dataclasses import dataclass
from functools import lru_cache

from sympy import Expr, S

from ..._display import Shown
from ...algebra.reals.exact import is_identically_zero
from ...algebra.rings.polynomials import derivatives, lowest_terms
from ...algebra.text.numbers import exact_expression
from ...arguments import checked
from ...errors import ScopeError, StructureError
from ...notation import Stored, symbol
from ..scenes.coupled import in_one_direction
from ..scenes.kind import Kind
from ..scenes.system import System

K3, ENERGY, V, P = symbol("k3"), symbol("energy"), symbol("p_phi"), symbol("p_psi")
OMEGA = symbol("omega")


@dataclass(frozen=True, repr=False)
class Reduction(Shown, Stored):
    """The motion of z = k3 on a level of the integrals.

    I1² ż² = g(z) = 2 I1 (e − U(z)) (1 − z²) − (v − P z)².

    The levels are symbols: energy is that of h, p_phi = v that of C1, p_psi = P that of π3 + l, and
    e = energy − π3²/(2 I3).

    Parameters
    ----------
    system : System
    axial : Expr
        π3²/(2 I3), so that π1² + π2² = 2 I1 (energy − axial − U)
    across : Expr
        k1² + k2² = 1 − z²
    twist : Expr
        π1 k1 + π2 k2 = v − P z

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> gs.mechanics.reduce(top).rate
    (-k3*p_psi + p_phi)/(I1*(1 - k3**2))
    """

    system: System
    axial: Expr
    across: Expr
    twist: Expr

    @checked
    def square(self, U: Expr | float | str | None = None) -> Expr:
        """Return g = I1² k̇3², a function of k3 and the levels.

        Parameters
        ----------
        U : Expr, str or None
            in place of the scene's potential [M L²/T²]

        Returns
        -------
        Expr
            [M² L⁴/T²]
        """
        twice = 2 * self.system.body.moments[0] * (ENERGY - self.axial - self._field(U))
        return twice * self.across - self.twist**2

    def effective_potential(self) -> Expr:
        """Return V(k3) with g = 2 I1 (1 − k3²) (energy − V).

        Its critical points are the regular precessions. With k3 = cos θ it is
        gyrostat.mechanics.effective_potential, which comes from the Lagrangian.

        Returns
        -------
        Expr
            [M L²/T²]

        Examples
        --------
        >>> import gyrostat as gs
        >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
        >>> V = gs.mechanics.reduce(top).effective_potential()
        >>> for term in V.as_ordered_terms():
        ...     print(term)
        k3*m0
        (-l + p_psi)**2/(2*I3)
        (-k3*p_psi + p_phi)**2/(2*I1*(1 - k3**2))
        """
        return self.axial + self._field(None) + self.twist * self.rate / 2

    @property
    def rate(self) -> Expr:
        """The rate about the vertical on a level, (v − P k3)/(I1 (1 − k3²)) [1/T]."""
        return self.twist / (self.system.body.moments[0] * self.across)

    def precession(self) -> Expr:
        """Return what vanishes for the regular precessions ω = W k + σ e3, U' − P W + I1 k3 W².

        W is the symbol omega, U' is dU. It is the slope of the effective potential. At σ = 0, P = I3 W k3 +
        l, it is the relation of E3.

        Returns
        -------
        Expr
            [M L²/T²]

        Examples
        --------
        >>> import gyrostat as gs
        >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
        >>> gs.mechanics.reduce(top).precession()
        I1*k3*omega**2 + dU - omega*p_psi
        """
        return symbol("dU") + self._at_rate(derivatives(self.twist * self.rate / 2, [K3])[0])

    def restoring(self) -> Expr:
        """Return I1 (1 − k3²) V'' = −g''/2 on the regular precessions, with d2U for U''.

        It is positive where they are stable.

        Returns
        -------
        Expr
            [M² L⁴/T²]

        Examples
        --------
        >>> import gyrostat as gs
        >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
        >>> whole = gs.mechanics.reduce(top).restoring()
        >>> for term in whole.as_ordered_terms():
        ...     print(term)
        3*I1**2*k3**2*omega**2
        I1**2*omega**2
        -I1*d2U*k3**2
        I1*d2U
        -4*I1*k3*omega*p_psi
        p_psi**2
        """
        return self._at_rate(self.system.body.moments[0] * self.across
                             * (symbol("d2U") + (self.twist * self.rate / 2).diff(K3, 2)))

    def _at_rate(self, expression: Expr) -> Expr:
        """Express the level v by the rate omega, and return the expression in lowest terms."""
        level = self.system.body.moments[0] * OMEGA * self.across + V - self.twist
        return lowest_terms(expression.xreplace({V: level}))

    def _field(self, U: Expr | float | str | None) -> Expr:
        potential = self.system.potential
        if U is None:
            return S.Zero if potential is None else potential.expression
        return U if isinstance(U, Expr) else exact_expression(U, "U")


@checked
@lru_cache(maxsize=64)
def reduce(scene: System) -> Reduction:
    """Return the reduced motion, from the bracket and the integrals.

    It rests on I1² {k3, h}² = (k1² + k2²)(π1² + π2²) − (π1 k1 + π2 k2)².

    Parameters
    ----------
    scene : System
        a body of revolution in U(k3)

    Returns
    -------
    Reduction

    Raises
    ------
    ScopeError
        the body is not of revolution, or U is not U(k3)
    StructureError
        the identity does not hold

    References
    ----------
    Goldstein, Classical Mechanics, §5.7; for any U, Marsden & Ratiu, Introduction to Mechanics and Symmetry,
    §15.10; derived in docs/explanation/derivations/boundaries.md, section 1.

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
    >>> gs.mechanics.reduce(top).twist
    -k3*p_psi + p_phi
    """
    in_one_direction(scene.potential, "reduce")
    if scene.kind is not Kind.REVOLUTION:
        raise ScopeError("k3 moves by itself only for a body of revolution in U(k3); this scene has "
                         f"inertia {scene.body.moments}, l = "
                         f"{scene.body.gyrostatic_momentum}, U = "
                         f"{scene.potential and scene.potential.expression}: use vector_field()")
    names = {s for e in (*scene.body.moments, scene.body.gyrostatic_momentum[2]) for s in e.free_symbols}
    if taken := sorted(s.name for s in names & {ENERGY, V, P, OMEGA}):
        raise ScopeError(f"the body depends on {', '.join(taken)}, a name of the reduced motion: rename it")
    pi1, pi2, pi3, k1, k2, _ = scene.space.coordinates
    kinetic, (c1, c2) = scene.body.kinetic_energy(scene.space.coordinates[:3]), scene.space.casimirs
    plane = {pi1: S.Zero, pi2: S.Zero, k1: S.Zero, k2: S.Zero}
    axial, aligned = kinetic.xreplace(plane), c1.xreplace(plane)       # π3²/(2 I3) and (π3 + l) k3
    I1, across = scene.body.moments[0], c2 - K3**2
    rate = I1 * scene.space.bracket(K3, kinetic)
    residual = rate**2 - across * 2 * I1 * (kinetic - axial) + (c1 - aligned) ** 2
    if is_identically_zero(residual) is False:
        raise StructureError(f"I1 dk3/dt = {rate} is not a function of k3 and the integrals")
    spin = {pi3: P - scene.body.gyrostatic_momentum[2]}
    return Reduction(scene, axial.xreplace(spin), across - c2 + 1, V - aligned.xreplace(spin))
