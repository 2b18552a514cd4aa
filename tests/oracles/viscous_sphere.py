"""The growing modes of a body with a viscous sphere inside, about a rotation of both as one rigid body.

Uses nothing of gyrostat. The sphere has the inertia J in every direction, and the torque c s on it is
proportional to its rate s relative to the body; the moments I hold it. M = I ω + l + J s,

    Ṁ = M × ω + k × ∇U,   k̇ = k × ω,   J (ω + s)˙ = J (ω + s) × ω − c s.
"""
import mpmath as mp

DIGITS = 50


def growing_modes(moments, rotor, pi, k=None, slope=None, curvature=None, damping=1):
    """The number of eigenvalues with a positive real part; slope and curvature of U at k."""
    with mp.workdps(DIGITS):
        moments, J = [mp.mpf(m) for m in moments], mp.mpf(min(moments)) / 7
        turn = mp.diag([1 / m for m in moments])           # ω = turn (M − l − J s)
        omega, M = turn * mp.matrix(pi), mp.matrix(pi) + mp.matrix(rotor)
        blocks = [[-hat(omega) + hat(M) * turn, -hat(M) * turn * J]]
        if k is not None:
            k = mp.matrix(k)
            blocks[0].append(-hat(mp.matrix(slope)) + hat(k) * mp.matrix(curvature))
        free = (mp.eye(3) - J * turn) ** -1
        own = [mp.zeros(3), -mp.mpf(damping) / J * mp.eye(3) - hat(omega), mp.zeros(3)]
        blocks.append([free * (rate - turn * torque) for rate, torque in zip(own, blocks[0])])
        if k is not None:
            blocks.append([hat(k) * turn, -hat(k) * turn * J, -hat(omega)])
        matrix = mp.matrix(3 * len(blocks))
        for i, row in enumerate(blocks):
            for j, block in enumerate(row):
                matrix[3 * i:3 * i + 3, 3 * j:3 * j + 3] = block
        values = mp.eig(matrix, left=False, right=False)
        scale = max(map(abs, values))
        return sum(mp.re(x) > scale * mp.mpf(10) ** -14 for x in values)


def hat(v):
    """The matrix of v ×."""
    return mp.matrix([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])
