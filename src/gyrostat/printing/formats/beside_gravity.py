"""Writes what acts on a satellite beside the gravity gradient, as it stands above a picture."""
from sympy import Add, Expr, Float

from ...mechanics.families.circular_orbit import VELOCITY, acting_beside
from ...mechanics.scenes.system import System
from .latex import tex
from .latex_names import Names

SHORT, DIGITS = 8, 4                                   # letters of a number that stays; of another one


def other_latex(scene: System) -> str:
    r"""Return the other potential of a satellite in orbit as LaTeX, long numbers in four digits.

    Examples
    --------
    >>> import gyrostat as gs
    >>> orbit = gs.circular_orbit("1/3", potential="r2/7 + 0.123456789*n1")
    >>> other_latex(gs.assemble(gs.Gyrostat((1, 2, 3)), orbit))
    '0.1235 n_{1} + \\frac{r_{2}}{7}'
    """
    directions = {s for t in VELOCITY.values() for s in t.free_symbols}
    terms = (x.as_independent(*directions, as_Add=False) for x in Add.make_args(acting_beside(scene)))
    return tex(Add(*(_short(c) * rest for c, rest in terms)), Names())


def _short(number: Expr) -> Expr:
    return Float(number, DIGITS) if not number.free_symbols and len(str(number)) > SHORT else number
