"""Straight-line programs.

The margin itself, exactly, with the least done for each point, whatever varies along which axes.
"""
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st
from sympy import Integer, Rational, chebyshevt, exp, sqrt

import gyrostat as gs
from gyrostat.charts.programs.straightline import program_of

k3, x, y, z = map(gs.symbol, ("k3", "x", "y", "z"))
SIX = sum(gs.symbol(f"a{n}") * k3**n for n in range(1, 7))
NUMBERS = sum(Rational(3 * n - 8, 7 + n) * k3**n for n in range(1, 7))
FIELDS = {"unspecified": gs.axial_potential(), "uniform": gs.uniform_field(),
          "Newtonian": gs.newtonian_field(2),
          "degree 6": gs.axial_potential(SIX), "degree 6, numbers": gs.axial_potential(NUMBERS),
          "degree 20": gs.axial_potential(gs.symbol("a") * chebyshevt(20, k3))}
values = st.fractions(min_value=-4, max_value=4, max_denominator=16)
along = st.frozensets(st.integers(0, 3))


def parts(report):
    """All that is ever compiled of a report: margins and even factors."""
    return list(dict.fromkeys(e for criterion in (report.sufficient, report.necessary)
                              for group in criterion.alternatives
                              for c in group for e in (c.margin, *c.degenerate)))


def general(l, omega):
    """Three moments and the Newtonian field of a general body, rotating about axis 3."""
    I, m0, m1 = [gs.symbol(f"I{i}") for i in (1, 2, 3)], gs.symbol("m0"), gs.symbol("m1")
    potential = gs.general_potential(lambda *k: m0 * k[2] + m1 / 2 * sum(a * c**2 for a, c in zip(I, k)))
    scene = gs.assemble(gs.Gyrostat(gyrostatic_momentum=(0, 0, l)), potential)
    return gs.equilibrium(scene, (0, 0, I[2] * omega, 0, 0, 1))


@pytest.fixture(scope="module")
def margins():
    """Margins and even factors of all families in all fields, a free rotation and a general body."""
    l = gs.symbol("l")
    scenes = {name: gs.assemble(gs.symmetric_gyrostat(), field) for name, field in FIELDS.items()}
    reports = [gs.analyze(gs.upright(scenes["unspecified"])), gs.analyze(gs.hanging(scenes["degree 6"]))]
    reports += [gs.analyze(gs.inclined(scene)) for scene in scenes.values()]
    reports += [gs.analyze(gs.static_tilt(scenes[name]))
                for name in ("unspecified", "uniform", "Newtonian", "degree 20")]
    reports.append(gs.analyze(gs.principal_rotation(gs.assemble(gs.Gyrostat(gyrostatic_momentum=(0, 0, l))),
                                                    3)))
    reports.append(gs.analyze(general(l, gs.symbol("omega"))))
    return list(dict.fromkeys(e for report in reports for e in parts(report)))


def run(program, numbers):
    """Every step in Fractions; symbols by name."""
    return program.run(lambda leaf: numbers[leaf.name], lambda c: Fraction(int(c.p), int(c.q)))


def inner(program, full):
    """The steps that are done at each point."""
    return [step for step in program.steps if step.arguments and step.axes == full]


@pytest.mark.slow
@given(data=st.data())
def test_the_program_is_the_margin(margins, data):
    """The last step is the margin, in Fractions, whatever the axes."""
    margin = data.draw(st.sampled_from(margins))
    symbols = sorted(margin.free_symbols, key=str)
    numbers = {s.name: data.draw(values) for s in symbols}
    axes = {s: data.draw(along) for s in symbols}
    exact = margin.xreplace({s: Rational(numbers[s.name].numerator, numbers[s.name].denominator)
                             for s in symbols})
    assert run(program_of(margin, axes), numbers)[-1] == Fraction(int(exact.p), int(exact.q))


@pytest.mark.slow
@given(data=st.data())
def test_steps_vary_along_their_axes_alone(margins, data):
    """A step without an axis keeps its value when all that varies along that axis changes.

    Axes are unions of those of the arguments.
    """
    margin = data.draw(st.sampled_from(margins))
    symbols = sorted(margin.free_symbols, key=str)
    axes = {s: data.draw(along) for s in symbols}
    program, axis = program_of(margin, axes), data.draw(st.integers(0, 3))
    one = {s.name: data.draw(values) for s in symbols}
    other = {s.name: data.draw(values) if axis in axes[s] else one[s.name] for s in symbols}
    for step, a, b in zip(program.steps, run(program, one), run(program, other)):
        assert axis in step.axes or a == b
    for step in program.steps:
        below = frozenset().union(*(program.steps[i].axes for i in step.arguments))
        assert step.axes == (axes[step.value] if step.operation == "leaf" else below)


@pytest.mark.slow
@given(data=st.data())
def test_nothing_is_computed_twice_or_in_vain(margins, data):
    """No two steps are equal, all but the last are read later, arguments come before.

    Leaves are the symbols of the margin.
    """
    margin = data.draw(st.sampled_from(margins))
    program = program_of(margin, {s: data.draw(along) for s in sorted(margin.free_symbols, key=str)})
    keys = [(s.operation, s.arguments, s.value) for s in program.steps]
    assert len(set(keys)) == len(keys)
    assert {i for s in program.steps for i in s.arguments} == set(range(len(keys) - 1))
    assert all(i < n for n, s in enumerate(program.steps) for i in s.arguments)
    assert set(program.leaves) == margin.free_symbols
    assert len(list(program.leaves)) == len(margin.free_symbols)
    for step in program.steps:
        assert (step.value is None) == bool(step.arguments)
        assert (step.operation != "constant" or step.value > 0)


