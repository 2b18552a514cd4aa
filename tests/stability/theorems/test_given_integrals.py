"""Integrals that are given: what they prove where the second variation with the Casimirs is indefinite."""
import random
import re
from fractions import Fraction

import pytest
from oracles import pencil
from slow import sampled, slow
from sympy import Rational, S, sqrt, sympify

import gyrostat as gs
from gyrostat.printing.formats.json_data import decision_data

KOWALEVSKI = "(M1^2 - M2^2 - 4*m*k1)^2 + (2*M1*M2 - 4*m*k2)^2 + 8*l*(M3 - 2*l)*(M1^2 + M2^2) - 32*l*m*M1*k3"
SQUARE = "M1^2 + M2^2 + M3^2"
TRIPLES = ((3, 4, 5), (5, 12, 13), (8, 15, 17), (7, 24, 25), (20, 21, 29), (9, 40, 41))


def kowalevski(draw):
    """Moments (2, 2, 1), U = m k1, l along axis 3 (Yehia), a rotation about an axis in the plane k2 = 0."""
    a, b, c = draw.choice(TRIPLES)
    a, b = draw.choice(((a, b), (b, a)))
    u, v = Rational(a, c) * draw.choice((1, -1)), Rational(b, c) * draw.choice((1, -1))
    w, l = Rational(draw.randint(1, 9), draw.randint(1, 4)), Rational(draw.randint(-3, 3), 2)
    m = w**2 * u - w * l * u / v                           # w² Ik + w l − g along k
    F = KOWALEVSKI.replace("m", f"({m})").replace("l", f"({l})")
    return (2, 2, 1), (0, 0, l), {"1": m}, F, (u, S.Zero, v), w


def clebsch(draw):
    """U = e k·Ik/2, a rotation about a principal axis."""
    I = draw.sample(range(1, 9), 3)
    e, w = Rational(draw.randint(-6, 6), draw.randint(1, 3)), Rational(draw.randint(1, 9), draw.randint(1, 3))
    axis = draw.randrange(3)
    F = f"{SQUARE} - ({e})*({I[1] * I[2]}*k1^2 + {I[2] * I[0]}*k2^2 + {I[0] * I[1]}*k3^2)"
    slopes = {str(n + 1) * 2: e * I[n] / 2 for n in range(3)}
    return I, (0, 0, 0), slopes, F, tuple(S(int(n == axis)) for n in range(3)), w


def parts(draw, family):
    """The report of a point with the integral, that without, and both polynomials in M, k."""
    I, rotor, slopes, F, k, w = family(draw)
    x = [gs.symbol(f"k{n}") for n in (1, 2, 3)]
    U = sum((c * x[int(n[0]) - 1] ** len(n) for n, c in slopes.items()), S.Zero)
    point = (*(i * w * y for i, y in zip(I, k)), *k)
    body, field = gs.Gyrostat(I, rotor), gs.general_potential(U)
    reports = [gs.analyze(gs.equilibrium(gs.assemble(body, field, integrals=given), point))
               for given in ((F,), ())]
    plain = dict(zip(map(str, pencil.X), pencil.X))
    own = U.xreplace({s: plain[s.name] for s in x})
    h = sum(((y - l) ** 2 / (2 * S(i)) for y, l, i in zip(pencil.X, map(S, rotor), I)), own)
    M = [p + l for p, l in zip(point[:3], map(S, rotor))]
    return *reports, pencil.forms(h, sympify(F.replace("^", "**"), plain), (*M, *k))


def coefficient(decision):
    """α of h + α F1: the certificate, which JSON and the reason say too."""
    ((F, a),) = decision.certificate
    sign, number = re.search(r"of h ([+−]) ([0-9/]*) ?F1 is definite", decision.reason).groups()
    assert Fraction(number or 1) * (-1 if sign == "−" else 1) == a
    assert decision_data(decision)["certificate"] == {str(F): str(a)}
    return Fraction(int(a.p), int(a.q))


@pytest.mark.slow
@pytest.mark.parametrize("family, seeds", [(kowalevski, range(5)), (clebsch, range(8, 13)),
                                           *slow((kowalevski, range(5, 150)), (clebsch, range(13, 160)))])
