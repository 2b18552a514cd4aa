"""Expands U(k3) near k3 = ±1 in powers of x = 1 ∓ k3, fractional ones too, and tells if it is smooth.

With ρ the distance from the pole, x = ρ²/2 + …: a power xᵃ, a not whole, has continuous derivatives on the
sphere of the orders below 2a. Three cases follow:

- a ≤ 1/2: U has no slope at the pole, which is no equilibrium.
- 1/2 < a < 1: the pole is one, but the field has no linear part there, and U no second variation.
- a > 1: U is twice differentiable, U(±1) ∓ U'(±1) ρ²/2 + o(ρ²). Both criteria have U' alone and hold as they
  stand: the field is its linear part and o of the distance (Coddington & Levinson 1955, chapter 13).

On the boundary between them the motion of k3 decides. On the level of the equilibrium I1² ẋ² = g(x), which is
2 I1 (U(±1) − U) (2x − x²) − (π3 + l)² x². If its first term c xᵖ has c < 0, there are x as small as one likes
with g(x) < 0, on levels near it too, since U is continuous: what starts below such an x stays below. If c >
0, a motion leaves, ẋ > 0 from every small x on. Neither case asks for a derivative at the pole. The first
term decides, since g is a convergent series in t with x = tᵠ.
"""
from collections.abc import Iterable
from dataclasses import dataclass
from functools import lru_cache
from math import lcm

from sympy import Dummy, Expr, Pow, Rational, S, acos, acosh, asin, atanh, factorial, log, pi

from ..._cached import cached_property
from ...algebra.enclosures.balls import is_undefined
from ...algebra.reals.exact import is_identically_zero, sign, sign_of_constant
from ...algebra.rings.polynomials import Ring, lowest_terms
from ...algebra.text.numbers import shown
from ...errors import EquilibriumError
from ..scenes.potential import DIRECTIONS, Potential, smooth_where_positive

K3, T = DIRECTIONS[2], Dummy("t", positive=True)
MOST = 60                                              # the largest q


class _UnknownError(Exception):
    """No series in a root of x is found here."""


class _FinerError(Exception):
    """A higher root of x is needed; the argument is its order."""


@dataclass(frozen=True)
class NearPole:
    """The series of U(±(1 − tᵠ)) in powers of t.

    Parameters
    ----------
    side : int
        1 or −1
    order : int
        q
    expression : Expr
        in T
    positive : tuple of Expr
        what has to be positive for it, in the parameters
    """

    side: int
    order: int
    expression: Expr
    positive: tuple[Expr, ...]

    def coefficient(self, n: int) -> Expr:
        """Return the coefficient of tⁿ."""
        while len(self._derivatives) <= n:
            self._derivatives.append(self._derivatives[-1].diff(T))
        return lowest_terms(self._derivatives[n].xreplace({T: S.Zero}) / factorial(n))

    def derivative(self, n: int) -> Expr:
        """Return the n-th derivative of U by k3 at the pole; infinite if a lower power is not whole."""
        if any(m % self.order and self.coefficient(m) != 0 for m in range(1, n * self.order)):
            return S.ComplexInfinity
        return (-self.side) ** n * factorial(n) * self.coefficient(n * self.order)

    @cached_property
    def root(self) -> Rational | None:
        """The least power of x below 1; None if there is none."""
        return next((Rational(n, self.order) for n in range(1, self.order) if self.coefficient(n) != 0), None)

    @cached_property
    def smooth(self) -> bool:
        """Whether it is proved that all powers of x are whole."""
        turned = self.expression.xreplace({T: -T})
        return self.order == 2 and is_identically_zero(self.expression - turned) is True

    @cached_property
    def _derivatives(self) -> list[Expr]:
        return [self.expression]


def near_pole(potential: Potential | None, k3: Expr) -> NearPole | None:
    """Return U(k3) near k3 = ±1, if it has roots or inverse functions that are not smooth there; else None.

    None is returned, too, if it is no such series, with a logarithm of x for example, or infinite.
    """
    if potential is None or not (potential.given and potential.axial) or k3 not in (S.One, S.NegativeOne):
        return None
    return in_powers(potential.expression, int(k3))


@lru_cache(maxsize=64)
def in_powers(U: Expr, side: int) -> NearPole | None:
    """Return the series of an expression U(k3) near k3 = ±1, None if it needs or has none.

    Examples
    --------
    >>> from sympy import acos
    >>> series = in_powers((1 - K3) ** Rational(5, 2) - K3, 1)
    >>> [series.coefficient(n) for n in (0, 2, 5)]
    [-1, 1, 1]
    >>> series.derivative(1), series.derivative(3)
    (-1, zoo)
    >>> series = in_powers(acos(K3) ** 2, 1)
    >>> [series.derivative(n) for n in (0, 1, 2)], series.smooth
    ([0, -2, 2/3], True)
    """
    if not any(_vanishes(a, side) for a in smooth_where_positive(U)):
        return None
    order = 1
    while order <= MOST:
        unrolled = _Unrolled(side, order)
        try:
            found = NearPole(side, order, unrolled.of(U), tuple(dict.fromkeys(unrolled.positive)))
        except _FinerError as finer:
            order = lcm(order, *finer.args)
        except _UnknownError:
            return None
        else:
            return found if found.coefficient(0).is_finite is not False else None
    return None


