"""Quantities with units: exact in SI, of the right dimension, never half of them."""
from fractions import Fraction

import pytest
from commands import run
from sympy import Rational, pi

import gyrostat as gs
from gyrostat.algebra.text.numbers import exact_number
from gyrostat.algebra.text.quantities import quantity
from gyrostat.algebra.text.units import UNITS, Dimension, unit
from gyrostat.errors import ExpressionError, ValuesError

SI = [("120 kg m^2", 120, (1, 2, 0)), ("3000 rpm", 100 * pi, (0, 0, -1, 1)),
      ("5 deg", pi / 36, (0, 0, 0, 1)),
      ("0.1 N m s", Rational(1, 10), (1, 2, -1)), ("2 mNms", Rational(1, 500), (1, 2, -1)),
      ("-3 deg/s", -pi / 60, (0, 0, -1, 1)), ("5 kg·m²·s⁻¹", 5, (1, 2, -1)),
      ("2*pi rad/s", 2 * pi, (0, 0, -1, 1)),
      ("1/3 g mm^2", Rational(1, 3 * 10**9), (1, 2, 0)), ("2 kg m m/s/s", 2, (1, 2, -2)),
      ("1 slug ft^2", Rational(45359237 * 980665 * 3048, 10**8 * 10**5 * 10**4), (1, 2, 0)),
      ("1 lb in^2", Rational(45359237, 10**8) * Rational(254, 10**4)**2, (1, 2, 0)),
      ("2 rev/min", pi / 15, (0, 0, -1, 1)), ("5°", pi / 36, (0, 0, 0, 1)), ("1 h", 3600, (0, 0, 1))]


@pytest.mark.parametrize(("text", "number", "dimension"), SI)
def test_a_quantity_is_its_number_in_si(text, number, dimension):
    """Exactly, turns and degrees with π."""
    assert quantity(text) == (number, Dimension(*dimension))


@pytest.mark.parametrize(("text", "why"), [
    ("5 furlong", "'furlong' is no unit"), ("5 kg m^20", "power '20'"), ("5 m^(1/2)", "parenthesis"),
    ("a kg", "a unit stands after a number"), ("5 kg)", "no unit"), ("5 kg +", "no unit"),
    ("5 kg /", "ends too"), ("5" + " m" * 9, "more than 8 units"), ("5 exec", "no unit"),
    ("5 m^99999999999", "power")])
def test_what_is_no_quantity_says_why(text, why):
    """A unit that is not known is not taken for a factor."""
    with pytest.raises(ExpressionError, match=why):
        quantity(text)


@pytest.mark.parametrize(("text", "name", "why"), [
    ("5 kg", "I1", "a number of kg, but I1 .*is one of kg m.2"), ("5 rpm", "l", "kg m.2 s.-1"),
    ("5 rpm", "inertia", "kg m.2"),
    ("5 deg", "omega3_0", "of rad, but .* of s.-1"), ("5 kg", "--until", "of s")])
def test_another_dimension_is_refused(text, name, why):
    """A rate where an inertia is meant."""
    with pytest.raises(ValuesError, match=why):
        exact_number(text, name)


def test_a_name_of_the_user_may_be_anything():
    """Its dimension is not known."""
    assert exact_number("5 rpm", "speed") == pi / 6


@pytest.mark.parametrize(("inertia", "rotor"), [
    (("1 kg m^2", 2, 3), (0, 0, 0)), (("1 kg m^2", "2 kg m^2", "3"), (0, 0, 0)),
    (("1 kg m^2", "2 kg m^2", "3 kg m^2"), (0, 0, 1)), ((1, 2, 3), (0, 0, "1 N m s"))])
def test_quantities_and_bare_numbers_are_not_mixed(inertia, rotor):
    """In one body; nobody knows what unit a bare number is in."""
    with pytest.raises(ValuesError, match="has a unit and .* has none"):
        gs.Gyrostat(inertia, rotor)


def test_zero_and_names_need_no_unit():
    """They go with any."""
    body = gs.Gyrostat([["5 kg m^2", "1 kg m^2", 0], ["1 kg m^2", "4 kg m^2", "0"], [0, 0, "30000 g m^2"]],
                       (0, "20 mN m s", gs.symbol("l3")))
    assert body.entries == (5, 4, 30, 0, 0, 1)
    assert body.gyrostatic_momentum == (0, Rational(1, 50), gs.symbol("l3"))


