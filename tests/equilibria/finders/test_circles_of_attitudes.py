"""Attitudes on circles and other curves: complete, with their equations, the same in any axes."""
from fractions import Fraction as F
from random import Random

import numpy as np
import pytest
from attitude_search import landings, torque
from mpmath import mp
from satellites import rotation
from torques_on_satellites import ONE, Satellite, in_axes, turned

WEIGHTS = {"t": 0, "n": -1, "r": 3}                    # V = ½ Σ weight a·Ia + v·e


def draw(rng, kind):
    """Moments, rotor, and what acts along t, n, r and as forms; in axes of which the third is the own one."""
    A, C = (F(n, 20) for n in rng.sample(range(12, 23), 2))

    def some():
        return F(rng.choice((-1, 1)) * rng.randint(1, 20), 15)

    def up(x):
        return [F(0), F(0), x]

    if kind == "axial":
        tensor = [[F(int(i == j == 2)) * some() for j in range(3)] for i in range(3)]
        return (A, A, C), up(some()), {a: up(some()) for a in "tnr"}, {("n", "n"): tensor}
    if kind == "vertical":
        return (A, A, C), up(F(0)), {"r": up(some() / 7)}, {("r", "r"): [[F(0)] * 3, [F(0)] * 3, up(some())]}
    if kind == "ball":
        return (A, A, A), up(some()), {}, {}
    return (A, A, C), up(some() / 3), {"n": up(some() / 4)}, {}


def matrices(equilibria):
    """Rows t, n, r in body axes."""
    return [np.array(e.attitude.matrix) for e in equilibria]


def signs_of(satellite, R):
    """The eigenvalues of K at a rotation."""
    return np.linalg.eigvalsh(stiffness(satellite, R))


def stiffness(satellite, R):
    """K at a rotation."""
    bend = torque(R[None], satellite.matrix, satellite.vector)[1][0]
    return -(bend + bend.T) / 2


def growth(satellite, tensor, rotor, R):
    """The largest real part of an eigenvalue of I θ̈ + g × θ̇ + K θ = 0, ω0 = 1."""
    I, l = np.array(tensor, float), np.array(rotor, float)
    g = np.trace(I) * R[1] - 2 * I @ R[1] - l
    hat = np.array([[0, -g[2], g[1]], [g[2], 0, -g[0]], [-g[1], g[0], 0]])
    back = np.linalg.inv(I)
    motion = np.block([[np.zeros((3, 3)), np.eye(3)], [-back @ stiffness(satellite, R), -back @ hat]])
    return np.linalg.eigvals(motion).real.max()


@pytest.mark.few(1)
@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("kind", ["one torque", "axial", "ball", "vertical"])
def test_circles_of_a_body_of_revolution(kind, seed):
    """Newton's method ends on no other circle, Σ (−1)^index is 2 on the sphere of the axis, and verdicts.

    The same satellite in axes turned by a rational rotation has the same circles with the same verdicts.
    """
    rng = Random(f"{kind} {seed}")
    moments, rotor, linear, forms = draw(rng, kind)
    answers = []
    for turn in (ONE, rotation(rng)):
        tensor, l = turned(moments, turn), in_axes(turn, rotor)
        rows = {pair: turned([m[i][i] for i in range(3)], turn) for pair, m in forms.items()}
        satellite = Satellite(tensor, l, {a: in_axes(turn, v) for a, v in linear.items()}, rows)
        c, found = np.array(turn[2], float), satellite.found()
        here = [R @ c for R in matrices(found)]
        assert all("a circle of equilibria about" in e.locus and e.decision.modulo for e in found)
        for R, _ in landings(satellite.matrix, satellite.vector, seed=seed):
            assert min(np.abs(R @ c - z).max() for z in here) < 1e-6
        assert len({tuple(np.round(z, 7)) for z in here}) == len(here)
        count = 0
        for e, R in zip(found, matrices(found)):
            K = sorted(signs_of(satellite, R), key=abs)[1:]
            assert min(map(abs, K)) > 1e-6
            count += (-1) ** sum(x < 0 for x in K)
            assert e.decision.unstable == (growth(satellite, tensor, l, R) > 1e-4)
            across = np.cross(c, R[1]) * float(moments[2])**0.5
            H = sorted(np.linalg.eigvalsh(stiffness(satellite, R) + np.outer(across, across)), key=abs)[1:]
            assert e.decision.stable or not min(H) > 0
            assert e.damped.stable == (min(K) > 0)
        assert count == 2
        answers.append(sorted((*(round(x, 6) + 0.0 for x in z), e.decision.verdict.name, e.decision.rung.name,
                               e.damped.verdict.name) for z, e in zip(here, found)))
    assert answers[0] == answers[1]


