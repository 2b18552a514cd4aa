"""What the page computes itself: programs in fractions, and the boundary of a chart column by column."""
import json
import operator
from fractions import Fraction
from pathlib import Path
from random import Random

import pytest
import session

import gyrostat as gs
from gyrostat.questions.page.chosen import chosen

EXAMPLES = [example["scene"] for example in json.loads(
    (Path(session.__file__).parent / "examples.json").read_text(encoding="utf-8"))]
ARITHMETIC = {"add": operator.add, "subtract": operator.sub, "multiply": operator.mul,
              "divide": operator.truediv, "negative": operator.neg}
ENDS = ["1/20", "5"], ["-3", "3"]


def asked(want, scene, *more):
    return gs.questions.show(scene, want, *more)


def run(steps, numbers):
    """The results of a program in fractions."""
    found = []
    for operation, *arguments in steps:
        if operation in ARITHMETIC:
            found.append(ARITHMETIC[operation](*(found[i] for i in arguments)))
        else:
            found.append(numbers[arguments[0]] if operation == "name" else Fraction(arguments[0]))
    return found


def said(alternatives, results):
    """Whether a criterion holds."""
    def holds(condition):
        factors = [results[i] for i in condition["degenerate"]]
        if condition["strict"]:
            return results[condition["margin"]] > 0 and all(factors)
        return results[condition["margin"]] >= 0 or not all(factors)
    return any(all(map(holds, conditions)) for conditions in alternatives)


@pytest.mark.parametrize("number", [0, 1, 3, 5, 7])
def test_a_program_says_what_the_criteria_say(number):
    """At random numbers, whatever the axes."""
    rng, scene = Random(number), EXAMPLES[number]
    report, told = chosen(scene).report, set()
    for _ in range(20):
        chart = asked("charted", scene, rng.sample(report.required, 2))
        assert set(chart["names"]) <= set(report.required)
        numbers = {name: Fraction(rng.randint(1, 40), 60 if name == "k3" else 20) for name in report.required}
        results = run(chart["steps"], numbers)
        verdict = report.verdict({name: str(x) for name, x in numbers.items()}).verdict.name
        assert all(results[i] > 0 for i in chart["positive"])
        sufficient, necessary = (said(chart[name], results) for name in ("sufficient", "necessary"))
        assert verdict == "STABLE" if sufficient else necessary or verdict == "UNSTABLE"
        told.add(verdict)
    assert len(told) > 1


@pytest.mark.parametrize("number", [0, 4, 6])
def test_the_boundary_is_where_the_verdict_changes(number):
    """On both sides of each point another verdict; as often on a line as along points close together."""
    scene = EXAMPLES[number]
    report = chosen(scene).report
    axes = ["I1", report.required[-1]]
    points = asked("edges", scene, axes, ENDS)["points"]
    values = {name: text for name, text in scene["values"].items() if name in report.required}

    def verdict(x, y):
        return report.verdict({**values, axes[0]: x, axes[1]: y}).verdict

    small = Fraction(1, 10**9)
    for x, y in points[::9]:
        assert any(verdict(Fraction(x) - dx, Fraction(y) - dy) != verdict(Fraction(x) + dx, Fraction(y) + dy)
                   for dx, dy in ((0, small), (small, 0)))
    changes = 0
    for n in (6, 40, 60):
        share = Fraction(2 * n + 1, 128)
        x, y = Fraction(1, 20) + Fraction(99, 20) * share, -3 + 6 * share
        column = [verdict(x, Fraction(i, 20) + Fraction(1, 1000)) for i in range(-60, 60)]
        row = [verdict(Fraction(i, 20) + Fraction(1, 1000), y) for i in range(1, 100)]
        for axis, place, line in ((0, x, column), (1, y, row)):
            there = sum(a != b for a, b in zip(line, line[1:]))
            assert sum(abs(point[axis] - place) < 1e-9 for point in points) == there
            changes += there
    assert changes


@pytest.mark.slow
def test_what_is_not_drawn_is_said():
    """Numbers bound to each other, an axis that nothing depends on, a number beyond doubles."""
    assert "bound to each other" in asked("charted", EXAMPLES[8], ["k1", "I1"])["why"]
    directed = {**EXAMPLES[8], "direction": ["stereographic"]}
    assert {"u1", "u2"} <= set(asked("charted", directed, ["u1", "u2"])["names"])
    assert "two different names" in asked("charted", EXAMPLES[0], ["I1", "I1"])["why"]
    assert "I3 has no axis" in asked("charted", EXAMPLES[1], ["I3", "I1"])["why"]
    large = {**EXAMPLES[0], "potential": "1e400*k3"}
    assert "larger than any double" in asked("charted", large, ["I1", "l"])["why"]
    assert "needs a field that is given" in asked("moving", EXAMPLES[1])["why"]
    assert asked("edges", {**EXAMPLES[0], "values": {**EXAMPLES[0]["values"], "m0": "sqrt(2)"}}, ["I1", "l"],
                 ENDS)["points"] == []


