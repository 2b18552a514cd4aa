"""--scene FILE#NAME: the tables that verify reads, in the place of options, and options before them."""
import pytest
from commands import run
from slow import slow

from gyrostat.published import check

FILE = """
[scene.top]
inertia = ["I1", "I1", "I3"]
gyrostatic_momentum = [0, 0, "l"]
potential = "m0*k3"
equilibrium = "E1"
values = { I1 = 1, I3 = 1.60, l = 0.0, m0 = 1e0, omega3_0 = "5/4" }

[scene.any]
inertia = ["I1", "I1", "I3"]
gyrostatic_momentum = ["0", "0", "l"]
potential = "U(k3)"
equilibrium = "E3"
eliminate = "d2U"
spin = "omega3_0"

[scene.general]
gyrostatic_momentum = ["0", "0", "l"]
potential = "k1*k2 + k3"
point = [0, 0, "I3*w", 0, 0, 1]
state = ["1/10", 0, 5, "3/5", 0, 0.8]
values = { I1 = 1, I2 = 2, I3 = 3, l = 0.5, w = 2.50 }

[scene.moving]
potential = "k1*k2 + k3"
state = ["1/10", 0, 5, "3/5", 0, 0.8]
values = { I1 = 1, I2 = 2, I3 = 2.5 }

[scene.steady]
inertia = [2, 2, 1]
potential = "m0*k3"
values = { m0 = 0.5 }

[scene.box]
inertia = ["I1", "I2", "I3"]
equilibrium = "axis 2"
values = { I1 = 1, I2 = 2, I3 = 3 }
"""
SETS = {"top": ["I1=1", "I3=1.60", "l=0.0", "m0=1e0", "omega3_0=5/4"],
        "general": ["I1=1", "I2=2", "I3=3", "l=0.5", "w=2.50"], "moving": ["I1=1", "I2=2", "I3=2.5"],
        "steady": ["m0=0.5"], "box": ["I1=1", "I2=2", "I3=3"]}
OPTIONS = {
    "top": ["--inertia", "I1,I1,I3", "--gyrostatic-momentum", "0,0,l", "--potential", "m0*k3",
            "--equilibrium", "E1"],
    "general": ["--inertia", "I1,I2,I3", "--gyrostatic-momentum", "0,0,l", "--potential", "k1*k2 + k3",
                "--point", "0,0,I3*w,0,0,1"],
    "moving": ["--inertia", "I1,I2,I3", "--gyrostatic-momentum", "0,0,0", "--potential", "k1*k2 + k3",
               "--state", "1/10,0,5,3/5,0,0.8"],
    "steady": ["--inertia", "2,2,1", "--gyrostatic-momentum", "0,0,0", "--potential", "m0*k3"],
    "box": ["--inertia", "I1,I2,I3", "--gyrostatic-momentum", "0,0,0", "--potential", "none",
            "--equilibrium", "axis 2"]}


@pytest.fixture
def file(tmp_path):
    """The scenes above."""
    path = tmp_path / "scenes.toml"
    path.write_text(FILE)
    return str(path)


def by_options(scene, *but):
    """A scene by options alone, without some names."""
    return [*OPTIONS[scene], *(f"--set={s}" for s in SETS[scene] if s.partition("=")[0] not in but)]


PRINTED = [
    ("report", "top", []), ("report", "top", ["--format", "json"]), ("report", "top", ["--format", "latex"]),
    ("report", "general", []), ("report", "box", ["--set", "omega2_0=1"]), ("conditions", "top", []),
    ("conditions", "general", ["--format", "json"]), ("decide", "top", []),
    ("decide", "general", ["--format", "json"]), ("decide", "box", ["--set", "omega2_0=1"]),
    ("motion", "moving", ["--until", "1/10", "--count", "2"])]


@pytest.mark.parametrize(("verb", "scene", "more"), [PRINTED[0], *slow(*PRINTED[1:])])
def test_a_file_is_the_same_as_options(capsys, file, verb, scene, more, monkeypatch):
    """Byte by byte, numbers of TOML as they are written."""
    # heyoka compiles longer than this takes
    monkeypatch.setattr("gyrostat.trajectories.integrated.integrated_motion.find_spec", lambda name: None)
    found = run(capsys, "--scene", f"{file}#{scene}", *more, verb=verb)
    assert found == run(capsys, *by_options(scene), *more, verb=verb)
    assert found[0] == 0 and len(found[1]) > 50


DRAWN = [
    ("chart", "top", "png", ["--x", "omega3_0=0:2:9", "--y", "l=-1:1:8"], {"omega3_0", "l"}),
    ("chart", "general", "nc", ["--x", "w=0:4:9", "--y", "l=-2:2:8"], {"w", "l"}),
    ("plot eigenvalues", "general", "png", ["--x", "w=0:4:40"], {"w"}),
    ("plot bifurcations", "steady", "png", ["--x", "omega=-1:1"], set()),
    ("plot effective-potential", "steady", "png", ["--set", "p_phi=1", "--set", "p_psi=1"], set()),
    ("plot energy-momentum", "steady", "png", ["--set", "p_psi=1"], set())]


