"""Formulas as a person writes them: products kept, squares completed, denominators split."""
from typing import Any

from flint import fmpq_mpoly
from sympy import Add, Expr, ImmutableMatrix, Integer, Mul, Pow, S, Symbol

from .algebra import Ring, cancel
from .conditions import Condition
from .notation import ORDER


def inequality(condition: Condition) -> tuple[Expr, Expr]:
    """Left and right side of the condition: what is negative stands on the right, at E1 and E2 all but the square.

    Examples
    --------
    >>> from gyrostat import analyze, assemble, axial_potential, hanging, symmetric_gyrostat
    >>> report = analyze(hanging(assemble(symmetric_gyrostat(), axial_potential())))
    >>> inequality(report.sufficient.alternatives[0][0])
    ((l + pi3_0)**2, -4*I1*dU)
    """
    terms = Add.make_args(readable(condition.margin))
    squares = [term for term in terms if isinstance(term, Pow) and term.base.is_Add]
    if condition.at.is_number and len(terms) == 2 and len(squares) == 1:
        left = squares
    else:
        left = [term for term in terms if not term.could_extract_minus_sign()]
    return Add(*left), Add(*(-term for term in terms if term not in left))


def readable(expression: Expr) -> Expr:
    """The same fraction of polynomials, factored, with squares completed and coefficients collected."""
    if expression.is_Atom:
        return expression
    ring = Ring([expression])
    top, bottom = cancel(*ring.fraction(expression))
    return _quotient(ring, ring.reduce(top), bottom)


def entries(matrix: ImmutableMatrix) -> ImmutableMatrix:
    """The same matrix, each entry a sum over its different denominators, as in π3/I3 − (π3 + l)/I1."""
    return ImmutableMatrix(matrix.applyfunc(split))


def split(entry: Expr) -> Expr:
    """The same fraction of polynomials as a sum over its different denominators."""
    if entry.is_Atom:
        return entry
    ring = Ring([entry])
    top, bottom = cancel(*ring.fraction(entry))
    groups: dict[str, tuple[fmpq_mpoly, fmpq_mpoly]] = {}
    for exponents, coefficient in ring.reduce(top).to_dict().items():
        numerator, denominator = cancel(top.context().from_dict({exponents: coefficient}), bottom)
        scale = denominator.leading_coefficient()
        numerator, denominator = numerator / scale, denominator / scale
        groups[str(denominator)] = (groups.get(str(denominator), (ring.zero, ring.zero))[0] + numerator, denominator)
    return Add(*(_quotient(ring, *group) for group in groups.values()))


def _quotient(ring: Ring, top: fmpq_mpoly, bottom: fmpq_mpoly) -> Expr:
    if not top:
        return Add()
    factors = _factors(ring, top)
    return Mul(*factors, *(Pow(factor, -1) for factor in _factors(ring, bottom)))   # at once: −1·(a + b)/c stays a product


def _factors(ring: Ring, polynomial: fmpq_mpoly) -> list[Expr]:
    """The content, then the factors, each written as it reads best."""
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
    return [ring.expression(ring.one * content), *parts]


def _starts_negative(expression: Expr) -> bool:
    return expression.is_Add and min(expression.args, key=term_order).could_extract_minus_sign()


def _paired(factors: list[tuple[fmpq_mpoly, int]]) -> list[tuple[fmpq_mpoly, int]]:
    """Factors x − y and x + y as the one x² − y²."""
    result: list[tuple[fmpq_mpoly, int]] = []
    for f, n in factors:
        partner = next((g for g, m in result if m == int(n) and len(g) == len(f) == 2 and len(f * g) == 2), None)
        result = [(g, m) for g, m in result if g is not partner] + [(f if partner is None else f * partner, int(n))]
    return result


def _completed(ring: Ring, factor: fmpq_mpoly) -> Expr | None:
    """The polynomial with the square completed that leaves least, None where none makes it shorter."""
    best, found = len(factor), None
    for index, g in enumerate(ring.generators):
        if not isinstance(g, Symbol) or factor.degrees()[index] != 2:
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
    """Collected by the monomials in everything but k3 and the moments of inertia."""
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
        terms.append(Mul(ring.expression(ring.one * content), ring.monomial(kind), *parts))
    return Add(*terms)


def term_order(term: Expr) -> tuple[int, ...]:
    """Where a term stands in a sum: constants, then momenta, rates, parameters, k and U, as in notation.py."""
    symbols = {s for s in term.free_symbols if not s.is_positive} or term.free_symbols
    return tuple(sorted(ORDER.get(s.name, len(ORDER)) for s in symbols))


def ordered_terms(expression: Add) -> list[Expr]:
    """The terms of a sum as they are written, a positive one first."""
    terms = sorted(expression.args, key=lambda t: (not t.free_symbols, term_order(t)))
    first = next((t for t in terms if not t.could_extract_minus_sign()), terms[0])
    return [first, *(t for t in terms if t is not first)]


def ordered_factors(product: Expr) -> list[Expr]:
    """The factors of a product as they are written: numbers, moments, symbols as in the notation, sums from short to long."""
    def key(factor: Expr) -> tuple[Any, ...]:
        base = factor.base if isinstance(factor, Pow) else factor
        inertia = all(s.is_positive for s in factor.free_symbols)
        size = len(base.free_symbols) if base.is_Add else not inertia
        return not factor.is_number, base.is_Add, not (base.is_Add or base.is_Symbol), size, term_order(factor)

    factors = [f for f in Mul.make_args(product) if f != 1]
    roots = [f for f in factors if isinstance(f, Pow) and f.exp == S.Half]
    if len(roots) > 1:                                     # √a √b reads better as √(a b)
        factors = [f for f in factors if f not in roots] + [Pow(Mul(*(r.base for r in roots)), S.Half, evaluate=False)]
    return sorted(factors, key=key)


def over(product: Expr) -> tuple[Expr, Expr]:
    """Numerator and denominator of a product, as they stand."""
    c, rest = product.as_coeff_Mul()
    if not c.is_Rational:
        c, rest = S.One, product
    parts = Mul.make_args(rest)
    below = [f for f in parts if isinstance(f, Pow) and f.exp.is_Rational and f.exp < 0]
    above = [Integer(c.p), *(f for f in parts if f not in below)]
    return _product(above), _product([Integer(c.q), *(1 / f for f in below)])


def _product(factors: list[Expr]) -> Expr:
    """The product without distributing a number over a sum."""
    factors = [f for f in factors if f != 1]
    return factors[0] if len(factors) == 1 else Mul(*factors, evaluate=False) if factors else S.One
