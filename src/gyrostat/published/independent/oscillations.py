"""Expands motions near an equilibrium, and how their frequencies change with their size (Lindstedt).

x(z1, w1, z2, w2), where z_j = √ρ_j exp(iφ_j) and w_j is its conjugate, is put into Newton and Euler's
equations for π and k, with rates of φ_j that depend on ρ1 and ρ2 (Lindstedt, Poincaré). Nothing here uses a
chart of the orbit, a bracket or a normal form of the energy.
"""
from collections.abc import Sequence
from typing import Any

from flint import acb, acb_mat, arb, fmpq
from sympy import Expr, Poly

from ..._cached import cached_property
from .counterexample import K, Model
from .power_series import (
    OWN,
    START,
    Monomial,
    Series,
    added,
    cross,
    dot,
    of_degree,
    pair,
    pairs,
    plus,
    times,
)


class Motion:
    """The motions near an equilibrium to an order in z and w, computed inside own_precision.

    ratio is 2 or 3 if the frequencies are as 1 to 2 or 1 to 3, otherwise 0.
    """

    def __init__(self, model: Model, coefficients: Sequence[Expr], order: int, ratio: int = 0):
        self.model, self.ratio = model, ratio
        self.inverse = [ball(1 / x) for x in self.model.inertia]
        self.rotor = [ball(x) for x in self.model.rotor]
        self.slopes = [Poly(self.model.U.diff(x), *K).terms() for x in K]
        p, q = map(ball, coefficients)
        root = (p**2 - 4 * q).sqrt()
        self.rates = [((p + root) / 2).real.sqrt(), (2 * q / (p + root)).real.sqrt()]
        self.values = [acb(0, s * rate) for rate in self.rates for s in (1, -1)]
        self.A = acb_mat([[ball(x) for x in row] for row in self.model.jacobian.tolist()])
        self.onto = [self._projection(n) for n in range(4)]
        square = self.A * self.A
        self.still = (square * square + square * p + identity() * q) * (1 / q)
        self.columns = [greatest_column(part) for part in self.onto]
        self.turning: list[Series] = [{} for _ in range(4)]  # what is added to each value, by ρ1 and ρ2
        self.x: list[Series] = [{START: ball(x)} for x in self.model.point]
        for monomial, column in zip(OWN, self.columns):
            self._put(monomial, column)
        self.driving = acb(0)                              # of z2² or z2³ on z1, at that ratio
        for degree in range(2, order + 1):
            self._solve(degree)

    def _projection(self, n: int) -> Any:
        """Return the projection on the n-th eigenvector, along the others and the kernel."""
        value, partner = self.values[n], self.values[n ^ 1]
        other = self.values[n ^ 2]
        shape = self.A * (self.A - identity() * partner) * (self.A * self.A - identity() * other**2)
        return shape * (1 / (value * (value - partner) * (value**2 - other**2)))

    def _put(self, monomial: Monomial, column: Sequence[Any]) -> None:
        for part, c in zip(self.x, column):
            part[monomial] = part.get(monomial, acb(0)) + c

    def _solve(self, degree: int) -> None:
        """Solve (Λ − A) P = f(x) − Σ (∂x/∂z_j)(rates so far) for each monomial of a degree."""
        field, carried = self._field(degree), self._carried(degree)
        for m in of_degree(degree):
            G = acb_mat([[f.get(m, acb(0)) - c.get(m, acb(0))] for f, c in zip(field, carried)])
            if m == (0, 0, self.ratio, 0):
                self.driving = first_of(self.onto[0] * G, self.columns[0])
            value = sum((n * v for n, v in zip(m, self.values)), acb(0))
            for n, part in enumerate(self.onto):
                size = m[0] - OWN[n][0], m[1] - OWN[n][1], m[2] - OWN[n][2], m[3] - OWN[n][3]
                if size in pairs(degree - 1):
                    self.turning[n][size] = first_of(part * G, self.columns[n])
                elif not self.ratio or m != resonant(self.ratio)[n]:
                    self._put(m, column_of(part * G * (1 / (value - self.values[n]))))
            if m not in pairs(degree):
                self._put(m, column_of(self.still * G * (1 / value)))
        if degree % 2 == 0:
            casimirs = self._casimirs(degree)
            for m in pairs(degree):
                self._put(m, self._back([-c.get(m, acb(0)) for c in casimirs]))

    def _field(self, degree: int) -> list[Series]:
        """Return the field, (π + l) × ω + k × ∇U and k × ω."""
        pi, k = self.x[:3], self.x[3:]
        omega = [{m: c * i for m, c in part.items()} for part, i in zip(pi, self.inverse)]
        slope = [self._composed(terms, degree) for terms in self.slopes]
        turned, load = cross(self.momentum, omega, degree), cross(k, slope, degree)
        return [*map(added, turned, load), *cross(k, omega, degree)]

    def _composed(self, terms: Sequence[tuple[Sequence[int], Expr]], degree: int) -> Series:
        found: Series = {}
        for exponents, c in terms:
            term: Series = {START: ball(c)}
            for part, n in zip(self.x[3:], exponents):
                for _ in range(n):
                    term = times(term, part, degree)
            found = added(found, term)
        return found

    def _carried(self, degree: int) -> list[Series]:
        """Return what the rates of lower degree make of the terms that are known."""
        found: list[Series] = []
        for part in self.x:
            total: Series = {}
            for m, c in part.items():
                for n, turning in zip(m, self.turning):
                    for size, rate in turning.items():
                        if n and sum(m) + sum(size) == degree and sum(m) > 1:
                            total = added(total, {plus(m, size): n * c * rate})
            found.append(total)
        return found

    @property
    def momentum(self) -> list[Series]:
        """The momentum M = π + l."""
        return [added(part, {START: l}) for part, l in zip(self.x, self.rotor)]

    def _casimirs(self, degree: int) -> list[Series]:
        """Return the Casimirs (π + l)·k and k·k."""
        k = self.x[3:]
        return [dot(self.momentum, k, degree), dot(k, k, degree)]

    def _back(self, wanted: Sequence[Any]) -> list[Any]:
        """Return the step along the family of equilibria by which the Casimirs change as wanted."""
        k, M = ([part[START] for part in vector] for vector in (self.x[3:], self.momentum))
        gradients = acb_mat([[*k, *M], [acb(0)] * 3 + [2 * x for x in k]])
        along = self.still * gradients.transpose()
        return column_of(along * (gradients * along).inv() * acb_mat([[c] for c in wanted]))

    @cached_property
    def energies(self) -> list[Any]:
        """The energies of the two oscillations, divided by ρ1 and ρ2."""
        pi = self.x[:3]
        kinetic = dot(pi, [{m: c * i / 2 for m, c in part.items()} for part, i in zip(pi, self.inverse)], 2)
        energy = added(kinetic, self._composed(Poly(self.model.U, *K).terms(), 2))
        return [energy[pair(n)] for n in (0, 1)]

    @property
    def signs(self) -> list[int]:
        """The signs of the energies."""
        return [1 if e.real > 0 else -1 for e in self.energies]

    @cached_property
    def bent(self) -> tuple[Any, Any, Any]:
        """The energy's coefficients in actions with the sign of the energies, from how the rates change."""
        (a, b), (_, c) = ([turning[pair(n)] / acb(0, 1) for n in (0, 1)] for turning in self.turning[::2])
        first, second = self.sizes
        return a / first / 2, b / second, c / second / 2

    @cached_property
    def sizes(self) -> list[Any]:
        """The actions of the two oscillations, divided by ρ1 and ρ2."""
        return [e / rate for e, rate in zip(self.energies, self.rates)]

    @cached_property
    def twists(self) -> list[Any]:
        """D4 and, from order 5 on, D6: at the actions Ω2 and −Ω1, where the energies cancel."""
        one, mixed, two = self.bent
        first, second = actions = self.rates[1], -self.rates[0]
        found = [one * first**2 + mixed * first * second + two * second**2]
        if all((2, 2, 0, 0) in turning for turning in self.turning[::2]):
            rho = [action / size for action, size in zip(actions, self.sizes)]
            bent = [sum((c / acb(0, 1) * rho[0] ** m[0] * rho[1] ** m[2] for m, c in turning.items()
                         if sum(m) == 4), acb(0)) for turning in self.turning[::2]]
            x, y = self._second_actions(rho)
            left = bent[0] - 2 * one * x - mixed * y, bent[1] - mixed * x - 2 * two * y
            sign = self.signs[0] * self.signs[1]
            found.append(sign * (first * left[0] + second * left[1]) / 3)
        return found

    @property
    def amplitude(self) -> Any:
        """The size of the term by which z2³ drives z1, in the energy, at the actions where D4 is taken."""
        (one, two), (fast, slow) = ([abs(x) for x in both] for both in (self.sizes, self.rates))
        return 2 * abs(self.driving) * one * (slow / one).sqrt() * (fast / two) * (fast / two).sqrt()

    def _second_actions(self, rho: Sequence[Any]) -> list[Any]:
        """Return the terms of degree 2 in ρ of the actions, from areas that the motions enclose.

        Ω(δ, δ') = δM·θ' − δ'M·θ − M·(θ × θ') where δk = k × θ.
        """
        k = self.x[3:]
        grown = [{m: c * sum(m) / 2 for m, c in part.items()} for part in self.x]
        found = []
        for n in (0, 1):
            turned = [{m: c * acb(0, m[2 * n] - m[2 * n + 1]) for m, c in part.items()} for part in self.x]
            theta, other = (cross(part[3:], k, 4) for part in (grown, turned))
            area = [dot(grown[:3], other, 4), {m: -c for m, c in dot(turned[:3], theta, 4).items()},
                    {m: -c for m, c in dot(self.momentum, cross(theta, other, 4), 4).items()}]
            whole = added(added(area[0], area[1]), area[2])
            found.append(sum((whole.get(m, acb(0)) / 2 * rho[0] ** m[0] * rho[1] ** m[2] for m in pairs(4)),
                             acb(0)))
        return found