def test_a_motion_has_the_equations_of_the_scene():
    """At a state off the equilibrium, and the state of the equilibrium itself, which stays."""
    scene = EXAMPLES[3]
    found = asked("moving", scene)
    whole = chosen(scene).scene
    values = {name: Fraction(text) for name, text in scene["values"].items()}
    state = [Fraction(n, 7) for n in (1, -2, 3, 2, 3, 6)]
    known = {gs.symbol(name): value for name, value in values.items()}
    expected = [rate.subs({**known, **dict(zip(whole.space.coordinates, state))})
                for rate in whole.vector_field()]
    results = run(found["rates"]["steps"], {**values, **dict(zip(found["coordinates"], state))})
    assert [results[i] for i in found["rates"]["results"]] == expected
    assert {name["name"] for name in found["names"]} == {"I1", "I3", "l", "k3", "omega"}


# numbers that doubles have
TENSOR = {"potential": "m0*k3",
          "inertia": [["I11", "1/2", "1/4"], ["1/2", "I22", "-1/4"], ["1/4", "-1/4", "I33"]],
          "gyrostatic_momentum": ["l1", "1/8", "l3"], "point": ["0", "0", "0", "0", "0", "1"],
          "values": {"I11": "3", "I22": "4", "I33": "5", "l1": "1/7", "l3": "-2", "m0": "1"}}


@pytest.mark.parametrize("scene", [*(EXAMPLES[n] for n in (0, 2, 5, 8, 9)), TENSOR], ids=str)
def test_the_body_turns_as_its_momentum_says(scene):
    """I (ω + ω₀ n) = π at a state of no equilibrium: ω is relative to the orbital frame, if there is one."""
    found = asked("moving", scene)
    numbers = {name: Fraction(text) for name, text in scene["values"].items()}
    rows, rotor = body_of(scene, numbers)
    assert results_of(found["inertia"], numbers) == [
        rows[i][j] for i, j in ((0, 0), (1, 1), (2, 2), (1, 2), (2, 0), (0, 1))]
    assert results_of(found["rotor"], numbers) == rotor
    state = [Fraction(n, 7) for n in (1, -2, 3, 2, 3, 6, 6, 2, -3)][:len(found["coordinates"])]
    turning = results_of(found["velocity"], {**numbers, **dict(zip(found["coordinates"], state))})
    rate = numbers["omega0"] if "orbit" in scene else 0
    absolute = [w + rate * n for w, n in zip(turning, state[3:6] or [0, 0, 0])]
    assert [sum(a * w for a, w in zip(row, absolute)) for row in rows] == state[:3]


def body_of(scene, numbers):
    """The tensor and the rotor of a scene whose entries are names or numbers."""
    def value(text):
        return numbers[text] if text in numbers else Fraction(text)

    rows = [[value(x) for x in row] if isinstance(row, list) else
            [value(row) if i == j else 0 for j in range(3)] for i, row in enumerate(scene["inertia"])]
    return rows, [value(x) for x in scene["gyrostatic_momentum"]]


def results_of(program, numbers):
    """The results of a program that has some."""
    found = run(program["steps"], numbers)
    return [found[i] for i in program["results"]]


def test_a_body_at_rest_is_drawn_where_its_equilibrium_is():
    """Where U is not given, or a number larger than doubles is in it, the state and the body are there."""
    unspecified = asked("moving", EXAMPLES[2])
    steps = [step if step[0] != "power" else ["number", 0.75**0.5] for step in unspecified["state"]["steps"]]
    numbers = {name: Fraction(text) for name, text in EXAMPLES[2]["values"].items()}
    assert run(steps, numbers)[unspecified["state"]["results"][5]] == Fraction(1, 2)
    assert "rates" not in unspecified
    large = asked("moving", {**EXAMPLES[0], "potential": "1e400*k3"})
    assert "larger than any double" in large["why"] and {"inertia", "rotor", "state"} <= large.keys()
    assert asked("moving", {**EXAMPLES[0], "inertia": ["1e400", "1e400", "1"]})["names"] == []
    every = asked("moving", EXAMPLES[10])
    assert "choose one" in every["why"] and every.keys() == {"inertia", "rotor", "why", "names"}
