"""Every kind of scene with an equilibrium and numbers, as a scene file has it, or made in Python alone."""
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import gyrostat as gs
from gyrostat.algebra.reals.exact import Point
from gyrostat.algebra.text.grammar import parse
from gyrostat.algebra.text.numbers import exact_number
from gyrostat.mechanics.equilibrium.standard_axes import placed
from gyrostat.mechanics.equilibrium.unit_vectors import direction_in
from gyrostat.mechanics.families.scene_tables import SceneTable
from gyrostat.mechanics.scenes.system import names_of_scene
from gyrostat.notation import jet


@dataclass(frozen=True)
class Case:
    """One equilibrium of a scene at numbers.

    level: what a list of all is asked with, beside the numbers of the scene; None where there is no list.
    """

    values: dict[str, str]
    table: dict[str, Any] | None = None
    make: Callable[[], gs.Equilibrium] | None = None
    level: dict[str, str] | None = None

    @cached_property
    def equilibrium(self):
        """By its family, or as a point."""
        if self.make is not None:
            return self.make()
        read = SceneTable(self.table)
        if "point" in self.table:
            return gs.equilibrium(read.system, list(map(parse, self.table["point"])))
        direction = read.table.get("direction")
        return read.family.of(read.system, self.table.get("spin", "pi3_0"), None,
                              direction and direction_in(direction), read.table.get("pointing"))

    @cached_property
    def report(self):
        """As analyze makes it."""
        return gs.analyze(self.equilibrium)

    @cached_property
    def numbers(self):
        """As exact numbers."""
        return Point({gs.symbol(name): exact_number(x, name) for name, x in self.values.items()})

    @cached_property
    def at_numbers(self):
        """The same equilibrium of the scene at numbers."""
        return placed(self.equilibrium, self.numbers)

    @cached_property
    def jets(self):
        """The numbers for derivatives of an unspecified U."""
        return {name: x for name, x in self.values.items() if jet(name)}

    @cached_property
    def asks_for_all(self):
        """The numbers of a list in which it is."""
        tied = {str(name): str(x.subs(self.numbers)) for name, x in self.equilibrium.relations}
        own = {s.name for s in names_of_scene(self.equilibrium.system)}
        return {**{name: (tied | self.values)[name] for name in own}, **self.level}

    def listed(self):
        """The one of the list that is this equilibrium."""
        found = gs.relative_equilibria(self.equilibrium.system, self.asks_for_all)
        return next(e for e in found if self._is(e))

    def _is(self, e):
        """Whether it is the same, up to the symmetries of a body of revolution; the sphere of a ball is."""
        point = self.at_numbers.point
        if "sigma" in e.rates:
            along, k3 = e.form.described[0]
            place = along.subs(dict(zip(self.equilibrium.system.space.coordinates, point)))
            return k3 is not None and abs(float(place - k3)) < 1e-12
        if e.locus.startswith("a curve"):                  # of which another point may stand in the list
            place = dict(zip(map(gs.symbol, ("k1", "k2", "k3")), point[-3:]))
            return abs(complex(e.form.curve.subs(place))) < 1e-12
        return e.locus == "the whole sphere" or _near(e.point, point)


def _near(one, other):
    return max(abs(complex(x - y)) for x, y in zip(one, other)) < 1e-12


def _free(inertia, rotor, *point):
    return {"inertia": inertia, "gyrostatic_momentum": [*rotor]} | (
        {"point": [*point]} if len(point) > 1 else {"equilibrium": point[0]})


def _top(label, **more):
    return ROUND | {"potential": "m0*k3", "equilibrium": label} | more


def _vehicle(omega=(0, 0, 0), weight=5):
    d = gs.symbol("d")
    scene = gs.underwater_vehicle((1, 1, 1), (2, 2, 1), [[0, -d, 0], [d, 0, 0], [0, 0, 0]],
                                  weight=(0, 0, weight))
    return gs.steady_motion(scene, (0, 0, 2), (0, 0, 1), omega=omega)