def resonant(ratio: int) -> list[Monomial]:
    """Return the monomials that turn at the same rate as z1, w1, z2 and w2."""
    return [(0, 0, ratio, 0), (0, 0, 0, ratio), (1, 0, 0, ratio - 1), (0, 1, ratio - 1, 0)]


def ball(x: Expr) -> Any:
    """Return a ball: exact for a rational number, to 80 digits for another."""
    if x.is_Rational:
        return acb(fmpq(int(x.p), int(x.q)))
    return acb(arb(f"{x.evalf(90)} +/- {abs(x.evalf(90)) / 10**80}"))


def identity() -> Any:
    """Return the identity matrix of six rows."""
    return acb_mat([[acb(int(i == j)) for j in range(6)] for i in range(6)])


def column_of(x: Any) -> list[Any]:
    """Return the entries of a column."""
    return [row[0] for row in x.tolist()]


def greatest_column(x: Any) -> list[Any]:
    """Return the column of the greatest entry."""
    columns = [list(column) for column in zip(*x.tolist())]
    return max(columns, key=lambda column: max(float(abs(c).mid()) for c in column))


def first_of(x: Any, column: Sequence[Any]) -> Any:
    """Return the factor by which a vector along a column is that column."""
    row = max(range(6), key=lambda n: float(abs(column[n]).mid()))
    return x[row, 0] / column[row]
