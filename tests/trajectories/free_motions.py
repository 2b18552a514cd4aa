"""Free motions, and how far numbers of any kind are apart."""
from fractions import Fraction

import numpy as np

import gyrostat as gs
from gyrostat.trajectories.free.free_motion import FreeMotion

REST = (0, 0, 0)
# (1, 2, 3) rests at the same |M| and energy
SADDLE = (Fraction(1, 5), 1, Fraction(1, 6)), (Fraction(1, 5), -6, 1), (-3, -2, -1)


def free(inertia, M, rotor=REST):
    """The motion from M on."""
    return FreeMotion(gs.assemble(gs.Gyrostat(inertia, rotor)), [m - l for m, l in zip(M, rotor)])


def distance(x, y):
    """Largest difference of arrays of numbers of any kind."""
    return np.abs(np.asarray(x, dtype=float) - np.array([float(v) for v in y])).max()


def middles(x):
    return [float(v.mid()) for v in x]
