"""The scenes of tests/published/textbook.toml, what their authors mean, and what the library says of them."""
import math
import re
import tomllib
from pathlib import Path

import heavy
import numpy as np
import pytest

import gyrostat as gs
from gyrostat.algebra.text.grammar import parse
from gyrostat.mechanics.families.scene_tables import SceneTable

DATA = tomllib.loads((Path(__file__).with_name("textbook.toml")).read_text(encoding="utf-8"))
FUNCTIONS = {name: getattr(math, name) for name in ("cos", "sin", "sqrt", "exp")}
GREEK_NAMES = {"lambda": "lambda_"}                        # a word of Python


def rows(name):
    """The entries of a list, each with its number."""
    cells = [[cell.strip() for cell in row.split("|")] for row in DATA[name]]
    return [pytest.param(*row[1:], id=f"{n}-{row[0][:30]}") for n, row in enumerate(cells)]


def numbers(text):
    """Numbers by name, and what else is said of the scene."""
    found = dict(part.split("=") if "=" in part else (part, "") for part in text.split())
    special = {name: found.pop(name) for name in ("spin", "axis", "rotor", "down") if name in found}
    return found, special


def valued(text, names):
    """A formula of the author at numbers."""
    python = re.sub(r"\blambda\b", "lambda_", text.replace("^", "**"))
    return eval(python, {"__builtins__": {}}, {**FUNCTIONS, **names})  # noqa: S307 (of this file alone)


def energy(book, values):
    """The author's U as a function of the direction."""
    given = {GREEK_NAMES.get(name, name): float(value) for name, value in values.items()}

    def U(k):
        theta, psi = math.acos(max(-1.0, min(1.0, k[2]))), math.atan2(k[0], k[1])
        direction = {f"{name}{n}": x for name in ("k", "gamma", "nu", "alpha", "e", "n")
                     for n, x in enumerate(k, 1)}
        other = dict.fromkeys(("K3", "k_3", "k_z", "costheta"), k[2])
        return valued(book, {**direction, **other, "theta": theta, "psi": psi, **given})
    return U


def homogeneous(U):
    """U of the direction of any vector, so that it may be differenced."""
    return lambda x: U(x / np.linalg.norm(x))


def expected(book, moments, values, special):
    """The verdict of the author's scene by Newton and Euler's equations, and of which rotation."""
    names = {GREEK_NAMES.get(name, name): float(value) for name, value in values.items()}
    inertia = np.diag([valued(moment, names) for moment in moments])
    rotor = np.array([valued(x, names) for x in special.get("rotor", "0,0,0").split(",")], dtype=float)
    axis = int(special.get("axis", "3")) - 1
    k = np.eye(3)[axis] * (-1 if "down" in special else 1)
    f, h = homogeneous(energy(book, values)), 1e-4
    e = np.eye(3)
    c = np.array([(f(k + h * x) - f(k - h * x)) / (2 * h) for x in e])
    Q = np.array([[(f(k + h * x + h * y) - f(k + h * x - h * y) - f(k - h * x + h * y) + f(k - h * x - h * y))
                   / (4 * h * h) for x in e] for y in e])
    assert np.abs(np.delete(c, axis)).max() < 1e-6, "the author's body does not rest so"
    omega = float(special["spin"]) * (-1 if "down" in special else 1)
    rate = heavy.growth(inertia, rotor, c - Q @ k, Q, omega, k)
    assert not 1e-3 < rate < 3e-2, "too near a boundary"
    if rate >= 3e-2:
        return {"UNSTABLE"}
    squares = heavy.squares(inertia, rotor, c - Q @ k, Q, omega, k)
    revolution = axis == 2 and moments[0] == moments[1] and abs(Q[0, 0] - Q[1, 1]) < 1e-5
    return {"STABLE"} if squares[0] > 1e-4 or revolution else {"STABLE", "UNDECIDED"}


def asked(moments, typed, values, special):
    """The verdict of the library on the scene as it is typed."""
    table = {"inertia": moments, "potential": typed,
             "gyrostatic_momentum": special.get("rotor", "0,0,0").split(",")}
    scene = SceneTable(table).system
    if "spin" not in special:
        return scene, None
    axis = int(special.get("axis", "3"))
    if axis == 3:
        eq = (gs.hanging if "down" in special else gs.upright)(scene, spin="omega3_0")
        report, spin = gs.analyze(eq), {"omega3_0": special["spin"]}
    else:
        k = [int(n == axis) for n in (1, 2, 3)]
        rate = parse(special["spin"])
        point = [moment * rate * x for moment, x in zip(scene.body.moments, k)]
        report, spin = gs.analyze(gs.equilibrium(scene, (*point, *k))), {}
    given = {name: value for name, value in values.items() if name in report.parameters}
    return scene, report.verdict(given | {n: x for n, x in spin.items() if n in report.parameters})
