"""Tells whether a tilted equilibrium is stable as a point, not only modulo the spin.

It is not if relative equilibria near it drift along its orbit under the spin (Patrick). How fast they do is
derived, and whether the linearised field shows it by a Jordan block.
"""
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import chain

from sympy import Add, Expr, Mul, Rational, S, Symbol

from ..._cached import cached_property
from ..._display import Shown
from ...algebra.reals.exact import evaluate, sign, sign_of_constant
from ...algebra.reals.number_matrices import NotProvedError, matrices_of, rank
from ...algebra.rings.matrices import multiply
from ...algebra.rings.polynomials import Ring, cancel, derivatives, lowest_terms
from ...algebra.solving.margins import Signs
from ...mechanics.equilibrium.coadjoint_orbit import regular_differentials
from ...mechanics.equilibrium.derivation_ring import rows_at_point
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.equilibrium.reduction import reduce
from ...notation import Stored, symbol
from ..criteria.linearization import Linearization, linearize
from ..criteria.numbers_asked import left_open, names_in
from ..decision import Decision, Rung, settled, undecided

K3, OMEGA, DU, P = symbol("k3"), symbol("omega"), symbol("dU"), symbol("p_psi")
SHORT = 12                                             # characters of a fraction that is written whole


@dataclass(frozen=True, repr=False)
class Drift(Shown, Stored):
    """Why a tilted equilibrium is not Lyapunov stable as a point, even if it is stable modulo the spin.

    Near it are regular precessions ω = W k + σ e3 with σ ≠ 0: they turn about the axis of the body at the
    constant rate −σ, and leave the point, however close to it they start. The only exception is I1 = I3, l =
    0, U constant near k3, and ω ≠ 0.

    Parameters
    ----------
    equilibrium : Equilibrium
        tilted, of a body of revolution in U(k3)

    References
    ----------
    Derived in docs/explanation/derivations/boundaries.md, section 4.
    """

    equilibrium: Equilibrium

    @cached_property
    def omega(self) -> Expr:
        """The rate about the vertical, ω·k [1/T]."""
        eq = self.equilibrium
        pi, k = eq.point[:3], eq.point[3:]
        return lowest_terms(Add(*(p / moment * x for p, moment, x in zip(pi, eq.system.body.moments, k))))

    @cached_property
    def rates(self) -> tuple[Expr, Expr]:
        """The derivatives (∂σ/∂k3, ∂σ/∂ω) of the precessions near the point, σ = 0 at it [1/T, 1].

        They are those of the implicit function by the relation of a precession, affine in π3 + l = I3 (ω k3 +
        σ) + l. If ω = 0, any σ goes with ω = 0.

        Examples
        --------
        >>> import gyrostat as gs
        >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
        >>> Drift(gs.inclined(top)).rates[0]
        (I1*omega**2 - I3*omega**2 + d2U)/(I3*omega)
        """
        scene = self.equilibrium.system
        # the relation is affine in P = π3 + l, which is I3 ω k3 + l at the point
        relation, moment = reduce(scene).precession(), scene.body.moments[2]
        along, curved, across, slope = derivatives(relation, (K3, DU, OMEGA, P))
        here = {P: moment * OMEGA * K3 + scene.body.gyrostatic_momentum[2]}
        rates = (-(along + curved * symbol("d2U")) / (slope * moment) - OMEGA,
                 -across / (slope * moment) - K3)
        return self._here(rates[0].xreplace(here)), self._here(rates[1].xreplace(here))

    @cached_property
    def defect(self) -> Expr:
        """The polynomial D, which is 0 if the zero eigenvalue of the linearised field is semisimple.

        It is the common factor of the entries of J³ + p J, for p ≠ 0. As the characteristic polynomial is λ²
        (λ² + p), that matrix is a multiple of X (∇π3)ᵀ, X the field of the spin: 0 if and only if the
        eigenvalue 0 has no Jordan block. Neither X nor the differential of π3 vanishes at a tilt.

        Examples
        --------
        >>> import gyrostat as gs
        >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
        >>> Drift(gs.static_tilt(top)).defect
        -I1*d2U*k3**2 + I1*d2U + I3*d2U*k3**2 + l**2
        """
        eq = self.equilibrium
        matrix = [[eq.insert(entry) for entry in row] for row in self._linearization.matrix.tolist()]
        ring = Ring([*(entry for row in matrix for entry in row), self._p, *eq.existence()])
        (J, below), (p, under) = ring.matrix(matrix), ring.fraction(self._p)
        # J³ + p J = (under J³ + p below² J)/(under below³)
        cube = multiply(ring, multiply(ring, J, J), J)
        common = ring.zero
        for x, y in zip(chain(*cube), chain(*J)):
            common = common.gcd(ring.reduce(under * x + p * below**2 * y))
        common, _ = cancel(common, under * below**3)
        margin, even = Signs(ring, eq.existence()).split(common, ring.one)
        # its sign has no meaning: the one is chosen in which coefficients of squares have a positive sum
        if sum(c for exponents, c in margin.to_dict().items() if not any(e % 2 for e in exponents)) < 0:
            margin = -margin
        return Mul(*map(ring.expression, (margin, *even)))

    @cached_property
    def _linearization(self) -> Linearization:
        return linearize(self.equilibrium)

    @cached_property
    def _p(self) -> Expr:
        return self.equilibrium.insert(self._linearization.coefficients[0])

    def decide(self, numbers: Mapping[Symbol, Expr], margins: dict[Expr, Expr]) -> Decision:
        """Return the decision about the point, which is stable modulo the spin.

        It is stable only in the exceptional case.
        """
        body = self.equilibrium.system.body
        wanted = names_in([self.defect, self._p, self.omega, *(self.rates if self.omega else ())])
        if missing := left_open(wanted, numbers):
            return undecided(f"give {', '.join(missing)} to decide")
        linear = self._linear(numbers, margins)
        turning = "relative equilibria near it turn about the axis of the body"
        if (moving := sign(self.omega, numbers)) == 0:
            return settled(False, f"{turning}, at any rate σ; {linear}", Rung.DRIFT)
        slopes = [evaluate(rate, numbers) for rate in self.rates]
        if any(sign_of_constant(slope) for slope in slopes):
            rates = ", ".join(map(_said, ("∂σ/∂k3", "∂σ/∂ω"), slopes))
            return settled(False, f"{turning}, at the rate σ with {rates}; {linear}", Rung.DRIFT)
        known = {**numbers, **{name: evaluate(value, numbers)
                               for name, value in self.equilibrium.relations if name not in numbers}}
        special = [body.moments[0] - body.moments[2], body.gyrostatic_momentum[2]]
        signs = [sign(e, known) if e.free_symbols <= known.keys() else None
                 for e in special]
        if any(signs):
            return settled(False, f"{turning}, at a rate σ of second order; {linear}", Rung.DRIFT)
        constant = None if None in signs else self._constant(known)
        if constant is None or constant and moving is None:
            return undecided(f"whether {turning} depends on U near k3; {linear}")
        if constant:
            return settled(True, "I1 = I3, l = 0 and U is constant: ω and M are fixed in space, and nothing "
                           "drifts", Rung.NO_TORQUE)
        return settled(False, f"{turning}, at a rate σ of higher order; {linear}", Rung.DRIFT)

    def _constant(self, known: Mapping[Symbol, Expr]) -> bool | None:
        """Tell whether U is constant at the values of its parameters, None if that is not proved."""
        potential = self.equilibrium.system.potential
        if not potential or not potential.given or any(s not in known for s in potential.parameters):
            return None
        slope = potential.value(DU).xreplace({s: known[s] for s in potential.parameters})
        if not Ring([slope]).numerator(slope):
            return True
        places = (Rational(n, 7) for n in range(-6, 7))
        return False if any(sign_of_constant(slope.xreplace({K3: place})) for place in places) else None

    def _linear(self, numbers: Mapping[Symbol, Expr], margins: dict[Expr, Expr]) -> str:
        margins[self.defect] = evaluate(self.defect, numbers)
        signs = [sign_of_constant(x) for x in (margins[self.defect], evaluate(self._p, numbers))]
        here = _said("D", margins[self.defect])
        if signs[1] == 0 or signs[0]:                      # p = 0: J is nilpotent and not 0
            return f"it is linearly unstable, because the eigenvalue 0 has a Jordan block ({here})"
        if None in signs:
            return f"whether it is linearly stable is not proved ({here})"
        return f"it is linearly stable, because the eigenvalue 0 is semisimple ({here})"

    def _here(self, expression: Expr) -> Expr:
        eq = self.equilibrium
        placed = expression.xreplace({K3: eq.at, OMEGA: self.omega})
        for name, value in eq.relations:
            if name == DU:
                placed = placed.xreplace({name: value})
        return lowest_terms(eq.insert(placed))


