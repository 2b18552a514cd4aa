"""Potentials and scenes in the letters of textbooks: answered as their authors mean them, or refused.

What is meant is the author's energy, evaluated without the library, and the verdict that the equations of
Newton and Euler give with its gradient.
"""
import json
import math
import re

import numpy as np
import pytest
from commands import decide
from published.textbook_scenes import DATA, GREEK_NAMES, asked, energy, expected, numbers, rows, valued

import gyrostat as gs
from gyrostat.algebra.text.grammar import parse
from gyrostat.errors import GyrostatError
from gyrostat.mechanics.families.scene_tables import SceneTable


def check_meaning(scene, book, values, typed_values):
    """U of the scene is the author's, but for a constant."""
    U, f = scene.potential.expression, energy(book, values)
    known = {gs.symbol(name): parse(value) for name, value in typed_values.items()}
    apart = []
    for k in ((0.6, 0.0, 0.8), (0.48, 0.6, -0.64), (-0.36, 0.48, 0.8), (0.0, -0.8, -0.6), (0.64, 0.48, 0.6)):
        at = U.subs({**known, **{gs.symbol(f"k{n}"): x for n, x in enumerate(k, 1)}})
        assert not at.free_symbols, at.free_symbols
        apart.append(float(at) - f(np.array(k)))
    np.testing.assert_allclose(apart, apart[0], atol=1e-9 * (1 + max(map(abs, apart))))


def test_there_are_three_hundred():
    """And each is there once."""
    every = [row for name in DATA for row in DATA[name]]
    assert len(every) >= 300 and len(set(every)) == len(every)


@pytest.mark.few(8)
@pytest.mark.parametrize(("moments", "book", "typed", "at"), rows("answered"))
def test_a_scene_is_answered_as_its_author_means_it(moments, book, typed, at):
    """The same energy, and the same verdict."""
    values, special = numbers(at)
    scene, decision = asked(moments.split(), typed, values, special)
    check_meaning(scene, book, values, values)
    assert decision.verdict.name in expected(book, moments.split(), values, special)


@pytest.mark.few(17)
@pytest.mark.parametrize(("moments", "book", "typed", "at", "said", "letters"), rows("refused"))
def test_a_scene_is_refused_with_what_to_write(moments, book, typed, at, said, letters):
    """In one sentence; the formula that it proposes means what the author's does."""
    values, special = numbers(at)
    with pytest.raises(GyrostatError) as error:
        asked(moments.split(), typed, values, special | {"spin": "1"})
    message = str(error.value)
    assert said in message and len(message) <= 300
    proposed = re.search(r"as in U = (.*)$", message)
    if not proposed or not values:
        return
    taken = dict(pair.split("=") for pair in letters.split())
    renamed = values | {new: values[old] for new, old in taken.items() if old in values}
    renamed = {name: value for name, value in renamed.items() if name not in taken.values() or name in taken}
    scene, decision = asked(moments.split(), proposed[1], renamed, special)
    check_meaning(scene, book, values, renamed)
    assert decision is None or decision.verdict.name in expected(book, moments.split(), values, special)


@pytest.mark.few(4)
@pytest.mark.parametrize(("moments", "book", "typed", "at"), [
    row for row in rows("answered") if "axis=" not in row.values[3] and "lambda" not in row.values[2]])
def test_every_route_answers_alike(capsys, tmp_path, moments, book, typed, at):
    """Options, a scene of a file and a line of a batch say the same as Python."""
    values, special = numbers(at)
    verdict = asked(moments.split(), typed, values, special)[1].verdict.name
    given, label = values | {"omega3_0": special["spin"]}, "E2" if "down" in special else "E1"
    body = {"inertia": moments.split(), "gyrostatic_momentum": special.get("rotor", "0,0,0").split(",")}
    scene = [f"--inertia={','.join(body['inertia'])}", f"--potential={typed}", f"--equilibrium={label}",
             f"--gyrostatic-momentum={','.join(body['gyrostatic_momentum'])}"]
    line = tmp_path / "line.jsonl"
    line.write_text(json.dumps(given) + "\n", encoding="utf-8")
    file = tmp_path / "scene.toml"
    file.write_text(f"[scene.one]\npotential = {json.dumps(typed)}\nequilibrium = \"{label}\"\n"
                    + "".join(f"{name} = {json.dumps(x)}\n" for name, x in body.items())
                    + f"values = {{ {', '.join(f'{n} = {json.dumps(x)}' for n, x in given.items())} }}\n",
                    encoding="utf-8")
    for options in ([*scene, "--set", *(f"{name}={x}" for name, x in given.items()), "--format", "json"],
                    [*scene, "--batch", str(line)], ["--scene", str(file), "--format", "json"]):
        status, out, err = decide(capsys, *options)
        assert status == 0, err
        assert json.loads(out)["equilibria"][0]["decision"]["verdict"] == verdict


