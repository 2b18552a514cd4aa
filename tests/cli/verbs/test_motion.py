"""gyrostat motion: tables and data; bodies, states and times; errors."""
import sys
from fractions import Fraction

import commands
import mpmath
import numpy as np
import pytest
from cli.two_motions import FREE, TOP, the_box, the_top

import gyrostat as gs
from gyrostat.cli.parser import main
from gyrostat.questions.scene_texts import Asked, scene_of
from gyrostat.trajectories import motion


def run(capsys, *arguments):
    return commands.run(capsys, *arguments, verb="motion")


def rows(text):
    return [line.split(",") for line in text.splitlines() if not line.startswith("#")]


def test_the_table_is_the_motion(capsys, heavy):
    """Read back, each double is that of the library; what is known of the motion goes to standard error."""
    status, out, err = run(capsys, *TOP, "--until", "30")
    top, (header, *lines) = the_top(heavy), rows(out)
    found = np.array(lines, dtype=float)
    assert status == 0 and header[:7] == ["time", "pi1", "pi2", "pi3", "k1", "k2", "k3"] and len(found) == 201
    assert found[:, 0].tolist() == [3 * n / 20 for n in range(201)]
    np.testing.assert_array_equal(found[:, 1:7], top(found[:, 0]))
    known = dict(line.split(maxsplit=1) for line in err.splitlines())
    assert known["route"] == "elliptic" and float(known["period"]) == top.period
    assert known["precession"] == f"{top.precession} in a period"
    assert float(known["error"].split(",")[0]) < 1e-13
    worst, name, _ = known["drift"].split(", ")
    drift = top.drift(found[:, 0])
    assert float(worst) == pytest.approx(max(drift.values()), rel=0.5)   # of roundings
    assert float(worst) == pytest.approx(drift[name.removeprefix("of ")], rel=0.5)


@pytest.mark.parametrize(("arguments", "times"), [
    (["--until", "1", "--count", "11"], [0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1]),
    (["--until", "1", "--step", "0.3"], [0, 0.3, 0.6, 0.9]),
    (["--until", "-1/3", "--step", "1/6"], [0, -1 / 6, -1 / 3]),
    (["--until", "2*pi", "--step", "pi/2"], [0, np.pi / 2, np.pi, 3 * np.pi / 2, 2 * np.pi])])
def test_times(capsys, arguments, times):
    """Each the double next to the exact time, from 0 forwards or back, T included where a step reaches it."""
    _, out, _ = run(capsys, *FREE, *arguments)
    assert [float(row[0]) for row in rows(out)[1:]] == times


def test_all_digits(capsys, heavy):
    """With --precision the times are decimals, and the states those at the times as written."""
    _, out, err = run(capsys, *TOP, "--until", "1e9/3", "--count", "3", "--precision", "25")
    top, lines = the_top(heavy, precision=25), rows(out)[1:]
    assert [line[0] for line in lines] == ["0", "166666666.6666666666666667", "333333333.3333333333333333"]
    for time, *state in lines:
        assert state == [mpmath.nstr(x, 25) for x in top(Fraction(time))]
    assert f"period      {mpmath.nstr(top.period, 25)}\n" in err and "error" not in err and "drift" not in err
    _, out, _ = run(capsys, *TOP, "--until", "1", "--step", "0.1", "--precision", "20")
    assert [row[0] for row in rows(out)[1:5]] == ["0", "0.1", "0.2", "0.3"]


@pytest.mark.slow
def test_files_of_numbers(capsys, tmp_path):
    """The table in a file; netCDF holds the dataset of the library."""
    import xarray as xr
    box = the_box()
    status, out, err = run(capsys, *FREE, "--until", "9", "--count", "120", "--output",
                           str(tmp_path / "box.csv"))
    assert status == 0 and out == "" and err.startswith("route       free gyrostat\n")
    found = np.array(rows((tmp_path / "box.csv").read_text())[1:], dtype=float)
    np.testing.assert_array_equal(found[:, 1:4], box(found[:, 0]))
    assert run(capsys, *FREE, "--until", "9", "--count", "120", "--output", str(tmp_path / "box.nc"))[0] == 0
    with xr.open_dataset(tmp_path / "box.nc") as data:
        again = box.to_xarray(found[:, 0])
        # the angles of two computations may differ in the last bit, where NumPy's loops begin elsewhere
        xr.testing.assert_allclose(data.load(), again, rtol=0, atol=1e-14)
        assert data.attrs == again.attrs


