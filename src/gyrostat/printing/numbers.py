"""Writes exact numbers: as they are if they are short, otherwise by their first digits."""
from collections.abc import Iterator
from decimal import ROUND_DOWN, ROUND_HALF_EVEN, Context, Decimal
from fractions import Fraction
from typing import Any

from flint import arb
from sympy import Abs, Basic, CRootOf, Expr, Float, Pow, Rational, S, Symbol

from ..algebra.enclosures.balls import Enclosed, accurate
from ..algebra.rings.readable import readable
from ..notation import symbol
from ..typesetting import SUPERSCRIPTS
from .blocks import Number, Word
from .formats.unicode import unicode

SHORT = 12                                             # characters of a rational number that is written whole
READABLE = 28                                          # characters of a root, or of a polynomial with a root
DIGITS, ACCURATE = 30, 110                             # of a decimal, and the bits that suffice for it
BESIDE, ALONE = 4, 6                                   # digits beside the exact form, and without it
SMALL, LARGE = -5, 7                                   # powers of 10 between which none is written
NOTHING = Word("", "")
_WORKING, _KNOWN = Context(prec=40), Context(prec=25)
_NO_DECIMAL = (S.NaN, S.ComplexInfinity, S.Infinity, S.NegativeInfinity)


def number(value: Expr) -> Any:
    """Write a number as all texts and LaTeX have it; an expression with names is factored.

    - A rational number of at most 12 characters is written as it is: 1/2.
    - A longer one of at most 12 digits is written as a decimal: 1.0123456.
    - A root or a multiple of π of at most 28 characters is followed by four digits: √3/4 ≈ 0.4330.
    - Of every other number the first six digits are written, and … for those that follow: 0.347296….
      If the number is a root of a polynomial of at most 28 characters, the polynomial is named.

    Digits before … are not rounded. Digits before the point are never left out.

    Parameters
    ----------
    value : Expr
        a real number, or an expression

    Returns
    -------
    Expr, Number or Word

    Examples
    --------
    >>> from sympy import rootof, sqrt
    >>> from gyrostat.printing.formats.text import number_text
    >>> x = symbol("x")
    >>> for value in (Rational(1, 2), sqrt(3) / 4, rootof(x**3 - 3*x + 1, 1)):
    ...     print(number_text(value))
    1/2
    √3/4 ≈ 0.4330
    0.347296… (root of x³ − 3 x + 1)
    """
    if isinstance(value, Rational):
        return _rational(value)
    leaves = set(_leaves(value))
    if any(isinstance(leaf, Symbol) for leaf in leaves):
        return tidy(value)
    if not leaves.isdisjoint(_NO_DECIMAL):
        said = "infinite" if value.is_infinite else "undefined"
        return Word(said, rf"\text{{{said}}}")
    if not any(isinstance(x, (CRootOf, Enclosed, Float)) for x in leaves) and _is_readable(value):
        near = with_digits(long_decimal(value), BESIDE, ROUND_HALF_EVEN)
        return Number((value, Word(" ≈ ", r" \approx "), near))
    return Number((_first_digits(long_decimal(value)), *_root_of(value)))


def in_sentence(value: Expr) -> Any:
    """Write a number in a sentence or a list: the same without the polynomial of a root."""
    written = number(value)
    return Number(written.parts[:1]) if isinstance(value, CRootOf) else written


def tidy(value: Expr) -> Expr:
    """Factor a fraction of polynomials, and leave any other expression as it is."""
    rational = all(p.exp.is_Integer for p in value.atoms(Pow)) and not value.atoms(Abs)
    return readable(value) if value.free_symbols and rational else value