def on_closed_curve(rng, e):
    """Moments, an axis j, v with v² = p q (I_i − I_j)(I_k − I_j), p, q, and the other axes of the orbit."""
    f, g = (x for x in "tnr" if x != e)
    p, q = WEIGHTS[f] - WEIGHTS[e], WEIGHTS[g] - WEIGHTS[e]
    s, u = F(rng.randint(1, 9), 10), F(rng.randint(1, 9), 10)
    while s == u or p**2 * s**2 == q**2 * u**2:            # there it meets an attitude with e along e_j
        u += F(1, 7)
    side = rng.choice((-1, 1))
    a, b, v = side * p * s**2, side * q * u**2, p * q * s * u
    own = max(0, -a, -b) + F(rng.randint(5, 20), 4)
    j = rng.randrange(3)
    moments = [own] * 3
    moments[j - 1] += a
    moments[j - 2] += b
    return moments, j, v, p, q, f, g


@pytest.mark.few(1)
@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("e", "tnr")
def test_a_closed_curve(e, seed):
    """Where K is singular, the equations of the curve hold, and only there; isolated attitudes are beside it.

    Along the normal v is that of a dipole; the same in turned axes.
    """
    rng = Random(f"{e} {seed}")
    moments, j, v, p, q, f, g = on_closed_curve(rng, e)
    vector = [v * (i == j) for i in range(3)]
    answers = []
    for turn in (ONE, rotation(rng)):
        tensor = turned(moments, turn)
        satellite = Satellite(tensor, linear={e: in_axes(turn, vector)})
        found, I = satellite.found(), np.array(tensor, float) - float(moments[j]) * np.eye(3)
        axis = np.array(turn[j], float)

        def left(R, I=I, axis=axis):
            at = dict(zip("tnr", R))
            F, G = at[f] @ I @ at[f], at[g] @ I @ at[g]
            level = -float(v) * at[e] @ axis
            return max(abs(at[f] @ I @ at[g]), abs(p * F - level), abs(q * G - level))

        isolated = [R for x, R in zip(found, matrices(found)) if not x.locus]
        met = 0
        for R, bend in landings(satellite.matrix, satellite.vector):
            if min(abs(np.linalg.eigvalsh(bend + bend.T))) < 1e-5:
                assert left(R) < 1e-6
                met += 1
            else:
                assert min(np.abs(R - other).max() for other in isolated) < 1e-7
        assert met > 5
        for x, R in zip(found, matrices(found)):
            assert bool(x.locus) == (left(R) < 1e-9)
            assert np.abs(torque(R[None], satellite.matrix, satellite.vector)[0]).max() < 1e-12
            K = signs_of(satellite, R)
            if x.locus:
                assert f"{f}·I{g} = 0" in x.locus
                assert x.decision.stable == (min(K) > -1e-9) and x.decision.rung.name in (
                    "LEAST_ON_SET", "SPECTRUM", "NOTHING")
        answers.append(sorted((x.locus != "", x.decision.verdict.name, x.damped.verdict.name) for x in found))
    assert answers[0] == answers[1] and any(line[0] for line in answers[0])


def test_attitudes_along_a_closed_curve():
    """With a rotor: 50 digits along the curve, from its equations, leave no torque.

    I' in the axes t, n, r has the entries that the equations say; its eigenvectors are the axes of the body.
    """
    mp.dps = 50
    a, b = mp.mpf(4) / 5, mp.mpf(1) / 3                    # I_i − I_j, I_k − I_j
    L = 2 * mp.sqrt(a * b)
    done = 0
    for n in range(1, 40):
        height = mp.mpf(n) / 40                            # n·e_j
        # E + F + G = a + b with E = (L/height)(t_j² + r_j²/4), F = L height, G = L height/4
        square = ((a + b - L * height * 5 / 4) * height / L - (1 - height**2) / 4) * 4 / 3
        if not 0 < square < 1 - height**2:
            continue
        tj, rj = mp.sqrt(square), mp.sqrt(1 - height**2 - square)
        F_, G = L * height, L * height / 4
        E = L / height * (square + rj**2 / 4)
        whole = mp.matrix([[F_, -L * tj, 0], [-L * tj, E, -L * rj / 4], [0, -L * rj / 4, G]])      # t, n, r
        values, vectors = mp.eigsy(whole)
        assert max(abs(x - y) for x, y in zip(values, sorted((0, a, b)))) < mp.mpf(10) ** -40
        column = vectors[:, 0] * mp.sign(vectors[1, 0])    # e_j in t, n, r
        assert mp.norm(column - mp.matrix([tj, height, rj])) < mp.mpf(10) ** -40
        l = L * column
        # t·Ir = 0, t·(In + l) = 0, r·(4 In + l) = 0 with ω0 = 1
        assert max(abs(whole[0, 2]), abs(whole[0, 1] + l[0]), abs(4 * whole[2, 1] + l[2])) < mp.mpf(10) ** -40
        done += 1
    assert done > 5


