"""Tables of relative equilibria of every kind of scene, against spectra of the equations of motion."""
import math

import numpy as np
import pandas
import pytest

import gyrostat as gs
from gyrostat.errors import ArgumentError

# inertia, rotor, gradient of U or None, ω0 or 0, the field, what is asked
SCENES = {
    "satellite": ((1, 1.25, 1.6), (0.3, 0, 0), None, 2.0, gs.circular_orbit(2), {}),
    "free": ((1, 2, 3), (0, 0, 0.5), None, 0.0, None, {"M": 2}),
    "heavy": ((1, 2, 3), (0, 0, 0.5), (1, 1, 0), 0.0, gs.general_potential("k1 + k2"), {"omega": 2}),
    "top": ((1, 1, 1.5), (0, 0, 0), (0, 0, 1), 0.0, gs.axial_potential("k3"), {"omega": 2})}
SHARED = {"number", "label", "verdict", "damped", "locus", "growing_modes", "notion", "scope", "reason",
          "damped_reason", "note", "growth_rate", "doubling_time", "frequency_1"}


def found(name):
    """The list of a scene."""
    inertia, rotor, _, _, field, asked = SCENES[name]
    body = gs.Gyrostat(tuple(map(str, inertia)), tuple(map(str, rotor)))
    return gs.relative_equilibria(gs.assemble(body, *([] if field is None else [field])), asked)


def spectrum(name, row):
    """Frequencies and the largest real part, by central differences of Newton and Euler's equations."""
    inertia, rotor, gradient, rate, *_ = SCENES[name]
    I = np.array(inertia, dtype=float)

    def field(x):
        directions = x[3:].reshape(-1, 3)
        spin = x[:3] / I
        torque = np.cross(x[:3] + rotor, spin)
        if rate:
            n, r = directions
            torque = torque + 3 * rate**2 * np.cross(r, I * r)
            return np.concatenate([torque, np.cross(n, spin), np.cross(r, spin - rate * n)])
        if gradient is not None:
            torque = torque + np.cross(directions[0], gradient)
        return np.concatenate([torque, *(np.cross(k, spin) for k in directions)])

    def vector(letter):
        return np.array([row[f"{letter}{n}"] for n in (1, 2, 3)])

    if rate:
        point = np.concatenate([rate * I * vector("n"), vector("n"), vector("r")])
    elif gradient is None:
        point = vector("pi")
    else:
        k = vector("k") if "k1" in row else np.array([math.sqrt(1 - row["k3"]**2), 0, row["k3"]])
        spin = row["omega"] * k + (row["sigma"] * np.array([0, 0, 1]) if "sigma" in row else 0)
        point = np.concatenate([I * spin, k])
    assert abs(field(point)).max() < 1e-12
    h = 1e-5
    J = np.array([(field(point + h * e) - field(point - h * e)) / (2 * h) for e in np.eye(len(point))]).T
    values = np.linalg.eigvals(J)
    return sorted(values.imag[(abs(values.real) < 1e-3) & (values.imag > 1e-3)]), values.real.max()


@pytest.mark.parametrize("name", SCENES)
def test_rows_have_the_spectra_of_the_equations_of_motion(name):
    """Frequencies, growth rate, doubling time; verdicts and numbers are those of the list."""
    equilibria = found(name)
    rows = gs.table(equilibria)
    assert [row["number"] for row in rows] == list(range(1, len(equilibria) + 1))
    for e, row in zip(equilibria, rows):
        assert set(row) == set(rows[0]) >= SHARED
        assert (row["label"], row["verdict"]) == (e.label, e.decision.verdict.name)
        assert row["damped"] == e.damped.verdict.name and row["growing_modes"] == e.damped.growing
        slow, grows = spectrum(name, row)
        mine = [row[f"frequency_{n}"] for n in range(1, 4) if row.get(f"frequency_{n}") is not None]
        assert mine == pytest.approx(slow, rel=1e-5), row
        assert (row["growth_rate"] is None) == (grows < 1e-3)
        if row["growth_rate"] is not None:
            assert row["growth_rate"] == pytest.approx(grows, rel=1e-5)
            assert row["doubling_time"] == pytest.approx(math.log(2) / grows, rel=1e-5)
        if name == "satellite":
            per_orbit = [row[f"frequency_{n}_per_orbit"] for n in range(1, len(mine) + 1)]
            assert per_orbit == pytest.approx([x / 2 for x in mine]) and row["omega0"] == 2


def test_pandas_takes_the_rows_as_they_are():
    """A column for each key, numbers as floats; nothing is an exact number of SymPy."""
    for name in SCENES:
        rows = gs.table(found(name))
        frame = pandas.DataFrame(rows)
        assert list(frame) == list(rows[0]) and len(frame) == len(rows)
        assert frame.frequency_1.dtype == float and frame.number.dtype == int
        assert all(x is None or type(x) in (int, float, str) for row in rows for x in row.values())


def test_a_place_that_takes_every_value_has_no_frequencies():
    """Nor a growth rate: they change along it."""
    flat = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential("k3^2/4"))
    rows = gs.table(gs.relative_equilibria(flat, {"I1": 1, "I3": 3, "l": 0, "omega": "1/2"}))
    (every,) = [row for row in rows if row["locus"]]
    assert every["k3"] is None and every["frequency_1"] is None and every["growth_rate"] is None
    assert gs.table([]) == []


def test_what_is_no_list_of_equilibria_is_refused():
    """A scene, a report."""
    for wrong in (3, [1], "eq"):
        with pytest.raises(ArgumentError):
            gs.table(wrong)
