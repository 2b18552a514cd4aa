"""Families of equilibria that gyroscopic forces may hold, in names."""
from sympy import Rational

import gyrostat as gs

I1, I2, I3, l, m0, a = map(gs.symbol, ("I1", "I2", "I3", "l", "m0", "a"))


def scene(inertia, rotor, U):
    return gs.assemble(gs.Gyrostat(inertia, rotor), gs.general_potential(U))


def off_symmetry():
    """A permanent rotation off every principal plane, of any strength of a cubic field."""
    k = (Rational(2, 3), Rational(1, 3), Rational(2, 3))

    def U(k1, k2, k3):
        away = 2 * k1 - k2 - k3 * Rational(3, 2)
        return 2 * (k2 + k3) / 3 + a * away**2 + a**2 * away**3

    return gs.equilibrium(scene((3, 5, 4), (0, 0, 0), U), (-2, Rational(-5, 3), Rational(-8, 3), *k))


FAMILIES = {
    "E1": lambda: gs.upright(scene((I1, I2, I3), (0, 0, 0), lambda k1, k2, k3: m0 * k3)),
    "E1 with a rotor": lambda: gs.upright(scene((I1, I2, I3), (0, 0, l), lambda k1, k2, k3: m0 * k3)),
    "E2, quadratic": lambda: gs.hanging(scene((I1, I2, I3), (0, 0, l),
                                              lambda k1, k2, k3: m0 * k3 + a * k1**2 - a * k3**2 / 2)),
    "off symmetry": off_symmetry,
    "with a rotor, in any uniform field": lambda: gs.permanent_rotation(
        scene((3, 5, 4), (l, 0, 1), lambda k1, k2, k3: sum(
            gs.symbol(f"m{n}") * k for n, k in enumerate((k1, k2, k3)))), ("2/3", "1/3", "2/3")),
}