def _rational(value: Rational) -> Any:
    """Write the fraction if it is short, otherwise the decimal if that is, otherwise the first digits."""
    top, bottom = int(value.p), int(value.q)
    if max(abs(top), bottom).bit_length() <= 4 * SHORT and len(unicode(value)) <= SHORT:
        return value
    decimal = _WORKING.divide(Decimal(top), Decimal(bottom)).normalize(_WORKING)
    digits = len(decimal.as_tuple().digits)
    if digits <= SHORT and Fraction(decimal) == Fraction(top, bottom):
        return Number((with_digits(decimal, digits, ROUND_DOWN),))
    return Number((_first_digits(decimal),))


def _is_readable(value: Expr) -> bool:
    """Whether the exact form is short; operations are counted first, as a text of nested roots takes long."""
    return bool(value.count_ops() <= READABLE) and len(unicode(value)) <= READABLE


def _leaves(value: Basic) -> Iterator[Basic]:
    """Yield what an expression is made of; a root of a polynomial is a leaf, its polynomial is not read."""
    if isinstance(value, (CRootOf, Enclosed)) or not value.args:
        yield value
    else:
        for part in value.args:
            yield from _leaves(part)


def _root_of(value: Expr) -> tuple[Any, ...]:
    """Name the polynomial in x of which a number is given as a root, if it is short."""
    if not isinstance(value, CRootOf) or value.poly.degree() > READABLE:
        return ()
    polynomial = value.poly.as_expr().xreplace({value.poly.gen: symbol("x")})
    if len(unicode(polynomial)) > READABLE:
        return ()
    return Word(" (root of ", r" \; (\text{root of } "), polynomial, Word(")", ")")


def rounded(value: Expr, rounding: str, digits: int = ALONE) -> Word:
    """Write a number with so many digits at most, rounded up, down or to the nearest.

    Examples
    --------
    >>> from decimal import ROUND_CEILING, ROUND_FLOOR
    >>> from sympy import sqrt
    >>> [rounded(-sqrt(2), rounding).text for rounding in (ROUND_FLOOR, ROUND_CEILING)]
    ['−1.41422', '−1.41421']
    """
    decimal = _KNOWN.plus(long_decimal(value)).normalize()
    return with_digits(decimal, min(digits, len(decimal.as_tuple().digits)), rounding)


def is_long(expression: Any) -> bool:
    """Whether a number in an expression has more than 12 digits."""
    return isinstance(expression, Expr) and any(
        max(abs(int(x.p)), int(x.q)) >= 10**SHORT for x in expression.atoms(Rational))


def long_decimal(value: Expr) -> Decimal:
    """Return a number to 30 digits, or to those of a Float."""
    if value.is_Float:
        return Decimal(str(value))
    enclosed = accurate(value, ACCURATE)
    return middle(enclosed) if enclosed.is_finite() else Decimal(str(value.evalf(DIGITS)))


def middle(enclosure: arb) -> Decimal:
    """Return the middle of an enclosure to 30 digits."""
    return Decimal(enclosure.mid().str(DIGITS, radius=False))


def _first_digits(value: Decimal) -> Word:
    """Write the first digits, and … for those that follow."""
    # the middle of a ball around 1/2 may be 0.4999…; rounded to 25 digits it is 0.5
    return with_digits(_KNOWN.plus(value), ALONE, ROUND_DOWN, Word("…", r"\dots"))


def with_digits(value: Decimal, digits: int, rounding: str, end: Word = NOTHING) -> Word:
    """Write so many digits of a decimal, with a power of 10 if it is small or large."""
    power = value.adjusted() if value else 0
    scaled = value if SMALL <= power < LARGE else value.scaleb(-power, _WORKING)
    places = max(digits - 1 - scaled.adjusted(), 1 if end.text else 0)
    shown = f"{scaled.quantize(Decimal(1).scaleb(-places), rounding, _WORKING):f}"
    text, latex = shown.replace("-", "−") + end.text, shown + end.latex
    if scaled is value:
        return Word(text, latex)
    return Word(f"{text}·10{str(power).translate(SUPERSCRIPTS)}", rf"{latex} \cdot 10^{{{power}}}")
