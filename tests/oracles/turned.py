"""A body turned through three angles, at numbers.

The rates of what moves by differences. Imports nothing of gyrostat.
"""
import mpmath as mp
from differences import dot, rate
from reread import Texts


class Turning(Texts):
    """Three turns at angles φ(t), θ(t), ψ(t); a state is the time."""

    start = mp.mpf(0)

    def __init__(self, table, numbers, let=()):
        super().__init__(numbers, let)
        self.table, self.free = table, table.get("vertical")
        self.inertia = [Texts(numbers).value(t, None) for t in table.get("inertia", ["I1", "I2", "I3"])]
        now = [numbers[a] for a in ("phi", "theta", "psi")]
        self.rates = (
            list(self._free_rates(now))
            if self.free
            else [numbers.get(f"{a}_dot", mp.mpf(0)) for a in ("phi", "theta", "psi")]
        )
        self.now = now

    def angles(self, t):
        bends = [0 if self.free else self.numbers.get(f"{a}_ddot", mp.mpf(0))
                 for a in ("phi", "theta", "psi")]
        return [a + r * t + b * t**2 / 2 for a, r, b in zip(self.now, self.rates, bends)]

    def _turns(self, angles):
        found = []
        for axis, angle in zip(self.table["angles"], angles):
            i, j = ("xyz".index(axis) + 1) % 3, ("xyz".index(axis) + 2) % 3
            R = mp.eye(3)
            R[i, i], R[i, j], R[j, i], R[j, j] = mp.cos(angle), -mp.sin(angle), mp.sin(angle), mp.cos(angle)
            found.append(R)
        return found

    def R(self, angles):
        a, b, c = self._turns(angles)
        return a * b * c

    def _nodes(self, angles):
        return self._turns(angles)[2].T * mp.eye(3)[:, "xyz".index(self.table["angles"][1])]

    def _free_rates(self, angles):
        k, line = self.R(angles)[2, :].T, self._nodes(angles)
        omega = [self.numbers[self.free] * x / m for x, m in zip(k, self.inertia)]
        axes = mp.matrix([[k[i], line[i], mp.mpf(i == 2)] for i in range(3)])
        return mp.lu_solve(axes, mp.matrix(omega))

    def omega(self, t):
        R = self.R(self.angles(t))
        if self.free:
            return mp.matrix([self.numbers[self.free] * x / m for x, m in zip(R[2, :], self.inertia)])
        W = R.T * rate(lambda s: self.R(self.angles(s)), t)
        return mp.matrix([W[2, 1], W[0, 2], W[1, 0]])

    def pi(self, t):
        return mp.matrix([m * w for m, w in zip(self.inertia, self.omega(t))])

    def tensor(self):
        return mp.matrix([[self.numbers.get(f"J{min(i, j)}{max(i, j)}", 0) for j in (1, 2, 3)]
                          for i in (1, 2, 3)])

    def torque(self, momentum, t):
        return self.R(self.angles(t)).T * rate(lambda s: self.R(self.angles(s)) * momentum(s), t)

    def base(self, name, t):
        angles, n = self.angles(t), self.numbers
        if name in ("phi", "theta", "psi"):
            return angles[("phi", "theta", "psi").index(name)]
        if name in ("phi_dot", "theta_dot", "psi_dot"):
            i = ("phi_dot", "theta_dot", "psi_dot").index(name)
            return self._free_rates(angles)[i] if self.free else rate(lambda s: self.angles(s)[i], t)
        if name in ("vector_r", "vector_m"):
            return mp.matrix([n.get(f"{name[-1]}{i}", 0) for i in (1, 2, 3)])
        vectors = {"omega": self.omega, "pi": self.pi, "tau": lambda s: self.torque(self.pi, s),
                   "k": lambda s: self.R(self.angles(s))[2, :].T}
        if name[:-1] in vectors and name[-1] in "123":
            return vectors[name[:-1]](t)[int(name[-1]) - 1]
        if name in ("vector_omega", "vector_pi", "vector_k"):
            return vectors[name[7:]](t)
        unit, T = mp.eye(3), lambda: dot(self.omega(t), self.pi(t)) / 2
        simple = {"R": lambda: self.R(angles),
                  "vector_A": lambda: mp.matrix([n.get(f"A{i}", 0) + n.get(f"A{i}_dot", 0) * t
                                                 for i in (1, 2, 3)]),
                  "tensor": self.tensor, "torque": lambda: self.torque(self.pi, t), "T": T,
                  "axis_nodes": lambda: self._nodes(angles),
                  "tensor_torque": lambda: self.torque(lambda s: self.tensor() * self.omega(s), t),
                  "vector_z": lambda: unit[:, 2],
                  "axis_1": lambda: unit[:, 0], "axis_2": lambda: unit[:, 1], "axis_3": lambda: unit[:, 2],
                  "axis_vertical": lambda: self.R(angles)[2, :].T, "lagrangian": lambda: T() - Texts(
                      {**n, "k3": self.R(angles)[2, 2]}).value(self.table.get("potential", "0"), None)}
        return simple[name]() if name in simple else n[name]

    def called(self, name, arguments, t):
        return rate(arguments[0], t) if name == "dt" else super().called(name, arguments, t)
