"""The curves on the sphere k·k = 1 along which polynomials over ℚ vanish, by stereographic projection.

With x = k1/(1 − k3) and y = k2/(1 − k3), the projection from (0, 0, 1), the curves are, where k3 ≠ 1, the
factors of a greatest common divisor in ℚ[x, y]: see docs/explanation/derivations/zeros-on-the-sphere.md,
section 4.
"""
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import reduce
from itertools import pairwise

from flint import Ordering, fmpq, fmpq_mpoly, fmpq_mpoly_ctx, fmpq_poly
from sympy import Add, Dummy, Expr, Integer, Matrix, Mul, Poly, S, eye, oo, sqrt

from ..._cached import cached_property
from ..enclosures.rationals import to_flint, to_sympy
from ..reals.exact import evaluate
from ..reals.number_fields import in_one
from ..rings.polynomials import by_degree
from .roots import between, in_order, real_roots, roots_of_polynomial

Exponents = tuple[int, ...]
Terms = Mapping[Exponents, fmpq]
ONE, AXES = (0, 0, 0), ((1, 0, 0), (0, 1, 0), (0, 0, 1))
T, SIDE = Dummy(real=True), Dummy(real=True)
PLANE = fmpq_mpoly_ctx.get(("x", "y"), Ordering.lex)
X, Y = PLANE.gens()                                    # also for k1 and k2
FLAT = X**2 + Y**2
ROUND = FLAT + 1                                       # 2/(1 − k3)