def test_pencils_in_fractions(family, seeds, full):
    """Proved where and only where a pencil of the oracle is definite, at the α shown."""
    proved = undecided = 0
    for seed in seeds[:sampled(len(seeds), full, 40)]:
        given, without, (h, F) = parts(random.Random(seed), family)
        decision, alone = given.verdict({}), without.verdict({})
        if "F1" not in decision.reason:                    # decided before: by Casimirs, or by an eigenvalue
            assert decision == alone
            assert 4 in pencil.signature(h) or alone.verdict is not gs.Verdict.STABLE
            continue
        assert 4 not in pencil.signature(h)
        if "no h + α F1" in decision.reason:
            undecided += 1
            assert not pencil.some_definite(h, F)
            assert decision.reason.endswith(alone.reason) and decision.verdict is alone.verdict
        else:
            proved += 1
            assert decision.verdict is gs.Verdict.STABLE and decision.notion == "Lyapunov"
            assert 4 in pencil.signature(pencil.combined(h, F, coefficient(decision)))
            assert alone.verdict is not gs.Verdict.UNSTABLE
    assert proved


def sretensky(t, w=None):
    """Goryachev and Chaplygin's body with a rotor; a rotation about (u, 0, v), M·k = 0 unless ω is given."""
    u, v = (1 - t**2) / (1 + t**2), 2 * t / (1 + t**2)
    w = -v / (4 * u**2 + v**2) if w is None else S(w)      # w k·Ik + l·k = 0, l = 1
    slope = 3 * w**2 * u - w * u / v                       # w² Ik + w l − g along k
    scene = gs.assemble(gs.Gyrostat((4, 4, 1), (0, 0, 1)), gs.general_potential(slope * gs.symbol("k1")),
                        integrals=(f"(M3 - 2)*(M1^2 + M2^2) - 4*({slope})*M1*k3",))
    h = sum(((x - l) ** 2 / (2 * S(i)) for x, l, i in zip(pencil.X, (0, 0, 1), (4, 4, 1))), slope * pencil.k1)
    F = (pencil.M3 - 2) * (pencil.M1**2 + pencil.M2**2) - 4 * slope * pencil.M1 * pencil.k3
    return scene, (4 * w * u, 0, w * v, u, 0, v), (h, F)


@pytest.mark.few(1)
@pytest.mark.parametrize("t", [Rational(3, 4), Rational(6, 5)])
def test_on_its_level_only(t):
    """What is conserved where M·k = 0 proves stability there, and the notion says so."""
    scene, point, functions = sretensky(t)
    assert scene.level_only == scene.integrals == scene.given_integrals and not scene.linear_integrals
    decision = gs.analyze(gs.equilibrium(scene, point)).verdict({})
    assert (decision.verdict.name, decision.notion) == ("STABLE", "Lyapunov")
    assert decision.scope == "on its level of C1"
    h, F = pencil.forms(*functions, (*point[:2], point[2] + 1, *point[3:]))
    assert 4 not in pencil.signature(h)
    assert 4 in pencil.signature(pencil.combined(h, F, coefficient(decision)))


@pytest.mark.slow
def test_what_is_not_used_is_said():
    """Off its level, or not critical: the reason says so, and other theorems decide."""
    scene, point, _ = sretensky(Rational(3, 4), 2)
    decision = gs.analyze(gs.equilibrium(scene, point)).verdict({})
    assert decision.reason.startswith("F1 is conserved where M·k = 0 only; the amended potential has")
    body, k = gs.Gyrostat((3, 2, 1), (0, 0, 0)), (Rational(3, 5), 0, Rational(4, 5))
    U = sum(i * gs.symbol(f"k{n}") ** 2 for n, i in ((1, 3), (2, 2), (3, 1))) / S(2)
    field = gs.general_potential(U)                        # every k turns with ω = k
    scene = gs.assemble(body, field, integrals=(f"{SQUARE} - 2*k1^2 - 3*k2^2 - 6*k3^2",))
    decision = gs.analyze(gs.equilibrium(scene, (*(i * x for i, x in zip((3, 2, 1), k)), *k))).verdict({})
    assert decision.reason.startswith("F1 is not critical there on the orbit; ")


def test_irrational_numbers():
    """√ in the point and in U: the certificate is rational all the same."""
    root = sqrt(2)
    scene = gs.assemble(gs.Gyrostat((3, 2, 1), (0, 0, 0)), gs.general_potential(S.Zero), integrals=(SQUARE,))
    decision = gs.analyze(gs.equilibrium(scene, (0, 0, root, 0, 0, 1))).verdict({})
    assert decision.notion == "Lyapunov" and coefficient(decision) < Fraction(-1, 2)
