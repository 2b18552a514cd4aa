"""The solved sets in few lines: what matters least is left out first, and it is said what that is."""
from collections.abc import Callable, Sequence
from dataclasses import replace

from ...parameters.sets import EXCLUDED, INCLUDED, Case, Interval, Solution
from .solve_for import Solved

_WITHOUT = EXCLUDED, INCLUDED                          # ends that ask for no condition


def brief(found: Sequence[Solved],
          fits: Callable[[Sequence[Solved], str], bool]) -> tuple[Sequence[Solved], str]:
    """The sets, with no more than fits, and what is not shown as a sentence, "" if everything is.

    First the conditions are left out under which an end belongs to an interval, next the cases in which an
    expression vanishes, which numbers rarely meet, at last the longest cases.

    Parameters
    ----------
    found : sequence of Solved
    fits : callable
        whether the sets and the sentence are short enough

    Returns
    -------
    (sequence of Solved, str)
    """
    if fits(found, ""):
        return found, ""
    shown = _each(found, _without_conditions_of_ends)
    words = [] if shown == list(found) else ["whether the ends of the intervals belong to them"]
    if fits(shown, _said(words)):
        return shown, _said(words)
    generic = _each(shown, _generic)
    vanishing = _cases(shown) - _cases(generic)
    shown = generic
    if vanishing:
        words.append(f"{_counted(vanishing, 'case')} in which an expression vanishes")
    total = _cases(shown)
    while not fits(shown, _said([*words, *_long(total - _cases(shown))])) and _cases(shown):
        shown = _without_the_longest(shown)
    return shown, _said([*words, *_long(total - _cases(shown))])


def _said(words: Sequence[str]) -> str:
    """What is left out, and how to see it."""
    return f"Not shown: {'; '.join(words)}. Everything: --full" if words else ""


def _counted(number: int, what: str) -> str:
    return f"{number} {what}{'' if number == 1 else 's'}"


def _long(number: int) -> list[str]:
    return [_counted(number, "long case")] if number else []


def _each(found: Sequence[Solved], change: Callable[[Solution], Solution]) -> list[Solved]:
    return [(label, report, change(solution)) for label, report, solution in found]


def _cases(found: Sequence[Solved]) -> int:
    return sum(len(part.cases) for _, _, solution in found for part in solution.parts)


def _without_conditions_of_ends(solution: Solution) -> Solution:
    """Ends that belong to the set under a condition are excluded."""
    def plain(i: Interval) -> Interval:
        low, high = (ladder if ladder in _WITHOUT else EXCLUDED for ladder in (i.low_if, i.high_if))
        return i if i.low == i.high else replace(i, low_if=low, high_if=high)

    return replace(solution, parts=tuple(replace(part, cases=tuple(
        replace(case, intervals=tuple(map(plain, case.intervals))) for case in part.cases))
        for part in solution.parts))


def _generic(solution: Solution) -> Solution:
    """The cases that hold on open sets of numbers, of each condition that has one."""
    def generic(cases: tuple[Case, ...]) -> tuple[Case, ...]:
        return tuple(c for c in cases if all(relation != "=" for _, relation in c.when)) or cases

    return replace(solution, parts=tuple(replace(part, cases=generic(part.cases)) for part in solution.parts))


def _without_the_longest(found: Sequence[Solved]) -> list[Solved]:
    """Without the case that has most operations."""
    longest = max((case for _, _, solution in found for part in solution.parts for case in part.cases),
                  key=_length)
    return _each(found, lambda solution: replace(solution, parts=tuple(
        replace(part, cases=tuple(case for case in part.cases if case is not longest))
        for part in solution.parts)))


def _length(case: Case) -> int:
    ends = [end for i in case.intervals for end in (i.low, i.high)]
    return sum(int(x.count_ops()) for x in (*ends, *(e for e, _ in case.when)))
