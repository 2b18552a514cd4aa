"""Quantities in every place that takes a number: the right dimension is read, any other is refused."""
import random
import re
from pathlib import Path

import pytest

import gyrostat as gs
from gyrostat.algebra.text.numbers import exact_number
from gyrostat.algebra.text.quantities import dimension_of
from gyrostat.cli.options.axis_option import axis_of
from gyrostat.errors import GyrostatError
from gyrostat.mechanics.families.scene_tables import SceneTable
from gyrostat.questions.given_numbers import numbers_of

# of each kind its dimension in kg, m, s, and spellings of it; those of a pure number are none
KINDS = {
    "inertia": ((1, 2, 0), ("kg m^2", "g m²", "slug ft^2", "N m s^2", "kg·mm^2")),
    "momentum": ((1, 2, -1), ("N m s", "mNms", "kg m^2 rad/s", "kg m^2 rpm", "lbf ft s")),
    "rate": ((0, 0, -1), ("rad/s", "rpm", "deg/s", "rev/day", "s^-1", "°/s")),
    "torque": ((1, 2, -2), ("N m", "J", "kg m²·s⁻²", "lbf ft")), "mass": ((1, 0, 0), ("kg", "lb", "N s^2/m")),
    "length": ((0, 1, 0), ("km", "ft", "m^2/m")), "time": ((0, 0, 1), ("s", "min", "day")),
    "mu": ((0, 3, -2), ("km^3/s^2", "m³·s⁻²")), "angle": ((0, 0, 0), ("deg", "rad", "°", "arcmin", "rev")),
    "pure": (None, ())}
STRANGE = ("kg m^2 deg", "min/rev", "s^-2", "kg^2 m^2", "m/m", "rad^2", "W", "N/m", "kg rad", "km deg")
ORBIT = gs.assemble(gs.Gyrostat((60, 70, 35), (0, 0, 0)), gs.circular_orbit(1))
FREE = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)))


def table(**entries):
    """A body of a table with what is asked."""
    return SceneTable({"inertia": "900, 900, 900 kg m^2", **entries}).system


def wheel(**entries):
    """A wheel of the command line, in a body without another number."""
    texts = {"axis": "0,0,1", "inertia": "1 g m^2", **entries}
    return table(lumped=True, rotors=[" ".join(f"{name}={x}" for name, x in texts.items())])


PLACES = [
    ("inertia", lambda x: gs.Gyrostat((x, x, x), (0, 0, 0))),
    ("inertia", lambda x: gs.Gyrostat(f"[[2, 0, 0], [0, 3, 0], [0, 0, 2]] {x[2:]}", (0, 0, 0))),
    ("momentum", lambda x: gs.Gyrostat("1, 1, 1 kg m^2", (0, 0, x))),
    ("inertia", lambda x: gs.Rotor((0, 0, 1), x)), ("inertia", lambda x: gs.Rotor((0, 0, 1), "1 g m^2", x)),
    ("rate", lambda x: gs.Rotor((0, 0, 1), "1 g m^2", rate=x)), ("pure", lambda x: gs.Rotor((0, x, 1), 1)),
    ("momentum", lambda x: gs.Rotor((0, 0, 1), "1 g m^2", momentum=x)),
    ("rate", gs.circular_orbit), ("mu", lambda x: gs.circular_orbit(mu=x, radius="7000 km")),
    ("length", lambda x: gs.circular_orbit(mu="4e5 km^3/s^2", radius=x)),
    ("length", lambda x: gs.circular_orbit(height=x)), ("time", lambda x: gs.circular_orbit(period=x)),
    ("angle", lambda x: gs.release(ORBIT, (x, 0, 0))),
    ("rate", lambda x: gs.mechanics.angle_rates((x, 0, 0))),
    ("torque", lambda x: gs.mechanics.momentum_limits(FREE.body, x)),
    ("torque", lambda x: gs.mechanics.torque_equations(FREE.body, (x, 0, 0))),
    ("momentum", lambda x: gs.equilibrium(FREE, (x, 0, 0))),
    ("mass", lambda x: gs.underwater_vehicle(mass=(x, x, x))),
    ("inertia", lambda x: wheel(inertia=x)), ("rate", lambda x: wheel(speed=x)),
    ("momentum", lambda x: wheel(momentum=x)), ("pure", lambda x: wheel(axis=f"0,{x},1")),
    ("length", lambda x: table(orbit=f"height={x}")), ("time", lambda x: table(orbit=f"period={x}")),
    ("rate", lambda x: table(orbit=x))]