@pytest.mark.few(6)
@pytest.mark.parametrize(("moments", "rotor", "axis", "at"), rows("free"))
def test_a_free_body_in_other_letters(moments, rotor, axis, at):
    """Stable where the energy is an extremum on the momentum sphere: 1/I − ν of one sign across the axis."""
    values, special = numbers(at)
    names, n = {GREEK_NAMES.get(name, name): float(value) for name, value in values.items()}, int(axis)
    I, l = ([valued(x, names) for x in text.split()] for text in (moments, rotor))
    nu = float(special["spin"]) / (I[n - 1] * float(special["spin"]) + l[n - 1])
    one, other = (1 / I[m] - nu for m in range(3) if m != n - 1)
    assert abs(one * other) > 1e-3
    scene = SceneTable({"inertia": moments.split(), "gyrostatic_momentum": rotor.split()}).system
    report = gs.analyze(gs.principal_rotation(scene, n))
    given = values | {f"omega{n}_0": special["spin"]}
    decision = report.verdict({name: x for name, x in given.items() if name in report.parameters})
    assert decision.verdict.name == ("STABLE" if one * other > 0 else "UNSTABLE")


@pytest.mark.few(4)
@pytest.mark.parametrize(("moments", "rotor", "rate", "at"), rows("orbit"))
def test_a_satellite_in_other_letters(moments, rotor, rate, at):
    """By the dynamic potential 3/2 ω0² r·Ir − ω0²/2 n·In − ω0 l·n, differenced over turns of the body."""
    values, _ = numbers(at)
    names = {name: float(value) for name, value in values.items()}
    I, l = (np.array([valued(x, names) for x in text.split()], dtype=float) for text in (moments, rotor))
    w = math.sqrt(names["K"] / names["R"]**3) if "mu=" in rate else valued(rate, names)

    def V(turn):
        angle = np.linalg.norm(turn)
        axis = turn / angle if angle else turn
        K = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
        R = np.eye(3) + math.sin(angle) * K + (1 - math.cos(angle)) * K @ K
        n, r = R[:, 1], R[:, 2]
        return 1.5 * w**2 * r @ (I * r) - w**2 / 2 * n @ (I * n) - w * l @ n

    e, h = np.eye(3), 1e-4
    slope = [(V(h * x) - V(-h * x)) / (2 * h) for x in e]
    K = np.array([[(V(h * x + h * y) - V(h * x - h * y) - V(h * y - h * x) + V(-h * x - h * y)) / (4 * h * h)
                   for x in e] for y in e])
    squares = np.linalg.eigvalsh(K)
    assert np.abs(slope).max() < 1e-8 and np.abs(squares).min() > 1e-3
    table = {"inertia": moments.split(), "gyrostatic_momentum": rotor.split(), "orbit": rate}
    decision = gs.analyze(gs.earth_pointing(SceneTable(table).system)).verdict(values)
    odd = (squares < 0).sum() % 2
    assert decision.verdict.name in ({"STABLE"} if squares[0] > 0 else {"UNSTABLE"} if odd else
                                     {"UNSTABLE", "UNDECIDED"})


@pytest.mark.few(2)
@pytest.mark.parametrize(("moments", "mass", "weight", "at"), rows("vehicle"))
def test_a_vehicle_in_other_letters(moments, mass, weight, at):
    """Leonard 1997: level motion along axis 2 is stable if m2 m3 w + P² (m2 − m3) > 0, w > 0 and m2 > m1."""
    values, _ = numbers(at)
    names = {name: float(value) for name, value in values.items()}
    (m1, m2, m3), w, P = [valued(x, names) for x in mass.split()], valued(weight, names), names["P"]
    proved = m2 * m3 * w + P**2 * (m2 - m3) > 0 and w > 0 and m2 > m1
    scene = gs.underwater_vehicle(*([parse(x) for x in text.split()] for text in (moments, mass)),
                                  weight=(0, 0, parse(weight)))
    report = gs.analyze(gs.steady_motion(scene, (0, gs.symbol("P"), 0), (0, 0, 1)))
    decision = report.verdict({name: x for name, x in values.items() if name in report.parameters})
    assert (decision.verdict.name == "STABLE") == proved


@pytest.mark.few(6)
@pytest.mark.parametrize(("kind", "moments", "second", "third", "said"), rows("elsewhere"))
def test_names_are_refused_in_every_kind_of_scene(kind, moments, second, third, said):
    """In a body, an orbit, what acts beside the gravity gradient, a vehicle."""
    with pytest.raises(GyrostatError) as error:
        if kind == "vehicle":
            gs.underwater_vehicle(*([parse(x) for x in text.split()] for text in (moments, second)),
                                  weight=(0, 0, parse(third)))
        else:
            orbit = {"orbit": {"orbit": third}, "drag": {"orbit": "n", "potential": third}}.get(kind, {})
            _ = SceneTable({"inertia": moments.split(), "gyrostatic_momentum": second.split()} | orbit).system
    assert said in str(error.value) and len(str(error.value)) <= 300