def _level():
    scene = gs.underwater_vehicle((1, 1, 1), weight=(0, 0, gs.symbol("m0")))
    return gs.steady_motion(scene, (0, gs.symbol("p0"), 0), (0, 0, 1))


def _two_fields():
    a, b, k1, e2 = map(gs.symbol, ("a", "b", "k1", "e2"))
    scene = gs.assemble(gs.Gyrostat((2, 2, 1), (0, 0, 1)), gs.coupled_potential(-a * k1 - b * e2))
    return gs.steady_motion(scene, (1, 0, 0), (0, 1, 0))


def _any_direction():
    body = gs.Gyrostat(gyrostatic_momentum=tuple(map(gs.symbol, ("l1", "l2", "l3"))))
    c = [gs.symbol(f"c{n}") for n in (1, 2, 3)]
    field = gs.general_potential(lambda *k: sum(x * y for x, y in zip(c, k)))
    return gs.permanent_rotation(gs.assemble(body, field))


def _held():
    d, orbit = gs.symbol("d"), gs.circular_orbit()
    body = gs.Gyrostat([["3/2", d, 0], [d, 2, "1/20"], [0, "1/20", 1]], (0, gs.symbol("l"), 0))
    return gs.earth_pointing(gs.assemble(gs.earth_pointing_gyrostat(body, orbit), orbit))


def _screw():
    return gs.steady_motion(gs.underwater_vehicle(), (0, 0, gs.symbol("p0")),
                            omega=(0, 0, gs.symbol("w")))


ANY = {"inertia": ["I1", "I2", "I3"], "gyrostatic_momentum": ["0", "0", "0"]}
ROUND = {"inertia": ["I1", "I1", "I3"], "gyrostatic_momentum": ["0", "0", "l"]}
UP = ["0", "0", "3*omega", "0", "0", "1"]
HEAVY = {"inertia": ["5", "4", "3"], "gyrostatic_momentum": ["0", "0", "0"], "potential": "k3", "point": UP}
WHEEL = {"inertia": ["3", "2", "2"], "gyrostatic_momentum": ["0", "0", "0"]}
KOVALEVSKAYA = "(pi1^2/4 - pi2^2/4 + k1)^2 + (pi1*pi2/2 + k2)^2"
SPIN = {"I1": "1", "I3": "8/5", "l": "0", "m0": "1"}
EARTH = ANY | {"orbit": "omega0", "equilibrium": "earth-pointing"}
MOMENTS = {"I1": "1", "I2": "2", "I3": "3"}
ASTEROID = "a*(I1*r1^2 + I2*r2^2 + I3*r3^2) + b*(I1*n1^2 + I2*n2^2 + I3*n3^2)"
# the moments 1, 5/4, 8/5 along the directions (2, −1, 2)/3, (2, 2, −1)/3, (−1, 2, 2)/3
TURNED = [["53/45", "-1/45", "-17/90"], ["-1/45", "62/45", "19/90"], ["-17/90", "19/90", "233/180"]]
PRECESSES = ROUND | {"orbit": "omega0"}
TILT = {"I1": "1", "n3": "3/4", "omega0": "1"}
ROTOR = ("0", "0", "1/2")