@pytest.mark.parametrize(("verb", "scene", "kind", "more", "axes"), slow(*DRAWN))
def test_a_file_draws_the_same_as_options(capsys, file, tmp_path, verb, scene, kind, more, axes):
    """Data and pictures, byte by byte; an axis goes before the number of the file."""
    verb, *sort = verb.split()
    one, other = (tmp_path / f"{name}.{kind}" for name in ("one", "other"))
    assert run(capsys, *sort, "--scene", f"{file}#{scene}", *more, "--output", str(one), verb=verb)[0] == 0
    assert run(capsys, *sort, *by_options(scene, *axes), *more, "--output", str(other), verb=verb)[0] == 0
    if kind == "png":
        assert one.read_bytes() == other.read_bytes()
        return
    import xarray as xr
    with xr.open_dataset(one) as found, xr.open_dataset(other) as wanted:
        xr.testing.assert_identical(found.load(), wanted.load())
        assert found.verdict.size == 72 and found.I1.attrs["exact"] == "1"


@pytest.mark.slow
def test_the_momentum_sphere_of_a_file(capsys, file, tmp_path):
    """Without a field; a scene with one is refused."""
    drawn = ["momentum-sphere", "--momentum", "1", "--output", str(tmp_path / "sphere.png")]
    assert run(capsys, *drawn, "--scene", f"{file}#box", verb="plot")[0] == 0
    status, _, err = run(capsys, *drawn, "--scene", f"{file}#steady", verb="plot")
    assert status == 2 and "only in a free body, the scene has the potential k3*m0" in err


OVERRIDDEN = [
    ("top", ["--inertia", "2,2,1"], {"I1", "I3"}), ("top", ["--potential", "m0*k3**2"], set()),
    ("top", ["--gyrostatic-momentum", "0,0,1/3"], {"l"}), ("top", ["--equilibrium", "E2"], set()),
    ("top", ["--set", "I3=7/4"], {"I3"}), ("top", ["--set", "pi3_0=2"], {"omega3_0"}),
    ("top", ["--point", "0,0,I3*omega3_0,0,0,-1"], set()),
    ("general", ["--point", "0,0,w,0,0,-1"], set()),
    ("general", ["--equilibrium", "E1", "--set", "pi3_0=1"], {"w"})]


def replaced(options, *others):
    """The options with others in their place; an equilibrium and a point take the place of each other."""
    place = {"--point": "naming", "--equilibrium": "naming"}
    pairs = {place.get(name, name): (name, value) for name, value in zip(options[::2], options[1::2])}
    return [x for pair in {**pairs, **{place.get(n, n): (n, v) for n, v in others}}.values() for x in pair]


@pytest.mark.parametrize(("scene", "options", "gone"), OVERRIDDEN)
def test_an_option_goes_before_the_file(capsys, file, scene, options, gone):
    """Each key has an option; numbers that the key alone named, or of the other spin, give way too."""
    pairs = [pair for pair in zip(options[::2], options[1::2]) if pair[0] != "--set"]
    sets = [f"--set={value}" for name, value in zip(options[::2], options[1::2]) if name == "--set"]
    kept = [f"--set={s}" for s in SETS[scene] if s.partition("=")[0] not in gone]
    found = run(capsys, "--scene", f"{file}#{scene}", *options, verb="decide")
    assert found == run(capsys, *replaced(OPTIONS[scene], *pairs), *kept, *sets, verb="decide")


def test_spin_and_eliminated_name(capsys, file):
    """Keys of verify's tables, each with its option."""
    any_field = ["--scene", f"{file}#any"]
    assert run(capsys, *any_field, "--eliminate", "l") == run(capsys, "--equilibrium", "E3", "--eliminate",
                                                              "l")
    _, out, _ = run(capsys, *any_field, "--equilibrium", "E1", verb="conditions")
    assert "(I₃ ω₃⁰ + l)² ≥ 4 I₁ U′(1)" in out
    assert out == run(capsys, "--equilibrium", "E1", "--spin", "omega3_0", verb="conditions")[1]
    status, _, err = run(capsys, *any_field)
    assert status == 2 and "d2U" in err
    numbers = [f"--set={s}" for s in ("I1=1", "I3=2", "l=0", "dU=1", "pi3_0=3")]
    found = run(capsys, *any_field, "--equilibrium", "E1", *numbers, verb="decide")
    assert found == run(capsys, "--equilibrium", "E1", *numbers, verb="decide") and found[0] == 0


