"""Short inequalities that suffice for a permanent rotation: with them the second variation is definite."""
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import gyrostat as gs
from gyrostat.printing.formats.text import text
from gyrostat.printing.results.document import conditions_blocks
from gyrostat.stability.criteria.short_sufficient import short_sufficient

a, b, d, omega, I1, I2, I3 = map(gs.symbol, ("a", "b", "d", "omega", "I1", "I2", "I3"))
BODY = gs.Gyrostat(gyrostatic_momentum=(0, 0, 0))
MOMENTS = st.fractions("1/4", 9, max_denominator=12)
NUMBERS = st.fractions(-3, 3, max_denominator=9)


@pytest.fixture(scope="module")
def level():
    """The rotations with sigma = −I2 omega² of a body whose centre of mass has no component along axis 2."""
    scene = gs.assemble(BODY, gs.general_potential(lambda k1, k2, k3: a * k1 + b * k3))
    k = gs.stereographic()
    momentum = [I * omega * x for I, x in zip((I1, I2, I3), k)]
    return gs.analyze(gs.equilibrium(scene, (*momentum, *k), relations=(
        (a, (I1 - I2) * omega**2 * k[0]), (b, (I3 - I2) * omega**2 * k[2]))))


@pytest.fixture(scope="module")
def any_direction():
    """Every permanent rotation in U = a k1 + b k2 + d k3."""
    U = gs.general_potential(lambda k1, k2, k3: a * k1 + b * k2 + d * k3)
    return gs.analyze(gs.permanent_rotation(gs.assemble(BODY, U), gs.stereographic()))


def holds(criterion, numbers):
    """Whether all its margins are positive and no even factor is 0."""
    values = {gs.symbol(name): x for name, x in numbers.items()}
    return all(c.margin.subs(values) > 0 and all(e.subs(values) != 0 for e in c.degenerate)
               for c in criterion.alternatives[0])


@pytest.mark.slow
@settings(max_examples=40)
@given(moments=st.tuples(MOMENTS, MOMENTS, MOMENTS), u=st.tuples(NUMBERS, NUMBERS), rate=NUMBERS)
def test_they_suffice_for_the_class(level, moments, u, rate):
    """At sigma = −I2 omega² they are I2 > I1 and I2 > I3, off the plane across axis 2."""
    numbers = dict(zip(("I1", "I2", "I3", "u1", "u2", "omega"), (*moments, *u, rate)))
    assume(rate != 0)
    short = holds(short_sufficient(level.equilibrium), numbers)
    assert short == (moments[1] > moments[0] and moments[1] > moments[2] and u[1] != 0)
    assert holds(level.written_out.sufficient, numbers) or not short


@pytest.mark.slow
@settings(max_examples=40)
@given(moments=st.tuples(MOMENTS, MOMENTS, MOMENTS), u=st.tuples(NUMBERS, NUMBERS), rate=NUMBERS,
       sigma=st.fractions(-40, 0, max_denominator=9))
def test_they_suffice_in_any_direction(any_direction, moments, u, rate, sigma):
    """If I_i omega² + sigma < 0 for each axis, the rotation is stable by the second variation."""
    names = ("I1", "I2", "I3", "u1", "u2", "omega", "sigma")
    numbers = dict(zip(names, (*moments, *u, rate, sigma)))
    assume(holds(short_sufficient(any_direction.equilibrium), numbers) and rate != 0)
    assert holds(any_direction.written_out.sufficient, numbers)


def test_they_are_printed_before_the_long_ones(level):
    """The long condition follows; a short one has none before it."""
    said = text(conditions_blocks(level))
    assert "  These short inequalities suffice:\n    I₂ > I₁\n    I₂ > I₃\n" in said
    assert said.index("These short inequalities suffice") < said.index("Sufficient:")
    top = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())))
    assert "short inequalities" not in text(conditions_blocks(top))


def test_there_are_none_where_the_part_is_not_diagonal():
    """A field with a product, a body of revolution, a free body and a body at rest."""
    crossed = gs.assemble(BODY, gs.general_potential(lambda k1, k2, k3: a * k1 * k2 + b * k3))
    assert short_sufficient(gs.equilibrium(crossed, (0, 0, I3 * omega, 0, 0, 1))) is None
    resting = gs.assemble(BODY, gs.general_potential(lambda k1, k2, k3: a * k3))
    assert short_sufficient(gs.equilibrium(resting, (0, 0, 0, 0, 0, 1))) is None
    assert short_sufficient(gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field()))) is None
