"""Boundary points, moved, against the integrated six-dimensional motion."""
import numpy as np
import oracle
import pytest
from flint import fmpq
from scipy.integrate import solve_ivp
from stability.moved_points import KINDS, NAMED, cases, excursion, names, plain, roots, turning_points, vector

INTEGRATED = [kind for kind in KINDS if kind[2] == 1] + [("inclined", "STABLE", 2)]


def test_written_out_field_is_the_field():
    """The Euler-Poisson field in numbers is the one with np.cross, exactly.

    It vanishes at the boundary points.
    """
    for kind in KINDS:
        case = cases(*kind)[0]
        slope = [i * a for i, a in enumerate(case.potential)][1:]
        x = case.moved(fmpq(1, 3))
        field = oracle.field(x, vector([case.I1, case.I1, case.I3]), vector([0, 0, case.l]),
                             lambda k: vector([0, 0, oracle.polynomial(slope, k[2])]))    # noqa: B023
        assert list(field) == oracle.axial_field(x, case.I1, case.I3, case.l, slope)
        assert not any(oracle.axial_field(case.state, case.I1, case.I3, case.l, slope))
        assert x[3:].dot(x[3:]) == 1


@pytest.mark.slow
@pytest.mark.parametrize("kind", INTEGRATED, ids=names)
def test_integrated_motion_turns_where_g_says(kind):
    """Over a period of k3 the 6-dimensional motion from a point moved by ε = 10⁻² turns at the roots of g.

    Three cases of each kind.
    """
    for case in cases(*kind)[::6]:
        far, step = excursion(case, NAMED[0])
        x = case.moved(step)
        g, (low, high) = case.reduced(x), map(float, turning_points(case, x))
        others = sorted(map(complex, roots(g)[1]),
                        key=lambda r: min(abs(r - low), abs(r - high)))[2:]       # noqa: B023
        theta = (np.arange(4000) + 0.5) * np.pi / 4000
        y = (low + high) / 2 - (high - low) / 2 * np.cos(theta)
        lead = next(c for c in reversed(g) if c)
        # g = (y − low)(high − y) q
        q = -plain(lead) * np.prod([y - r for r in others], axis=0).real
        period = 2 * plain(case.I1) * np.pi * np.mean(1 / np.sqrt(q))
        slope = [plain(i * a) for i, a in enumerate(case.potential)][1:]
        I1, I3, l = map(plain, (case.I1, case.I3, case.l))
        motion = solve_ivp(lambda t, x: oracle.axial_field(x, I1, I3, l, slope),  # noqa: B023
                           (0, 1.01 * period), list(map(plain, x)), method="DOP853", rtol=1e-11, atol=1e-13,
                           events=lambda t, x: x[3] * x[1] - x[4] * x[0])
        extremes = case.sigma * (motion.y_events[0][:, 5] - plain(case.state[5]))
        # invariants are kept to 10⁻¹⁰; a turning point is as sensitive to e as 1/ε² = 10⁴ times: 10⁻⁶
        assert abs(min(extremes) - low) < 1e-6 * far and abs(max(extremes) - high) < 1e-6 * far
        assert max(abs(motion.y[5] - plain(case.state[5]))) < (1 + 1e-6) * far
        end = vector(fmpq(*a.as_integer_ratio()) for a in motion.y[:, -1])
        for before, after in zip((*case.integrals(x), fmpq(1)), (*case.integrals(end), end[3:].dot(end[3:]))):
            assert abs(plain(after - before)) < 1e-10
