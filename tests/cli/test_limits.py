"""The command line at its limits: exceptions of others, numbers beyond doubles, files that are kept."""
import errno
import json

import pytest

import gyrostat
from gyrostat.cli.parser import main
from gyrostat.cli.verbs import report

TOPS = ["--equilibrium", "E1", "--potential", "m0*k3", "--set", "I1=1", "--set", "I3=1.6", "--set", "l=0",
        "--set", "m0=1"]


@pytest.mark.parametrize(("raised", "status", "said"), [
    (ValueError("of\nflint"), 2, "internal error, ValueError: of flint; it is a bug"),
    (MemoryError(), 2, "not enough memory"),
    (KeyboardInterrupt(), 130, "interrupted; nothing is kept"),
    (OSError(errno.ENOSPC, "No space"), 2, "cannot write to standard output")])
def test_the_last_resort(capsys, monkeypatch, raised, status, said):
    """One line for whatever comes, and a traceback where it is asked for."""
    def run(given, out):
        raise raised
    monkeypatch.setattr(report, "run", run)
    assert main(["report"]) == status
    err = capsys.readouterr().err
    assert said in err and len(err.splitlines()) == 1
    monkeypatch.setenv("GYROSTAT_DEBUG", "1")
    if isinstance(raised, ValueError):
        with pytest.raises(ValueError, match="flint"):
            main(["report"])


@pytest.mark.parametrize("text", ["0", "-1", "nan", "inf", "1e400", "soon", ""])
def test_a_time_is_positive_seconds(capsys, text):
    """Or none."""
    with pytest.raises(SystemExit) as stop:
        main(["report", f"--timeout={text}"])
    assert stop.value.code == 2 and "is not a time: give seconds" in capsys.readouterr().err


@pytest.mark.slow
@pytest.mark.parametrize("arguments", [
    ["decide", "--potential", "m0*k3", "--set", "I1=2", "--set", "I3=1", "--set", "l=1", "--set", "m0=1/2",
     "--set", "omega=1e400"],
    ["report", "--equilibrium", "E1", *TOPS[2:], "--set", "pi3_0=1e400"],
    ["decide", *TOPS, "--set", "omega3_0=1e-400"]])
def test_json_has_no_infinity(capsys, arguments):
    """A number beyond doubles is null."""
    def refused(constant):
        raise AssertionError(constant)
    assert main([*arguments, "--format", "json"]) == 0
    found = json.loads(capsys.readouterr().out, parse_constant=refused)
    if "omega=1e400" in arguments:
        assert found["equilibria"][0]["place"]["omega"] is None


@pytest.mark.few(1)
@pytest.mark.parametrize(("verb", "potential", "missing"), [
    ("conditions", "k3**(1/3)", ["E2"]),
    pytest.param("conditions", "1/(k3-1)", ["E1"], marks=pytest.mark.slow),
    ("conditions", "asin(k3)", ["E1", "E2"]),
    pytest.param("conditions", "exp(-1/(1-k3))", ["E1"], marks=pytest.mark.slow),
    ("report", "1/(k3-1)", ["E1"])])
def test_the_others_are_given_where_one_does_not_exist(capsys, verb, potential, missing):
    """And why it does not; in JSON and LaTeX too; asked for alone it is an error."""
    for form in ("text", "latex", "json"):
        assert main([verb, "--potential", potential, "--format", form]) == 0
        out = capsys.readouterr().out
        assert all(f"{label} cannot be analysed: U " in " ".join(out.split())
                   for label in missing)
    labels = {e["label"]: "error" in e for e in json.loads(out)["equilibria"]}
    assert {label: label in missing for label in ("E1", "E2", "E3")}.items() <= labels.items()
    assert main([verb, "--potential", potential, "--equilibrium", missing[0]]) == 2


