"""Conditions with an integral that is given, α eliminated: against pencils, and all that reads them."""
import random
from fractions import Fraction
from functools import cache

import numpy as np
import pytest
from oracles import pencil
from slow import sampled, slow
from sympy import Rational, S

import gyrostat as gs
from gyrostat.charts.codes import CODE_OF

l, m, q, w, k1, k2, k3 = map(gs.symbol, ("l", "m", "q", "w", "k1", "k2", "k3"))
I1, I2, I3, e = map(gs.symbol, ("I1", "I2", "I3", "e"))


@cache
def kowalevski():
    """Kowalevski's top with a rotor (Yehia) about any k in the plane of its centre of mass and its axis."""
    u, v = (1 - q**2) / (1 + q**2), 2 * q / (1 + q**2)
    F = "(M1^2 - M2^2 - 4*m*k1)^2 + (2*M1*M2 - 4*m*k2)^2 + 8*l*(M3 - 2*l)*(M1^2 + M2^2) - 32*l*m*M1*k3"
    scene = gs.assemble(gs.Gyrostat((2, 2, 1), (0, 0, l)), gs.general_potential(m * k1), integrals=(F,))
    given = ((m, w**2 * u - w * l * u / v),)
    return gs.analyze(gs.equilibrium(scene, (2 * w * u, 0, w * v, u, 0, v), relations=given))


@cache
def clebsch():
    """U = e k·Ik/2, a rotation about axis 3."""
    U = e * (I1 * k1**2 + I2 * k2**2 + I3 * k3**2) / 2
    F = "M1^2 + M2^2 + M3^2 - e*(I2*I3*k1^2 + I3*I1*k2^2 + I1*I2*k3^2)"
    scene = gs.assemble(gs.Gyrostat(gyrostatic_momentum=(0, 0, 0)), gs.general_potential(U), integrals=(F,))
    return gs.analyze(gs.equilibrium(scene, (0, 0, I3 * w, 0, 0, 1)))


def forms(report, values):
    """Both forms of the oracle at numbers."""
    eq = report.equilibrium
    numbers = {gs.symbol(name): S(x) for name, x in values.items()}
    numbers |= {name: value.xreplace(numbers) for name, value in eq.relations}
    rotor = [S(x).xreplace(numbers) for x in eq.system.body.gyrostatic_momentum]
    M = [x - y for x, y in zip(pencil.X, rotor)]
    plain = dict(zip(eq.system.space.coordinates, (*M, *pencil.X[3:])))
    h, F = (f.xreplace(numbers).xreplace(plain) for f in (eq.system.hamiltonian, *eq.system.given_integrals))
    point = [S(x).xreplace(numbers) for x in eq.point]
    return pencil.forms(h, F, [*(x + y for x, y in zip(point, rotor)), *point[3:]])


def drawn(draw, names):
    """Three different moments, q > 0 and not 1."""
    moments = draw.sample(range(4, 25), 3)
    numbers = {name: Rational(draw.randint(-9, 9), draw.randint(1, 4)) for name in ("e", "l", "w")}
    numbers |= {f"I{n}": Rational(x, 8) for n, x in enumerate(moments, 1)}
    numbers["q"] = Rational(2 * draw.randint(0, 8) + 1, 4)
    return {name: numbers[name] for name in names}


@pytest.mark.slow
@pytest.mark.parametrize("family, seeds", [(kowalevski, range(1, 3)), (clebsch, range(4, 6)),
                                           *slow((kowalevski, range(3, 120)), (clebsch, range(6, 120)))])
def test_where_some_pencil_is_definite(family, seeds, full):
    """The condition holds where one is, but for p = 0, q = 0, p² = 4q, of which it says nothing."""
    report, held = family(), 0
    for seed in seeds[:sampled(len(seeds), full, 40)]:
        values = drawn(random.Random(seed), report.required)
        h, F = forms(report, values)
        verdict = report.verdict(values)
        definite = 4 in pencil.signature(h)
        if verdict.certificate and not verdict.pointwise:
            held += 1
            ((_, a),) = verdict.certificate
            assert 4 in pencil.signature(pencil.combined(h, F, Fraction(int(a.p), int(a.q))))
            assert not definite
        elif verdict.reason == "the second variation is definite on the symplectic slice":
            assert definite
        else:
            assert not definite
            assert not pencil.some_definite(h, F) or verdict.pointwise and verdict.certificate
    assert held


def test_the_condition_is_printed():
    """Of a body without torque, whose k does not turn with it; what it means is said, and what F adds."""
    scene = gs.assemble(gs.Gyrostat((3, 2, 1), (0, 0, 0)), gs.general_potential(0),
                        integrals=("M1^2 + M2^2 + M3^2",))
    report = gs.analyze(gs.equilibrium(scene, (0, 0, w, 0, 0, 1)))
    assert (str(report.sufficient), str(report.casimirs_only)) == ("w ≠ 0", "no information")
    assert "definite on the orbit for some α" in str(report)


def agree(report, values):
    """Whether an array has the verdict of each point; how many the integral decided."""
    used = 0
    names = list(values)
    for place, code in np.ndenumerate(gs.charts.verdicts(report, values)):
        grid = np.broadcast_arrays(*values.values())
        decision = report.verdict({name: float(a[place]) for name, a in zip(names, grid)})
        assert code == CODE_OF[decision.verdict], place
        used += bool(decision.certificate)
    return used


@pytest.mark.slow
def test_arrays_agree_with_verdicts():
    """At every point, on the curves too."""
    assert agree(kowalevski(), {"q": np.array([0.5, 0.75])[:, None], "w": 1.0,
                                "l": np.array([-1.5, 0.0, 0.5, 0.96])}) == 3
    assert agree(clebsch(), {"I1": 3.0, "I2": 2.0, "I3": 1.0, "e": np.array([-2.0, 0.0, 1.0, 4.0])[:, None],
                             "w": np.array([-1.0, 0.0, 1.0, 2.0])}) > 3


@pytest.mark.slow
def test_a_box_in_the_window_is_stable():
    """As a whole, by F alone; and not where it contains unstable points."""
    report = kowalevski()
    inside = {"w": 1, "q": ("3/4", "19/25"), "l": (0, "1/100")}
    assert gs.charts.certify_box(report, inside).verdict.name == "STABLE"
    assert gs.charts.certify_box(report, inside | {"l": ("1/2", 1)}).verdict.name != "STABLE"


@pytest.mark.slow
def test_the_stabilizing_set_has_the_window():
    """Of l, where the Casimirs alone prove l > 24/25 only."""
    found = gs.stabilizing_set(kowalevski(), "l", {"q": "3/4", "w": 1})
    assert str(found).splitlines()[0] == ("Stable: −13824/1225 < l < −24/25 or −24/25 < l < −49/600 or "
                                          "−49/600 < l < 239/300 or l ≥ 24/25.")


@pytest.mark.slow
def test_rotations_found_are_decided_with_it():
    """relative_equilibria and Report.verdict say the same of each, and some need F."""
    used = 0
    for rotation in gs.relative_equilibria(kowalevski().equilibrium.system, {"m": 1, "l": 0, "omega": 2}):
        found, direct = rotation.decision, gs.analyze(rotation.equilibrium).verdict({})
        assert (found.verdict, found.notion, found.certificate) == (
            direct.verdict, direct.notion, direct.certificate)
        used += bool(found.certificate)
    assert used