NAMES = {"inertia": ("I1", "I3"), "momentum": ("l", "l2", "pi3_0", "C1", "M", "p_phi"), "pure": ("k3", "k1"),
         "rate": ("omega0", "omega", "omega2_0"), "torque": ("m0", "dU", "d2U_13", "energy", "sigma"),
         "angle": ("theta", "psi")}
OPTIONS = {"time": ("--until", "--step"), "torque": ("--energy",), "momentum": ("--momentum",),
           "pure": ("--tolerance", "resolution"), "rate": ("--transverse", "--axial")}


@pytest.mark.slow
def test_every_place_takes_its_dimension_and_no_other():
    """Whatever spelling it has; what is no quantity of the place is said in at most 300 characters."""
    draw = random.Random(5)
    named = [(kind, name) for kind, names in NAMES.items() for name in names]
    places = [*PLACES, *((kind, lambda x, name=name: numbers_of([f"{name}={x}"])) for kind, name in named),
              *((kind, lambda x, name=name: axis_of("--x", f"{name}=0:{x}:5")) for kind, name in named),
              *((kind, lambda x, name=name: exact_number(x, name)) for kind, names in OPTIONS.items()
                for name in names)]
    for kind, place in places:
        for right in KINDS[kind][1]:
            place(f"2 {right}")
        others = [unit for other, (dimension, units) in KINDS.items() for unit in units
                  if dimension != KINDS[kind][0]]
        for wrong in ("m/m", *draw.sample([*others, *STRANGE], 2)):
            with pytest.raises(GyrostatError, match="is a number of|has no unit") as refused:
                place(f"2 {wrong}")
            assert len(str(refused.value)) <= 300


SOURCE = Path(gs.__file__).parent
ANY = {"value", "f", "g", "a Casimir", "its value", "an integral"}    # which may be of any dimension


def test_every_argument_that_is_read_has_a_dimension():
    """The label under which a number is read stands in a table, or is the name of what the user gives."""
    labels = [(path.stem, label) for path in SOURCE.rglob("*.py") for label in re.findall(
        r"""exact_(?:number|expression)\([^"\n]*, "([^"]+)"\)""", path.read_text(encoding="utf-8"))]
    assert len(labels) > 20
    assert [label for label in labels if label[1] not in ANY and dimension_of(label[1]) is None] == []


@pytest.mark.parametrize(("text", "ends"), [
    ("l=-2:2 N m s", ("-2 N m s", "2 N m s")), ("l=-2 N m s:2 N m s:4", ("-2 N m s", "2 N m s")),
    ("l=0:2", ("0", "2"))])
def test_a_unit_after_the_last_end_is_that_of_both(text, ends):
    """As after the last entry of a vector."""
    found = axis_of("--x", text, "NAME=LOW:HIGH[:COUNT]", 5)
    assert found[1:3] == tuple(exact_number(end, "l") for end in ends)


def test_degrees_stand_in_trigonometric_functions():
    """And nowhere else in an expression."""
    assert exact_number("cos(60 deg)") == exact_number("sin(30°)") == exact_number("1/2")
    assert exact_number("tan(45°)", "k3") == 1
    for text in ("sqrt(30 deg)", "(30 deg)", "exp(30°)", "30° + 1"):
        with pytest.raises(GyrostatError):
            exact_number(text, "k3")