@pytest.mark.slow
def test_decide_gives_the_others(capsys):
    """At numbers: of U = 1/(k3 − a) at a = 1 E2 is decided, and E1 says why it is not."""
    numbers = [f"--set={s}" for s in ("I1=1", "I3=1/2", "l=1", "pi3_0=1")]
    for potential, more in (("1/(k3-a)", ["--set=a=1"]), ("1/(k3-1)", [])):
        assert main(["decide", "--potential", potential, *numbers, *more, "--format", "json"]) == 0
        found = {e["label"]: e for e in json.loads(capsys.readouterr().out)["equilibria"]}
        assert found["E2"]["decision"]["verdict"] == "STABLE" and "finite" in found["E1"]["error"]
    assert main(["decide", "--potential", "1/(k3-1)", *numbers]) == 0
    assert "E1 cannot be analysed" in capsys.readouterr().out


def test_no_class_name_is_prose(capsys):
    """What is not solved for says so in words; LaTeX has the reason, with its signs escaped.

    All names of the relation of l need numbers, I3 too; k3 may stay open.
    """
    top = ["conditions", "--potential", "exp(k3)", "--solve-for", "l"]
    for form in ("text", "latex"):
        assert main([*top, "--format", form]) == 0
        out = " ".join(capsys.readouterr().out.split())
        assert "Error" not in out
        assert "E3 ties l to the other names" in out
        assert "give numbers for I1, I3, omega; k3 may stay open" in out
    assert main(["conditions", "--potential", "m0*k3", "--solve-for", "pi3_0", "--format", "latex"]) == 0
    assert r"E3 has no parameter pi3\_0" in capsys.readouterr().out


def test_a_table_is_read_by_others(capsys, tmp_path):
    """pandas and NumPy; the numbers it is of stand above it."""
    import numpy as np
    pandas = pytest.importorskip("pandas")
    path = tmp_path / "top.csv"
    assert main(["motion", "--potential", "m0*k3",
                 *(f"--set={s}" for s in ("I1=1", "I3=0.6", "l=0.4", "m0=1")), "--state",
                 "0.3,-0.2,10,0.6,0,0.8", "--until", "3", "--count", "4", "--output", str(path)]) == 0
    table = pandas.read_csv(path, comment="#")
    assert (
        list(table.columns)
        == "time pi1 pi2 pi3 k1 k2 k3 omega1 omega2 omega3 q0 q1 q2 q3 phi theta psi".split()
    )
    assert table.iloc[0, :7].tolist() == [0, 0.3, -0.2, 10, 0.6, 0, 0.8]
    with open(path) as file:
        read = np.genfromtxt((line for line in file if line[0] != "#"), delimiter=",", names=True)
    assert read["q0"].tolist() == pytest.approx(table["q0"].tolist(), rel=1e-15, abs=0)
    head = [line[2:].strip() for line in path.read_text().splitlines() if line[0] == "#"]
    assert "inertia = (1, 1, 3/5)" in head
    assert "state = (3/10, -1/5, 10, 3/5, 0, 4/5)" in head
    assert "potential = k3" in head
    assert "omega1 [s-1]: angular velocity of the body, axis 1" in head
    assert f"gyrostat_version = {gyrostat.__version__}" in head


@pytest.mark.slow
def test_the_old_file_is_kept(capsys, tmp_path, monkeypatch):
    """Of every kind, where writing the new one fails; nothing lies beside it."""
    from matplotlib.animation import PillowWriter
    from matplotlib.figure import Figure
    xarray = pytest.importorskip("xarray")

    def full(*_, **__):
        raise OSError(errno.ENOSPC, "No space left on device")
    for owner, name in ((Figure, "savefig"), (xarray.Dataset, "to_netcdf"), (PillowWriter, "finish")):
        monkeypatch.setattr(owner, name, full)
    box = ["motion", "--potential", "none", *(f"--set={s}" for s in ("I1=1", "I2=2", "I3=5/2", "l=0")),
           "--state", "1/50,2,0",
           "--until", "6", "--count", "2", "--output"]
    cones = ["plot", "cones", "--set", "I1=2", "--set", "I3=1", "--transverse", "1", "--axial", "2",
             "--output"]
    for command, kind in ((box, "png"), (box, "nc"), (box, "gif"), (cones, "svg")):
        (path := tmp_path / f"old.{kind}").write_text("old")
        assert main([*command, str(path)]) == 2 and path.read_text() == "old"
        assert capsys.readouterr().err == f"gyrostat: cannot write {path}: No space left on device\n"
    assert len(list(tmp_path.iterdir())) == 4
