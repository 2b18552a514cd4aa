"""gyrostat plot of satellites in orbit: what is drawn, against equations of motion written here in NumPy."""
import json
import re

import numpy as np
import pytest
from commands import run
from matplotlib.colors import same_color

from gyrostat.plotting.looks import MARKERS

TURN = np.array([[2, -1, 2], [2, 2, -1], [-1, 2, 2]]) / 3              # a rotation in fractions
TILTED = "[[2, 1/6, -1/6],[1/6, 7/4, 1/4],[-1/6, 1/4, 3/2]]"
ATTITUDES = {
    "three moments": (["--inertia", "1,5/4,8/5", "--set", "l1=3/10", "l2=1/5", "l3=1/10"],
                      np.diag([1, 1.25, 1.6]), [0.3, 0.2, 0.1], None),
    "a tensor": (["--inertia", TILTED, "--gyrostatic-momentum", "0,1/5,1/7"],
                 [[2, 1 / 6, -1 / 6], [1 / 6, 1.75, 0.25], [-1 / 6, 0.25, 1.5]], [0, 0.2, 1 / 7], None),
    "drag and a magnet": (["--inertia", "1,5/4,8/5", "--set", "l=1/9", "--potential", "t1/10 + n2/7 - r3/9"],
                          np.diag([1, 1.25, 1.6]), [0, 1 / 9, 0],
                          lambda t, n, r: t[0] / 10 + n[1] / 7 - r[2] / 9)}


@pytest.fixture
def drawn(capsys, tmp_path, monkeypatch):
    """The axes of a picture of the command line."""
    def made(kind, *arguments):
        figures = []
        monkeypatch.setattr("gyrostat.cli.options.picture_options.save_picture",
                            lambda figure, *form: figures.append(figure))
        status, out, err = run(capsys, kind, *arguments, "--output", str(tmp_path / "x.png"), verb="plot")
        assert (status, out, err) == (0, "", "")
        return figures[0].axes[0]
    return made


def turned(v):
    """The rotation by a vector."""
    angle = np.linalg.norm(v)
    if not angle:
        return np.eye(3)
    x, y, z = v / angle
    hat = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * hat + (1 - np.cos(angle)) * hat @ hat


def variations(n, r, energy, h=1e-4):
    """Slope and second derivatives of an energy of n and r if the body is turned."""
    def at(v):
        turn = turned(np.array(v))
        return energy(turn @ n, turn @ r)
    e = h * np.eye(3)
    slope = [(at(a) - at(-a)) / (2 * h) for a in e]
    second = [[(at(a + b) - at(a - b) - at(b - a) + at(-a - b)) / (4 * h * h) for b in e] for a in e]
    return np.array(slope), np.array(second)


@pytest.mark.slow
@pytest.mark.parametrize("case", ATTITUDES)
def test_attitudes_are_those_of_the_table(capsys, drawn, case):
    """Number i stands beside row i of decide; there is no torque; the full look where the energy is least."""
    arguments, tensor, rotor, other = ATTITUDES[case]
    I, l, w = np.array(tensor, float), np.array(rotor), 3 / 4

    def amended(n, r):
        beside = 0 if other is None else other(np.cross(n, r), n, r)
        return 1.5 * w**2 * r @ I @ r - w * n @ l - w**2 * n @ I @ n / 2 + beside

    status, out, _ = run(capsys, "--orbit", "3/4", *arguments, "--format", "json", verb="decide")
    rows = np.array([[e["place"][f"{x}{i}"] for x in "nr" for i in (1, 2, 3)]
                     for e in json.loads(out)["equilibria"]]).reshape(-1, 2, 3)
    ax = drawn("attitudes", "--orbit", "3/4", *arguments)
    numbers = {int(t.get_text()): np.array(t.get_position_3d()) for t in ax.texts if t.get_text().isdigit()}
    marks = [(p, line.get_color()) for line in ax.lines if line.get_marker() == "o"
             for p in np.array(line.get_data_3d()).T]
    assert status == 0 and sorted(numbers) == list(range(1, len(rows) + 1)) and len(marks) == len(rows)
    least = 0
    for number, (n, r) in enumerate(rows, 1):
        tip = r + 0.22 * n
        assert np.linalg.norm(numbers[number] - tip) < 0.2
        colour, = (colour for place, colour in marks if np.linalg.norm(place - tip) < 1e-6)
        slope, second = variations(n, r, amended)
        assert abs(slope).max() < 1e-6
        smallest = np.linalg.eigvalsh(second)[0]
        assert abs(smallest) > 1e-4 and (smallest > 0) == same_color(colour, MARKERS["stable"]["color"])
        least += smallest > 0
    assert least >= 2 and "in orbit" in ax.get_title() and r"\omega_0 = 3/4" in ax.get_title()
    assert ("$U = " in ax.get_title()) == (other is not None)


