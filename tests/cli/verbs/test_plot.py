"""gyrostat plot: each picture is that of the library; files and errors."""
import sys

import numpy as np
import pytest
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from PIL import Image

import gyrostat as gs
from gyrostat import plotting
from gyrostat.cli.parser import main
from gyrostat.trajectories import motion


def sets(text):
    return [f"--set={setting}" for setting in text.split()]


HEAVY = ["--potential", "m0*k3", *sets("I1=1 I3=1/2 l=0 m0=1")]
BODY = {"I1": 1, "I3": "1/2", "l": 0, "m0": 1}
STATE = ["--state", "0,0,3,0.8,0,0.6"]
HOPF = ["--potential", "m0*k3", *sets("I1=1 I3=1.6 l=0 m0=1"), "--equilibrium", "E1"]


def space(elev=22, azim=40):
    return Figure().add_subplot(projection="3d", elev=elev, azim=azim)


def flat():
    return Figure().subplots()


def sphere(heavy):
    return plotting.draw_momentum_sphere(gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, "0.55"))), 2,
                                         ax=space())


def level(heavy):
    return plotting.draw_momentum_sphere(gs.assemble(gs.Gyrostat((1, 2, 3), (0, "1/4", "1/2"))), 2, {},
                                         [1, 1.5], ax=space())


def nutation(heavy):
    top = motion(heavy, (0, 0, 3, "0.8", 0, "0.6"), BODY)
    return plotting.draw_nutation(top, [n / 4 for n in range(9)], space())


def well(heavy):
    return plotting.draw_effective_potential(heavy, BODY | {"p_phi": 1, "p_psi": 1}, "1.9", flat())


def branches(heavy):
    return plotting.draw_bifurcation_diagram(heavy, "omega", ("-1/2", 3), BODY, flat())


def in_orbit(heavy):
    scene = gs.assemble(gs.Gyrostat((1, "5/4", "8/5"), (0, gs.symbol("l2"), 0)), gs.circular_orbit(1))
    return plotting.draw_bifurcation_diagram(scene, "l2", (1, 2), {}, flat())


def spun_up(heavy):
    scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, gs.symbol("l"))))
    return plotting.draw_bifurcation_diagram(scene, "l", ("0", 1), {"M": 1}, flat())


def rotors(heavy):
    return plotting.draw_rotor_set(gs.assemble(gs.Gyrostat()), {"I1": 1, "I2": 2, "I3": 3, "l2": 0, "M": 1},
                                   flat())


def staude(heavy):
    scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)), gs.general_potential(lambda *k: sum(k)))
    return plotting.draw_staude_cone(scene, {}, space())


def staude_plane(heavy):
    scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, "1/2")), gs.general_potential(lambda k1, k2, k3: k3))
    return plotting.draw_staude_plane(scene, {}, ("-3", 3), flat())


def amended(heavy):
    scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 1)), gs.general_potential(lambda *k: sum(k)))
    return plotting.draw_amended_potential(scene, {"C1": 3}, space())


def diagram(heavy):
    return plotting.draw_energy_momentum(heavy, BODY | {"p_psi": 1}, ax=flat())


def hopf(heavy):
    eq, samples = gs.upright(heavy, spin="omega3_0"), np.linspace(2.2, 0, 40)
    return plotting.draw_eigenvalues(eq, "omega3_0", samples.tolist(),
                                     {"I1": 1, "I3": "1.6", "l": 0, "m0": 1}, flat())


def rolling(heavy):
    return plotting.draw_cones((2, 1), 1, "2", space(14, 12))


def contents(figure):
    """All that is drawn, as numbers and texts."""
    found = []
    for ax in figure.axes:
        named = [*ax.texts, *(ax.get_legend().get_texts() if ax.get_legend() else [])]
        found += [ax.get_xlabel(), ax.get_ylabel(), ax.name, getattr(ax, "azim", 0),
                  *sorted(text.get_text() for text in named)]
        found += [np.nan_to_num(np.array(line.get_data_3d() if ax.name == "3d"
                                         else line.get_data())).tolist() for line in ax.lines]
        found += [np.array(c.get_segments()).tolist() if type(c) is LineCollection else type(c).__name__
                  for c in ax.collections]
    return found


