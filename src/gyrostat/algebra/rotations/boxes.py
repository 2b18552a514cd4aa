"""Critical points of a quartic form on N = q·q = 1: approximated all at once, and enclosed one by one."""
from collections.abc import Sequence
from typing import Any

from flint import acb, acb_mat, arb, arb_mat, ctx

from .bounds import DEGREE, Bound, times_line, times_norm
from .quartic_forms import Exponents, Form, QuarticForm, minors, monomials, moved, multiples, slopes

# along which the body turns: −b, a, d, −c, as pairs of a place and a sign, and two others
TURNS = (((1, -1), (0, 1), (3, 1), (2, -1)), ((2, -1), (3, -1), (0, 1), (1, 1)),
         ((3, -1), (2, 1), (1, -1), (0, 1)))
STEPS = 12                                             # of Newton's method, at most


def approximated(form: QuarticForm, bound: Bound) -> list[list[acb]]:
    """Return approximations of all critical points, at the precision that is set; none is proved.

    The functionals of the bound span the evaluations at the points. On ℓ f and ℓ' f they give two matrices,
    whose ratio has the eigenvalues ℓ/ℓ' at the points; eigenvectors give the values of all monomials there.
    """
    matrix, free = multiples(minors(form.enclosed()), DEGREE, 4), bound.free
    square = arb_mat([[matrix[n][column] for column in bound.solved] for n in bound.rows])
    known = arb_mat([[-matrix[n][column] for column in free] for n in bound.rows])
    solved = square.solve(known, algorithm="approx").mid().tolist()
    one, zero = arb(1), arb(0)
    functionals = [[zero] * len(free) for _ in matrix[0]]
    for column, row in zip(bound.solved, solved):
        functionals[column] = row
    for n, column in enumerate(free):
        functionals[column] = [one if n == m else zero for m in range(len(free))]
    degree = DEGREE
    if bound.beyond:
        functionals, degree = times_norm(functionals, degree), degree - 2
    above, below = (arb_mat(times_line(functionals, degree, line, bound.lower)) for line in bound.lines)
    ratio = below.solve(above, algorithm="approx").mid()
    vectors = acb_mat(ratio).eig(right=True, algorithm="approx")[1]
    places = monomials(degree)
    rows = [[places[moved(moved((0, 0, 0, 0), i, degree - 1), j, 1)] for j in range(4)] for i in range(4)]
    values = (acb_mat([functionals[n] for row in rows for n in row]) * vectors).mid().tolist()
    found = []
    for point in zip(*values):
        largest = max(range(4), key=lambda i: float(abs(point[5 * i]).mid()))
        found.append(list(point[4 * largest:4 * largest + 4]))
    return found


class CriticalEquations:
    """The four equations of critical points: three torques, derivatives of F along turns, and N = 1.

    Parameters
    ----------
    form : QuarticForm
    """

    def __init__(self, form: QuarticForm):
        self._form = form
        self._found: dict[int, tuple[acb_mat, acb_mat]] = {}

    @property
    def _matrices(self) -> tuple[acb_mat, acb_mat]:
        """The coefficients of the torques, and of their derivatives, at the precision that is set."""
        if ctx.prec not in self._found:
            torques = [turned(self._form.enclosed(), turn) for turn in TURNS]
            bends = [g for f in torques for g in slopes(f)]
            self._found[ctx.prec] = (acb_mat([[acb(f.get(e, 0)) for e in monomials(4)] for f in torques]),
                                     acb_mat([[acb(g.get(e, 0)) for e in monomials(3)] for g in bends]))
        return self._found[ctx.prec]

    def enclosed(self, near: Sequence[acb]) -> list[acb] | None:
        """Return balls with one zero in them, which is near, and simple; None if none is proved.

        References
        ----------
        Krawczyk, Computing 4 (1969) 187-201; Rump, Acta Numerica 19 (2010) 287-449, §13.
        """
        q = list(near)
        small = arb(2) ** (-3 * ctx.prec // 4)
        for _ in range(STEPS):
            try:
                step = self._jacobian(q).solve(self._residual(q), algorithm="approx").mid().entries()
            except ZeroDivisionError:
                return None
            q = [(a - b).mid() for a, b in zip(q, step)]
            if all(abs(x) < small for x in step):
                return self._proved(q)
        return None

    def _proved(self, q: Sequence[acb]) -> list[acb] | None:
        """Return Krawczyk's image of a box around q, if it is in its interior."""
        try:
            inverse = self._jacobian(q).mid().inv().mid()
        except ZeroDivisionError:
            return None
        one = acb_mat([[int(i == j) for j in range(4)] for i in range(4)])
        real = all(x.imag.is_zero() for x in q)
        width = arb(0, arb(2) ** (-ctx.prec // 2))
        ball = acb(width) if real else acb(width, width)
        box = [x + ball for x in q]
        moved = (one - inverse * self._jacobian(box)) * acb_mat([[ball]] * 4) - inverse * self._residual(q)
        image = [x + y for x, y in zip(q, moved.entries())]
        inside = all(a.real.contains_interior(b.real) and (real or a.imag.contains_interior(b.imag))
                     for a, b in zip(box, image))
        return image if inside else None

    def _residual(self, q: Sequence[acb]) -> acb_mat:
        values = (self._matrices[0] * _column(q, 4)).entries()
        return acb_mat([[x] for x in (*values, sum((x * x for x in q), acb(-1)))])

    def _jacobian(self, q: Sequence[acb]) -> acb_mat:
        entries = (self._matrices[1] * _column(q, 3)).entries()
        return acb_mat(4, 4, [*entries, *(2 * x for x in q)])


def _column(q: Sequence[acb], degree: int) -> acb_mat:
    """Return the values of all monomials of a degree."""
    powers = [[acb(1)] for _ in q]
    for x, several in zip(q, powers):
        for _ in range(degree):
            several.append(several[-1] * x)
    w, x, y, z = powers
    return acb_mat([[w[a] * x[b] * (y[c] * z[d])] for a, b, c, d in monomials(degree)])


def turned(form: Form, turn: Sequence[tuple[int, int]]) -> dict[Exponents, Any]:
    """Return the derivative of a form along q → q + Σ ± q_j e_i."""
    found: dict[Exponents, Any] = {}
    for slope, (j, sign) in zip(slopes(form), turn):
        for e, c in slope.items():
            place = moved(e, j, 1)
            found[place] = found.get(place, 0) + sign * c
    return found