@dataclass(frozen=True)
class SphereCurve:
    """The zeros on the sphere of an irreducible polynomial: the real ones are arcs, or single points.

    Parameters
    ----------
    projected : fmpq_mpoly
        in x and y
    """

    projected: fmpq_mpoly

    @cached_property
    def terms(self) -> Terms:
        """The polynomial in k1, k2, k3."""
        return lifted(self.projected)

    @cached_property
    def samples(self) -> list[tuple[Expr, ...]]:
        """A point of an arc, exact, or one of each circle; the list is empty if there are no arcs."""
        return self._on_arc() if self.axis is None else self._on_circles(Matrix(self.axis))

    def _on_arc(self) -> list[tuple[Expr, ...]]:
        """Return a point of an arc, which lies over an interval of x, or over a line x = constant.

        It lies over a line if the projection is a polynomial in x alone. Between two roots of the
        discriminant or of the leading coefficient in y the number of real y does not change: one x tells it.
        """
        if not (degree := int(self.projected.degrees()[1])):
            return [_above(x, S.Zero) for x in roots_of_polynomial(in_one(self.projected, 0))[:1]]
        parts = [in_one(part, 0) for part in by_degree(self.projected, 1, degree)]
        slope = self.projected.derivative(1)
        meeting = self.projected.resultant(slope, "y") if degree > 1 else slope
        special = dict.fromkeys([*roots_of_polynomial(in_one(meeting, 0)), *roots_of_polynomial(parts[-1])])
        for low, high in pairwise([-oo, *in_order(list(special)), oo]):
            x = between(low, high)
            if found := roots_of_polynomial(fmpq_poly([part(to_flint(x)) for part in parts])):
                return [_above(x, found[0])]
        return []

    def _on_circles(self, axis: Matrix) -> list[tuple[Expr, ...]]:
        """Return a point of each circle about the axis a.

        On the sphere the polynomial is one in t = a·k: k = t a/a·a + s e with e ⟂ a.
        """
        n = next(n for n in range(3) if axis[n])
        e, square = axis.cross(eye(3)[:, n - 1]), axis.dot(axis)
        rest = (1 - T**2 / square) / e.dot(e)              # s²
        placed = Poly(self.expression(T * axis / square + SIDE * e), SIDE)
        whole = Add(*(c * rest ** (m // 2) for (m,), c in placed.terms()))  # odd powers of s cancel
        places = [t * axis / square + sqrt(evaluate(rest, {T: t})) * e
                  for t in real_roots(whole, T, -sqrt(square), sqrt(square)) or ()]
        return [tuple(evaluate(x, {}) for x in k) for k in places]

    @cached_property
    def singular(self) -> list[Terms]:
        """Polynomials whose common zeros are the singular points: without an arc, all real ones."""
        return [self.terms, *filter(None, self._turned)]

    def divides(self, f: Terms) -> bool:
        """Tell whether a polynomial vanishes on the whole curve."""
        return not divmod(projected(f), self.projected)[1]

    @cached_property
    def axis(self) -> tuple[Expr, ...] | None:
        """The axis about which the arcs are circles: turns about it keep the polynomial; None if none do."""
        places = {e for part in self._turned for e in part}
        rows = [[to_sympy(part.get(e, fmpq(0))) for part in self._turned] for e in sorted(places)]
        found = Matrix(rows).nullspace()
        return tuple(found[0]) if len(found) == 1 else None

    @cached_property
    def _turned(self) -> list[Terms]:
        """The components of k × ∇f on the sphere: how f changes when k turns about each axis."""
        found: list[Terms] = []
        for i, j in ((1, 2), (2, 0), (0, 1)):
            part: dict[Exponents, fmpq] = {}
            for e, c in self.terms.items():
                for n, m, sign in ((i, j, 1), (j, i, -1)):
                    if e[m]:
                        moved = product(e, [(a == n) - (a == m) for a in range(3)])
                        part[moved] = part.get(moved, fmpq(0)) + sign * e[m] * c
            found.append(on_sphere(part))
        return found

    def expression(self, k: Sequence[Expr]) -> Expr:
        """Return the polynomial in symbols, with integers for coefficients."""
        common = reduce(lambda a, b: a.gcd(b), self.terms.values())
        return Add(*(Mul(Integer(int((c / common).p)), *(x**n for x, n in zip(k, e)))
                     for e, c in self.terms.items()))


def split(given: Sequence[Terms]) -> tuple[list[SphereCurve], list[Terms]]:
    """Split polynomials into the curves on which they vanish, and polynomials with their other common zeros.

    Neither tells whether (0, 0, 1) is a zero.

    Parameters
    ----------
    given : sequence of Terms
        at least one, none of them 0

    Examples
    --------
    >>> one = fmpq(1)
    >>> (curve,), rests = split([{(2, 0, 0): one}, {(1, 1, 0): one}])
    >>> curve.samples, curve.axis
    ([(0, -1, 0)], (1, 0, 0))
    >>> [list(rest) for rest in rests]
    [[(1, 0, 0)], [(0, 1, 0)]]
    """
    planes = [projected(f) for f in given]
    common = reduce(lambda f, g: f.gcd(g), planes)
    curves = [SphereCurve(factor) for factor, _ in common.factor()[1] if factor != ROUND]
    return curves, [lifted(f / common) for f in planes]


def on_sphere(terms: Terms) -> dict[Exponents, fmpq]:
    """Return the same polynomial on the sphere, with 1 − k1² − k2² for k3²."""
    done: dict[Exponents, fmpq] = {}
    left = dict(terms)
    while left:
        (a, b, c), number = left.popitem()
        if c < 2:
            done[a, b, c] = done.get((a, b, c), fmpq(0)) + number
            continue
        for e, sign in (((a, b, c - 2), 1), ((a + 2, b, c - 2), -1), ((a, b + 2, c - 2), -1)):
            left[e] = left.get(e, fmpq(0)) + sign * number
    return {e: c for e, c in done.items() if c}


def product(e: Sequence[int], m: Sequence[int]) -> Exponents:
    """Return the exponents of a product of monomials."""
    return tuple(x + y for x, y in zip(e, m))


def projected(f: Terms) -> fmpq_mpoly:
    """Return f (1 + x² + y²)ᵈ in the projection, where d is the degree of f."""
    degree = max(map(sum, f))
    return sum((c * 2 ** (a + b) * X**a * Y**b * (FLAT - 1) ** n * ROUND ** (degree - a - b - n)
                for (a, b, n), c in f.items()), PLANE.constant(0))


def lifted(f: fmpq_mpoly) -> dict[Exponents, fmpq]:
    """Return f (1 − k3)ⁿ with the least n for which that is a polynomial on the sphere.

    It is p + q k3 with p and q in k1 and k2. It is 1 − k3 times another polynomial if its product with 1 + k3
    is k1² + k2² = (1 − k3) (1 + k3) times another.
    """
    groups: dict[int, dict[tuple[int, int], fmpq]] = {}
    for (a, b), c in f.to_dict().items():
        groups.setdefault(int(a + b), {})[int(a), int(b)] = c
    p, q = PLANE.constant(0), PLANE.constant(0)
    for n in range(max(groups) + 1):                       # Horner, in 1 − k3
        p, q = p - q * (1 - FLAT) + PLANE.from_dict(groups.get(n, {})), q - p
    while True:
        above = p + q * (1 - FLAT), p + q
        if any(divmod(x, FLAT)[1] for x in above):
            return {(int(a), int(b), n): c for n, part in enumerate((p, q))
                    for (a, b), c in part.to_dict().items()}
        p, q = (x / FLAT for x in above)


def _above(x: Expr, y: Expr) -> tuple[Expr, ...]:
    """Return the point of the sphere over a point of the plane."""
    square = evaluate(x**2 + y**2, {})
    return tuple(evaluate(top / (square + 1), {}) for top in (2 * x, 2 * y, square - 1))
