"""Scenes in other units: each question of each kind of scene, with its numbers as they are in units of any
size, and what of the answer does not depend on them.
"""
from fractions import Fraction

INERTIA, MOMENTUM, TORQUE, RATE = (1, 2, 0), (1, 2, -1), (1, 2, -2), (0, 0, -1)
DIMENSIONS = {"I": INERTIA, "l": MOMENTUM, "pi": MOMENTUM, "m0": TORQUE, "omega": RATE, "M": MOMENTUM,
              "C": MOMENTUM, "p": MOMENTUM, "k": (0, 0, 0), "u": (0, 0, 0), "n": (0, 0, 0), "a": TORQUE,
              "b": TORQUE, "c": TORQUE, "h": TORQUE, "mass": (1, 0, 0), "v": (0, 1, -1), "w": (1, 1, -2),
              "impulse": (1, 1, -1)}


class Units:
    """Powers of ten of the units of mass, length and time."""

    def __init__(self, mass=0, length=0, time=0):
        self.powers = mass, length, time

    def __call__(self, value, kind):
        """A number of a dimension in these units, exact."""
        dimension = DIMENSIONS[kind] if isinstance(kind, str) else kind
        power = -sum(a * b for a, b in zip(self.powers, dimension))
        return Fraction(value) * Fraction(10)**power

    def values(self, **given):
        """Numbers by the names of the table of notation."""
        return {name: self(value, kind_of(name)) for name, value in given.items()}


def kind_of(name):
    """What a name is a number of."""
    return next(kind for kind in (name, name.rstrip("0123456789"), name.split("_")[0].rstrip("0123456789"),
                                  name[0]) if kind in DIMENSIONS)
