"""Orders terms, factors and the two sides of an inequality as they are written."""
from typing import Any

from sympy import Add, Expr, Float, Integer, Mul, Pow, S

from ..algebra.rings.readable import readable, term_order
from ..stability.criteria.conditions import Condition


def inequality(condition: Condition) -> tuple[Expr, Expr]:
    """Give the left and the right side of a condition.

    Negative terms stand on the right; at E1 and E2 all terms but the square do.

    Examples
    --------
    >>> import gyrostat as gs
    >>> report = gs.analyze(gs.hanging(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())))
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


def ordered_terms(expression: Add) -> list[Expr]:
    """Order the terms of a sum as they are written, a positive one first; with decimals by their degrees."""
    terms = sorted(expression.args, key=lambda t: (not t.free_symbols, term_order(t)))
    if expression.has(Float):
        terms.sort(key=lambda t: -sum(f.as_base_exp()[1] for f in Mul.make_args(t) if f.free_symbols))
    first = next((t for t in terms if not t.could_extract_minus_sign()), terms[0])
    return [first, *(t for t in terms if t is not first)]


def signed(terms: list[str], minus: str) -> str:
    """Join written terms to a sum; terms with a minus are subtracted."""
    text = terms[0]
    for term in terms[1:]:
        if term.startswith(minus):
            text += f" {minus} {term.removeprefix(minus).lstrip()}"
        else:
            text += f" + {term}"
    return text


def ordered_factors(product: Expr) -> list[Expr]:
    """Order the factors of a product as they are written.

    Numbers come first, then moments, symbols as in the notation, and sums from short to long.
    """
    def key(factor: Expr) -> tuple[Any, ...]:
        base = factor.base if isinstance(factor, Pow) else factor
        inertia = all(s.is_positive for s in factor.free_symbols)
        size = len(base.free_symbols) if base.is_Add else not inertia
        return not factor.is_number, base.is_Add, not (base.is_Add
                                                       or base.is_Symbol), size, term_order(factor)

    factors = [f for f in Mul.make_args(product) if f != 1]
    roots = [f for f in factors if isinstance(f, Pow) and f.exp == S.Half]
    if len(roots) > 1:                                     # √a √b reads better as √(a b)
        factors = [f for f in factors if f not in roots] + [Pow(Mul(*(r.base for r in roots)), S.Half,
                                                                evaluate=False)]
    return sorted(factors, key=key)


def over(product: Expr) -> tuple[Expr, Expr]:
    """Split a product into numerator and denominator, as they stand."""
    c, rest = product.as_coeff_Mul()
    if not c.is_Rational:
        c, rest = S.One, product
    parts = Mul.make_args(rest)
    below = [f for f in parts if isinstance(f, Pow) and f.exp.is_Rational and f.exp < 0]
    above = [Integer(c.p), *(f for f in parts if f not in below)]
    return _product(above), _product([Integer(c.q), *(1 / f for f in below)])


def _product(factors: list[Expr]) -> Expr:
    """Multiply without distributing a number over a sum."""
    factors = [f for f in factors if f != 1]
    if not factors:
        return S.One
    return factors[0] if len(factors) == 1 else Mul(*factors, evaluate=False)