def angles(turn):
    """Roll, pitch and yaw in degrees; the rows are the axes of the body in (t, n, r)."""
    first, second, third = turn
    return np.degrees([np.arctan2(second[2], third[2]), -np.arcsin(first[2]), np.arctan2(first[1], first[0])])


@pytest.mark.slow
@pytest.mark.parametrize("pointing", ["1,2,3", "-3,1,-2"])
def test_librations_are_the_motion(drawn, pointing):
    """Of a tensor with a wheel, released off its place; the equations of Euler and Poisson by Runge-Kutta."""
    I = np.array([[3, 0.1, 0], [0.1, 4, -0.2], [0, -0.2, 2]])
    w, l = 0.5, 0.3 * np.array([0, 0.6, 0.8])
    ax = drawn("librations", "--orbit", "0.5 rad/s", "--inertia",
               "[[3, 0.1, 0], [0.1, 4, -0.2], [0, -0.2, 2]] kg m^2", "--wheel",
               "axis=0,3,4 inertia=0.1 kg m^2 speed=3 rad/s", "--pointing", pointing, "--release",
               "10 deg,-4 deg,5 deg", "--until", "6 s", "--count", "61")
    axes = [int(x) for x in pointing.split(",")]
    n, r = (np.sign(a) * np.eye(3)[abs(a) - 1] for a in axes[1:])
    frame = np.array([np.cross(n, r), n, r])               # the axes roll, pitch, yaw in those of the body
    x, y, z = np.radians([10, -4, 5])
    one = np.array([[1, 0, 0], [0, np.cos(x), np.sin(x)], [0, -np.sin(x), np.cos(x)]])
    two = np.array([[np.cos(y), 0, -np.sin(y)], [0, 1, 0], [np.sin(y), 0, np.cos(y)]])
    three = np.array([[np.cos(z), np.sin(z), 0], [-np.sin(z), np.cos(z), 0], [0, 0, 1]])
    start = frame.T @ (one @ two @ three)                  # columns t, n, r in the body
    state = np.concatenate([w * start[:, 1], start[:, 1], start[:, 2]])

    def rate(s):
        omega, n, r = s.reshape(3, 3)
        torque = 3 * w**2 * np.cross(r, I @ r) - np.cross(omega, I @ omega + l)
        turning = omega - w * n
        return np.concatenate([np.linalg.solve(I, torque), np.cross(n, turning), np.cross(r, turning)])

    wanted, h = [], 0.01
    for step in range(601):
        if step % 10 == 0:
            n, r = state[3:6], state[6:]
            wanted.append(angles(frame @ np.array([np.cross(n, r), n, r]).T))
        a = rate(state)
        b = rate(state + h / 2 * a)
        c = rate(state + h / 2 * b)
        state = state + h / 6 * (a + 2 * b + 2 * c + rate(state + h * c))
    for line, curve in zip(ax.lines, np.array(wanted).T, strict=True):
        across, up = np.array(line.get_data())[:, ~np.isnan(line.get_ydata())]
        assert np.allclose(across, 0.5 * np.linspace(0, 6, 61) / (2 * np.pi))
        assert np.allclose(up, curve, atol=1e-5)           # of the integration, 1e-3 of the largest error


def smelt(moments, rotor):
    """What is known of an Earth-pointing body with the rotor l/ω0: theory of DeBra and Delp."""
    t, n, r = moments
    roll, yaw, b = 4 * (n - r) + rotor, n - t + rotor, t + r - n - rotor
    K, g = np.diag([roll, 3 * (t - r), yaw]), np.array([0, b, 0])
    hat = np.array([[0, -g[2], g[1]], [g[2], 0, -g[0]], [-g[1], g[0], 0]])
    inverse = np.diag([1 / t, 1 / n, 1 / r])
    growth = np.linalg.eigvals(np.block([[np.zeros((3, 3)), np.eye(3)], [-inverse @ K, -inverse @ hat]])).real
    if np.diag(K).min() > 0:
        return "stable"
    return "undecided" if growth.max() < 1e-6 else "unstable"


