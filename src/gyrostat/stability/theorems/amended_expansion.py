"""Expands the amended potential on the sphere of directions beyond the second variation, and decides by it.

A leading form of a definite sign proves a minimum, or a gyroscopically stabilised maximum; at rest a negative
value of it proves instability.
"""
from collections.abc import Mapping
from dataclasses import dataclass
from math import factorial
from typing import Any

from sympy import Dummy, Expr, Mul, Poly, S, Symbol

from ..._cached import cached_property
from ...algebra.reals.exact import evaluate, proved_sign, sign_of_constant
from ...algebra.rings.matrices import cross
from ...algebra.rings.polynomials import Ring, by_degree
from ...algebra.solving.binary_forms import Form, valley, values_of
from ...errors import ScopeError
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.scenes.potential import DIRECTIONS
from ...notation import jet_name, symbol
from ..decision import C1, Decision, Rung, settled, undecided

ALONG = "where the second variation vanishes"
HIGHEST = 16                                           # degree up to which the expansion goes
X, Y, SIZE = Dummy("x", real=True), Dummy("y", real=True), Dummy("size", real=True)


@dataclass(frozen=True)
class Amended:
    """The amended potential U_c(k) = U(k) + (c − l·k)²/(2 k·Ik) near an equilibrium, c the value of C1 there.

    On the orbit h is U_c plus a positive square in π, so h has a strict minimum if U_c has one on abs(k) = 1:
    Lyapunov stable (Lagrange, Dirichlet). If U_c has none, a motion at rest with l = 0 is decided: there the
    system is a natural one, and an expansion that begins with a form which takes negative values makes it
    unstable (Chetaev; Kozlov). With gyroscopic forces one case is decided, that of two imaginary eigenvalues
    beside 0 (Sokolskii).

    Parameters
    ----------
    equilibrium : Equilibrium
        on e(3)*, k ≠ 0
    numbers : mapping of Symbol to Expr
        exact

    References
    ----------
    Simo, Lewis & Marsden, Arch. Rational Mech. Anal. 115 (1991) 15-59, for U_c; Chetaev, The Stability of
    Motion (1961), §17; Kozlov, J. Appl. Math. Mech. 50 (1986) 719-725, for a form that takes negative values
    without being definite; Sokolskii, J. Appl. Math. Mech. 41 (1977) 20-28, for a zero frequency. An example:
    docs/explanation/derivations/boundaries.md, section 7.
    """

    equilibrium: Equilibrium
    numbers: Mapping[Symbol, Expr]

    @cached_property
    def natural(self) -> bool:
        """Whether π = 0 and l = 0.

        Then the reduced motion is that of a natural system, without gyroscopic forces.
        """
        pi, rotor, _ = self._vectors
        return all(sign_of_constant(x) == 0 for x in (*pi, *rotor))

    def forms(self, degree: int) -> list[Form]:
        """Return U_c − U_c(k0) in homogeneous parts, of degree 0 to the degree given.

        The coordinates are stereographic: k = ((4 − abs(ξ)²) k0 + 4 ξ)/(4 + abs(ξ)²), ξ ⟂ k0.
        """
        pi, rotor, k0 = self._vectors
        tensor = self.equilibrium.system.body.tensor.applyfunc(self._value)
        # two products eᵢ × k0 span the tangent plane if the third component of k0 is not 0
        ahead = next(n for n in (2, 1, 0) if sign_of_constant(k0[n]))
        across = [cross(tuple(S.One if n == m else S.Zero for n in range(3)), k0)
                  for m in range(3) if m != ahead]
        tangent = [SIZE * (X * a + Y * b) for a, b in zip(*across)]
        square = sum(x**2 for x in tangent)
        step = [(4 * x - 2 * square * k) / (4 + square) for x, k in zip(tangent, k0)]
        value = sum((slope / Mul(*map(factorial, orders)) * Mul(*(d**n for d, n in zip(step, orders)))
                     for orders, slope in self._slopes(degree).items()), S.Zero)
        level = sum((p + r) * k for p, r, k in zip(pi, rotor, k0))
        place = [k + d for k, d in zip(k0, step)]
        value += (level - sum(r * k for r, k in zip(rotor, place))) ** 2 / (
            2 * sum(tensor[i, j] * place[i] * place[j] for i in range(3) for j in range(3))
        )
        ring = Ring([value, SIZE, X, Y])
        top, bottom = ring.fraction(value)
        index = ring.generators.index(SIZE)
        tops, bottoms = ([ring.reduce(part)
                          for part in by_degree(f, index, max(int(f.degrees()[index]), degree))]
                         for f in (top, bottom))
        parts: list[Any] = []                               # long division: f_n = parts[n]/bottoms[0]^(n + 1)
        for n in range(degree + 1):
            part = tops[n] * bottoms[0] ** n
            for m in range(n):
                part -= parts[m] * bottoms[n - m] * bottoms[0] ** (n - m - 1)
            parts.append(ring.reduce(part))
        return [{}, *(_form(ring.quotient(part, bottoms[0] ** (n + 1)))
                      for n, part in enumerate(parts) if n > 0)]

    def decide(self, oscillates: bool) -> Decision:
        """Return the decision at an equilibrium whose second variation is degenerate.

        Parameters
        ----------
        oscillates : bool
            whether p > 0: beside the eigenvalue 0 there are two imaginary ones

        Returns
        -------
        Decision
        """
        values, which = self.leading()
        if values is None:
            return undecided(which)
        if values == {1}:
            return settled(True, "the amended potential has a strict minimum, because its leading form, "
                           f"{which}, is positive (Lagrange-Dirichlet)", Rung.LEADING_FORM)
        said = f"the leading form of the amended potential, {which}, "
        if values == {-1} and ALONG in which and oscillates:
            return settled(True, f"{said}is negative, as the second variation is: a strict maximum, "
                           "which gyroscopic forces stabilise (Sokolskii)", Rung.LEADING_FORM, level=(C1,))
        if -1 not in values:
            return undecided(f"{said}is positive or 0, which does not tell whether it has a minimum")
        if self.natural:
            return settled(False, f"at rest with l = 0 the leading form of the potential, {which}, takes "
                           "negative values (Chetaev)", Rung.LEADING_FORM)
        if ALONG in which and oscillates:
            return settled(False, f"{said}is not of the sign of the second variation: a motion leaves "
                           "(Sokolskii)", Rung.LEADING_FORM)
        return undecided(f"{said}takes negative values: gyroscopic forces may stabilise the equilibrium")

    def leading(self) -> tuple[set[int] | None, str]:
        """Return the signs that the leading form takes, and which form it is.

        They are None, and why, if they are not proved. If the form is of degree 2 and vanishes along a
        direction, the leading form along the valley in that direction is meant: along the curve on which U_c
        is least, or greatest, in the other direction.
        """
        if self.equilibrium.near_pole is not None:
            return None, "the second variation is degenerate, and U has powers of 1 ∓ k3 that are not whole"
        for degree in (4, 8, HIGHEST):
            if wanted := {s.name for e in self._slopes(degree).values() for s in e.free_symbols}:
                return None, f"the second variation is degenerate, give {', '.join(sorted(wanted))} to decide"
            try:
                values, which = self._expanded(degree)
            except ScopeError as error:
                return None, ("the second variation is degenerate, and further terms are not compared: "
                              f"{error}")
            if which:
                return values, which
        return None, f"up to degree {HIGHEST} the amended potential does not change along a direction"

    def _expanded(self, degree: int) -> tuple[set[int] | None, str]:
        """Return the signs by the terms up to a degree; no form if these terms vanish along a direction."""
        forms = self.forms(degree)
        first = next((n for n, form in enumerate(forms) if form), 0)
        if first == 0:
            return None, ""
        values = values_of(forms[first], first)
        if first > 2 or values not in ({0, 1}, {0, -1}):
            return values, f"of degree {first}"
        for n, coefficient in enumerate(valley(forms), 3):
            if (sign := proved_sign(coefficient)) != 0:
                steady = n % 2 == 0 and {sign} < values    # of the sign of the second variation
                return {sign} if steady else {-1, 1}, f"of degree {n} {ALONG}"
        return None, ""

    def _slopes(self, degree: int) -> dict[tuple[int, ...], Expr]:
        """Return the derivatives of U at the point that are not 0, up to the degree.

        The keys say how often each of k1, k2, k3 is differentiated.
        """
        potential = self.equilibrium.system.potential
        assert potential is not None
        found: dict[tuple[int, ...], Expr] = {}
        axes = (2,) if potential.axial else (0, 1, 2)
        derivatives: dict[tuple[int, ...], Expr] = {(0, 0, 0): potential.expression}
        for _ in range(degree):
            above: dict[tuple[int, ...], Expr] = {}
            for orders, value in derivatives.items():
                for axis in axes:
                    if value != 0 and not any(orders[axis + 1:]):  # each product of derivatives in one order
                        following = tuple(n + (m == axis) for m, n in enumerate(orders))
                        above[following] = (value.diff(DIRECTIONS[axis]) if potential.given
                                            else self._jet(following))
            derivatives = above
            found |= {orders: slope for orders, value in above.items() if (slope := self._value(value)) != 0}
        return found

    def _jet(self, orders: tuple[int, ...]) -> Expr:
        potential = self.equilibrium.system.potential
        axes = "" if potential and potential.axial else "".join(a * n for a, n in zip("123", orders))
        return symbol(jet_name(sum(orders), axes))

    def _value(self, expression: Expr) -> Expr:
        """Insert the point and the numbers."""
        value = self.equilibrium.insert(self.equilibrium.at_point(expression))
        return evaluate(value, self.numbers) if value.free_symbols <= self.numbers.keys() else value

    @cached_property
    def _vectors(self) -> list[tuple[Expr, ...]]:
        """The vectors π, l and k."""
        point, rotor = self.equilibrium.point, self.equilibrium.system.body.gyrostatic_momentum
        return [tuple(map(self._value, vector)) for vector in (point[:3], rotor, point[3:])]


def _form(value: Expr) -> Form:
    """Return the coefficients of a form in x and y that are not proved to vanish."""
    terms = Poly(value, X, Y).terms() if value != 0 else []
    return {orders: c for orders, c in terms if sign_of_constant(c) != 0}
