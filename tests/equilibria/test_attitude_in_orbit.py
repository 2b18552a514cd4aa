"""Roll, pitch, yaw and quaternion of attitudes: against rotation matrices that are written here."""
import math

import mpmath
import pytest
from flint import arb

import gyrostat as gs
from gyrostat.equilibria.attitude_in_orbit import _degrees

CLOSED = gs.Gyrostat((60, 70, 35), (0, "15/2", 0))             # tilts with square roots
RIGID = gs.Gyrostat((60, 70, 35), (0, 0, 0))


def listed(body, rate=1, potential=0):
    """All attitudes."""
    return gs.relative_equilibria(gs.assemble(body, gs.circular_orbit(rate, potential=potential)), {})


def about(axis, degrees):
    """A rotation about an axis."""
    c, s = mpmath.cos(mpmath.radians(degrees)), mpmath.sin(mpmath.radians(degrees))
    rows = mpmath.eye(3)
    i, j = [(1, 2), (2, 0), (0, 1)][axis]
    rows[i, i] = rows[j, j] = c
    rows[i, j], rows[j, i] = -s, s
    return rows


def turned(w, x, y, z):
    """The rotation of a unit quaternion."""
    return mpmath.matrix([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                          [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                          [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def exact(e):
    """The rotation with rows t, n, r, from the exact directions, to 60 digits."""
    n, r = ([mpmath.mpf(str(x.evalf(60))) for x in v] for v in e.directions)
    t = [n[1] * r[2] - n[2] * r[1], n[2] * r[0] - n[0] * r[2], n[0] * r[1] - n[1] * r[0]]
    return mpmath.matrix([t, n, r])


def far(one, other):
    """The largest difference of two matrices."""
    return max(abs(x) for x in one - other)


@pytest.mark.parametrize(("body", "potential", "count"), [(CLOSED, 0, 8), (RIGID, 0, 8), (RIGID, "7*r3", 0)],
                         ids=["closed", "rigid", "dipole"])
def test_angles_and_quaternion_are_the_doubles_next_to_those_of_the_matrix(body, potential, count):
    """By atan2 and Shepperd's formula with 60 digits; the matrix is Rz(yaw) Ry(pitch) Rx(roll).

    Under a dipole r2 = 0 or r1 = 0 at all of them, which no ball proves.
    """
    singular = 0
    with mpmath.workdps(60):
        for e in listed(body, potential=potential):
            R, found = exact(e), e.attitude
            assert far(mpmath.matrix(found.matrix), R) < 1e-16
            w, x, y, z = found.scalar_first
            assert found.scalar_last == (x, y, z, w) and far(turned(w, x, y, z), R) < 1e-15
            first = next(q for q in found.scalar_first if q)
            assert first > 0 and w == float(
                mpmath.chop(mpmath.sqrt(max(0, 1 + R[0, 0] + R[1, 1] + R[2, 2])) / 2, 1e-25))
            if found.roll is None:
                singular += 1
                assert found.yaw is None and abs(found.pitch) == 90 and abs(R[2, 0]) == 1
                sign = "−" if found.pitch > 0 else "+"
                turn = float(found.note.partition(f"only yaw {sign} roll = ")[2].partition("°")[0]
                             .replace("−", "-"))
                assert far(about(2, turn) * about(1, found.pitch), R) < 1e-3     # four digits
                continue
            assert found.note == "" and far(
                about(2, found.yaw) * about(1, found.pitch) * about(0, found.roll), R) < 1e-15
            angles = [(R[2, 1], R[2, 2]), (-R[2, 0], mpmath.hypot(R[2, 1], R[2, 2])), (R[1, 0], R[0, 0])]
            assert [found.roll, found.pitch, found.yaw] == [
                float(mpmath.degrees(mpmath.atan2(a, b))) for a, b in angles]
    assert singular == count


def test_angles_are_those_of_a_release():
    """A satellite that is let go with these angles is at rest there."""
    for e in listed(CLOSED)[::5]:
        if (found := e.attitude).roll is not None:
            angles = [f"{x!r} deg" for x in (found.roll, found.pitch, found.yaw)]
            start = gs.release(e.scene, angles)[3:]
            assert max(abs(float(a) - float(b)) for a, b in zip(start, sum(e.directions, ()))) < 1e-14


def test_the_frame_with_z_to_the_earth_has_other_signs():
    """Against x along t, y against n and z to the Earth: roll + 180°, −pitch, −yaw."""
    found = listed(gs.Gyrostat((1, "5/4", "8/5"), ("3/10", "1/5", "1/10")))[0].attitude
    assert min(abs(found.pitch), abs(found.yaw)) > 1
    turned_over = mpmath.diag([1, -1, -1]) * mpmath.matrix(found.matrix)
    angles = about(2, -found.yaw) * about(1, -found.pitch) * about(0, found.roll + 180)
    assert far(angles, turned_over) < 1e-14


def test_rates_per_orbit_and_doubling_time():
    """Frequencies over ω0, an irrational number; log 2 over the growth rate."""
    per_orbit = set()
    for e in listed(RIGID, "sqrt(2)/1000")[:6]:
        doubles, rate = e.doubles, math.sqrt(2) / 1000
        assert doubles.frequencies_per_orbit == pytest.approx(
            [x / rate for x in doubles.frequencies], rel=1e-15)
        per_orbit |= set(doubles.frequencies_per_orbit)
        assert (doubles.doubling_time is None) == (doubles.growth_rate is None)
        if doubles.growth_rate:
            assert math.exp(doubles.growth_rate * doubles.doubling_time) == pytest.approx(2, rel=1e-14)
    assert 0.5 in per_orbit


def test_an_angle_of_180_degrees_is_enclosed_although_its_sine_may_have_either_sign():
    """The enclosure reaches beyond 180°, not round to −180°."""
    angle = _degrees(arb(0, 1e-12), arb(-2))
    assert 179.99 < angle < 180.01 and angle.contains(180)
