"""Two constant fields; a magnet or a constant pressure in orbit: textbook forms, and fractions."""
from random import Random

import pytest
from satellites import exact, of_orbit, satellite
from slow import sampled
from sympy import Matrix, Rational, diag, sqrt
from two_directions import Scene, second_variation, sextic, stable_spectrum
from two_directions import random_fraction as some

import gyrostat as gs
from gyrostat.errors import EquilibriumError, PotentialError, StructureError
from gyrostat.stability.criteria.orientation_form import orientation_form

N, R, MU, F = ([gs.symbol(f"{x}{i}") for i in (1, 2, 3)] for x in ("n", "r", "mu", "F"))
MAGNET = -sum(a * b for a, b in zip(MU, N))
a, b = map(gs.symbol, "ab")
PULL = -a * gs.symbol("k1") - b * gs.symbol("e2")


@pytest.mark.few(1)
@pytest.mark.parametrize(("first", "second"), [(1, 1), (1, -1), (-1, 1), (-1, -1)])
def test_two_constant_fields(first, second):
    """K = diag(s2 b, s1 a, s1 a + s2 b), g = −l, whatever the body and its rotor."""
    scene = gs.assemble(gs.Gyrostat(), gs.coupled_potential(PULL))
    eq = gs.steady_motion(scene, (first, 0, 0), (0, second, 0))
    form = orientation_form(eq)
    assert form.stiffness == Matrix(diag(second * b, first * a, first * a + second * b))
    assert form.gyroscopic == tuple(-gs.symbol(f"l{i}") for i in (1, 2, 3))
    values = {"a": 1, "b": 2, "I1": 2, "I2": 2, "I3": 1, "l1": 0, "l2": 0, "l3": 1}
    stable = first == second == 1
    assert (gs.analyze(eq).verdict(values, damped=True).verdict.name == "STABLE") == stable


def test_a_gyrostat_in_two_fields():
    """(x + 3)(4 x² + 7 x + 2) of I = (2, 2, 1), l = (0, 0, 1), a = 1, b = 2."""
    scene = gs.assemble(gs.Gyrostat((2, 2, 1), (0, 0, 1)), gs.coupled_potential(PULL.xreplace({a: 1, b: 2})))
    square = gs.symbol("lamda") ** 2
    linear = gs.derivation.linearize(gs.steady_motion(scene, (1, 0, 0), (0, 1, 0)))
    assert {f.expand() for f, _ in linear.factors()} == {square + 3, 4 * square**2 + 7 * square + 2}


