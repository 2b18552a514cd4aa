"""Turns under which a function of degree 2 on the rotations stays, and the function of a unit vector left."""
from collections.abc import Sequence
from typing import NamedTuple

from flint import fmpq, fmpq_mat, fmpq_mpoly, fmpz_mat
from sympy import Expr, Matrix, Rational, S

from ..enclosures.rationals import to_sympy
from .boxes import TURNS, turned
from .quartic_forms import FRAME, NORM, Form, QuarticForm, monomials

# i q, j q and k q, which turn the frame, as TURNS the body
FRAME_TURNS = (((1, -1), (0, 1), (3, -1), (2, 1)), ((2, -1), (3, 1), (0, 1), (1, -1)),
               ((3, -1), (2, -1), (1, 1), (0, 1)))


class Turning(NamedTuple):
    """A turn of the body about an axis in it, and of the frame about an axis, at rates as the vectors say."""

    body: Sequence[int]
    frame: Sequence[int]


class OnSphere(NamedTuple):
    """A function u·Qu + s b·u of a unit vector u, but for a constant and a factor; Q and b are rational."""

    quadratic: Matrix
    linear: Matrix
    scale: Expr


def symmetries(form: QuarticForm) -> list[Turning]:
    """Return a basis of all turns under which a function on the rotations stays; none if there are none.

    Its factors are independent over the rational numbers, so that each of its forms stays. A basis is in
    lowest terms: a turn of the body alone and one of the frame alone are in it if both are symmetries.

    Examples
    --------
    >>> from .quartic_forms import quartic
    >>> disc = {(0, 0, 0, 0, 0, 2): 3, (0, 0, 2, 0, 0, 0): -1}
    >>> symmetries(QuarticForm(quartic(disc)))
    [Turning(body=(0, 0, 1), frame=(0, 0, 0))]
    """
    rows = [[f.get(e, 0) for f in several] for part in (form.whole, *(f for _, f in form.parts))
            for several in [[turned(part, turn) for turn in (*TURNS, *FRAME_TURNS)]]
            for e in monomials(4)]
    kernel, count = fmpz_mat(rows).nullspace()
    basis, _ = fmpq_mat(fmpz_mat([[kernel[i, n] for i in range(6)] for n in range(count)])).rref() if count \
        else (fmpq_mat(0, 6), 0)
    found = []
    for n in range(count):
        row = [basis[n, i] for i in range(6)]
        whole = fmpq_mat(1, 6, row).numer_denom()[0].entries()
        found.append(Turning(tuple(map(int, whole[:3])), tuple(map(int, whole[3:]))))
    return found


def on_sphere(form: QuarticForm, turning: Turning) -> OnSphere | None:
    """Return the function as one of the unit vector along the axis of a symmetry of the body, or the frame.

    Its components are those in the frame, or in the body. None if more than one irrational factor is left.
    """
    of_body = any(turning.body)
    c = turning.body if of_body else turning.frame
    Z = [sum((x * (FRAME[i][j] if of_body else FRAME[j][i]) for j, x in enumerate(c)), 0 * NORM)
         for i in range(3)]
    pairs = [(i, j) for i in range(3) for j in range(i, 3)]
    columns = [_entries(f) for f in (*(Z[i] * Z[j] for i, j in pairs), *(x * NORM for x in Z))]
    square = sum(x * x for x in c)
    found = []
    for factor, part in ((S.One, form.whole), *form.parts):
        solved, _ = fmpq_mat([*zip(*columns, [fmpq(part.get(e, 0)) for e in monomials(4)])]).rref()
        values = [to_sympy(solved[n, 9]) for n in range(9)]
        Q = Matrix(3, 3, lambda i, j, v=values: v[pairs.index((min(i, j), max(i, j)))] / (1 + (i != j)))
        found.append((factor, Q, Matrix(values[6:])))
    (_, Q, b), *others = found
    linear = [(factor, b) for factor, _, b in found if any(b)] or [(S.One, b)]
    if len(linear) > 1 or any(any(part) for _, part, _ in others):
        return None
    (factor, b), = linear
    return OnSphere(Q, b, factor / S(square) ** Rational(1, 2))


def _entries(form: fmpq_mpoly) -> list[fmpq]:
    known: Form = {(a, b, c, d): x for (a, b, c, d), x in form.to_dict().items()}
    return [known.get(e, fmpq(0)) for e in monomials(4)]
