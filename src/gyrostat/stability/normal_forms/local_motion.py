"""The motion near an equilibrium of a body in a field, at exact numbers, with two degrees of freedom.

It is h in canonical coordinates of the coadjoint orbit, expanded to a degree.
"""
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from math import factorial
from typing import Any

from flint import acb, arb, fmpq
from sympy import Add, Expr, Mul, Pow, Rational, S, Symbol, preorder_traversal

from ..._cached import cached_property
from ...algebra.enclosures.balls import ball
from ...algebra.enclosures.precision import doubled, own_precision
from ...algebra.reals.exact import Point, evaluate
from ...algebra.rings.series import Part, Series, composed
from ...algebra.solving.real_fields import FieldNumbers, are_fractions, balls
from ...mechanics.equilibrium.derived_once import once
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.scenes.potential import DIRECTIONS
from ...notation import jet, jet_name, symbol
from ..criteria.linearization import linearize
from .birkhoff import Modes, characteristic, linear_motion, modes
from .orbit_chart import energy_on_orbit

Number = Callable[[Expr], Any]
PRECISION = 128                                            # bits that decide nearly always


@dataclass(frozen=True)
class InBalls:
    """Takes an expression into balls of a precision, or each of a sequence."""

    precision: int

    def __call__(self, x: Expr) -> arb:
        return ball(x, self.precision)

    def each(self, numbers: Sequence[Expr]) -> list[arb]:
        """Return all of them; those of FieldNumbers need no expressions."""
        return balls(numbers, self.precision)


@dataclass(frozen=True)
class LocalMotion:
    """A body in a field near an equilibrium on its coadjoint orbit; every number is exact.

    Parameters
    ----------
    inverse : tuple of tuple of Expr, shape (3, 3)
        the inverse of the tensor of inertia [1/(M L²)]
    rotor : tuple of Expr, shape (3,)
        l [M L²/T]
    k, momentum : sequence of Expr, shape (3,)
        the direction, and M = π + l [M L²/T]; FieldNumbers are enclosed without their expressions
    potential : Expr
        U in k1, k2, k3; if only its derivatives are given, their Taylor polynomial
    coefficients : callable
        gives p and q of λ⁴ + p λ² + q [1/T², 1/T⁴], asked if balls do not decide
    square_of_k : Expr
        abs(k)², not 1 if M, k and h have another scale
    rough : bool
        whether U has powers of 1 ∓ k3 at a pole that are not whole: normal forms ask for more derivatives
    """

    inverse: tuple[tuple[Expr, ...], ...]
    rotor: tuple[Expr, ...]
    k: Sequence[Expr]
    momentum: Sequence[Expr]
    potential: Expr
    coefficients: Callable[[], tuple[Expr, Expr]]
    square_of_k: Expr = S.One
    rough: bool = False

    @cached_property
    def p(self) -> Expr:
        """The p of λ⁴ + p λ² + q."""
        return self.coefficients()[0]

    @cached_property
    def q(self) -> Expr:
        """The q of λ⁴ + p λ² + q."""
        return self.coefficients()[1]

    @property
    def entries(self) -> list[Expr]:
        """The entries of the tensor and the vectors."""
        return [*(x for row in self.inverse for x in row), *self.rotor, *self.k, *self.momentum]

    @property
    def names(self) -> set[Symbol]:
        """The symbols that have no number."""
        inside = {s for x in (*self.entries, *self.coefficients()) for s in x.free_symbols}
        return inside | self.potential.free_symbols - set(DIRECTIONS)

    @cached_property
    def rational(self) -> bool:
        """Whether every number is rational, and U a fraction of polynomials with rational coefficients."""
        nodes = list(preorder_traversal(self.potential))
        return (all(map(are_fractions, (*self.inverse, self.rotor, self.k, self.momentum)))
                and all(isinstance(x, Rational | Symbol | Add | Mul | Pow) for x in nodes)
                and all(x.exp.is_Integer for x in nodes if isinstance(x, Pow)))

    def energy(self, degree: int, number: Number) -> list[Part]:
        """Return h on the orbit in canonical coordinates, in homogeneous parts, in a ring of numbers."""
        # the chart has a pole on its third axis: the one that is farthest from k
        far = _along(self.k)
        upright = far.index(min(far))

        def potential(places: Sequence[Series]) -> Series:
            return composed(self.potential, dict(zip(DIRECTIONS, places)), number)

        inverse = [[number(x) for x in row] for row in self.inverse]
        rotor, k, momentum = (
            number.each(vector) if isinstance(number, InBalls) else [number(x) for x in vector]
            for vector in (self.rotor, self.k, self.momentum))
        return energy_on_orbit(inverse, rotor, k, momentum, potential, upright, degree,
                               number(self.square_of_k))

    @cached_property
    def first(self) -> tuple[list[Part], Modes]:
        """The energy and the modes to degree 4, in balls of 128 bits."""
        with own_precision(PRECISION):
            return self.in_balls(4, PRECISION)

    def in_balls(self, degree: int, precision: int) -> tuple[list[Part], Modes]:
        """Return the energy and the modes with positive actions: h = Σ ω_j J_j + …, ω_j of either sign.

        It is called inside own_precision.
        """
        parts = self.energy(degree, InBalls(precision))
        A = linear_motion(parts[2])
        p, q = characteristic(A)
        root = (p**2 - 4 * q).sqrt()
        squares = (p + root) / 2, 2 * q / (p + root)       # the smaller by their product: no digits are lost
        return parts, modes(A, p, (acb(0, squares[0].sqrt()), acb(0, squares[1].sqrt()))).oriented()