@pytest.mark.slow
@pytest.mark.parametrize(("arguments", "ours"), [
    (["momentum-sphere", *sets("I1=1 I2=2 I3=3 l=0.55"), "--momentum", "2"], sphere),
    pytest.param(["momentum-sphere", *sets("I1=1 I2=2 I3=3 l1=0 l2=1/4 l3=1/2"), "--momentum", "2",
                  "--energy", "1", "--energy", "1.5"], level, marks=pytest.mark.slow),
    (["nutation", *HEAVY, *STATE, "--until", "2", "--step", "1/4"], nutation),
    (["effective-potential", *HEAVY, *sets("p_phi=1 p_psi=1"), "--energy", "1.9"], well),
    (["bifurcations", *HEAVY, "--x", "omega=-1/2:3"], branches),
    pytest.param(["bifurcations", "--potential", "none", *sets("I1=1 I2=2 I3=3 M=1"), "--x", "l=0:1"],
                 spun_up, marks=pytest.mark.slow),
    (["bifurcations", "--orbit", "1", "--inertia", "1,5/4,8/5", "--gyrostatic-momentum", "0,l2,0",
      "--x", "l2=1:2"], in_orbit),
    (["rotor-set", *sets("I1=1 I2=2 I3=3 l2=0"), "--momentum", "1"], rotors),
    (["staude-cone", "--potential", "k1+k2+k3", *sets("I1=1 I2=2 I3=3 l=0")], staude),
    (["staude-plane", "--potential", "k3", *sets("I1=1 I2=2 I3=3 l=1/2"), "--x", "omega=-3:3"], staude_plane),
    (["amended-potential", "--potential", "k1+k2+k3", *sets("I1=1 I2=2 I3=3 l=1 C1=3")], amended),
    pytest.param(["energy-momentum", *HEAVY, *sets("p_psi=1")], diagram, marks=pytest.mark.slow),
    (["eigenvalues", *HOPF, "--x", "omega3_0=2.2:0:40"], hopf),
    (["cones", *sets("I1=2 I3=1"), "--transverse", "1", "--axial", "2"], rolling)],
                         ids=lambda value: getattr(value, "__name__", ""))
def test_pictures_of_the_library(capsys, tmp_path, monkeypatch, heavy, arguments, ours):
    """The same lines, labels and view."""
    figures = []
    # coarse regions, sooner
    monkeypatch.setattr("gyrostat.plotting.energy_momentum.CELLS", 40)
    monkeypatch.setattr("gyrostat.cli.options.picture_options.save_picture",
                        lambda figure, *form: figures.append(figure))
    assert main(["plot", *arguments, "--output", str(tmp_path / "picture.png")]) == 0
    assert capsys.readouterr() == ("", "")
    assert contents(figures[0]) == contents(ours(heavy).figure)


@pytest.mark.slow
def test_files(capsys, tmp_path):
    """.png, .pdf and .svg; there is something on them."""
    for kind, start, arguments in (("png", b"\x89PNG", ["nutation", *HEAVY, *STATE, "--until", "9"]),
                                   ("pdf", b"%PDF", ["eigenvalues", *HOPF, "--x", "omega3_0=2.2:0"]),
                                   ("svg", b"<?xml", ["effective-potential", *HEAVY,
                                                      *sets("p_phi=1 p_psi=1")])):
        path = tmp_path / f"picture.{kind}"
        assert main(["plot", *arguments, "--output", str(path)]) == 0 and path.read_bytes().startswith(start)
        assert path.stat().st_size > 5000
    with Image.open(tmp_path / "picture.png") as image:
        pixels = np.asarray(image.convert("L"))
    assert image.width > 500 and pixels.min() < 80 and pixels.std() > 10
    assert capsys.readouterr() == ("", "")