@pytest.mark.slow
def test_axes_whose_length_is_irrational():
    """Along (1, 1, 0) torques have √2 in them: the same as along axis 3, by decimals of the same torques."""
    tensor = [[F(3, 2), F(1, 2), 0], [F(1, 2), F(3, 2), 0], [0, 0, 1]]
    given = Satellite(tensor, (F(1, 5), F(1, 5), 0), {"t": (F(1, 7), F(1, 7), 0), "r": (F(1, 9), F(1, 9), 0)})
    own = Satellite(turned((1, 1, 2), ONE), (0, 0, F(2**0.5) / 5),
                    {"t": (0, 0, F(2**0.5) / 7), "r": (0, 0, F(2**0.5) / 9)})
    found, expected = given.found(), own.found()
    c = np.array([1, 1, 0]) / 2**0.5
    assert len(found) == len(expected) >= 4
    for e, R, other, S in zip(found, matrices(found), expected, matrices(expected)):
        np.testing.assert_allclose(R @ c, S[:, 2], atol=1e-12)
        assert (e.decision.verdict, e.damped.verdict) == (other.decision.verdict, other.damped.verdict)
        assert np.abs(torque(R[None], given.matrix, given.vector)[0]).max() < 1e-12


@pytest.mark.few(1)
@pytest.mark.parametrize("seed", range(4))
def test_circles_about_the_normal(seed):
    """A ball in a potential of n alone, with a rotor that is not along its axes: the frame may turn about n.

    Newton's method ends on no other circle; the energy is least where K has two positive eigenvalues.
    """
    matrix = turned([F(1, 3), F(-1, 4), F(1, 2)], rotation(Random(seed)))
    satellite = Satellite(turned((1, 1, 1), ONE), (0, 0, F(1, 5)), {"n": (F(1, 9), F(1, 5), 0)},
                          {("n", "n"): matrix})
    found = satellite.found()
    here = [R[1] for R in matrices(found)]
    assert all("a circle of equilibria about n," in e.locus for e in found)
    for R, _ in landings(satellite.matrix, satellite.vector):
        assert min(np.abs(R[1] - n).max() for n in here) < 1e-6
    count = 0
    for e, R in zip(found, matrices(found)):
        K = sorted(signs_of(satellite, R), key=abs)[1:]
        count += (-1) ** sum(x < 0 for x in K)
        assert (e.decision.rung.name == "LEAST_ON_SET") == (min(K) > 0)
    assert count == 2


def test_a_torus_of_attitudes():
    """In a potential of n·c alone, (n·c)²/2 − n·c/3 with c = e3: n·c = 1/3 on a torus, and two circles."""
    satellite = Satellite(turned((1, 1, 1), ONE), linear={"n": (0, 0, F(-1, 3))},
                          forms={("n", "n"): turned((0, 0, 1), ONE)})
    torus, *circles = satellite.found()
    assert "a torus" in torus.locus and torus.locus.endswith("is 1/3")
    assert abs(torus.doubles.place["n3"] - 1 / 3) < 1e-15
    assert sorted(e.doubles.place["n3"] for e in circles) == [-1, 1]


@pytest.mark.parametrize(("digits", "count"), [(6, 24), (12, 24), (None, 6)])
def test_moments_that_are_equal_but_for_rounding(digits, count):
    """A body of revolution in tilted axes, exact or rounded: it is taken as what it is."""
    turn = [[F(3, 7), F(-6, 7), F(2, 7)], [F(6, 7), F(2, 7), F(-3, 7)], [F(2, 7), F(3, 7), F(6, 7)]]
    tensor = turned((1, 1, 2), turn)
    if digits:
        tensor = [[F(round(x * 10**digits), 10**digits) for x in row] for row in tensor]
    found = Satellite(tensor).found()
    assert len(found) == count
    assert all(bool(e.locus) == (count == 6) for e in found)
    assert sum((-1) ** e.form.index for e in found if not e.locus) == 0
