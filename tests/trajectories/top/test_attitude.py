"""The attitude: against Taylor series, as a rotation, and as it turns."""
import mpmath
import numpy as np
import pytest
from slow import slow
from sympy import lambdify
from trajectories.tops import BODY, CASES, MOTIONS, SEPARATRICES, F, as_mpf, moving, plain, theirs

from gyrostat.mechanics.classical.attitude import ANGLES, rotation


@pytest.mark.few(1)
@pytest.mark.parametrize("name", [
    "degree 1", "exp", "from the lower pole", "over the top", "sleeping top",
    *slow(("at the upper turning point",), ("from the upper pole",), ("through the upper pole",),
          ("k of length 5",), ("near the lower pole",))])
def test_attitude_is_that_of_the_oracle(name):
    """R by Taylor series, from the Euler angles φ = 0, θ, ψ of k at the time 0; at a pole ψ = 0 as well."""
    if name in MOTIONS:
        inertia, l, U, state, t, _ = MOTIONS[name]
    else:
        (inertia, l, t), (U, state, _) = (BODY, "2/5", "3/2"), SEPARATRICES[name]
    found = moving(inertia, l, U, state)
    with mpmath.workdps(40):
        k = [as_mpf(F(x)) for x in state[3:]]
        r, across = mpmath.sqrt(sum(x * x for x in k)), mpmath.hypot(k[0], k[1])
        (sine, cosine), (s, c) = ((k[0] / across, k[1] / across) if across
                                  else (0, 1)), (across / r, k[2] / r)
        start = [[cosine, -sine, 0], [c * sine, c * cosine, -s], [s * sine, s * cosine, c]]
        _, R = theirs(inertia, l, U, state, t, 15, start)
    np.testing.assert_allclose(found.attitude(0.0), plain(start), rtol=0, atol=2e-15)
    np.testing.assert_allclose(found.attitude(float(F(t))), plain(R), rtol=0, atol=1e-14)


@pytest.mark.few(9)
@pytest.mark.parametrize("name", CASES)
def test_attitude_is_a_rotation_with_k_below(name):
    """Rᵀ R = 1, det R = 1, the third row is k/abs(k), the angles are those of R.

    At the time 0 the angle φ is 0.
    """
    inertia, l, U, state, _, _ = MOTIONS[name]
    found = moving(inertia, l, U, state)
    t = np.array([[0.0, -0.9], [3.7, 1e7]])
    R, k = found.attitude(t), found(t)[..., 3:]
    assert R.shape == (2, 2, 3, 3)
    np.testing.assert_allclose(R @ np.swapaxes(R, -1, -2), np.broadcast_to(np.eye(3), R.shape), rtol=0,
                               atol=3e-15)
    np.testing.assert_allclose(np.linalg.det(R), 1, atol=4e-15)
    np.testing.assert_allclose(R[..., 2, :], k / np.linalg.norm(k, axis=-1, keepdims=True), rtol=0,
                               atol=1e-14)
    angles = found.angles(t)
    again = lambdify(ANGLES, rotation("zxz"))
    for place in np.ndindex(t.shape):
        np.testing.assert_allclose(again(*angles[place]), R[place], rtol=0, atol=2e-15)
    assert abs(R[0, 0, 0, 2]) < 1e-15 and R[0, 0, 1, 2] <= 1e-15


@pytest.mark.parametrize("name", ["degree 1", "exp", "over the top", "from the lower pole",
                                  "nearly equal moments"])
def test_attitude_turns_with_omega(name):
    """Ṙ = R hat(ω), ω = (π1/I1, π2/I1, π3/I3): differences of fourth order."""
    inertia, l, U, state, _, _ = MOTIONS[name]
    found, h, t = moving(inertia, l, U, state), 2.0**-9, np.array([0.0, 0.4, 2.3])
    rates = sum(w * found.attitude(t + n * h) for n, w in ((1, 8), (-1, -8), (2, -1), (-2, 1))) / (12 * h)
    omega = found(t)[:, :3] / [float(F(inertia[0])), float(F(inertia[0])), float(F(inertia[1]))]
    hats = np.swapaxes(found.attitude(t), 1, 2) @ rates
    # h⁴ times a fifth derivative
    np.testing.assert_allclose(hats[:, [2, 0, 1], [1, 2, 0]], omega, atol=1e-8)
