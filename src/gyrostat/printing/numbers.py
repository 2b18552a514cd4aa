"""Writes exact numbers: as they are if they are short, otherwise by their first digits."""
from decimal import ROUND_DOWN, ROUND_HALF_EVEN, Context, Decimal
from fractions import Fraction
from typing import Any

from sympy import Abs, CRootOf, Expr, Float, Pow, Rational, S

from ..algebra.enclosures.balls import Enclosed, accurate
from ..algebra.rings.readable import readable
from ..notation import symbol
from ..typesetting import SUPERSCRIPTS
from .blocks import Number, Word
from .formats.unicode import unicode

SHORT = 12                                             # characters of a rational number that is written whole
READABLE = 28                                          # characters of a root, or of a polynomial with a root
CELL = 6                                               # characters of a rational number in a column
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
    if value.free_symbols:
        return tidy(value)
    if value.has(*_NO_DECIMAL):
        said = "infinite" if value.is_infinite else "undefined"
        return Word(said, rf"\text{{{said}}}")
    if isinstance(value, Rational):
        return _rational(value)
    if _is_readable(value):
        return Number((value, Word(" ≈ ", r" \approx "), _written(_decimal(value), BESIDE, ROUND_HALF_EVEN)))
    return Number((_first_digits(_decimal(value)), *_root_of(value)))


def in_sentence(value: Expr) -> Any:
    """Write a number in a sentence or a list: the same without the polynomial of a root."""
    written = number(value)
    return Number(written.parts[:1]) if isinstance(value, CRootOf) else written


def in_a_cell(value: Expr | None) -> str:
    """Write a number in a column of a text: a short fraction as it is, of any other number four digits.

    None stands for every number.

    Examples
    --------
    >>> from sympy import sqrt
    >>> in_a_cell(Rational(-5, 12)), in_a_cell(sqrt(2) / 2)
    ('−5/12', '0.7071')
    """
    if value is None:
        return "any"
    if isinstance(value, Rational) and len(exact := unicode(value)) <= CELL:
        return exact
    return _written(_decimal(value), BESIDE, ROUND_HALF_EVEN).text


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
        return Number((_written(decimal, digits, ROUND_DOWN),))
    return Number((_first_digits(decimal),))


def _is_readable(value: Expr) -> bool:
    """Whether the exact form is short; operations are counted first, as a text of nested roots takes long."""
    if value.has(CRootOf, Enclosed, Float) or value.count_ops() > READABLE:
        return False
    return len(unicode(value)) <= READABLE


def _root_of(value: Expr) -> tuple[Any, ...]:
    """Name the polynomial in x of which a number is given as a root, if it is short."""
    if not isinstance(value, CRootOf) or value.poly.degree() > READABLE:
        return ()
    polynomial = value.poly.as_expr().xreplace({value.poly.gen: symbol("x")})
    if len(unicode(polynomial)) > READABLE:
        return ()
    return Word(" (root of ", r" \; (\text{root of } "), polynomial, Word(")", ")")


def _decimal(value: Expr) -> Decimal:
    """The number to 30 digits, or to those of a Float."""
    if value.is_Float:
        return Decimal(str(value))
    enclosed = accurate(value, 110)
    if enclosed.is_finite():
        return Decimal(enclosed.mid().str(30, radius=False))
    return Decimal(str(value.evalf(30)))


def _first_digits(value: Decimal) -> Word:
    """Write the first digits, and … for those that follow."""
    # the middle of a ball around 1/2 may be 0.4999…; rounded to 25 digits it is 0.5
    return _written(_KNOWN.plus(value), ALONE, ROUND_DOWN, Word("…", r"\dots"))


def _written(value: Decimal, digits: int, rounding: str, end: Word = NOTHING) -> Word:
    """Write so many digits of a decimal, with a power of 10 if it is small or large."""
    power = value.adjusted() if value else 0
    scaled = value if SMALL <= power < LARGE else value.scaleb(-power, _WORKING)
    places = max(digits - 1 - scaled.adjusted(), 1 if end.text else 0)
    shown = f"{scaled.quantize(Decimal(1).scaleb(-places), rounding, _WORKING):f}"
    text, latex = shown.replace("-", "−") + end.text, shown + end.latex
    if scaled is value:
        return Word(text, latex)
    return Word(f"{text}·10{str(power).translate(SUPERSCRIPTS)}", rf"{latex} \cdot 10^{{{power}}}")