SMELT = [                                                  # options, moments about roll, pitch, yaw, and l/ω0
    (["--orbit", "2", "--inertia", "60,52,35", "--gyrostatic-momentum", "0,40,0"], (60, 52, 35), 20),
    (["--orbit", "2", "--inertia", "35,60,52", "--gyrostatic-momentum", "0,0,-40", "--pointing", "2,-3,1"],
     (60, 52, 35), 20),
    (["--orbit", "0.002 rad/s", "--inertia", "60 kg m^2,32 kg m^2,35 kg m^2", "--wheel",
      "axis=0,1,0 inertia=0.01 kg m^2 speed=10/pi rpm"], (60, 32, 35), 5 / 3),
    (["--orbit", "1", "--inertia", "60,32,35", "--wheel", "axis=0,1,0 inertia=2 momentum=2"],
     (60, 32, 35), 0),
    (["--orbit", "1", "--inertia", "[[6,1,0],[1,7,0],[0,0,4]]",
      "--gyrostatic-momentum", "0,0,0"], (6.5 - 5**0.5 / 2, 6.5 + 5**0.5 / 2, 4), 0)]


@pytest.mark.slow
@pytest.mark.parametrize("case", range(len(SMELT)))
def test_the_satellite_is_where_it_belongs_in_the_plane(drawn, monkeypatch, case):
    """At its ratios, in a plane of its own rotor: driven or free, in any axes, of a tensor in its own."""
    monkeypatch.setattr("gyrostat.plotting.smelt_plane.POINTS", 80)
    options, (t, n, r), rotor = SMELT[case]
    ax = drawn("smelt-plane", *options)
    spot, = (line.get_xydata()[0] for line in ax.lines if line.get_marker() == "o")
    assert np.allclose(spot, ((n - r) / t, (n - t) / r))
    (image,) = ax.images
    array = np.asarray(image.get_array())
    column, row = ((spot + 1) * 40).astype(int)
    codes = {"stable": 1, "undecided": 0, "unstable": -1}
    assert array[row, column] == codes[smelt((t, n, r), rotor)]
    for i, j in np.random.default_rng(case).integers(0, 80, (60, 2)):
        kR, kY = (2 * np.array([j, i]) + 1) / 80 - 1
        moments = np.array([1 - kY, 1 - kR * kY, 1 - kR])
        assert array[i, j] == codes[smelt(moments, rotor / n * moments[1])], (kR, kY)
    assert [text.get_text() for text in ax.texts] == ["1"]
    assert np.linalg.norm(np.array(ax.texts[0].xy) - spot) < 1e-9
    said = float(re.search(r"l = (\S+)\\,I", ax.get_title())[1].replace("/", " ").split()[0]) if rotor else 0
    assert (said != 0) == bool(rotor) and ("without a rotor" in ax.get_title()) == (not rotor)


@pytest.mark.parametrize(("arguments", "why"), [
    (["attitudes", "--set", "l=1"], "--orbit is missing, and attitudes shows a satellite"),
    (["librations", "--potential", "k3", "--state", "0,0,1,0,0,1", "--until", "1"], "--orbit is missing"),
    (["librations", "--orbit", "1", "--inertia", "1,2,5/2", "--set", "l=0", "--until", "1"],
     "--state is missing"),
    (["attitudes", "--orbit", "1", "--set", "I1=1", "I2=2", "I3=5/2", "l=0", "omega=1"],
     "no parameter omega"),
    (["smelt-plane", "--orbit", "1", "--inertia", "1,2,5/2", "--set", "l1=1", "l2=0", "l3=0"],
     "not along the principal axis of pitch"),
    (["smelt-plane", "--orbit", "1", "--inertia", "1,2,5/2", "--wheel", "axis=1,0,0 inertia=1/9 momentum=0"],
     "not along the principal axis of pitch"),
    (["smelt-plane", "--orbit", "1", "--inertia", "1,2,5/2", "--set", "l=1", "--potential", "n1"],
     "U = n1 acts beside the gravity gradient"),
    (["smelt-plane", "--orbit", "1", "--inertia", "1,2,4", "--set", "l=1"], "those of no body"),
    (["smelt-plane", "--orbit", "omega0", "--inertia", "1,2,5/2", "--set", "l=1"], "needs omega0"),
    (["smelt-plane", "--orbit", "1", "--inertia", "[[2,1,0],[1,2,0],[0,0,2]]", "--gyrostatic-momentum",
      "0,0,0"], "two diagonal entries of the tensor are equal"),
    (["staude-cone", "--orbit", "1", "--set", "l=1"], "plot draws attitudes, librations, smelt-plane")])