def _said(name: str, value: Expr) -> str:
    """Say what a number is: = and the number if it is a short fraction, otherwise ≈ and four digits."""
    if isinstance(value, Rational) and len(str(value)) <= SHORT:
        return f"{name} = {value}".replace("-", "−")
    return f"{name} ≈ {value.evalf(4)}".replace("-", "−")


def drifts_along(eq: Equilibrium, found: Decision) -> Decision:
    """Return the decision about a point at numbers that is stable modulo the flows of integrals.

    If J y = X has a solution for the field X of such a flow, relative equilibria near the point move along X,
    at rates that grow with their distance from it: the second variation is not degenerate across the flows,
    and they go on smoothly with the values of the integrals.

    References
    ----------
    Patrick, J. Geom. Phys. 9 (1992) 111-119, for relative equilibria and their drift.
    """
    flow = ", ".join(map(str, found.modulo))
    space = eq.system.space
    jacobian = [[eq.insert(x) for x in row] for row in rows_at_point(eq, eq.system.jet_jacobian)]
    rows = [*jacobian, *regular_differentials(eq)]
    for F in found.modulo:
        moved = [x for (x,) in rows_at_point(eq, space.tensor * space.gradient(F))]
        beside = [*moved, *([S.Zero] * (len(rows) - len(moved)))]
        if found.rung is Rung.SECOND_VARIATION and any(moved) and _solvable(rows, beside):
            return settled(False, f"relative equilibria near it move along the flow of {F}: the eigenvalue 0 "
                           "of the linearised field has a Jordan block", Rung.DRIFT)
    return undecided(f"it is stable modulo the flow of {flow}, and whether equilibria near it move along "
                     "that flow is not proved")


def _solvable(rows: Sequence[Sequence[Expr]], right: Sequence[Expr]) -> bool:
    """Tell whether it is proved that linear equations at numbers have a solution."""
    whole, left = matrices_of([[*row, x] for row, x in zip(rows, right)], rows)
    try:
        return rank(whole) == rank(left)
    except NotProvedError:
        return False