def left_positive(near: NearPole | None, arguments: Iterable[Expr]) -> list[Expr]:
    """Return the arguments of roots at a point that have to be positive.

    An argument that is 0 there is in the powers of x.
    """
    if near is None:
        return list(arguments)
    return [*(a for a in arguments if is_identically_zero(a) is not True), *near.positive]


def refuse_rough(label: str, potential: Potential | None, near: NearPole | None, values: Iterable[Expr],
                 positive: Iterable[Expr]) -> None:
    """Refuse a point at which U is not twice differentiable on the sphere, or not known to be.

    Parameters
    ----------
    label : str
        of the point
    potential : Potential or None
    near : NearPole or None
    values : iterable of Expr
        U and its derivatives there
    positive : iterable of Expr
        what has to be positive for U to be smooth
    """
    if near is not None and near.root is not None:
        raise EquilibriumError(f"{label} cannot be analysed: U changes near it as the power {near.root} of "
                               f"{1 - near.side * K3}, and on the sphere it has " + (
                                   "no slope: that is no equilibrium" if 2 * near.root <= 1 else
                                   "one derivative, not two: there is no second variation")
                               + "; choose another point, or a U that is smooth there")
    for value in values:
        powers = set() if potential is None else potential.expression.atoms(Pow)
        names = sorted({s.name for power in powers for s in power.exp.free_symbols - {K3}})
        if names and value.has(S.ComplexInfinity):
            raise EquilibriumError(f"{label} cannot be analysed: U contains near it a power of 0 whose "
                                   f"exponent has {', '.join(names)} in it; put numbers into U first, in "
                                   f"Python U.subs({names[0]}, 2)")
        if is_undefined(value):
            raise EquilibriumError(f"{label} cannot be analysed: U or one of its derivatives is "
                                   f"{shown(value)} there, not a finite real number; choose another point, "
                                   "or another U")
    for argument in positive:
        if not argument.free_symbols and sign(argument, {}) != 1:
            raise EquilibriumError(f"{label} cannot be analysed: U is not known to be smooth there, because "
                                   "the argument of a root, logarithm or inverse function is not proved to "
                                   f"be inside its range, {argument} > 0; choose another point or numbers")


def _vanishes(argument: Expr, side: int) -> bool:
    return is_identically_zero(argument.xreplace({K3: S(side)})) is True


class _Unrolled:
    """An expression in t: each root of what vanishes at 0 is a power of t times a root of what does not."""

    def __init__(self, side: int, order: int):
        self.side, self.order = side, order
        self.positive: list[Expr] = []

    def of(self, node: Expr) -> Expr:
        """Rewrite an expression in k3."""
        if not node.has(K3):
            return node
        if node == K3:
            return self.side * (1 - T**self.order)
        if isinstance(node, (acos, asin)):
            angle = self._angle(self.of(node.args[0]))
            return angle if isinstance(node, acos) else pi / 2 - angle
        if isinstance(node, Pow) and isinstance(node.exp, Rational) and not node.exp.is_Integer:
            return self._power(self.of(node.base), node.exp)
        inner = node.func(*map(self.of, node.args))
        if isinstance(node, (log, acosh, atanh)) and any(
                is_identically_zero(a.xreplace({T: S.Zero})) for a in smooth_where_positive(inner)):
            raise _UnknownError                            # x log x is no power of t
        return inner

    def _angle(self, cosine: Expr) -> Expr:
        """Return acos y as 2 asin √((1 − y)/2) near y = 1, and as π less that of −y near −1."""
        for side in (1, -1):
            if is_identically_zero(cosine.xreplace({T: S.Zero}) - side):
                half = 2 * asin(self._power((1 - side * cosine) / 2, Rational(1, 2)))
                return half if side == 1 else pi - half
        return acos(cosine)

    def _power(self, base: Expr, exponent: Rational) -> Expr:
        """Return a power of tᵐ u, where u is positive at 0."""
        ring = Ring([base, T])
        top, bottom = ring.fraction(base)
        place = ring.generators.index(T)
        if not (top := ring.reduce(top)):
            raise _UnknownError
        m, n = (min(int(e[place]) for e in f.monoms()) for f in (top, bottom))
        unit = ring.quotient(top / ring.gens[T] ** m, bottom / ring.gens[T] ** n)
        power = (m - n) * exponent
        if not power.is_Integer:
            raise _FinerError(int(self.order * power.q))
        first = unit.xreplace({T: S.Zero})
        if m != n:
            if first.free_symbols:
                self.positive.append(first)
            elif sign_of_constant(first) != 1:
                raise _UnknownError
        return T**power * unit**exponent