@pytest.mark.parametrize(("names", "steps"),
                         [(("l", "pi3_0"), 3), (("pi3_0", "dU"), 1), (("l", "dU"), 1), (("I1", "dU"), 2)])
def test_inner_steps_at_the_vertical(e1, names, steps):
    """(π3 + l)² − 4 I1 U': a sum, a square and a difference on a grid of l and π3.

    One difference where P² is known.
    """
    (margin,) = parts(e1)
    program = program_of(margin, {gs.symbol(name): frozenset({i}) for i, name in enumerate(names)})
    assert len(inner(program, frozenset({0, 1}))) == steps


@pytest.mark.parametrize(("names", "steps"),
                         [(("omega", "k3"), 5), (("k3", "d2U"), 2), (("omega", "l"), 3), (("I1", "d2U"), 3)])
def test_inner_steps_at_a_tilt(e3, names, steps):
    """E3: five operations at each point of a grid of ω and k3, two of k3 and U''."""
    (margin,) = parts(e3)
    program = program_of(margin, {gs.symbol(name): frozenset({i}) for i, name in enumerate(names)})
    assert len(inner(program, frozenset({0, 1}))) == steps


@pytest.mark.slow
def test_sums_and_products_take_first_what_varies_least():
    """x + y + z and x y z with x, y, z along 0, 1 and nothing: one step at each point.

    With x and z together along 0 also one.
    """
    for expression in (x + y + z, x * y * z):
        for axes in ({x: frozenset({0}), y: frozenset({1})},
                     {x: frozenset({0}), z: frozenset({0}), y: frozenset({1})}):
            assert len(inner(program_of(expression, axes), frozenset({0, 1}))) == 1


def test_what_varies_along_the_same_axes_is_joined_first():
    """Of x, y along 0 and z, w along 1, in a sum with v along both: x + y and z + w are taken apart."""
    v, w = gs.symbol("v"), gs.symbol("w")
    row, column = frozenset({0}), frozenset({1})
    program = program_of(v + x + z + y + w, {x: row, y: row, z: column, w: column, v: row | column})
    assert [len(inner(program, a)) for a in (row, column, row | column)] == [1, 1, 2]


def test_what_shares_axes_is_joined_first():
    """Of pairs that would vary along equally many axes, those that share one are joined.

    Here x varies along 0, y along 2, z along 0 and 1.
    """
    program = program_of(x + y + z, {x: frozenset({0}), y: frozenset({2}), z: frozenset({0, 1})})
    assert [step.axes for step in program.steps if step.arguments] == [{0, 1}, {0, 1, 2}]


@pytest.mark.parametrize(("n", "steps"), [(2, 1), (3, 2), (4, 2), (5, 3), (7, 4), (8, 3), (15, 6), (20, 5)])
def test_powers_are_repeated_squares(n, steps):
    """xⁿ takes ⌊log₂ n⌋ squares and a product for each further binary digit 1."""
    program = program_of(x**n, {})
    assert len(program.steps) - 1 == steps == n.bit_length() - 1 + n.bit_count() - 1
    assert run(program, {"x": Fraction(-3, 2)})[-1] == Fraction(-3, 2) ** n


@pytest.mark.parametrize("expression", [-x, -x - y, -x * y, y - x, -(x**2), -(x**3) * y, (x - y) ** 2 - z,
                                        -Integer(3) * x, Integer(-2),
                                        Integer(0), Rational(-2, 3) * x + y, x - 3, -x - 3,
                                        (-2) * (x + y) ** 3])
def test_signs_are_kept(expression):
    """Minus signs are gathered into subtractions and one negation at most, at the end."""
    program = program_of(expression, {})
    exact = expression.subs({x: Rational(5, 3), y: Rational(-7, 2), z: 2})
    found = run(program, {"x": Fraction(5, 3), "y": Fraction(-7, 2), "z": Fraction(2)})[-1]
    assert found == Fraction(int(exact.p), int(exact.q))
    assert sum(step.operation == "negative" for step in program.steps) == sum(
        step.operation == "negative" for step in program.steps[-1:])


@pytest.mark.slow
def test_nothing_is_multiplied_by_one(margins):
    """No product has the constant 1 as a factor: it would cost a step, and be counted as two roundings."""
    for margin in [*margins, -x, -x * y + z]:
        program = program_of(margin, {})
        ones = {i for i, step in enumerate(program.steps) if step.operation == "constant" and step.value == 1}
        assert not [step for step in program.steps if step.operation == "multiply"
                    and ones & set(step.arguments)], margin


def test_functions_are_leaves():
    """exp(b k3), √2 and such are read, not computed; they vary along what their symbols vary along."""
    b = gs.symbol("b")
    program = program_of(exp(b * k3) * x + sqrt(2) * y, {b: frozenset({0}), k3: frozenset({2})})
    axes = {step.value: step.axes for step in program.steps if step.operation == "leaf"}
    assert axes == {exp(b * k3): frozenset({0, 2}), sqrt(2): frozenset(), x: frozenset(), y: frozenset()}


def test_programs_are_remembered_by_expression_and_axes():
    """The same margin on the same axes is the same program; on others it is another."""
    margin = (x + y) * z
    assert program_of(margin, {x: frozenset({0})}) is program_of(margin, {x: frozenset({0}), y: frozenset()})
    assert program_of(margin, {x: frozenset({0})}) != program_of(margin, {x: frozenset({1})})
