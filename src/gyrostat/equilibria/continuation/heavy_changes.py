"""Algebraic numbers at which the stability of a permanent rotation in a field may change, by resultants."""
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

from flint import fmpq_mpoly
from sympy import Expr, Matrix, Symbol

from ...algebra.reals.number_fields import in_one
from ...algebra.rings.matrices import adjugate, cross
from ...algebra.rings.polynomials import Ring, by_degree, cancel
from ...algebra.solving.plane_curves import PlaneCurve
from ...algebra.solving.roots import roots_of_polynomial
from ...stability.criteria.amended_form import dot, with_multiplier
from ...stability.spectrum import conditions
from ..finders.heavy_polynomials import DIRECTION
from .pencil_branches import Pencil

SINGULAR, FREQUENCIES = "singular form", "frequencies meet"
ALONG = Symbol("along")                                    # the part of k in a kernel
Vector = list[fmpq_mpoly]


class Direction(NamedTuple):
    """The direction k = (across + ALONG kernel)/under on a component of a curve.

    It is that of one rotation (kernel = 0), or of two.
    """

    across: Vector
    kernel: Vector
    under: fmpq_mpoly

    @property
    def infinite(self) -> Vector:
        """What vanishes where this direction says nothing about two rotations."""
        return [self.under, dot(self.kernel, self.kernel)] if any(self.kernel) else []

    @property
    def rest(self) -> fmpq_mpoly:
        """ALONG² kernel², by abs(k) = 1."""
        return self.under**2 - dot(self.across, self.across)


def changes(curve: PlaneCurve, pencil: Pencil, inertia: Matrix, rotor: Matrix, curved: Matrix,
            omega: Expr) -> Iterator[tuple[Expr, str]]:
    """Yield (value, kind) where q or the discriminant p² − 4q of the spectrum may vanish on a curve.

    q has the sign of the determinant of the second variation. With p and q as polynomials in k, sigma and the
    name, and k that of the component F = 0 in sigma and the name, these values are roots of a resultant with
    F.

    Parameters
    ----------
    curve : PlaneCurve
        abs(adj(N) b)² = det(N)², of sigma over the name
    pencil : Pencil
        N and b
    inertia, rotor, curved : Matrix
        I, l, and Q of U = c·k + k·Qk/2
    omega : Expr
    """
    form = with_multiplier(inertia.tolist(), list(rotor), -pencil.x, curved.tolist(), DIRECTION, omega)
    whole = inertia.det(method="berkowitz")
    scaled = form.p * whole, form.q * whole**2, form.trace * dot(DIRECTION, inertia * Matrix(DIRECTION))
    ring = Ring([*scaled, *pencil.matrix, *pencil.vector, pencil.x, curve.t, ALONG, *DIRECTION])
    p, q, trace = (top / bottom for top, bottom in (cancel(*ring.fraction(e)) for e in scaled))
    sigma, t = (ring.generators.index(x) for x in (pencil.x, curve.t))
    for component in curve.components:
        F = ring.numerator(curve.ring.expression(component))
        for k in _directions(ring, pencil, F, sigma):
            P, Q = _inserted(ring, p, k, 2), _inserted(ring, q, k, 4)
            form = _norm(ring, Q, k)
            if not divmod(form, F)[1]:                     # as on circles: the trace decides
                form = _norm(ring, _inserted(ring, trace, k, 4), k)
            gap = _norm(ring, conditions((ring.one, P, Q))[-1], k)
            for kind, G in ((SINGULAR, form), (FREQUENCIES, gap), *((SINGULAR, x) for x in k.infinite)):
                if divmod(G, F)[1]:
                    resultant = F.resultant(G, str(F.context().names()[sigma]))
                    yield from ((root, kind) for root in roots_of_polynomial(in_one(resultant, t)))


def _directions(ring: Ring, pencil: Pencil, F: fmpq_mpoly, sigma: int) -> Iterator[Direction]:
    """Yield k on F = 0: adj(N) b/det N, or any part in the kernel of N if b has none in it.

    The second holds if N has a kernel at every value on the component.
    """
    N = [[ring.numerator(x) for x in row] for row in pencil.matrix.tolist()]
    b = [ring.numerator(x) for x in pencil.vector]
    minors = adjugate(N)
    above, below, order = [dot(row, b) for row in minors], dot([row[0] for row in N], minors[0]), 0
    while not divmod(below, F)[1]:
        if any(divmod(x, F)[1] for x in above):
            return                                         # b has a part in the kernel: there are none
        above, below, order = [x.derivative(sigma) for x in above], below.derivative(sigma), order + 1
    axes = [[ring.one * (n == m) for m in range(3)] for n in range(3)]
    kernels: dict[int, Sequence[Any]] = {
        0: [[ring.zero] * 3], 1: minors, 2: [cross(row, e) for row in N for e in axes], 3: axes}
    yield Direction(above, next(e for e in kernels[order] if not order or divmod(dot(e, e), F)[1]), below)


def _inserted(ring: Ring, polynomial: fmpq_mpoly, k: Direction, degree: int) -> fmpq_mpoly:
    """Insert k into a polynomial of a degree in k, times that power of what is under k."""
    places, s = [ring.generators.index(x) for x in DIRECTION], ring.gens[ALONG]
    parts = [[(x + s * e) ** n for n in range(degree + 1)] for x, e in zip(k.across, k.kernel)]
    under = [k.under**n for n in range(degree + 1)]
    found = ring.coefficients(polynomial, set(DIRECTION)).items()
    return sum((c * parts[0][i] * parts[1][j] * parts[2][m] * under[degree - i - j - m]
                for powers, c in found for i, j, m in [[powers[n] for n in places]]), ring.zero)


def _norm(ring: Ring, margin: fmpq_mpoly, k: Direction) -> fmpq_mpoly:
    """Return what vanishes where the margin does for either sign of ALONG, or k is not finite."""
    if not k.infinite:
        return margin
    place, size = ring.generators.index(ALONG), dot(k.kernel, k.kernel)
    parts = by_degree(margin, place, margin.degrees()[place])
    even, odd = (sum((c * k.rest**n * size ** (len(parts) // 2 - n) for n, c in enumerate(parts[side::2])),
                     ring.zero) for side in (0, 1))
    return size * even**2 - k.rest * odd**2 if odd else even
