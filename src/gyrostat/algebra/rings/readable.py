"""Writes formulas as a person does: products kept, squares completed, denominators split."""
from functools import lru_cache

from flint import fmpq_mpoly
from sympy import Add, Expr, ImmutableMatrix, Mul, Pow, Symbol

from ...notation import order
from ..enclosures.rationals import to_sympy
from .polynomials import Ring, cancel
from .rational_functions import RationalFunction


@lru_cache(maxsize=1024)
def readable(expression: Expr) -> Expr:
    """Return the same fraction of polynomials factored, with squares completed and terms collected."""
    if expression.is_Atom:
        return expression
    ring = Ring([expression])
    top, bottom = cancel(*ring.fraction(expression))
    return _quotient(ring, ring.reduce(top), bottom)


def entries(matrix: ImmutableMatrix) -> ImmutableMatrix:
    """Return the same matrix, each entry a sum over its denominators, as in π3/I3 − (π3 + l)/I1."""
    return ImmutableMatrix(matrix.applyfunc(split))


@lru_cache(maxsize=1024)
def split(entry: Expr) -> Expr:
    """Return the same fraction of polynomials as a sum over its different denominators."""
    if entry.is_Atom:
        return entry
    ring = Ring([entry])
    top, bottom = cancel(*ring.fraction(entry))
    groups: dict[str, tuple[fmpq_mpoly, fmpq_mpoly]] = {}
    for exponents, coefficient in ring.reduce(top).to_dict().items():
        part = RationalFunction(top.context().from_dict({exponents: coefficient}), bottom)
        known, _ = groups.get(str(part.bottom), (ring.zero, ring.zero))
        groups[str(part.bottom)] = known + part.top, part.bottom
    return Add(*(_quotient(ring, *group) for group in groups.values()))


def _quotient(ring: Ring, top: fmpq_mpoly, bottom: fmpq_mpoly) -> Expr:
    if not top:
        return Add()
    factors = _factors(ring, top)
    # at once: −1·(a + b)/c stays a product
    return Mul(*factors, *(Pow(factor, -1) for factor in _factors(ring, bottom)))


def _factors(ring: Ring, polynomial: fmpq_mpoly) -> list[Expr]:
    """Return the content, then the factors, each written as it reads best."""
    content, factors = polynomial.factor()
    parts = []
    for f, n in _paired(factors):
        squared = _completed(ring, f)
        part = squared if squared is not None else _collected(ring, f)
        if squared is None and (turned := _completed(ring, -f)) is not None:
            part, content = turned, content * (-1) ** n
        elif squared is None and _starts_negative(part):
            part, content = _collected(ring, -f), content * (-1) ** n
        parts.append(Pow(part, n))
    return [to_sympy(content), *parts]


def _starts_negative(expression: Expr) -> bool:
    return expression.is_Add and min(expression.args, key=term_order).could_extract_minus_sign()


def _paired(factors: list[tuple[fmpq_mpoly, int]]) -> list[tuple[fmpq_mpoly, int]]:
    """Multiply factors x − y and x + y into the one x² − y²."""
    result: list[tuple[fmpq_mpoly, int]] = []
    for f, n in factors:
        partner = next((g for g, m in result if m == int(n) and len(g) == len(f) == 2 and len(f * g) == 2),
                       None)
        result = [(g, m) for g, m in result if g is not partner]
        result.append((f if partner is None else f * partner, int(n)))
    return result


def _completed(ring: Ring, factor: fmpq_mpoly) -> Expr | None:
    """Complete the square that leaves least; None if none makes the polynomial shorter."""
    best, found = len(factor), None
    for index, (g, degree) in enumerate(zip(ring.generators, factor.degrees())):
        if degree != 2 or not isinstance(g, Symbol):
            continue
        slope = factor.derivative(index)
        lead = slope.derivative(index)                     # twice the coefficient of g²
        root, left = divmod(slope, lead)
        if left or len(root) == 1 or len(lead) > 1:
            continue
        rest = factor - lead * root**2 / 2
        size = len(root) + sum(len(f) for f, _ in rest.factor()[1] if len(f) > 1) - 1
        if size < best:
            best, found = size, (lead / 2, root, rest)
    if found is None:
        return None
    square = Mul(ring.expression(found[0]), Pow(_collected(ring, found[1]), 2))
    return Add(square, _quotient(ring, found[2], ring.one))


def _collected(ring: Ring, polynomial: fmpq_mpoly) -> Expr:
    """Collect by the monomials in everything but k3 and positive symbols, such as moments of inertia."""
    moving = {s for g in ring.generators for s in g.free_symbols if not s.is_positive and s.name != "k3"}
    terms = []
    for kind, coefficient in ring.coefficients(polynomial, moving).items():
        content, factors = coefficient.factor()
        parts = []
        for f, n in _paired(factors):
            part = ring.expression(f)
            turned = _starts_negative(part)
            parts.append(Pow(-part if turned else part, n))
            content *= (-1) ** n if turned else 1
        terms.append(Mul(to_sympy(content), ring.monomial(kind), *parts))
    return Add(*terms)


@lru_cache(maxsize=4096)
def term_order(term: Expr) -> tuple[tuple[int, str, int], ...]:
    """Return the key that says where a term stands in a sum.

    Constants come first, then momenta, rates, parameters, k and U, as in notation.py.
    """
    symbols = {s for s in term.free_symbols if not s.is_positive} or term.free_symbols
    return tuple(sorted(order(s.name) for s in symbols))
