"""Arrays of verdicts over directions, by stereographic coordinates: each is that of the exact report."""
import random
from fractions import Fraction

import heavy
import numpy as np
import pytest
from rotation_families import LINEAR
from slow import sampled
from sympy import Rational

import gyrostat as gs
from gyrostat.charts.codes import CODE_OF

MOMENTS, ROTOR = (3, 2, Rational(5, 2)), (Rational(1, 3), Rational(1, 5), Rational(1, 2))


@pytest.fixture(scope="module")
def report():
    scene = gs.assemble(gs.Gyrostat(MOMENTS, ROTOR), gs.general_potential(LINEAR))
    return gs.analyze(gs.permanent_rotation(scene, gs.stereographic()))


def number(rng):
    return float(Fraction(rng.randint(-24, 24), 2**rng.randint(0, 4)))


@pytest.mark.slow
@pytest.mark.parametrize(("grids", "n"), [(6, 3), pytest.param(32, 18, marks=pytest.mark.slow)])
@pytest.mark.parametrize("axes", [("u1", "u2"), ("u1", "omega")])
def test_an_array_is_what_the_report_says(report, axes, grids, n, full):
    """At every point, in fractions; and what the spectrum and the second variation say in doubles."""
    rng, seen = random.Random(f"{axes} {n}"), set()
    for _ in range(sampled(grids, full, 6)):
        numbers = {name: number(rng) for name in report.required if name not in axes}
        y, x = (np.array(sorted({number(rng) / 4 for _ in range(n)})) for _ in axes)
        found = gs.charts.verdicts(report, numbers | {axes[0]: y[:, None], axes[1]: x})
        for place, verdict in np.ndenumerate(found):
            here = numbers | {axes[0]: float(y[place[0]]), axes[1]: float(x[place[1]])}
            exact = {name: Rational(*value.as_integer_ratio()) for name, value in here.items()}
            assert verdict == CODE_OF[report.verdict(exact).verdict]
            assert by_oracle(here) in (verdict, None)
            seen.add(int(verdict))
    assert {1, -1} <= seen


def by_oracle(numbers):
    """1 or −1 where eigenvalues are far enough from 0, None where they are not or between the criteria."""
    u1, u2, omega, sigma = (numbers[name] for name in ("u1", "u2", "omega", "sigma"))
    k = np.array([2 * u1, 2 * u2, 1 - u1**2 - u2**2]) / (1 + u1**2 + u2**2)
    inertia, rotor = np.diag([float(x) for x in MOMENTS]), np.array([float(x) for x in ROTOR])
    c = omega**2 * inertia @ k + omega * rotor + sigma * k
    body = inertia, rotor, c, np.zeros((3, 3)), omega, k
    least, growth = heavy.squares(*body)[0], heavy.growth(*body)
    size = 1 + omega**2 + abs(sigma)
    if least > 1e-6 * size:
        return 1
    return -1 if growth > 1e-3 * size else None


@pytest.mark.slow
def test_on_a_boundary_the_sign_is_exact(report):
    """Where s = 0 along a line through doubles, and beside it: the array is the report."""
    (_, s), names = report.written_out.sufficient.alternatives[0], ("omega", "u1", "u2")
    place = dict(zip(names, (Rational(1), Rational(1, 2), Rational(1, 4))))
    in_sigma = s.margin.xreplace({gs.symbol(name): x for name, x in place.items()})
    coefficients = [float(c) for c in in_sigma.as_poly(gs.symbol("sigma")).all_coeffs()]
    roots = [z.real for z in np.roots(coefficients) if abs(z.imag) < 1e-9]
    assert roots
    for root in roots:
        sigma = root + np.arange(-4, 5) * np.spacing(root)
        found = gs.charts.verdicts(report, {n: float(x) for n, x in place.items()}, sigma=sigma)
        exact = [CODE_OF[report.verdict(place | {"sigma": Rational(*x.as_integer_ratio())}).verdict]
                 for x in sigma.tolist()]
        assert found.tolist() == exact


@pytest.mark.slow
@pytest.mark.parametrize("backend", ["numpy", "numba"])
@pytest.mark.parametrize("damped", [False, True])
@pytest.mark.parametrize("n", [6, pytest.param(13, marks=pytest.mark.slow)])
def test_small_matrices_decide_like_margins_that_are_written_out(report, tiny_blocks, backend, damped, n):
    """The same bits by both, on one thread and on two; the conditions of this scene are written in names."""
    assert report.closed is not None and report.written_out.closed is None
    u = np.linspace(-1.5, 1.5, n)
    given = {"omega": -1.0, "sigma": np.array([-3.0, -1.0, 0.5])[:, None, None], "u1": u[:, None], "u2": u}
    first, *others = (gs.charts.verdicts(which, given, backend=backend, damped=damped, threads=threads)
                      for which in (report, report.written_out) for threads in (1, 2))
    assert {1, -1} <= set(np.unique(first))
    assert all((first == other).all() for other in others)
