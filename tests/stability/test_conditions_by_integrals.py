"""Conditions with an integral that is given, α eliminated: against pencils at numbers, and all that reads them."""
import random

import numpy as np
import pytest
from oracles import pencil
from slow import slow
from sympy import Rational, S

import gyrostat as gs
from gyrostat.charts.codes import CODE_OF

m, w, k1, k2, k3 = map(gs.symbol, ("m", "w", "k1", "k2", "k3"))
I1, I2, I3, e = map(gs.symbol, ("I1", "I2", "I3", "e"))


def kowalevski(u=-1):
    """Kowalevski's top turns about the axis of its centre of mass."""
    F = "(M1^2 - M2^2 - 4*m*k1)^2 + (2*M1*M2 - 4*m*k2)^2"
    scene = gs.assemble(gs.Gyrostat((2, 2, 1), (0, 0, 0)), gs.general_potential(m * k1), integrals=(F,))
    return gs.analyze(gs.equilibrium(scene, (2 * u * w, 0, 0, u, 0, 0)))


def clebsch():
    """U = e k·Ik/2, a rotation about axis 3."""
    U = e * (I1 * k1**2 + I2 * k2**2 + I3 * k3**2) / 2
    F = "M1^2 + M2^2 + M3^2 - e*(I2*I3*k1^2 + I3*I1*k2^2 + I1*I2*k3^2)"
    scene = gs.assemble(gs.Gyrostat(gyrostatic_momentum=(0, 0, 0)), gs.general_potential(U), integrals=(F,))
    return gs.analyze(gs.equilibrium(scene, (0, 0, I3 * w, 0, 0, 1)))


def forms(report, values):
    """Both forms of the oracle at numbers."""
    numbers = {gs.symbol(name): S(x) for name, x in values.items()}
    scene = report.equilibrium.system
    plain = dict(zip(scene.space.coordinates, pencil.X))   # l = 0: M is π
    h, F = (f.xreplace(numbers).xreplace(plain) for f in (scene.hamiltonian, scene.given_integrals[0]))
    return pencil.forms(h, F, [x.xreplace(numbers) for x in map(S, report.equilibrium.point)])


def drawn(draw, names):
    return {name: Rational(draw.randint(1 if name.startswith("I") else -9, 9), draw.randint(1, 4))
            for name in names}


@pytest.mark.parametrize("family, seeds", [(kowalevski, range(8)), (clebsch, range(8)),
                                           *slow((kowalevski, range(8, 120)), (clebsch, range(8, 120)))])
def test_where_some_pencil_is_definite(family, seeds):
    """The condition holds where one is, but for p = 0, q = 0, p² = 4q, of which it says nothing."""
    report, held = family(), 0
    for seed in seeds:
        values = drawn(random.Random(seed), report.required)
        h, F = forms(report, values)
        verdict = report.verdict(values)
        definite = 4 in pencil.signature(h)
        if verdict.certificate and not verdict.pointwise:
            held += 1
            ((_, a),) = verdict.certificate
            assert 4 in pencil.signature(pencil.combined(h, F, a))
            assert not definite
        elif verdict.reason == "the second variation is definite on the symplectic slice":
            assert definite
        else:
            assert not definite
            assert not pencil.some_definite(h, F) or verdict.pointwise and verdict.certificate
    assert held


def test_the_condition_is_printed():
    """Of Kowalevski's top, with what it means."""
    report = kowalevski(1)
    assert str(report.casimirs_only) == "m < 0"
    assert str(report.sufficient) == "m < 0 or 2 w² > 3 m and m (m − w²) > 0 and m − 2 w² ≠ 0"


@pytest.mark.parametrize("turn", [1, -1])
def test_charts_and_boxes_agree_with_verdicts(turn):
    """At every point, on the curves too; a box in the window of Kowalevski's top is stable as a whole."""
    report = kowalevski(turn)
    values = {"m": np.linspace(-3, 3, 13)[:, None], "w": np.linspace(-2, 2, 9)}
    codes = gs.charts.verdicts(report, values)
    for (i, j), code in np.ndenumerate(codes):
        point = {"m": float(values["m"][i, 0]), "w": float(values["w"][j])}
        assert code == CODE_OF[report.verdict(point).verdict]
    box = gs.charts.certify_box(report, {"m": (turn, Rational(9, 8) * turn), "w": (2, 3)})
    assert box.verdict.name == "STABLE"
    assert gs.charts.certify_box(kowalevski(1), {"m": (1, 2), "w": (Rational(1, 2), 3)}).verdict.name != "STABLE"


def test_stabilizing_set_has_the_window():
    """m at w = 1, turning about +k1: stable up to 2/3 but for 0 and the point where no α exists."""
    (part, *_), report = gs.stabilizing_set(kowalevski(1), "m", {"w": 1}).parts, kowalevski(1)
    assert part.meaning == "stable"
    print(part)


def test_rotations_found_are_decided_with_it():
    """relative_equilibria and Report.verdict say the same of each, and some need F."""
    scene = kowalevski().equilibrium.system
    used = 0
    for rotation in gs.relative_equilibria(scene, {"m": 1, "omega": 2}):
        found, direct = rotation.decision, gs.analyze(rotation.equilibrium).verdict({})
        assert (found.verdict, found.notion, found.certificate) == (
            direct.verdict, direct.notion, direct.certificate)
        used += bool(found.certificate)
    assert used