@pytest.mark.parametrize(("potential", "names", "inertia", "rotor"), [
    ("k3", "I1 I3 l", "I1 I1 I3", "0 0 l"), ("k3", "I1 I2 I3 l", "I1 I2 I3", "0 0 l"),
    ("k1*k3", "I1 I2 I3 l", "I1 I2 I3", "0 0 l"),
    ("k3", "I1 I3 l1 l2 l3", "I1 I1 I3", "l1 l2 l3"), ("none", "I1 I2 I3 l1 l2 l3", "I1 I2 I3", "l1 l2 l3")])
def test_bodies(potential, names, inertia, rotor):
    """I2, k1 or k2, or no field at all: three moments; l1, l2, l3: any rotor."""
    body = scene_of(Asked(potential).of_body(names.split())).body
    assert " ".join(map(str, body.inertia)) == inertia
    assert " ".join(map(str, body.gyrostatic_momentum)) == rotor


def test_a_general_body_is_integrated(capsys, tmp_path, monkeypatch):
    """Three moments, three components of the rotor, U(k1, k2, k3).

    On a terminal a bar, wiped before the table.
    """
    import xarray as xr
    # heyoka compiles longer than this takes
    monkeypatch.setattr("gyrostat.trajectories.integrated.integrated_motion.find_spec", lambda name: None)
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    monkeypatch.setattr("gyrostat.charts.progress.QUIET", 0.0)
    monkeypatch.setattr("gyrostat.charts.progress.PAUSE", 0.0)
    sets = [f"--set={number}" for number in ("I1=1", "I2=2", "I3=3", "l1=0", "l2=0.1", "l3=1/2", "a=-1")]
    given = ["--potential", "a*k1*k2 + k3", *sets, "--state", "0.1,0,5,0,0,1", "--until", "-2", "--count",
             "4"]
    status, out, err = run(capsys, *given)
    scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, "0.1", "1/2")),
                        gs.general_potential(lambda x, y, z: z - x * y))
    found, wanted = np.array(rows(out)[1:], dtype=float), motion(scene, ("0.1", 0, 5, 0, 0, 1))
    np.testing.assert_array_equal(found[:, 1:7], wanted(found[:, 0]))
    assert status == 0 and "period" not in err and "route       DOP853" in err
    assert "motion       [" in err and "] 4/4" in err and " \rroute" in err
    assert run(capsys, *given, "--output", str(tmp_path / "body.nc"))[0] == 0
    # the steps are those of all times
    with xr.open_dataset(tmp_path / "body.nc") as data:
        xr.testing.assert_identical(data.load(), wanted.to_xarray(found[:, 0]))


@pytest.mark.slow
def test_numbers_below_0_after_an_option(capsys):
    """--state -1/3,2,0 --until -1 --set and --potential -k3 are values, not options; -h is help."""
    separate = run(capsys, *FREE[:-1], "-1/3,2,0", "--until", "-1/2", "--count", "2")
    assert separate[0] == 0
    assert separate == run(capsys, *FREE[:-2], "--state=-1/3,2,0", "--until=-1/2", "--count=2")
    for arguments in (["--potential", "-m0*k3"], ["--fragment", "--format", "latex"]):
        assert main(["report", "--equilibrium", "E1", *arguments]) == 0
    with pytest.raises(SystemExit) as stop:
        main(["report", "--fragment", "-h"])
    assert stop.value.code == 0