@pytest.mark.parametrize(("arguments", "why"), [
    (["eigenvalues", *HOPF[:-2], "--x", "omega3_0=0:1", "--output", "x.png"],
     "no equilibrium is named, and a picture shows one"),
    (["eigenvalues", *HOPF, "--x", "l=0:1", "--output", "x.png"],
     "l is given by --set and is the axis --x as well: leave out one"),
    (["eigenvalues", *HOPF, "--set", "pi3_0=1", "--x", "omega3_0=0:1", "--output", "x.png"],
     "both pi3_0 and omega3_0"),
    (["eigenvalues", *HOPF, "--x", "omega3_0=0:1:1", "--output", "x.png"], "COUNT 1"),
    (["eigenvalues", *HOPF, "--x", "omega3_0=0", "--output", "x.png"], "is not NAME=LOW:HIGH[:COUNT]: write"),
    (["bifurcations", *HEAVY, "--x", "omega=0:1:9", "--output", "x.png"],
     "is not NAME=LOW:HIGH: write, for example, --x l=-2:2\n"),
    (["bifurcations", *HEAVY, "--x", "omega=1:0", "--output", "x.png"], "the lower one first"),
    (["bifurcations", *HEAVY[2:], "--x", "omega=0:1", "--output", "x.png"],
     "--potential is missing, and the equilibria depend on it: write --potential \"m0*k3\", or none"),
    (["bifurcations", "--potential", "none", *sets("I1=1 I2=2 I3=3 l1=0 l2=0"), "--x", "l3=0:1", "--output",
      "x.png"], "the permanent rotations need M: give"),
    (["energy-momentum", *HEAVY, "--potential", "none", "--output", "x.png"],
     "--potential is none, and energy-momentum shows a body in a field"),
    (["energy-momentum", *HEAVY, "--output", "x.png"], "needs p_psi"),
    (["energy-momentum", *HEAVY, *sets("p_psi=1")],
     "--output is missing, and a picture is written to a file: name energy-momentum.png"),
    (["nutation", *HEAVY, *STATE, "--until", "1", "--output", "x.gif"], "has none of the suffixes"),
    (["nutation", *HEAVY, *STATE, "--until", "0", "--output", "x.png"], "give another time"),
    (["cones", *sets("I1=1 I2=1"), "--transverse", "1", "--axial", "2", "--output", "x.png"],
     "set I1 and I3, and nothing else"),
    (["cones", *sets("I1=1 I3=1"), "--transverse", "1", "--axial", "2", "--output", "x.png"],
     "there is no space cone"),
    (["rotor-set", *sets("I1=1 I2=2 I3=3"), "--momentum", "1", "--output", "x.png"],
     "without a number are l1, l2, l3, and the picture is a plane"),
    (["staude-cone", *sets("I1=1 I2=2 I3=3 l=0"), "--output", "x.png"],
     "--potential is missing, and staude-cone shows a body in a field"),
    (["staude-cone", "--potential", "k1^2+k2", *sets("I1=1 I2=2 I3=3 l=0"), "--output", "x.png"],
     "U = k1**2 + k2 is not c·k, and the arcs are found in a uniform field only"),
    (["staude-plane", "--potential", "k3", *sets("I1=1 I2=2 I3=3 l=1"), "--x", "l=0:1", "--output", "x.png"],
     "--x is l, and this picture is drawn over omega: write --x omega=-2:2"),
    (["staude-cone", "--potential", "k3", *sets("I1=2 I2=2 I3=3 l=1"), "--output", "x.png"],
     "the body is one of revolution in its field"),
    (["staude-cone", "--potential", "k1+k2", *sets("I1=1 I2=2 l=0"), "--output", "x.png"], "needs I3"),
    (["amended-potential", "--potential", "k1+k2", *sets("I1=1 I2=2 I3=3 l=0"), "--output", "x.png"],
     "depends on the level of C1 = M·k: give C1"),
    (["momentum-sphere", *sets("I1=1 I3=3 l=0"), "--momentum", "1", "--output", "x.png"], "no number for I2"),
    (["momentum-sphere", *sets("I1=1 I2=2 I3=3 l=0"), "--momentum", "0", "--output", "x.png"],
     "give a positive number"),
    (["effective-potential", *HEAVY, *sets("p_phi=1 p_psi=1"), "--energy", "E", "--output", "missing/x.png"],
     "cannot write")])
def test_bad_input_exits_2(capsys, tmp_path, monkeypatch, arguments, why):
    """A clear error on stderr, nothing on stdout, nothing written."""
    monkeypatch.chdir(tmp_path)
    status = main(["plot", *arguments])
    out, err = capsys.readouterr()
    assert status == 2
    assert out == ""
    assert err.startswith("gyrostat: ")
    assert why in err
    assert len(err.splitlines()) == 1
    assert list(tmp_path.iterdir()) == []


def test_matplotlib_is_named_where_it_is_missing(capsys, tmp_path, monkeypatch):
    """The pip command, exit status 2."""
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    status = main(["plot", "nutation", *HEAVY, *STATE, "--until", "1", "--output", str(tmp_path / "x.png")])
    assert status == 2 and 'pip install "gyrostat[plot]"' in capsys.readouterr().err


def test_help(capsys):
    """Of the verb with examples and all kinds, and of each kind with what it needs."""
    from gyrostat.cli.verbs.plot import DRAWN
    helped = {}
    for kind in ("", *DRAWN):
        with pytest.raises(SystemExit) as stop:
            main(["plot", *filter(None, [kind]), "--help"])
        assert stop.value.code == 0
        helped[kind] = capsys.readouterr().out
    assert all(f"gyrostat plot {kind}" in helped[""] and "--output" in helped[kind] for kind in DRAWN)
    assert "--x NAME=LOW:HIGH[:COUNT]" in helped["eigenvalues"]
    assert "--potential" not in helped["momentum-sphere"]
    with pytest.raises(SystemExit) as stop:
        main(["plot", "fly"])
    assert stop.value.code == 2