def _along(k: Sequence[Expr]) -> list[float]:
    """Return how far k is along each axis, and the most where it has no number."""
    if not isinstance(k, FieldNumbers):
        return [1.0 if x.free_symbols else abs(float(ball(x, 64).mid())) for x in k]
    for precision in doubled(PRECISION):
        near = k.balls(precision)
        if all(x.is_finite() for x in near):
            break
    return [abs(float(x.mid())) for x in near]


def fraction(x: Expr) -> fmpq:
    """Return a rational number in the ring of fractions."""
    return fmpq(int(x.p), int(x.q))


def local_motion(eq: Equilibrium, numbers: Mapping[Symbol, Expr], degree: int) -> LocalMotion | list[str]:
    """Return the motion at an equilibrium of a body in a field, k ≠ 0; or the names of what is missing.

    If U is unspecified, its derivatives up to a degree are among these names.
    """
    motion = motion_along(eq, numbers, degree)
    return sorted(s.name for s in motion.names) or motion


def motion_along(eq: Equilibrium, numbers: Mapping[Symbol, Expr], degree: int) -> LocalMotion:
    """Return the motion at an equilibrium of a body in a field, in which names may be without a number."""
    potential = eq.system.potential
    assert potential is not None
    known = Point({**numbers, **{name: evaluate(eq.insert(value), numbers) for name, value in eq.relations
                                 if not jet(name.name)}})
    slopes = {} if potential.given else _slopes(eq, degree)
    data = data_of(eq)
    inverse, l, pi, k, (p, q) = ([evaluate(x, known) for x in part] for part in data)
    if potential.given:
        U = potential.expression.xreplace({s: known[s] for s in potential.parameters if s in known})
    else:
        U = Add(*(evaluate(slope, known) * Mul(*((x - x0) ** n / factorial(n)
                                                 for x, x0, n in zip(DIRECTIONS, k, orders)))
                  for orders, slope in slopes.items()))
    return LocalMotion(tuple(tuple(inverse[3 * i:3 * i + 3]) for i in range(3)), tuple(l), tuple(k),
                       tuple(x + y for x, y in zip(pi, l)), U, lambda: (p, q), rough=eq.near_pole is not None)


@once
def data_of(eq: Equilibrium) -> tuple[list[Expr], ...]:
    """Return the inverse of the tensor, the rotor, π, k, and p and q, on the family."""
    body = eq.system.body
    return tuple([eq.insert(x) for x in part] for part in (
        body.inverse, body.gyrostatic_momentum, eq.point[:3], eq.point[3:],
        linearize(eq).frequency_coefficients))


def _slopes(eq: Equilibrium, degree: int) -> dict[tuple[int, ...], Expr]:
    """Return the derivatives of U at the point, on the family.

    The keys say how often each of k1, k2, k3 is differentiated.
    """
    potential = eq.system.potential
    axial = potential is not None and potential.axial
    found: dict[tuple[int, ...], Expr] = {}
    for order in range(1, degree + 1):
        for orders in ((a, b, order - a - b) for a in range(order + 1) for b in range(order + 1 - a)):
            if not axial or orders[2] == order:
                axes = "" if axial else "".join(axis * n for axis, n in zip("123", orders))
                found[orders] = eq.insert(eq.at_point(symbol(jet_name(order, axes))))
    return found
