"""Hostile values in every argument of everything public: an answer or a sentence, and nothing is executed."""
import inspect
import math
import sys

import numpy as np
import pytest
from public_calls import called, calls
from sympy import I, eye
from test_surface import function_of, methods, public

import gyrostat as gs
from gyrostat.errors import GyrostatError

MADE = (gs.Gyrostat, gs.Rotor)                         # other classes are those of results
INSIDE = ("Equilibrium.at_point", "Equilibrium.insert", "Equilibrium.insert_field", "Equilibrium.derived",
          "Potential.value", "Potential.following", "AmendedPotential.critical_points", "symbol")
EXECUTED = ("os.system", "os.exec", "os.posix_spawn", "subprocess.Popen", "socket.connect")
CALL = "__import__('os').system('true')"
VALUES = (None, True, 3.5, math.nan, math.inf, CALL, b"", [], {}, object(), 10**400, int, -1, "k3", "", I,
          np.array([object()] * 3), np.array([1.0, 0, 1]), [math.nan] * 3, [CALL] * 3, {CALL: CALL}, eye(3),
          range(10**9), "9^9^9^9")
SMALL = tuple(value for value in VALUES if not isinstance(value, range))       # what fits in any memory
TOLD = ("path", "store")                               # a file that is not there is said by Python
OWN = ("progress", "change")                           # functions of the user, whose errors are theirs


def slots(given):
    """Where a value can stand: arguments, entries of theirs, and one name more in a mapping."""
    for name, value in given.items():
        yield name, None
        if isinstance(value, dict):
            yield from ((name, key) for key in (*value, "one more"))
        elif isinstance(value, list | tuple) and not hasattr(value, "_fields"):
            yield from ((name, n) for n in range(min(len(value), 6)))


def with_value(given, slot, bad):
    """The arguments with a value in a place."""
    name, place = slot
    if place is None:
        return given | {name: bad}
    if not isinstance(given[name], dict):
        entries = list(given[name])
        entries[place] = bad
        return given | {name: type(given[name])(entries)}
    if place == "one more" and getattr(bad, "__hash__", None):
        return given | {name: given[name] | {bad: 1}}
    return given | {name: given[name] | {place: bad}}


def questions():
    """(name, callable, arguments, slot) of every place of a verb that people call."""
    for name, function, given in calls():
        if not inspect.isclass(function) or function in MADE:
            yield from ((name, function, given, slot) for slot in slots(given) if name not in INSIDE)


def asked(name, function, given, slot, values):
    """What is wrong with the answers, by value."""
    for bad in values:
        ran = []
        EVENTS.append(ran)
        try:
            called(function, with_value(given, slot, bad))
        except GyrostatError as refused:
            if not str(refused) or len(str(refused)) > 300:
                yield f"{name} {slot} {bad!r:.30}: {len(str(refused))} characters, {refused}"
        except OSError as error:
            if slot[0] not in TOLD:
                yield f"{name} {slot} {bad!r:.30}: {error!r:.150}"
        except Exception as error:
            if slot[0] not in OWN:
                yield f"{name} {slot} {bad!r:.30}: {error!r:.150}"
        finally:
            EVENTS.remove(ran)
        if ran:
            yield f"{name} {slot} {bad!r:.30}: executed {ran}"


EVENTS = []                                            # lists, each of what is executed while one is asked


@pytest.fixture(scope="module", autouse=True)
def _watched():
    """Whatever is executed while a question is asked is written down."""
    def seen(event, _):
        for ran in EVENTS:
            if event in EXECUTED:
                ran.append(event)

    sys.addaudithook(seen)


TOP = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
UP, BODY = gs.upright(TOP), gs.Gyrostat((1, 2, 3), (0, 0, 0))
HEAVY, HUNG = (gs.assemble(BODY, gs.general_potential(field)) for field in ("k1+k2+k3", "k3"))


@pytest.mark.slow
@pytest.mark.parametrize("function, given", [
    (gs.Gyrostat, {"inertia": (1, 2, "5/2"), "gyrostatic_momentum": (0, 0, 1)}),
    (gs.general_potential, {"expression": "k1"}), (gs.newtonian_field, {"order": 2}),
    (gs.coupled_potential, {"expression": "-k1 - 2*e2", "directions": ("k", "e"), "drift": (0, 0, 0),
                            "held": (("k1^2 + k2^2 + k3^2", 1),)}),
    (gs.equilibrium, {"scene": TOP, "point": (0, 0, "pi3_0", 0, 0, 1), "relations": (), "domain": ()}),
    (gs.analyze(UP).verdict, {"values": {"I1": 1, "l": 0, "m0": 1, "pi3_0": 3}, "damped": False}),
    (gs.derivation.linearize, {"eq": UP}), (gs.relative_equilibria, {"scene": HUNG, "values": {"omega": 2}}),
    pytest.param(gs.relative_equilibria, {"scene": HEAVY, "values": {"omega": 2}}, marks=pytest.mark.slow),
    (gs.mechanics.angle_rates, {"omega": ("omega1", 0, 0), "convention": "zxz"}),
    (gs.circular_orbit, {"rate": 1, "potential": 0}),
    (gs.underwater_vehicle, {"coupling": [[0, 0, 0], [0, 0, 0], [0, 0, 0]], "weight": (0, 0, 1)})])
def test_hostile_values_at_some_doors(function, given):
    """Whatever is given for a body, a field, a point, names and numbers."""
    wrong = [line for slot in slots(given)
             for line in asked(function.__name__, function, given, slot, VALUES)]
    assert not wrong, "\n".join(wrong)


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore")                  # a warning is no error, and objects are left half made
@pytest.mark.parametrize("part", range(4))
def test_hostile_values_everywhere(part, tmp_path, monkeypatch):
    """In every place of every call, six of the values, each value in every sixth place."""
    monkeypatch.chdir(tmp_path)
    wrong = [line for n, question in enumerate(questions()) if n % 4 == part
             for line in asked(*question, SMALL[n // 4 % 4::4])]
    assert not wrong, "\n".join(wrong)


@pytest.mark.slow
def test_every_public_verb_is_called():
    """What takes an argument is in public_calls, by the list of the surface."""
    named = {inspect.unwrap(getattr(function, "__func__", function)) for _, function, _ in calls()}
    inside = {"gs.Report.decide", "gs.Report.decide_point"}
    for name, what in public():
        if inspect.isfunction(what):
            assert inspect.unwrap(what) in named, name
        for attribute, member in methods(what) if inspect.isclass(what) else ():
            called_by = inspect.signature(function_of(member)).parameters
            if len(called_by) > 1 and f"{name}.{attribute}" not in inside:
                assert inspect.unwrap(function_of(member)) in named, f"{name}.{attribute}"
