"""Truth of a criterion: what it says where signs are known, and nothing where they leave it open."""
import operator
from itertools import product

import numpy as np
import pytest
from sympy import Rational, atan, pi

import gyrostat as gs
from gyrostat.charts.signs import three_valued as answers
from gyrostat.charts.signs.compiled_margins import compile_margin
from gyrostat.stability.criteria.conditions import Condition, Criterion
from gyrostat.stability.criteria.truth import holds, truth

NAMES = ("x", "y", "z")
x, y, z = map(gs.symbol, NAMES)
SIGNS = (-1, 0, 1)
HIDDEN = 16 * atan(Rational(1, 5)) - 4 * atan(Rational(1, 239)) - pi   # 0, by Machin, but not to this library


def condition(margin, strict, *even):
    return Condition(margin, strict, "", even, Rational(1))


CRITERIA = [Criterion("", alternatives) for alternatives in (
    (), ((),), ((condition(x, True, y),),), ((condition(x, False, y),),),
    ((condition(x, True, y, z),),), ((condition(x, False), condition(y, True, z)),),
    ((condition(x, True), condition(y, False)), (condition(z, True),)),
    ((condition(x, False, z),), (condition(y, True),), (condition(z, True, x),)))]


def expected(criterion, signs):
    """The definition, of known signs: an OR of ANDs, the sign of a condition 0 where an even factor is 0."""
    for alternative in criterion.alternatives:
        values = [0 if any(signs[e] == 0 for e in c.degenerate) else signs[c.margin] for c in alternative]
        if all(value > 0 if c.strict else value >= 0 for c, value in zip(alternative, values)):
            return True
    return False


@pytest.mark.parametrize("criterion", CRITERIA, ids=range(len(CRITERIA)))
def test_known_signs_decide_on_scalars_and_arrays_alike(criterion):
    """At every combination of signs: exact numbers, compiled margins and three-valued arrays agree."""
    table = np.array(list(product(SIGNS, repeat=3)), dtype=float)
    wanted = [expected(criterion, dict(zip((x, y, z), row))) for row in table.tolist()]
    exact = [holds(criterion, dict(zip((x, y, z), map(Rational, map(int, row)))), {}) for row in table]
    assert exact == wanted
    compiled = compile_margin(criterion)
    given = {name: column for name, column in zip(NAMES, table.T) if name in compiled.names}
    assert np.broadcast_to(compiled(**given), len(table)).tolist() == wanted

    def compare(expression, relation):
        held = relation(table[:, NAMES.index(expression.name)], 0)
        return answers.answered(held, ~held)

    found = truth(criterion, compare, answers.every, answers.some)
    assert np.broadcast_to(found, len(table)).tolist() == [1 if says else -1 for says in wanted]


@pytest.mark.parametrize("criterion", CRITERIA, ids=range(len(CRITERIA)))
def test_what_is_said_of_unknown_signs_is_true_of_all(criterion):
    """True or False where some signs are unknown: so it is whatever they are."""
    for signs in product((*SIGNS, None), repeat=3):
        numbers = {s: HIDDEN if sign is None else Rational(sign) for s, sign in zip((x, y, z), signs)}
        said = holds(criterion, numbers, {})
        worlds = {expected(criterion, dict(zip((x, y, z), world)))
                  for world in product(*(SIGNS if sign is None else (sign,) for sign in signs))}
        assert said is None or worlds == {said}
        if None not in signs:
            assert said is not None


@pytest.mark.parametrize(("strict", "margin", "factor", "says"), [
    (True, 1, 1, True), (True, 1, 0, False), (True, -1, 0, False), (False, -1, 0, True),
    (False, -1, 1, False), (False, 1, 0, True),
    (True, 1, None, None), (False, 1, None, True), (False, -1, None, None), (True, -1, None, False),
    (True, None, 1, None),
    (False, None, 0, True), (True, None, 0, False), (True, 0, None, False), (False, 0, None, True)])
def test_conditions_are_three_valued(strict, margin, factor, says):
    """The sign is 0 where an even factor vanishes.

    None, a sign that is not proved, decides nothing by itself.
    """
    number = {1: Rational(5), 0: Rational(0), -1: Rational(-2), None: HIDDEN}
    criterion = Criterion("", ((condition(x, strict, y),),))
    assert holds(criterion, {x: number[margin], y: number[factor]}, {}) is says


def test_a_three_valued_array_is_what_two_proofs_say():
    """1 where it is proved, −1 where the contrary is, 0 elsewhere; of nothing the conjunction holds."""
    holding, failing = np.array([True, False, False]), np.array([False, True, False])
    given = answers.answered(holding, failing)
    assert given.tolist() == [1, -1, 0] and given.dtype == np.int8
    assert answers.every([given, given[::-1]]).tolist() == [0, -1, 0]
    assert answers.some([given, given[::-1]]).tolist() == [1, -1, 1]
    assert answers.every([]) == 1 and answers.some([]) == -1


def test_all_margins_are_compared():
    """The values of all margins are entered, also of those that no longer matter."""
    margins = {}
    criterion = Criterion("", ((condition(x, True), condition(y, True)), (condition(z, True),)))
    assert holds(criterion, {x: Rational(-1), y: Rational(1), z: Rational(1)}, margins) is True
    assert margins == {x: -1, y: 1, z: 1}
    asked = []
    assert truth(criterion, lambda e, relation: asked.append(relation) or True, all, any) is True
    assert asked == [operator.gt] * 2                      # an OR that is decided asks no more
