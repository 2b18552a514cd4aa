"""Sets of one parameter: unions of intervals with exact ends, by cases of the other parameters."""
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from sympy import Expr, S, Symbol, oo

from .._display import Shown
from ..algebra.reals.exact import Point, evaluate, sign_of_constant
from ..algebra.text.numbers import exact_number
from ..arguments import checked
from ..errors import ValuesError
from ..notation import Stored, symbol
from ..stability.criteria.numbers_asked import is_positive
from ..stability.criteria.truth import some_proved

Ladder = tuple[Expr, ...]
# the signs that a value has which compares so with 0
_SIGNS = {">": (1,), "<": (-1,), "=": (0,), "!=": (1, -1)}
EXCLUDED: Ladder = ()
INCLUDED: Ladder = (S.One,)


@dataclass(frozen=True)
class Interval:
    """An interval between two ends.

    Parameters
    ----------
    low, high : Expr
        −oo and oo if there is no end
    low_if, high_if : tuple
        the end belongs to it if and only if the first of these that is not 0 is positive: () never, (1,)
        always
    tilt : (Expr, Expr) or None
        k3 at the ends, if the interval is that of a family of E3

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> report = gs.analyze(gs.upright(top))
    >>> given = {"I1": 1, "m0": 1, "pi3_0": 5}
    >>> solution = gs.stabilizing_set(report, "l", given)
    >>> interval = solution.parts[0].cases[0].intervals[0]
    >>> interval.low, interval.high, interval.high_if
    (-oo, -7, (1,))
    """

    low: Expr
    high: Expr
    low_if: Ladder = EXCLUDED
    high_if: Ladder = EXCLUDED
    tilt: tuple[Expr, Expr] | None = None


@dataclass(frozen=True)
class Case:
    """A case of the other parameters, and the set there.

    Parameters
    ----------
    when : tuple of (Expr, str)
        each compared with 0 by ">", "<", "=" or "!="
    intervals : tuple of Interval
        in increasing order; () is empty

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> report = gs.analyze(gs.upright(top))
    >>> given = {"I1": 1, "m0": 1, "pi3_0": 5}
    >>> solution = gs.stabilizing_set(report, "l", given)
    >>> (case,) = solution.parts[0].cases
    >>> case.when, len(case.intervals)
    ((), 2)
    """

    when: tuple[tuple[Expr, str], ...]
    intervals: tuple[Interval, ...]


@dataclass(frozen=True)
class SolvedCondition:
    """An inequality solved for the name: its cases exclude each other and cover everything.

    Parameters
    ----------
    meaning : str
        "exists"; "stable": there and nowhere else; "sufficient": stable there, elsewhere nothing is said;
        "necessary": unstable elsewhere; "undecided": nothing is proved there
    margin : Expr
        what was solved; it is positive inside
    cases : tuple of Case
    at : Expr
        the k3 at which derivatives of U are taken

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> report = gs.analyze(gs.upright(top))
    >>> given = {"I1": 1, "m0": 1, "pi3_0": 5}
    >>> solution = gs.stabilizing_set(report, "l", given)
    >>> [part.meaning for part in solution.parts]
    ['stable']
    """

    meaning: str
    margin: Expr
    cases: tuple[Case, ...]
    at: Expr


@dataclass(frozen=True, repr=False)
class Solution(Shown, Stored):
    """The set of one parameter where all parts hold, except for those that are called undecided.

    Parameters
    ----------
    name : str
    parts : tuple of SolvedCondition

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> report = gs.analyze(gs.upright(top))
    >>> given = {"I1": 1, "m0": 1, "pi3_0": 5}
    >>> solution = gs.stabilizing_set(report, "l", given)
    >>> tuple(solution.contains(given | {"l": l}) for l in (0, -5))
    (True, False)
    """

    name: str
    parts: tuple[SolvedCondition, ...]

    @checked
    def contains(self, values: Mapping[str, Any]) -> bool | None:
        """Tell whether the set contains a value, at numbers for all names.

        The answer is exact; None if nothing is proved there, or a sign is not.

        Parameters
        ----------
        values : mapping of name to number
            for the name that was solved for, and those that are left

        Returns
        -------
        bool or None

        Raises
        ------
        ValuesError
            a name is missing, or a positive one is given another number
        """
        if self.name not in values:
            raise ValuesError(f"the solution is a set of {self.name}: give a number for it")
        numbers = Point({symbol(name): exact_number(value, name) for name, value in values.items()})
        if doubtful := [s for s, x in numbers.items() if s.is_positive and not is_positive(s.name, x)]:
            raise ValuesError(f"whether {doubtful[0]} = {numbers[doubtful[0]]} is positive is not proved: "
                              "write it with rationals and roots")
        answers = [(part.meaning, _in_part(part, symbol(self.name), numbers)) for part in self.parts]
        if any(answer is False and meaning in ("exists", "necessary") for meaning, answer in answers):
            return False
        if any(answer is not False and meaning == "undecided" for meaning, answer in answers):
            return None
        if any(answer is False and meaning == "stable" for meaning, answer in answers):
            return False
        return True if all(answer for meaning, answer in answers if meaning != "undecided") else None


def _in_part(part: SolvedCondition, name: Symbol, numbers: Point) -> bool | None:
    unknown = False
    for case in part.cases:
        compared = [(_sign(e, numbers), relation) for e, relation in case.when]
        if any(s is None for s, _ in compared):
            unknown = True
        elif all(sign in _SIGNS[relation] for sign, relation in compared):
            return some_proved(_inside(interval, numbers[name], numbers) for interval in case.intervals)
    return None if unknown else False


def _inside(interval: Interval, value: Expr, numbers: Point) -> bool | None:
    for end, ladder, side in ((interval.low, interval.low_if, 1), (interval.high, interval.high_if, -1)):
        if end in (oo, -oo):
            continue
        sign = _sign(side * (value - end), numbers)
        if sign == 0:
            return _first(ladder, numbers)
        if sign != 1:
            return None if sign is None else False
    return True


def _first(ladder: Ladder, numbers: Point) -> bool | None:
    """Tell whether the first rung that is not 0 is positive; it is not if all are 0."""
    for rung in ladder:
        sign = _sign(rung, numbers)
        if sign != 0:
            return None if sign is None else sign > 0
    return False


def _sign(expression: Expr, numbers: Point) -> int | None:
    if missing := sorted(s.name for s in expression.free_symbols - numbers.keys()):
        raise ValuesError(f"the solution needs {', '.join(missing)}: give a number for each")
    return sign_of_constant(evaluate(expression, numbers))
