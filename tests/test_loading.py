"""What is loaded when it is used: each name is there, stands below, and is not loaded before."""
import re
import sys
from importlib import import_module
from pathlib import Path

import pytest
from loads import COMMANDS, modules_of, ours
from test_layout import FLOORS, SRC, loaded

import gyrostat as gs

WORDS = {"{THEOREMS}": "stability.theorems", "{NORMAL_FORMS}": "stability.normal_forms"}


def named():
    """(module that asks, module:name) of every call of loaded in the library."""
    for path in SRC.rglob("*.py"):
        for home in re.findall(r'\bloaded\(\s*f?"([^"]+)"', path.read_text(encoding="utf-8")):
            for word, meaning in WORDS.items():
                home = home.replace(word, meaning)
            yield pytest.param(path.relative_to(SRC), home, id=f"{path.stem}-{home}")


@pytest.mark.parametrize(("asking", "home"), list(named()))
def test_what_is_loaded_by_its_name_is_there_and_below(asking: Path, home):
    """A misspelt name would be seen by whoever stands on that rung, and by nobody before."""
    module, _, name = home.partition(":")
    if name:                                               # a name may be chosen when it is loaded
        assert hasattr(import_module(f"gyrostat.{module}"), name)
    here, there = (FLOORS.index(x) for x in (asking.with_suffix("").parts[0], module.split(".")[0]))
    assert there <= here or asking.stem == "_lazy"          # whose example it is


@pytest.mark.slow
def test_the_report_of_a_sleeping_top_loads_no_theorem_that_it_does_not_need():
    """Its ladder stands on the criteria and on the reduced motion."""
    new = loaded("import gyrostat as g; "
                 "r = g.analyze(g.upright(g.assemble(g.symmetric_gyrostat(), g.uniform_field()))); "
                 "r.necessary, r.sufficient, r.boundary, r.damped; "
                 "r.verdict({'I1': 1, 'l': 0, 'm0': 1, 'pi3_0': 2}); "
                 "r.verdict({'I1': 1, 'I3': 1, 'l': 0, 'm0': 1, 'pi3_0': 3}, damped=True)")
    theorems = {m for m in new if m.startswith("gyrostat.stability.theorems.")}
    assert theorems == {"gyrostat.stability.theorems.boundary"}
    assert not any(m.startswith("gyrostat.stability.normal_forms") for m in new)


LIMITS = {"--version": 20, "report": 124, "conditions": 154, "decide": 162, "decide, a free gyrostat": 147,
          "decide, a heavy gyrostat": 160, "decide, in orbit": 156, "chart": 216, "motion": 187, "plot": 229,
          "verify": 214}


@pytest.mark.slow
@pytest.mark.parametrize("name", COMMANDS)
def test_a_verb_loads_no_more_modules_than_it_needs(name):
    """Packages not counted; NumPy where there are arrays, Matplotlib where there is a picture."""
    found = modules_of(COMMANDS[name])
    assert f"gyrostat.cli.verbs.{COMMANDS[name][0]}" in found or name == "--version"
    assert len(ours(found)) <= LIMITS[name]
    packages = {m.split(".")[0] for m in found}
    assert ("numpy" in packages) == (COMMANDS[name][0] in ("chart", "motion", "plot", "verify"))
    assert ("matplotlib" in packages) == (COMMANDS[name][0] in ("chart", "plot"))
    assert ("sympy" in packages) == (name != "--version")


@pytest.mark.slow
@pytest.mark.parametrize("asked", [
    ["--potential", "m0*k3", "--set", "I1=2", "I3=1", "l=1", "m0=1/2", "omega=1"],
    ["--potential", "none", "--inertia", "1,2,3", "--gyrostatic-momentum=0,0,1/2", "--momentum", "2"],
    ["--potential", "k1 + k2", "--inertia", "1,2,3", "--gyrostatic-momentum=0,0,1/2", "--set", "omega=2"],
    ["--orbit", "1", "--inertia", "1,5/4,8/5", "--gyrostatic-momentum=3/10,1/5,1/10"]])
def test_a_list_loads_no_numpy(asked):
    """It costs as much as a list."""
    new = loaded("import contextlib, io; from gyrostat.cli.parser import main\n"
                 f"with contextlib.redirect_stdout(io.StringIO()): main({['decide', *asked]!r})")
    assert "gyrostat.equilibria.search" in new and "numpy" not in new


def heavy(moment):
    """A heavy gyrostat that no test has seen."""
    return gs.assemble(gs.Gyrostat((moment, 4, 3), (0, 0, "1/2")), gs.general_potential("k1 + 2*k2 + k3"))


@pytest.mark.few(1)
@pytest.mark.parametrize(("moment", "notion"), [(6, "ARNOLD_MOSER"), (7, "LYAPUNOV")])
def test_the_verdict_on_a_heavy_rotation_calls_functions_of_at_most_55_modules(moment, notion):
    """It is found among all at a rate; verdicts on another body have loaded what is needed."""
    called = set()

    def note(frame, event, _):
        if event == "call" and Path(frame.f_code.co_filename).is_relative_to(SRC):
            called.add(frame.f_code.co_filename)

    others = gs.relative_equilibria(heavy(moment - 1), {"omega": 2})
    notions = [found.decision.notion.name for found in others]
    scene, before = heavy(moment), sys.getprofile()
    sys.setprofile(note)
    try:
        decision = gs.relative_equilibria(scene, {"omega": 2})[notions.index(notion)].decision
    finally:
        sys.setprofile(before)
    assert decision.notion.name == notion and 20 < len(called) <= 55