CASES = {
    "free, axis 3": Case(MOMENTS | {"omega3_0": "1"}, ANY | {"equilibrium": "axis 3"}, level={"M": "3"}),
    "free, middle axis": Case(MOMENTS | {"omega2_0": "1"}, ANY | {"equilibrium": "axis 2"},
                              level={"M": "2"}),
    "free, a fold": Case({"omega3_0": "-1/4"}, _free(["1", "2", "3"], ROTOR, "axis 3"), level={"M": "1/4"}),
    "free, three meet": Case({"omega3_0": "-1/2"}, _free(["1", "2", "3"], ROTOR, "axis 3"), level={"M": "1"}),
    "free, a circle": Case({}, _free(["1", "1", "2"], "000", "1", "0", "0"), level={"M": "1"}),
    "free, a ball": Case({}, _free(["2", "2", "2"], "000", "0", "0", "-1"), level={"M": "1"}),
    "free, a tensor": Case({}, _free([[*"500"], [*"031"], [*"013"]], "000", *"100"), level={"M": "1"}),
    "E1, fast": Case(SPIN | {"pi3_0": "3"}, _top("E1"), level={"omega": "15/8"}),
    "E1, critical": Case(SPIN | {"pi3_0": "2"}, _top("E1"), level={"omega": "5/4"}),
    "E1, slow": Case(SPIN | {"pi3_0": "1"}, _top("E1"), level={"omega": "5/8"}),
    "E1, U unspecified": Case({"I1": "1", "I3": "2", "l": "1", "dU": "1", "pi3_0": "1", "d2U": "-3"},
                              _top("E1", potential="U(k3)")),
    "E3": Case({"I1": "2", "I3": "1", "k3": "1/2", "omega": "2", "a": "1"}, _top("E3", potential="a*k3^2"),
               level={"omega": "2"}),
    "E3, unstable": Case({"I1": "2", "I3": "1", "k3": "0", "omega": "1", "a": "-9"},
                         _top("E3", potential="a*k3^2"), level={"omega": "1"}),
    "about axis 1": Case({"omega": "3"}, WHEEL | {"potential": "k1", "point": ["3*omega", *"00100"]},
                         level={"omega": "3"}),
    "a tilt about axis 1": Case({}, WHEEL | {"potential": "k1^2", "point": [*"020010"]},
                                level={"omega": "1"}),
    "of revolution at numbers": Case({"I1": "3", "I2": "2", "I3": "2", "a": "0", "omega": "3"}, ANY | {
        "potential": "k1 + a*k2^2", "point": ["I1*omega", *"00100"]}, level={"omega": "3"}),
    "upright, least": Case({"omega": "0"}, HEAVY | {"potential": "-k3"}, level={"omega": "0"}),
    "upright, a window": Case({"omega": "9"}, HEAVY, level={"omega": "9"}),
    "upright, unstable": Case({"omega": "1/5"}, HEAVY, level={"omega": "1/5"}),
    "permanent rotation": Case(MOMENTS | {"a": "pi/2", "omega": "1", "sigma": "-9"}, ANY | {
        "potential": "c1*k1 + c3*k3", "direction": "sin(a), 0, cos(a)", "equilibrium": "permanent-rotation"}),
    "any direction": Case(MOMENTS | {"l1": "0", "l2": "0", "l3": "0", "omega": "2", "sigma": "-6", "k1": "1",
                                     "k2": "0", "k3": "0"}, make=_any_direction),
    "on a circle of one rate": Case({}, {
        "inertia": [*"123"], "gyrostatic_momentum": [*"000"],
        "potential": "k1^2/2 + k2^2 + 3*k3^2/2 + (2*k1 + k2 + 2*k3)^2",
        "point": ["0", "-4/sqrt(5)", "3/sqrt(5)", "0", "-2/sqrt(5)", "1/sqrt(5)"]}, level={"omega": "1"}),
    "on a curve of rotations": Case({}, {
        "inertia": [*"123"], "gyrostatic_momentum": [*"000"],
        "potential": "(k1^2 + k2/2)^2", "point": [*"000001"]}, level={"omega": "0"}),
    "an integral that is given": Case({"omega": "5"}, {
        "inertia": ["2", "2", "1"], "gyrostatic_momentum": ["0", "0", "0"], "potential": "-k1",
        "integrals": [KOVALEVSKAYA], "point": ["2*omega", *"00100"]}, level={"omega": "5"}),
    "no torque": Case({}, {"inertia": ["1", "2", "3"], "gyrostatic_momentum": ["0", "0", "1"],
                           "potential": "k1^2 + k2^2 + k3^2", "point": [*"002001"]}),
    "a degenerate minimum": Case(MOMENTS | {"a": "2", "b": "1"}, ANY | {
        "potential": "a*k1^2 + b*k2^4", "point": [*"000001"]}),
    "in orbit, least": Case({"I1": "5/4", "I2": "8/5", "I3": "1", "omega0": "1"}, EARTH, level={}),
    "in orbit, open": Case({"I1": "60", "I2": "32", "I3": "35", "omega0": "1"}, EARTH, level={}),
    "in orbit, unstable": Case({"I1": "1", "I2": "8/5", "I3": "5/4", "omega0": "1"}, EARTH, level={}),
    "in orbit, not all damped": Case({"I1": "1", "I2": "2", "I3": "2", "omega0": "1", "l": "-3"}, EARTH | {
        "gyrostatic_momentum": ["0", "l", "0"]}, level={}),
    "on a closed curve": Case({}, {"orbit": "1", "inertia": ["3/2", "9/10", "6/5"], "gyrostatic_momentum": [
        "0", "6/(5*sqrt(2))", "0"], "point": ["0", "9*sqrt(2)/20", "-3*sqrt(2)/5", "0", "sqrt(2)/2",
                                              "-sqrt(2)/2", "0", "sqrt(2)/2", "sqrt(2)/2"]}, level={}),
    "in orbit, with drag": Case({}, {"orbit": "1", "inertia": ["1", "5/4", "8/5"], "potential": "4/5*t1",
                                     "point": ["0", "0", "8/5", *"001010"]}, level={}),
    "in orbit, a dipole": Case({"I1": "5/4", "I2": "8/5", "I3": "1", "omega0": "1", "m0": "1/3"}, EARTH | {
        "potential": "m0*r3"}, level={}),
    "in orbit, an asteroid": Case({"I1": "5/4", "I2": "8/5", "I3": "1", "omega0": "1", "a": "-1/5",
                                   "b": "1/3"}, EARTH | {"potential": ASTEROID}, level={}),
    "in orbit, a free wheel": Case({"omega0": "1"}, {
        "orbit": "omega0", "inertia": ["60", "70", "35"], "lumped": True, "equilibrium": "earth-pointing",
        "rotors": [{"axis": [*"010"], "axial": "5", "momentum": "1"}]}, level={}),
    "in orbit, in other axes": Case({}, {
        "orbit": "1", "inertia": TURNED, "gyrostatic_momentum": ["-1/15", "2/15", "2/15"], "point": [
            "-8/15", "16/15", "16/15", "-1/3", "2/3", "2/3", "2/3", "-1/3", "2/3"]}, level={}),
    "in orbit, held by a rotor": Case({"d": "1/10", "l": "1/5", "omega0": "1"}, make=_held),
    "cylindrical": Case({"I1": "1", "I3": "8/5", "l": "1", "omega0": "1"}, PRECESSES | {
        "equilibrium": "cylindrical"}, level={}),
    "hyperbolic": Case(TILT | {"I3": "8/5"}, PRECESSES | {"equilibrium": "hyperbolic"}),
    "conical": Case(TILT | {"I3": "1/2"}, PRECESSES | {"equilibrium": "conical"}),
    "conical, a window": Case(TILT | {"I3": "8/5"}, PRECESSES | {"equilibrium": "conical"}),
    "conical, a ball": Case(TILT | {"I3": "1"}, PRECESSES | {"equilibrium": "conical"}),
    "level": Case({"p0": "2", "m0": "1", "mass1": "1", "mass2": "3/2", "mass3": "2"}, make=_level),
    "rising": Case({"d": "3/10"}, make=_vehicle),
    "rising with spin": Case({"d": "3/10", "w": "1"}, make=lambda: _vehicle((0, 0, gs.symbol("w")))),
    "rising, held by its spin": Case({"d": "3/10", "w": "4"},
                                     make=lambda: _vehicle((0, 0, gs.symbol("w")), 1)),
    "two fields": Case({"a": "1", "b": "2"}, make=_two_fields),
    "screw motion": Case(MOMENTS | {"mass1": "1", "mass2": "2", "mass3": "3", "p0": "1", "w": "2"},
                         make=_screw),
}
