"""Tells whether a criterion, an OR of ANDs of comparisons with 0, holds: exactly, in floats or over boxes."""
import operator
from collections.abc import Callable, Iterable, Mapping
from itertools import chain
from typing import Any, TypeVar

from sympy import Expr, S, Symbol

from ...algebra.reals.exact import evaluate, sign, sign_of_constant
from .conditions import Condition, Criterion

T = TypeVar("T")
Relation = Callable[[Any, Any], Any]                   # gt, ge, eq or ne from operator
Compare = Callable[[Expr, Relation], T]                # tells whether an expression stands in a relation to 0
Joined = Callable[[Iterable[T]], T]


def truth(criterion: Criterion, compare: Compare[T], every: Joined[T], some: Joined[T]) -> T:
    """Return what a criterion says if its comparisons with 0 have given answers.

    A strict condition holds if its margin is positive and no even factor is 0, another one if its margin is
    not negative or an even factor is 0. The answers may be True, False and None, arrays, or functions that
    write them.

    Parameters
    ----------
    criterion : Criterion
    compare : callable (expression, relation)
        whether an expression stands in a relation, operator.gt, ge, eq or ne, to 0
    every, some : callable (answers)
        the conjunction and the disjunction of any number of answers

    Returns
    -------
    as compare

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
    >>> report = gs.analyze(gs.upright(top))
    >>> def compare(margin, relation):
    ...     return relation(1, 0)
    >>> truth(report.sufficient, compare, all, any)
    True
    """
    return some(every(condition_truth(condition, compare, every, some) for condition in alternative)
                for alternative in criterion.alternatives)


def condition_truth(condition: Condition, compare: Compare[T], every: Joined[T], some: Joined[T]) -> T:
    """Return what one condition says, as truth does for a criterion."""
    of_margin, of_factor = ((operator.gt, operator.ne) if condition.strict else (operator.ge, operator.eq))
    answer = compare(condition.margin, of_margin)
    if not condition.degenerate:
        return answer
    others = (compare(factor, of_factor) for factor in condition.degenerate)
    return (every if condition.strict else some)(chain((answer,), others))


def holds(criterion: Criterion, numbers: Mapping[Symbol, Expr], margins: dict[Expr, Expr]) -> bool | None:
    """Return the truth of a criterion at exact numbers, None if it is not proved.

    The values of its margins are entered into the last argument.
    """
    def compare(expression: Expr, relation: Relation) -> bool | None:
        margin = relation in (operator.gt, operator.ge)
        found = _margin_sign(expression, numbers, margins) if margin else sign(expression, numbers)
        return None if found is None else bool(relation(found, 0))

    if criterion.only is not None:                         # the rule for a body of revolution
        return condition_truth(criterion.only, compare, every_proved, some_proved)
    return truth(criterion, compare, every_proved, some_proved)


def every_proved(answers: Iterable[bool | None]) -> bool | None:
    """Tell whether all hold; None if that is not proved."""
    given = list(answers)
    return False if False in given else None if None in given else True


def some_proved(answers: Iterable[bool | None]) -> bool | None:
    """Tell whether one holds; None if that is not proved."""
    given = list(answers)
    return True if True in given else None if None in given else False


def sign_at(condition: Condition, numbers: Mapping[Symbol, Expr], margins: dict[Expr, Expr]) -> int | None:
    """Return the sign of the margin at exact numbers, 0 if an even factor vanishes, None if it is not proved.

    The value of the margin is entered into the last argument.
    """
    factors = [sign(factor, numbers) for factor in condition.degenerate]
    if 0 in factors:
        return 0
    return None if None in factors else _margin_sign(condition.margin, numbers, margins)


def _margin_sign(margin: Expr, numbers: Mapping[Symbol, Expr], margins: dict[Expr, Expr]) -> int | None:
    if (value := margins.get(margin)) is None:
        value = margins[margin] = evaluate(margin, numbers)
    if (found := sign_of_constant(value)) == 0:
        margins[margin] = S.Zero                       # a proved 0 may have come out as a sum of roots
    return found
