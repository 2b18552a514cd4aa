"""What is refused is refused in at most 300 characters, and no long exact number is quoted whole."""
import ast
import re
from pathlib import Path

import pytest
from sympy import Integer, Rational, sqrt

import gyrostat as gs
from gyrostat.errors import GyrostatError

SRC = Path(gs.__file__).parent
MOST, QUOTED = 300, 12                                 # characters of a message, and of a quotation at least
LONG = Rational(3 * 10**70 + 7, 10**70 + 9)
ROOT = sqrt(Integer(10)**41 + 3) / (10**21 + 7) + sqrt(2) * Rational(10**33, 10**34 + 3)
EXACT = re.compile(r"(?:CRootOf|sqrt|[\d*/()+x, -])+")
MOMENTS = (62 + LONG, 72 + LONG, 39 + LONG)
TENSOR = [[62 + LONG, "1.3", ROOT / 100], ["1.3", 72 + LONG, "0.6"], [ROOT / 100, "0.6", 39 + LONG]]
TEXTS = [str(x) for x in MOMENTS]


def size(node):
    """(characters, quotations) of a message at most, by its tree."""
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        return len(node.value), 0
    if isinstance(node, ast.FormattedValue):
        return size(node.value) if isinstance(node.value, ast.IfExp | ast.Constant) else (0, 1)
    if isinstance(node, ast.IfExp):
        return max(size(node.body), size(node.orelse))
    if isinstance(node, ast.JoinedStr) or isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
        parts = map(size, node.values if isinstance(node, ast.JoinedStr) else (node.left, node.right))
        return tuple(map(sum, zip((0, 0), *parts, strict=True)))
    return 0, 1