def test_a_motion_leaves_the_numbers_of_an_equilibrium_aside(capsys, file, monkeypatch):
    """w is of the point alone, the spin of E1; a verb that takes neither does without them."""
    monkeypatch.setattr("gyrostat.trajectories.integrated.integrated_motion.find_spec", lambda name: None)
    status, out, _ = run(capsys, "--scene", f"{file}#general", "--until", "1/10", "--count", "2",
                         verb="motion")
    assert status == 0 and "# gyrostatic_momentum = (0, 0, 1/2)\n" in out
    assert "# state = (1/10, 0, 5, 3/5, 0, 4/5)\n" in out
    status, out, _ = run(capsys, "--scene", f"{file}#top", "--state", "0,0,1,0.6,0,0.8", "--until", "1",
                         verb="motion")
    assert status == 0 and "# inertia = (1, 1, 8/5)\n" in out


def test_a_file_with_one_scene_needs_no_name(capsys, tmp_path):
    """The defaults of a file are those of verify: three moments, no rotor, no field."""
    path = tmp_path / "one.toml"
    path.write_text("[scene.box]\nvalues = { omega3_0 = 1, I1 = 1, I2 = 2, I3 = 3 }\n")
    status, out, _ = run(capsys, "--scene", str(path), verb="decide")
    assert status == 0 and out.startswith("rotation about axis 3") and "I₂ − I₃ = −1" in out


def test_a_batch_of_a_scene(capsys, file, tmp_path):
    """Lines give numbers before the file, and another equilibrium in the place of its point."""
    lines = tmp_path / "lines.jsonl"
    lines.write_text('{"w": 1}\n{"equilibrium": "E2", "pi3_0": 6, "w": 0}\n')
    status, out, _ = run(capsys, "--scene", f"{file}#general", "--batch", str(lines), verb="decide")
    first, second = out.splitlines()
    assert '"label": "E"' in first and '"decision": {"verdict": "UNSTABLE"' in first
    assert status == 2 and "E2 has no parameter w" in second


BAD = [
    ("[scene.a]\nmass = 1", "a", "scene.a: a scene has no entry mass: its entries are angles, direction"),
    ("[scene.a]\npotentail = 'k3'", "a", "did you mean potential?"),
    ("[scene.a]\ninertia = [1, 2]", "a", "is not three numbers"),
    ("[scene.a]\ninertia = [1, 2, true]", "a", "write a list of numbers, or of texts in quotation marks"),
    ("[scene.a]\ninertia = 5", "a", "inertia = 5: write a list"),
    ("[scene.a]\npotential = 5", "a", "potential = 5: write a text"),
    ("[scene.a]\npotential = '__import__(\"os\")'", "a", "scene.a: cannot read"),
    ("[scene.a]\nequilibrium = 'E9'", "a", "equilibrium = 'E9': give E1"),
    ("[scene.a]\nequilibrium = 'axis 1'\npoint = [0, 0, 1]", "a", "point and equilibrium are both given"),
    ("[scene.a]\nvalues = 5", "a", "values = 5: write a table"),
    ("[scene.a]\nvalues = { I1 = [1] }", "a", "values.I1 = [1] is not a number"),
    ("[scene.a]\nvalues = { 'a b' = 1 }", "a", "'a b', which is not a name"),
    ("[scene.a]\nvalues = { I1 = nan }", "a", "nan is not a number"),
    ("[scene.a]\nvalues = { I1 = 'I3' }", "a", "contains the names I3"),
    ("[scene.a]\nvalues = { pi3_0 = 1, omega3_0 = 1 }", "a", "both pi3_0 and omega3_0"),
    ("[scene.a]\n[scene.b]\n", "", "has several scenes, a, b: name one, --scene "),
    ("[scene.a]\n", "b", "has no scene b: name one of its"), ("x = 1", "", "has no [scene.NAME] table"),
    ("scene = 5", "", "scene is not made of [scene.NAME] tables"), ("x = [", "", "is not TOML")]


@pytest.mark.parametrize(("text", "name", "why"), BAD)
def test_a_bad_file_is_refused(capsys, tmp_path, text, name, why):
    """One sentence, with the file, the scene and the key."""
    path = tmp_path / "bad.toml"
    path.write_text(text)
    status, out, err = run(capsys, "--scene", f"{path}#{name}" if name else str(path), verb="decide")
    assert status == 2 and out == "" and err.startswith("gyrostat: ") and why in err and err.count("\n") == 1


def test_a_file_that_is_not_there(capsys, tmp_path):
    """Which one."""
    status, _, err = run(capsys, "--scene", str(tmp_path / "none.toml"))
    assert status == 2 and "none.toml: cannot be read" in err


def test_verify_reads_the_same_file(tmp_path):
    """What is for the command line is no formula's."""
    path = tmp_path / "both.toml"
    path.write_text(FILE + """
[source]
name = "mine"
title = "A paper"
[[formula]]
key = "rate"
where = "(1)"
quantity = "dt(k3)"
printed = "pi2*k1/I2 - pi1*k2/I1"
kind = "identity"
scene = "field"
[scene.field]
potential = "k1*k2 + k3"
""")
    assert [finding.status for finding in check([str(path)])] == ["confirmed"]