def test_a_verdict_at_quantities():
    """The numbers of the values have units as well."""
    report = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field()), spin="omega3_0"))
    values = {"I1": "1 kg m^2", "I3": "2 kg m^2", "l": 0, "m0": "1 N m", "omega3_0": "10 rpm"}
    assert report.verdict(values).verdict == report.verdict(
        {"I1": 1, "I3": 2, "l": 0, "m0": 1, "omega3_0": pi / 3}).verdict


def test_values_are_not_mixed_either(capsys):
    """Nor those of the command line; a pure number has no unit."""
    scene = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    report = gs.analyze(gs.upright(scene))
    values = {"I1": "1 kg m^2", "I3": 2, "l": 0, "m0": "1 N m", "pi3_0": "1 N m s"}
    with pytest.raises(ValuesError, match="I1 = '1 kg m.2' has a unit and I3 = 2 has none"):
        report.verdict(values)
    with pytest.raises(ValuesError, match="I3 = 2 has none"):
        gs.trajectories.motion(scene, (0, 0, 1, 0, 0, 1), {"I1": "1 kg m^2", "I3": 2, "l": 0, "m0": 1})
    with pytest.raises(ValuesError, match="M = 1 has none"):
        gs.relative_equilibria(gs.assemble(gs.Gyrostat(gyrostatic_momentum=(0, 0, 0))),
                               {"I1": "1 kg m^2", "I2": "2 kg m^2", "I3": "3 kg m^2", "M": 1})
    status, _, err = run(capsys, "--potential", "none", "--set", "I1=1 kg m^2", "I2=2", "I3=3", "omega3_0=1",
                         verb="decide")
    assert status == 2 and "I2 = '2' has none" in err
    assert gs.relative_equilibria(scene, {"I1": "2 kg m^2", "I3": "1 kg m^2", "l": 0, "m0": "3 N m",
                                          "k3": "1/2", "pi3_0": "6 N m s"})


@pytest.fixture(scope="module")
def library():
    return pytest.importorskip("pint").UnitRegistry()


@pytest.mark.slow
def test_quantities_of_a_library(library):
    """With magnitude and units, as pint has them."""
    of = library.Quantity
    assert exact_number(of(3000, "rpm"), "omega") == 100 * pi
    assert exact_number(of(Fraction(1, 3), "kg mm^2"), "I1") == Rational(1, 3 * 10**6)
    with pytest.raises(ValuesError, match="one of kg m"):
        exact_number(of(5, "deg"), "I1")


@pytest.mark.parametrize("name", [*UNITS, "kg", "mm", "MN", "arcminute", "pound_force", "kJ", "uW"])
def test_units_are_those_of_a_library(name, library):
    """Sizes and dimensions, against pint."""
    text = {"Nm": "N*m", "Nms": "N*m*s", "min": "minute", "h": "hour", "rev": "turn"}.get(name, name)
    theirs = library.Quantity(1, text).to_base_units()
    size, dimension = unit(name)
    assert float(size) == pytest.approx(float(theirs.magnitude), rel=1e-14)
    powers = theirs.dimensionality
    assert dimension[:3] == tuple(int(powers.get(f"[{d}]", 0)) for d in ("mass", "length", "time"))


@pytest.mark.parametrize("asked", [
    lambda x: gs.permanent_rotation(gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)), gs.general_potential()),
                                    (x, 0, 0)),
    lambda x: gs.circular_orbit(mu=x, radius=1), lambda x: gs.circular_orbit(mu=1, radius=x),
    lambda x: gs.mechanics.free_precession((1, 2), x, 1), lambda x: gs.plotting.draw_smelt_plane(x),
    lambda x: gs.plotting.draw_smelt_plane(0, {"station": (x, x, x)}),
    lambda x: gs.underwater_vehicle(mass=(x, 1, 1)),
    lambda x: gs.equilibrium(gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0))), (x, 0, 0)),
    lambda x: gs.steady_motion(gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)), gs.circular_orbit(1)),
                               (x, 0, 0), (0, 1, 0))],
    ids=["direction", "mu", "radius", "rate", "Smelt", "its bodies", "mass", "point", "normal"])
def test_every_argument_has_its_dimension(asked):
    """Newtons are those of none of them; a pure number has no unit, nor that of an angle."""
    with pytest.raises(ValuesError, match="3 N is a number of kg m s.-2, but .* is one (of|without)"):
        asked("3 N")
