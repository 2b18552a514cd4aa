"""Equilibria in the frame of two directions, against fractions that do not import gyrostat."""
from fractions import Fraction
from random import Random

import pytest
from satellites import body_of, exact, of_orbit, rotation, satellite
from slow import sampled
from sympy import Matrix, Rational
from two_directions import Scene, dot, second_variation, sextic, stable_spectrum
from two_directions import random_fraction as some

import gyrostat as gs
from gyrostat.stability.criteria.orientation_form import orientation_form


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(6))
def test_satellites(seed, full):
    """The sextic, the signature of K beside three positive squares, the verdict and the damped one."""
    rng = Random(f"satellite {seed}")
    for _ in range(sampled(1700, full, 12)):
        I, n, r, l = satellite(rng)
        scene, state = of_orbit(I, n, r, l)
        assert not any(scene.field(state))
        eq = gs.equilibrium(gs.assemble(gs.Gyrostat(exact(I), exact(l)), gs.circular_orbit(1)), exact(state))
        expected = sextic(scene, state)
        found = gs.derivation.linearize(eq).coefficients
        assert found == tuple(exact(expected)) == orientation_form(eq).coefficients
        plus, minus, null = second_variation(scene, state)
        report = gs.analyze(eq)
        decision = report.verdict({})
        name = "STABLE" if plus == 6 else "UNDECIDED" if stable_spectrum(*expected) else "UNSTABLE"
        assert decision.verdict.name == name
        damped = report.verdict({}, damped=True)
        if not null and damped.verdict.name != "UNDECIDED":
            assert damped.growing == minus


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(3))
def test_two_constant_fields(seed):
    """U = −(a k1 + b e2) and the general β."""
    rng = Random(f"fields {seed}")
    for _ in range(2):
        I, (_, a, b) = body_of(rng), rotation(rng)
        B = [[some(rng) for _ in range(6)] for _ in range(3)]
        S = [[some(rng) for _ in range(6)] for _ in range(6)]
        S = [[S[min(i, j)][max(i, j)] for j in range(6)] for i in range(6)]
        x = [*a, *b]
        beta = [dot(row, x) for row in B]
        pi = [-i * y for i, y in zip(I, beta)]
        # ∂h/∂a = λ a + μ b, ∂h/∂b = μ a + ν b: critical on the orbit
        la, mu, nu = some(rng), some(rng), some(rng)
        wanted = [la * p + mu * q for p, q in zip(a, b)] + [mu * p + nu * q for p, q in zip(a, b)]
        s = [w - dot(S[j], x) - sum(B[i][j] * pi[i] for i in range(3)) for j, w in enumerate(wanted)]
        l = [some(rng) for _ in range(3)]
        A = [[1 / I[i] if i == j else Fraction(0) for j in range(3)] for i in range(3)]
        scene, state = Scene(A, l, B, S, s), [*pi, *x]
        assert not any(scene.field(state))
        names = Matrix(gs.lie_poisson(("k", "e")).coordinates[3:])
        form = Matrix(6, 6, [y for row in S for y in exact(row)])
        U = (names.T * form * names)[0] / 2 + Matrix(exact(s)).dot(names)
        drift = [Matrix(exact(row)).dot(names) for row in B]
        field = gs.coupled_potential(U, drift=drift)
        eq = gs.equilibrium(gs.assemble(gs.Gyrostat(exact(I), exact(l)), field), exact(state))
        assert gs.derivation.linearize(eq).coefficients == tuple(exact(sextic(scene, state)))
        assert orientation_form(eq).coefficients == gs.derivation.linearize(eq).coefficients
        plus, minus, _ = second_variation(scene, state)
        assert (gs.analyze(eq).verdict({}).verdict.name == "STABLE") == (plus == 6)
        assert gs.analyze(eq).verdict({}, damped=True).growing in (minus, None)


@pytest.mark.slow
def test_textbook_conditions():
    """Lagrange's, with a pitch rotor; DeBra and Delp's body of frequencies 4/5 and 1/2."""
    body = gs.Gyrostat(gyrostatic_momentum=(0, gs.symbol("l"), 0))
    report = gs.analyze(gs.earth_pointing(gs.assemble(body, gs.circular_orbit())))
    I1, I2, I3, w, l = map(gs.symbol, ("I1", "I2", "I3", "omega0", "l"))
    (conditions,) = report.sufficient.alternatives
    assert {c.margin.expand() for c in conditions} == {
        x.expand() for x in (l + 4 * w * (I2 - I3), I1 - I3, l + w * (I2 - I1))}
    bare = gs.analyze(gs.earth_pointing(gs.assemble(gs.Gyrostat(gyrostatic_momentum=(0, 0, 0)),
                                                    gs.circular_orbit())))
    assert {c.margin for (c,) in zip(*bare.sufficient.alternatives)} == {I1 - I3, I2 - I1}
    held = gs.analyze(gs.earth_pointing(gs.assemble(gs.Gyrostat((60, 32, 35), (0, 0, 0)),
                                                    gs.circular_orbit(1))))
    rates = {abs(x) for x in held.linearization.eigenvalues()}
    assert {Rational(1, 2), Rational(4, 5)} < rates and Rational(75, 32) in {x**2 for x in rates}
    assert held.verdict({}).verdict.name == "UNDECIDED"
    assert "three degrees of freedom" in held.verdict({}).reason
    assert held.verdict({}, damped=True).growing == 2


@pytest.mark.parametrize(("given", "wrong"), [
    ({"rate": 0}, "rate of a circular orbit is positive"), ({"mu": 1, "radius": -1}, "radius"),
    ({"mu": 1}, "mu and radius"), ({"rate": 1, "mu": 1, "radius": 2}, "leave one of them out")])
def test_impossible_orbits(given, wrong):
    """One sentence each."""
    with pytest.raises(gs.errors.PotentialError, match=wrong):
        gs.circular_orbit(**given)


def test_a_rate_from_the_radius():
    """ω0² = mu/radius³, with units."""
    orbit = gs.circular_orbit(mu="398600 km^3/s^2", radius="7000 km")
    assert orbit.drift[0]**2 / gs.symbol("n1")**2 == Rational(398600, 7000**3)