def test_what_does_not_belong_is_refused(capsys, tmp_path, arguments, why):
    """In one line, without a file."""
    status, out, err = run(capsys, *arguments, "--output", str(tmp_path / "x.png"), verb="plot")
    assert (status, out) == (2, "") and why in err and len(err.splitlines()) == 1
    assert not list(tmp_path.iterdir())


@pytest.mark.slow
def test_a_scene_file(drawn, monkeypatch, tmp_path):
    """Body, wheels, orbit and release of a file; an option overrides it."""
    monkeypatch.setattr("gyrostat.plotting.smelt_plane.POINTS", 40)
    path = tmp_path / "one.toml"
    path.write_text('[scene.one]\ninertia = [60, 52, 35]\norbit = "1/2"\nlumped = true\n'
                    'rotors = [{ axis = [0, 1, 0], axial = 1, rate = 13 }]\nrelease = ["3 deg", 0, 0]\n')
    ax = drawn("smelt-plane", "--scene", f"{path}#one")
    assert "$l = 1/2" in ax.get_title() and "$l_2 = 13$" in ax.get_title()
    ax = drawn("smelt-plane", "--scene", f"{path}#one", "--orbit", "1")
    assert "$l = 1/4" in ax.get_title()
    ax = drawn("librations", "--scene", f"{path}#one", "--until", "1")
    assert ax.lines[0].get_ydata()[0] == pytest.approx(3)


@pytest.mark.few(1)
@pytest.mark.parametrize(("orbit", "rate"), [
    ("height=500 km", (3.986004418e14 / 6878136.6**3) ** 0.5), ("period=95 min", 2 * np.pi / 5700),
    ("0.0012345678 rad/s", 0.0012345678), ("1/3", 1 / 3)])
def test_a_chart_has_the_rate_of_the_orbit_and_units(capsys, tmp_path, monkeypatch, orbit, rate):
    """In its title, with four digits, beside the moments that are no axes; units where they are given."""
    figures = []
    monkeypatch.setattr("gyrostat.cli.options.picture_options.save_picture",
                        lambda figure, *form: figures.append(figure))
    units = orbit != "1/3"
    moment, momentum = (" kg m^2", " N m s") if units else ("", "")
    status, _, err = run(capsys, "--orbit", orbit, "--inertia", f"60{moment},I2{moment},35{moment}".replace(
        f"I2{moment}", "I2"), "--x", f"I2=30{moment}:100{moment}:5", "--y", f"l=-1{momentum}:1{momentum}:5",
        "--output", str(tmp_path / "x.png"), verb="chart")
    assert (status, err) == (0, "")
    ax = figures[0].axes[0]
    title = ax.get_title().replace("\n", " ")
    said = re.search(r"\\omega_0 = ([0-9./]+)", title)[1].split("/")
    assert float(said[0]) / float((said + ["1"])[1]) == pytest.approx(rate, rel=6e-4)
    assert "in orbit" in title and "I_1 = 60" in title and "I_3 = 35" in title
    assert (r"60\,\mathrm{kg\,m^{2}}" in title) == (r"\mathrm{rad/s}" in title) == units
    assert ax.get_xlabel() == (r"$I_2$ $[\mathrm{kg\,m^{2}}]$" if units else r"$I_2$ $[\mathrm{M\,L^{2}}]$")
    assert ax.get_ylabel() == (r"$l$ $[\mathrm{kg\,m^{2}\,s^{-1}}]$" if units
                               else r"$l$ $[\mathrm{M\,L^{2}\,T^{-1}}]$")
