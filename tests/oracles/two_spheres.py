"""The growing modes of a dual spinner with a viscous sphere in each of its bodies, linearised about its axis.

Uses nothing of gyrostat. The rotor, a body of revolution, turns about axis 3 at the rate spin relative to the
platform, whose axes are used; each sphere has the inertia J in every direction, and the torque c s on it is
proportional to its rate s relative to the body that it is in. The moments I of the whole hold the spheres.
M = I ω + l e3 + J_p s_p + J_r s_r,

    Ṁ = M × ω,   J_p (ω + s_p)˙ = J_p (ω + s_p) × ω − c_p s_p,
    J_r (ω + s_r)˙ = J_r (ω + spin e3 + s_r) × ω − c_r s_r.
"""
import mpmath as mp
from viscous_sphere import DIGITS, hat


def growing_modes(moments, momentum, rate, spin, platform, rotor):
    """The number of eigenvalues with a positive real part; of each sphere J and c, momentum is l."""
    with mp.workdps(DIGITS):
        rate, spin, momentum, *moments = (mp.mpf(x.numerator) / x.denominator
                                          for x in (rate, spin, momentum, *moments))
        turn = mp.diag([1 / m for m in moments])
        axis = mp.matrix([0, 0, 1])
        spheres = [(*(mp.mpf(x.numerator) / x.denominator for x in sphere), own)
                   for sphere, own in ((platform, 0), (rotor, spin))]
        # of M, s_p, s_r: δω = turn (δM − Σ J s)
        omega = [turn, *(-J * turn for J, _, _ in spheres)]
        M = (mp.mpf(moments[2]) * rate + momentum) * axis
        rows = [[hat(M) * x for x in omega]]
        rows[0][0] -= rate * hat(axis)
        relative = []
        for n, (J, c, own) in enumerate(spheres, 1):
            # (δω + s)˙ = (δω + s) × ω + (ω + own) × δω − (c/J) s
            row = [-rate * hat(axis) * x + (rate + own) * hat(axis) * x for x in omega]
            row[n] -= rate * hat(axis) + c / J * mp.eye(3)
            relative.append(row)
        # s˙ = row − δω˙ with δω˙ = turn (Ṁ − Σ J s˙)
        (Jp, _, _), (Jr, _, _) = spheres
        coupled = mp.matrix(6)
        for i in range(2):
            for j, J in enumerate((Jp, Jr)):
                for a in range(3):
                    coupled[3 * i + a, 3 * j + a] = (i == j) - J * turn[a, a]
        right = mp.matrix(6, 9)
        for i, row in enumerate(relative):
            for j in range(3):
                block = row[j] - turn * rows[0][j]
                right[3 * i:3 * i + 3, 3 * j:3 * j + 3] = block
        rates = coupled**-1 * right
        matrix = mp.matrix(9)
        for j in range(3):
            matrix[:3, 3 * j:3 * j + 3] = rows[0][j]
        matrix[3:, :] = rates
        values = mp.eig(matrix, left=False, right=False)
        scale = max(map(abs, values))
        return sum(mp.re(x) > scale * mp.mpf(10) ** -30 for x in values)
