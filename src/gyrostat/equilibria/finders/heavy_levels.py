"""Finds the permanent rotations of any body in a field on a level of C1 = M·k, by resultants.

They are the critical points of the amended potential U_c.
"""
from collections.abc import Iterator, Sequence
from functools import cache, reduce
from typing import Any

from flint import arb, arb_mat, fmpq_mpoly
from sympy import Expr, Matrix, Rational, S, Symbol, sqrt

from ...algebra.enclosures.balls import ball
from ...algebra.enclosures.precision import own_precision
from ...algebra.pencils.exact_points import points_on_sphere
from ...algebra.reals.exact import evaluate, proved_sign
from ...algebra.reals.number_fields import at_root, divided
from ...algebra.rings.matrices import determinant
from ...algebra.rings.polynomials import Ring
from ...algebra.solving.common_points import CommonPoints
from ...algebra.solving.real_fields import FieldNumbers
from ...algebra.solving.roots import real_roots, roots_of_factor
from ...errors import ScopeError
from .level_rates import EPSILON, OMEGA, SIGMA, Field, LevelZeros, at_rate, in_omega, nothing_at, placed

PRECISION = 512                                            # bits
UNTOLD = "the rotations on that level of C1 are not told apart by omega"
Found = tuple[Expr, Sequence[Expr], tuple[Expr, ...] | None]


def rates_on_level(inertia: Matrix, curved: Matrix, linear: Matrix, rotor: Matrix, level: Expr
                   ) -> Iterator[Found]:
    """Yield omega, k and the axis of a circle, if any, of N k = b, k·k = 1 and C1 = omega k·Ik + l·k.

    N = omega² I − Q + sigma and b = c − omega l, where U = c·k + k·Qk/2. If det N ≠ 0, the solutions are the
    common roots of two polynomials F and G in omega and sigma; omega is a root of their resultant in sigma,
    R, which by Poisson's formula is a power of the leading coefficient of F times Π G(α) over the roots α of
    F. If G vanishes at one root α alone, the derivatives of R in epsilon for G + epsilon sigma and G +
    epsilon have the ratio α: so sigma and k are rational in omega. The omega at which det N = 0 and b has no
    part in the kernel are roots of R too, several times: there k·k = 1 and C1 are looked at on the kernel.

    Raises
    ------
    ScopeError
        a number is not rational, or the rotations of one omega are not told apart: heavy_polynomials has them
    """
    numbers = [*inertia, *curved, *linear, *rotor, level]
    if not all(isinstance(x, Rational) for x in numbers):
        raise ScopeError("a number is not rational")
    yield from _with_parts_along(Field(inertia, curved, linear, rotor, level), [0, 1, 2])


def _with_parts_along(field: Field, axes: list[int]) -> Iterator[Found]:
    """Yield the rotations with k in the span of some axes, in a plane of symmetry or not."""
    I, Q, c, l, _ = field

    def symmetric(n: int) -> bool:
        return not (c[n] or l[n] or any(I[n, m] or Q[n, m] for m in range(3) if m != n))

    n = next((n for n in axes if symmetric(n)), None)
    if n is None:
        yield from _in_span(field, axes)
        return
    others = [m for m in axes if m != n]
    yield from _with_parts_along(field, others)
    yield from _across(field, n, others)


def _across(field: Field, n: int, others: list[int]) -> Iterator[Found]:
    """Yield the rotations with a part along an axis of symmetry."""
    part, moment = field.along(others), field.inertia[n, n]
    placed = part.pencil.xreplace({SIGMA: field.curved[n, n] - OMEGA**2 * moment})
    above, below = placed.adjugate() * part.vector, placed.det(method="berkowitz").expand()
    if (singular := real_roots(below, OMEGA)) is None:
        raise ScopeError(UNTOLD)
    for root in singular:
        if all(proved_sign(evaluate(x, {OMEGA: root})) == 0 for x in above):
            yield from (found for found in _one_by_one(field, root, others + [n]) if found[1][n] != 0)
    rest = [x / below for x in above]
    a = Matrix(rest)
    twist = OMEGA * (a.dot(part.inertia * a) + moment * (1 - a.dot(a))) + part.rotor.dot(a) - field.level
    if (roots := real_roots(twist, OMEGA)) is None:
        raise ScopeError(UNTOLD)
    for root in roots:
        if proved_sign(square := evaluate(1 - a.dot(a), {OMEGA: root})) == 1:
            inside = dict(zip(others, (evaluate(x, {OMEGA: root}) for x in rest)))
            for t in (sqrt(square), -sqrt(square)):
                yield root, tuple(t if m == n else inside.get(m, S.Zero) for m in range(3)), None


