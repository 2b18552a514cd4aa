"""A satellite under torques, for the library and for the oracle of attitudes, in any axes."""
from fractions import Fraction as F

import numpy as np

import gyrostat as gs

TURN = [[F(2, 3), F(-1, 3), F(2, 3)], [F(2, 3), F(2, 3), F(-1, 3)], [F(-1, 3), F(2, 3), F(2, 3)]]
ONE = [[F(int(i == j)) for j in range(3)] for i in range(3)]


def turned(diagonal, turn):
    """The tensor with moments along the rows of a rotation."""
    return [[sum(x * row[i] * row[j] for x, row in zip(diagonal, turn)) for j in range(3)] for i in range(3)]


def along(name, vector):
    """The text of a scalar product with a direction."""
    return " + ".join(f"({x})*{name}{i}" for i, x in enumerate(vector, 1))


def in_axes(turn, vector):
    """The components of a vector given along the rows of a rotation."""
    return [sum(x * row[i] for x, row in zip(vector, turn)) for i in range(3)]


def form(a, matrix, b):
    """The text of ½ a·M b."""
    return " + ".join(f"({x})/2*{a}{i}*{b}{j}" for i, row in enumerate(matrix, 1)
                      for j, x in enumerate(row, 1))


class Satellite:
    """The same satellite for the library and for the oracle, ω0 = 1; a wheel is an axis, J and h."""

    def __init__(self, tensor, rotor=(0, 0, 0), linear=None, forms=None, wheel=None):
        parts = [along(a, v) for a, v in (linear or {}).items()]
        parts += [form(a, m, b) for (a, b), m in (forms or {}).items()]
        rotors = () if wheel is None else (gs.Rotor(wheel[0], axial=wheel[1], momentum=wheel[2]),)
        body = gs.gyrostat_with_rotors(tensor, rotors, lumped=True) if rotors else gs.Gyrostat(tensor, rotor)
        self.scene = gs.assemble(body, gs.circular_orbit(1, potential=" + ".join(parts) or 0))
        locked, self.vector = np.array(tensor, float), np.zeros(9)
        own = locked - float(wheel[1]) * np.outer(*[np.array(wheel[0], float)] * 2) if wheel else locked
        self.matrix = np.zeros((9, 9))
        self.matrix[3:6, 3:6], self.matrix[6:, 6:] = -own, 3 * locked
        self.rotor = np.array(rotor if wheel is None else [wheel[2] * x for x in wheel[0]], float)
        self.own, self.vector[3:6] = own, -self.rotor
        for a, v in (linear or {}).items():
            self.vector["tnr".index(a) * 3:][:3] += np.array(v, float)
        for (a, b), m in (forms or {}).items():
            i, j = "tnr".index(a) * 3, "tnr".index(b) * 3
            self.matrix[i:i + 3, j:j + 3] += np.array(m, float) / 2
            self.matrix[j:j + 3, i:i + 3] += np.array(m, float).T / 2

    def found(self):
        """All of its attitudes."""
        return gs.relative_equilibria(self.scene, {})