def messages(path):
    """(line, tree) of what each exception of the library is made with."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.args and (
                node.func.id.endswith("Error") and hasattr(gs.errors, node.func.id)):
            yield node.lineno, node.args[0]


@pytest.mark.slow
def test_every_message_of_the_source_is_short():
    """Its own words, and 12 characters for each quotation."""
    found = {f"{path.relative_to(SRC)}:{line}": size(tree) for path in SRC.rglob("*.py")
             for line, tree in messages(path)}
    assert len(found) > 500
    assert not {place: parts for place, parts in found.items() if parts[0] + QUOTED * parts[1] > MOST}


def orbit(**given):
    """One whose rate is a long number."""
    radius = "6778.12345678901234567890123456789 km"
    return gs.circular_orbit(mu="398600.4418 km^3/s^2", radius=radius, **given)


def scene(inertia=TENSOR, momentum=(ROOT, LONG, 1)):
    """A satellite of long numbers."""
    return gs.assemble(gs.Gyrostat(inertia, momentum), orbit())


def wheel(axis, **given):
    """A body with one."""
    return gs.gyrostat_with_rotors(TENSOR, [gs.Rotor(axis, LONG / 100, **given)], lumped=True)


def pointing():
    """A report in names."""
    body = gs.Gyrostat(gyrostatic_momentum=(0, gs.symbol("l"), 0))
    return gs.analyze(gs.earth_pointing(gs.assemble(body, gs.circular_orbit())))


WRONG = [
    lambda: gs.earth_pointing(scene()), lambda: gs.earth_pointing(scene(MOMENTS), 1, 1, LONG),
    lambda: gs.earth_pointing_gyrostat(gs.Gyrostat(TENSOR, (0, LONG, 0)), orbit()),
    lambda: gs.wheel_speeds(scene(), "s"), lambda: gs.wheel_speeds(scene(), "x" * 400),
    lambda: gs.wheel_speeds(gs.assemble(wheel((1, 1, 0), rate=gs.symbol("s")), orbit()), "s"),
    lambda: gs.wheel_speeds(gs.assemble(wheel((0, 1, 0), rate=gs.symbol("s")), orbit()), "s",
                            directions=((LONG, 0, 0), (0, ROOT, 1))),
    lambda: gs.Rotor((LONG, ROOT), 1), lambda: gs.Rotor((0, 0, 1), -ROOT),
    lambda: gs.Rotor((0, 0, 1), ROOT, rate=LONG, momentum=LONG),
    lambda: gs.gyrostat_with_rotors(MOMENTS, [gs.Rotor((0, 0, 1), LONG * 1000, rate=1)], lumped=True),
    lambda: gs.circular_orbit(-ROOT), lambda: gs.circular_orbit(ROOT, period=LONG),
    lambda: gs.circular_orbit(mu=-ROOT, radius=LONG), lambda: gs.circular_orbit(height=ROOT),
    lambda: gs.circular_orbit(height="500 km", body="pluto" * 99),
    lambda: orbit(potential=gs.symbol("k1") * ROOT * LONG + ROOT),
    lambda: orbit(potential=f"({ROOT * LONG})*k1"), lambda: orbit(potential=ROOT * gs.symbol("pi1")),
    lambda: gs.Gyrostat((-ROOT, 1, 1), (0, 0, 0)), lambda: gs.Gyrostat(MOMENTS, (ROOT, LONG)),
    lambda: gs.Gyrostat([[1, ROOT, LONG], [LONG, 1, 1], [1, 1, 1]], (0, 0, 0)),
    lambda: gs.Gyrostat([[1, ROOT, LONG], [ROOT, 1, 1], [LONG, 1, 1]], (0, 0, 0)),
    lambda: gs.relative_equilibria(scene(MOMENTS), {"x": ROOT}),
    lambda: gs.release(scene(MOMENTS), (ROOT,)),
    lambda: gs.orbital_precession(scene(MOMENTS), "conical"),
    lambda: gs.orbital_precession(gs.assemble(gs.symmetric_gyrostat(), orbit()), "x" * 400),
    lambda: gs.steady_motion(scene(MOMENTS), (ROOT, LONG, 0), (0, 0, 1)),
    lambda: gs.equilibrium(scene(MOMENTS), (ROOT, LONG, 1, ROOT, 0, 0, 0, LONG, 0)),
    lambda: gs.equilibrium(scene(MOMENTS), (ROOT, LONG, 1, 0, 1, 0, 0, 0, 1)),
    lambda: pointing().verdict({"I1": ROOT, "I2": -LONG, "I3": ROOT, "l": LONG, "omega0": 1}),
    lambda: pointing().verdict({"I1": ROOT, "z" * 400: LONG}),
    lambda: gs.stabilizing_set(pointing(), "l", {"I1": -LONG}),
    lambda: gs.questions.conditions({"orbit": str(LONG), "inertia": TEXTS,
                                     "gyrostatic_momentum": [str(ROOT), "0", "0"]}),
    lambda: gs.questions.conditions({"orbit": f"rate={LONG}*k1", "inertia": TEXTS}),
    lambda: gs.questions.decide({"orbit": "height=500 km", "inertia": TEXTS})]


@pytest.mark.few(8)
@pytest.mark.parametrize("number", range(len(WRONG)))
def test_what_is_refused_of_a_satellite_of_long_numbers_is_short(number):
    """With fractions of 71 digits and roots: in 300 characters, and with no number of more than 60."""
    with pytest.raises(GyrostatError) as refused:
        WRONG[number]()
    message = str(refused.value)
    assert len(message) <= MOST
    assert not [part for part in EXACT.findall(message) if len(part.strip()) > 60]


def test_a_long_number_is_cut_and_what_follows_it_stays():
    """At its beginning; a number of 60 characters, and words, stay whole."""
    root = "CRootOf(x**5 - 1234567890123456789012345*x - 12345678901234567890, 0)"
    sevens = f"{'7' * 40} + {'5' * 40}*sqrt(2)"
    for number in ("1" * 61, f"-{'1' * 40}/{'3' * 40}", f"3*{root}", sevens):
        said = str(GyrostatError(f"s = {number} is too long: give a short one, 1/2"))
        assert re.fullmatch(r"s = (.{57}|.{56})… is too long: give a short one, 1/2", said)
        assert said[4:50] == number[:46]
    for whole in ("1" * 60, "the words (a, b) - and so on " * 9):
        assert str(GyrostatError(whole)) == whole