def test_integrals_in_two_fields():
    """Bogoyavlensky's, where I1 = I2 = 2 I3; one that is none, even where e·k = 1."""
    body, field = gs.Gyrostat((2, 2, 1), (0, 0, 0)), gs.coupled_potential(PULL)
    pi1, pi2, k1, k2, e1, e2 = map(gs.symbol, ("pi1", "pi2", "k1", "k2", "e1", "e2"))
    w1, w2 = pi1 / 2, pi2 / 2
    known = (w1**2 - w2**2 + a * k1 - b * e2) ** 2 + (2 * w1 * w2 + a * k2 + b * e1) ** 2
    assert gs.assemble(body, field, integrals=(known,)).integrals == (known,)
    with pytest.raises(StructureError, match="its bracket with the Hamiltonian is [^,]*, not 0;"):
        gs.assemble(body, field, integrals=("(k1*e1 + k2*e2 + k3*e3 - 1)*pi1",))


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(3))
def test_a_magnet_acts_in_the_stiffness_as_a_rotor(seed):
    """The attitudes and K are those of the rotor B μ/ω0; g is that of no rotor."""
    rng = Random(f"magnet {seed}")
    I, n, r, l = satellite(rng)
    at = dict(zip(MU, exact(l)))
    orbit = gs.circular_orbit(1, potential=MAGNET.xreplace(at))
    magnetised = gs.assemble(gs.Gyrostat(exact(I), (0, 0, 0)), orbit)
    held = gs.assemble(gs.Gyrostat(exact(I), exact(l)), gs.circular_orbit(1))
    mine, other = (orientation_form(gs.steady_motion(scene, exact(n), exact(r)))
                   for scene in (magnetised, held))
    assert mine.stiffness == other.stiffness
    assert [x - y for x, y in zip(mine.gyroscopic, other.gyroscopic)] == exact(l)
    places = [sorted(tuple(round(x, 9) for x in e.doubles.place.values()) for e in
                     gs.relative_equilibria(scene, {})) for scene in (magnetised, held)]
    assert places[0] == places[1]


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(3))
def test_magnet_and_pressure_together(seed, full):
    """−B n·μ + F·(n × r), with a rotor: the sextic and the verdicts, by fractions that know neither."""
    rng = Random(f"pressure {seed}")
    U = MAGNET + Matrix(F).dot(Matrix(N).cross(Matrix(R)))
    for _ in range(sampled(30, full, 6)):
        I, n, r, l = satellite(rng)
        mu, extra = [some(rng) for _ in range(3)], some(rng)
        # pressure along t turns nothing; the magnet is made up for by the rotor
        t = [n[i - 2] * r[i - 1] - n[i - 1] * r[i - 2] for i in range(3)]
        pressure = [extra * x for x in t]
        rotor = [x - y for x, y in zip(l, mu)]
        oracle, state = of_orbit(I, n, r, rotor)
        S = [list(row) for row in oracle.S]
        for i in range(3):                                 # F·(n × r) = n·(r × F)
            j, k = (i + 1) % 3, (i + 2) % 3
            S[i][3 + j], S[i][3 + k] = S[i][3 + j] + pressure[k], S[i][3 + k] - pressure[j]
            S[3 + j][i], S[3 + k][i] = S[i][3 + j], S[i][3 + k]
        s = [*(x - y for x, y in zip(oracle.s[:3], mu)), *oracle.s[3:]]
        oracle = Scene(oracle.A, rotor, oracle.B, S, s)
        assert not any(oracle.field(state))
        at = dict(zip((*MU, *F), exact([*mu, *pressure])))
        orbit = gs.circular_orbit(1, potential=U.xreplace(at))
        scene = gs.assemble(gs.Gyrostat(exact(I), exact(rotor)), orbit)
        eq = gs.steady_motion(scene, exact(n), exact(r))
        expected = sextic(oracle, state)
        assert gs.derivation.linearize(eq).coefficients == tuple(exact(expected))
        plus, minus, null = second_variation(oracle, state)
        report = gs.analyze(eq)
        name = "STABLE" if plus == 6 else "UNDECIDED" if stable_spectrum(*expected) else "UNSTABLE"
        assert report.verdict({}).verdict.name == name
        if not null:
            assert report.verdict({}, damped=True).growing in (minus, None)


def test_damping_reaches_what_a_magnet_turns():
    """At I2 = I3, where the gravity gradient leaves a motion undamped."""
    body = gs.Gyrostat((1, 2, 2), (0, -3, 0))
    bare = gs.analyze(gs.earth_pointing(gs.assemble(body, gs.circular_orbit(1))))
    magnetised = gs.analyze(gs.earth_pointing(gs.assemble(body, gs.circular_orbit(1, potential=N[1]))))
    assert bare.verdict({}, damped=True).growing == 1
    body = gs.Gyrostat((1, gs.symbol("I2"), 2), (0, -3, 0))
    family = gs.analyze(gs.earth_pointing(gs.assemble(body, gs.circular_orbit(1))))
    assert gs.charts.verdicts(family, {"I2": [1.5, 2, 2.5]}, damped=True).tolist() == [-1, -1, -1]
    assert magnetised.verdict({}, damped=True).growing == 3


def test_a_magnet_on_a_symmetric_satellite():
    """Gyroscopically stabilised it is decided by the motion of its axis, with a magnet along the axis too."""
    height, rotor = Rational(3, 4), 4 * (1 - Rational(8, 5)) * Rational(3, 4)
    across = sqrt(1 - height**2)
    for magnet in (0, 1):
        body = gs.Gyrostat((1, 1, "8/5"), (0, 0, rotor - magnet))
        scene = gs.assemble(body, gs.circular_orbit(1, potential=-magnet * N[2]))
        conical = gs.steady_motion(scene, (across, 0, height), (-height, 0, across))
        decision = gs.analyze(conical).verdict({})
        assert decision.verdict.name == "STABLE" and "D4" in decision.reason, decision


def test_what_is_no_other_field():
    """Of k it is refused; an attitude that it turns is none."""
    with pytest.raises(PotentialError, match="n1, n2, n3, the normal, r1, r2, r3"):
        gs.circular_orbit(potential=gs.symbol("k3"))
    scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)), gs.circular_orbit(1, potential=N[0]))
    with pytest.raises(EquilibriumError, match="dpi3/dt"):
        gs.earth_pointing(scene)