@pytest.mark.slow
@pytest.mark.parametrize(("arguments", "why"), [
    (["--until", "0"], "--until 0 cannot be the last time of a motion that starts at 0: give another time"),
    (["--until", "1e400"], "give another time"),
    (["--until", "1", "--count", "1"], "--count 1 gives 1 times"),
    (["--until", "1", "--step", "2"], "--step 2 gives 1 times"),
    (["--until", "1", "--step", "1e-9"], "1000000001 times"),
    (["--until", "1", "--step", "-1"], "--step -1 is not positive"),
    (["--until", "1", "--step", "0"], "--step 0 is not positive"), (["--until", "soon"], "give a number"),
    (["--until", "1", "--tolerance", "0"], "--tolerance 0 is not positive"),
    (["--until", "1", "--precision", "0", "--count", "2"], "precision = 0"),
    (["--until", "1", "--precision", "20", "--output", "top.nc"],
     "--precision 20 is for a table, and top.nc holds doubles: leave it out"),
    (["--until", "1", "--precision", "20", "--set", "I2=2"], "this scene is integrated, in doubles"),
    (["--until", "1", "--set", "l1=1"],
     "both l and l1 are given, and l is the rotor along axis 3: give l, or l1, l2, l3"),
    (["--until", "1", "--set", "mass=1"], "no parameter mass"),
    (["--until", "1", "--state", "1,2,3"], "3 numbers, and the body has 6 coordinates"),
    (["--until", "1", "--state", "__import__('os'),0,0,0,0,1"], "cannot read"),
    (["--until", "1", "--state", "1,0,x,0,0,1"], "pi3 = x"),
    (["--until", "1", "--potential", "k1"],
     "and a motion needs one for each name; the body has the moments (I1, I2, I3) and the rotor (0, 0, l): "
     "add --set I2=…"),
    (["--until", "1", "--potential", "a*k1 + b*k3"], "no number for I2, a, b, and a motion"),
    (["--until", "1", "--potential", "a*k1 + b*k3"], ": add --set I2=… a=… b=…"),
    (["--until", "1", "--output", "top.txt"], "suffixes that are known here: name a table, motion.csv"),
    (["--until", "1", "--output", "missing/top.csv"], "cannot write")])
def test_bad_input_exits_2(capsys, tmp_path, monkeypatch, arguments, why):
    """A clear error on stderr, nothing on stdout, nothing written."""
    monkeypatch.chdir(tmp_path)
    status, out, err = run(capsys, *TOP, *arguments)
    assert status == 2
    assert out == ""
    assert err.startswith("gyrostat: ")
    assert why in err
    assert len(err.splitlines()) == 1
    assert list(tmp_path.iterdir()) == []


def test_a_field_is_needed(capsys):
    """An unspecified U moves nothing."""
    status, out, err = run(capsys, *TOP[2:], "--until", "1")
    assert status == 2 and out == "" and "--potential is missing" in err and "none for a free body" in err


@pytest.mark.parametrize(("missing", "kind", "extra"),
                         [("matplotlib", "png", "plot"), ("matplotlib", "gif", "plot"),
                                                        ("netCDF4", "nc", "charts"),
                          ("xarray", "nc", "charts")])
def test_missing_extras_are_named(capsys, tmp_path, monkeypatch, missing, kind, extra):
    """The pip command, exit status 2."""
    monkeypatch.setitem(sys.modules, missing, None)
    status, out, err = run(capsys, *TOP, "--until", "1", "--output", str(tmp_path / f"top.{kind}"))
    assert status == 2
    assert out == ""
    assert f'pip install "gyrostat[{extra}]"' in err
    assert list(tmp_path.iterdir()) == []


def test_help(capsys):
    """With examples."""
    with pytest.raises(SystemExit) as stop:
        main(["motion", "--help"])
    out = capsys.readouterr().out
    assert stop.value.code == 0
    assert "gyrostat motion --potential" in out
    assert "--state PI1,PI2,PI3,K1,K2,K3" in out