def _in_span(field: Field, axes: list[int]) -> Iterator[Found]:
    """Yield the rotations with k in the span of axes without a plane of symmetry."""
    part, size = field.along(axes), range(len(axes))
    inertia, curved, linear, rotor, level = part.in_flint
    ring = Ring([OMEGA, SIGMA, EPSILON])
    omega, sigma, epsilon = (ring.gens[x] for x in (OMEGA, SIGMA, EPSILON))
    pencil = [[omega**2 * inertia[i][j] - curved[i][j] + sigma * int(i == j) for j in size] for i in size]
    vector = [c - omega * l for c, l in zip(linear, rotor)]
    # N k = b by Cramer's rule
    above = [determinant(ring, [[*row[:n], b, *row[n + 1:]] for row, b in zip(pencil, vector)]) for n in size]
    below = determinant(ring, pencil)
    shared = reduce(lambda f, g: f.gcd(g), above, below)   # as with two equal moments
    above, below = [x / shared for x in above], below / shared
    if below.gcd(shared) != shared:
        raise ScopeError(UNTOLD)

    def total(parts: Any) -> fmpq_mpoly:
        return sum(parts, ring.zero)

    length = total(x**2 for x in above) - below**2
    moment = omega * total(inertia[i][j] * above[i] * above[j] for i in size for j in size)
    moment += below * total(l * x for l, x in zip(rotor, above)) - level * below**2
    moment += level * -length                              # 0 with length: lowers the degree in sigma
    place, name = ring.generators.index(EPSILON), str(length.context().names()[ring.generators.index(SIGMA)])
    if not moment or not moment.degrees()[ring.generators.index(SIGMA)]:
        raise ScopeError(UNTOLD)
    met = CommonPoints(moment, length, ring.generators.index(SIGMA), ring.generators.index(OMEGA))
    if met.degree < 0:
        raise ScopeError(UNTOLD)

    @cache
    def changed() -> list[fmpq_mpoly]:
        return [length.resultant(moment + epsilon * x, name).derivative(place) for x in (1, sigma, sigma + 1)]

    for factor, _ in (f for product in (met.simple, *met.multiple) for f in product.factor()[1]):
        if factor.degree() > 1 and not met.simple % factor:
            zeros = LevelZeros(met, factor, ring, above, below, changed, axes)
            if zeros.told:
                yield from ((root, FieldNumbers(zeros, n, [(m, S.One) for m in range(3)]), None)
                            for n, root in enumerate(zeros.rates))
                continue
        if factor.degree() == 1 and met.simple % factor and shared.is_constant() and nothing_at(
                part, -factor[0] / factor[1], *(at_rate(ring, x, -factor[0] / factor[1])
                                                for x in (length, moment))):
            continue
        if not (roots := roots_of_factor(factor)):
            continue
        # if G vanishes at two roots α and β, the second derivatives give α β and (α + 1)(β + 1)
        twice = [in_omega(ring, x.derivative(place)) for x in changed()]
        if factor.degree() > 1 and twice[0] % factor:
            product, both = divided(twice[1:], twice[0], factor)
            s = (both - product - 1) / 2
            if not any(placed(ring, x, s, factor) for x in (below, *above)) and not any(
                    _may_turn(part, root, at_root(s, root)) for root in roots):
                continue
        for root in roots:
            yield from _one_by_one(field, root, axes)


def _one_by_one(field: Field, root: Expr, axes: list[int]) -> Iterator[Found]:
    """Yield those of all rotations of a rate that are on the level with k in the span of some axes."""
    if not isinstance(root, Rational):
        raise ScopeError(UNTOLD)
    here = {OMEGA: root}
    for numbers, circle in points_on_sphere(field.pencil.xreplace(here), field.vector.xreplace(here), S.One,
                                            SIGMA):
        at = Matrix(k := tuple(numbers[1:]))
        if circle is not None and not _on_one_level(field, root, at, Matrix(circle)):
            raise ScopeError(UNTOLD)
        value = root * at.dot(field.inertia * at) + field.rotor.dot(at)
        if proved_sign(evaluate(value - field.level, {})) == 0 and not any(
                proved_sign(k[n]) for n in range(3) if n not in axes):
            yield root, k, circle


def _on_one_level(field: Field, root: Rational, k: Matrix, axis: Matrix) -> bool:
    """Tell whether C1 is the same on the whole circle of k about an axis; it is not for the axis 0."""
    inertia, rotor = field.inertia, field.rotor
    across = k * axis.dot(axis) - axis * axis.dot(k)
    other = axis.cross(across)
    turned = [rotor.dot(across), rotor.dot(other), *(root * x for x in (
        axis.dot(inertia * across), axis.dot(inertia * other), across.dot(inertia * other),
        across.dot(inertia * across) * axis.dot(axis) - other.dot(inertia * other)))]
    return any(axis) and not any(proved_sign(evaluate(x, {})) for x in turned)


def _may_turn(part: Field, root: Expr, sigma: Expr) -> bool:
    """Tell whether a solution is not excluded if det N = 0 and b has no part in the kernel, spanned by e.

    The solutions are k = a ± t e with (N + e eᵀ) a = b. This matrix is invertible, and since b ⟂ e, so is a ⟂
    e and N a = b.
    """
    with own_precision(PRECISION):
        at = {OMEGA: ball(root, PRECISION), SIGMA: ball(sigma, PRECISION)}
        N, adjugate = (_enclosed(m, at) for m in (part.pencil, part.pencil.adjugate()))
        b, I, l = (_enclosed(m, at) for m in (part.vector, part.inertia, part.rotor))
        size = range(len(part.linear))
        n = max(size, key=lambda n: abs(adjugate[n, n]).lower())
        if not abs(adjugate[n, n]) > 0:
            return True
        e = arb_mat([[adjugate[m, n]] for m in size])
        across = (N + e * e.transpose()).solve(b)
        rest = (1 - (across.transpose() * across)[0, 0]) / (e.transpose() * e)[0, 0]
        if rest < 0:
            return False
        places = [across + e * (side * rest.sqrt()) for side in (1, -1)]
        return any((at[OMEGA] * (k.transpose() * I * k)[0, 0] + (l.transpose() * k)[0, 0]
                    - ball(part.level, PRECISION)).contains(0) for k in places)


def _enclosed(matrix: Matrix, at: dict[Symbol, arb]) -> arb_mat:
    return arb_mat([[ball(x, PRECISION, at) for x in row] for row in matrix.tolist()])
