"""Satellites, bodies in two fields and vehicles at numbers, and the names that formulas have of them.

The equations of motion with differences in 40 digits; a body turned by a small angle and the energy V of its
orientation; nothing of gyrostat.
"""
import mpmath as mp
from differences import cross, dot, rate
from reread import Texts


class Framed(Texts):
    """A scene at numbers; a state is π, then the two directions."""

    def __init__(self, table, numbers, let=()):
        super().__init__(numbers, let)
        self.table = table
        # any, where no formula has them
        self.plain = plain = Texts({"I1": mp.mpf(1), "I2": mp.mpf(1), "I3": mp.mpf(1), **numbers})
        rows = table.get("inertia", ["I1", "I2", "I3"])
        found = [plain.value(row, None) for row in rows]
        self.tensor = mp.diag(found) if not isinstance(rows[0], list) else mp.matrix(
            [list(row) for row in found])
        self.rate = plain.value(table["orbit"]["rate"], None) if "orbit" in table else None
        label = table.get("equilibrium")
        if label in ("hyperbolic", "conical"):             # the rotor that the family has
            slope = (1 if label == "hyperbolic" else 4) * (found[0] - found[2]) * self.rate
            numbers = self.numbers = plain.numbers = {**plain.numbers, "l": slope * numbers["n3"]}
        rotor = table.get("gyrostatic_momentum", ["0", "0", "0"])
        self.rotor = mp.matrix([plain.value(t, None) for t in rotor])
        self.a, self.b = ("n", "r") if "orbit" in table else table.get("directions", ("p", "gamma"))
        self.names = [f"{x}{i}" for x in ("pi", self.a, self.b) for i in (1, 2, 3)]
        self.spins = label in ("cylindrical", "hyperbolic", "conical")
        if "point" in table:
            self.start = [plain.value(t, None) for t in table["point"]]
        elif label:
            n, r = self._directions(label)
            self.start = [*(self.rate * self.tensor * mp.matrix(n)), *n, *r]
        else:
            self.start = [numbers.get(name, mp.mpf(0)) for name in self.names]

    def _directions(self, label):
        if label == "earth-pointing":
            _, pitch, yaw = self.table.get("pointing", (1, 2, 3))
            return ([mp.mpf((abs(x) == i) * (1 if x > 0 else -1)) for i in (1, 2, 3)] for x in (pitch, yaw))
        if label == "cylindrical":
            return [mp.mpf(x) for x in (0, 0, 1)], [mp.mpf(x) for x in (1, 0, 0)]
        height = self.numbers["n3"]
        across = mp.sqrt(1 - height**2)
        r = [0, 1, 0] if label == "hyperbolic" else [-height, 0, across]
        return [across, mp.mpf(0), height], [mp.mpf(x) for x in r]

    def U(self, a, b):
        """Of the directions alone."""
        if "orbit" in self.table:
            return 3 * self.rate**2 * dot(b, self.tensor * b) / 2 - self.rate * dot(a, self.rotor)
        if "vehicle" in self.table:
            weight = mp.matrix([self.plain.value(t, None) for t in self.table["vehicle"]["weight"]])
            v = self._whole() ** -1 * mp.matrix([0, 0, 0, *a])
            return dot(mp.matrix(list(v)[3:]), a) / 2 - dot(b, weight)
        return Texts({**self.numbers, **{f"{self.a}{i + 1}": x for i, x in enumerate(a)},
                      **{f"{self.b}{i + 1}": x for i, x in enumerate(b)}}).value(self.table["potential"],
                                                                                 None)

    def _whole(self):
        table = self.table["vehicle"]
        D = self.plain.value(table.get("coupling", [["0"] * 3] * 3), None)
        M = mp.diag([self.plain.value(t, None) for t in table["mass"]])
        return mp.matrix([[*(self.tensor[i, j] for j in range(3)), *(D[i, j] for j in range(3))]
                          for i in range(3)]
                         + [[*(D[j, i] for j in range(3)), *(M[i, j] for j in range(3))] for i in range(3)])

    def omega(self, x):
        """Absolute; of a vehicle the first three velocities of its momenta."""
        if "vehicle" in self.table:
            return mp.matrix(list(self._whole() ** -1 * mp.matrix(x[:6]))[:3])
        return self.tensor ** -1 * mp.matrix(x[:3])

    def field(self, x):
        """π̇ by the torques, ȧ = a × the rate in the frame."""
        pi, a, b = (mp.matrix(x[n:n + 3]) for n in (0, 3, 6))
        omega = self.omega(x)
        turning = cross(pi + self.rotor, omega)
        if "orbit" in self.table:
            turning += 3 * self.rate**2 * cross(b, self.tensor * b)
            frame = omega - self.rate * a
        elif "vehicle" in self.table:
            v = mp.matrix(list(self._whole() ** -1 * mp.matrix(x[:6]))[3:])
            weight = mp.matrix([self.plain.value(t, None) for t in self.table["vehicle"]["weight"]])
            turning, frame = turning + cross(a, v) + cross(weight, b), omega
        else:
            slopes = [[(f(i, 1) - f(i, -1)) / 2 for i in range(3)]
                      for f in (lambda i, s: self.U(_shifted(a, i, s), b),
                                lambda i, s: self.U(a, _shifted(b, i, s)))]
            turning, frame = turning + cross(a, slopes[0]) + cross(b, slopes[1]), omega
        return mp.matrix([*turning, *cross(a, frame), *cross(b, frame)])

    def jacobian(self, x):
        """By central differences, exact of degree two."""
        columns = [(self.field(_shifted(x, i, 1)) - self.field(_shifted(x, i, -1))) / 2 for i in range(9)]
        return mp.matrix([[column[i] for column in columns] for i in range(9)])

    def sextic(self, x):
        """1, c2, c1, c0: three factors λ of det(λ − J) are of the Casimirs."""
        J, power, c = self.jacobian(x), mp.eye(9), [mp.mpf(1)]
        for n in range(1, 10):
            power = J * power
            c.append(-sum(power[i, i] for i in range(9)) / n)
            power = power + c[-1] * mp.eye(9)
        return c[0:7:2]

    def stability(self):
        """1 proved stable, modulo the spin of a body of revolution, −1 unstable, 0 neither."""
        roots = mp.polyroots(self.sextic(self.start), maxsteps=400, extraprec=400)
        if any(abs(mp.im(x)) > 1e-8 or mp.re(x) > 1e-8 for x in roots):
            return -1
        return int(min(self.squares(self.spins)) > 1e-12)

    def squares(self, reduced):
        """Eigenvalues of the second derivatives of the energy of orientations; reduced, of the axis alone,
        the momentum along it fixed.
        """
        return list(mp.eigsy(self._axis() if reduced else self.stiffness(), eigvals_only=True))

    def V(self, a, b):
        """The energy at rest in the frame, the momenta eliminated."""
        if "vehicle" in self.table:
            mass = [self.plain.value(t, None) for t in self.table["vehicle"]["mass"]]
            weight = mp.matrix([self.plain.value(t, None) for t in self.table["vehicle"]["weight"]])
            return sum(x**2 / m for x, m in zip(a, mass)) / 2 - dot(b, weight)
        return self.U(a, b) - (self.rate**2 * dot(a, self.tensor * a) / 2 if "orbit" in self.table else 0)

    def stiffness(self):
        """Second derivatives of V by turns about the axes of the body; of parallel directions across them."""
        a, b = (mp.matrix(self.start[n:n + 3]) for n in (3, 6))
        K = _bent(lambda t: self.V(_turned(a, t), _turned(b, t)), 3)
        if mp.norm(cross(a, b)) > 0:
            return K
        across = [i for i in range(3) if not a[i] and not b[i]]
        return mp.matrix([[K[i, j] for j in across] for i in across])

    def _axis(self):
        A, C, w = self.tensor[0, 0], self.tensor[2, 2], self.rate
        n, r = (mp.matrix(self.start[i:i + 3]) for i in (3, 6))
        P, t = C * w * n[2] + self.rotor[2], cross(n, r)
        place = mp.matrix([t[2], n[2], r[2]])

        def W(z):
            return 3 * w**2 * (C - A) * z[2] ** 2 / 2 + A * w**2 * z[1] ** 2 / 2 - w * P * z[1]

        K = _bent(lambda s: W(_turned(place, s)), 3)
        basis = mp.svd_r(place.T, full_matrices=True)[2][1:, :]
        return basis * K * basis.T

    def base(self, name, x):
        if name in self.names:
            return x[self.names.index(name)]
        vectors = {"vector_pi": 0, f"vector_{self.a}": 3, f"vector_{self.b}": 6}
        if name in vectors:
            return mp.matrix(x[vectors[name]:vectors[name] + 3])
        if name in ("omega1", "omega2", "omega3"):
            return self.omega(x)[int(name[-1]) - 1]
        simple = {"vector_omega": lambda: self.omega(x), "vector_l": lambda: self.rotor,
                  "vector_M": lambda: mp.matrix(x[:3]) + self.rotor, "h": lambda: self._energy(x),
                  "stiffness": self._stiffness, "gyroscopic": self._gyroscopic,
                  "tensor": self._inertia,
                  "polynomial": lambda: mp.polyval([c for p in self.sextic(x) for c in (p, 0)][:-1],
                                                   self.numbers["lamda"])}
        if name in simple:
            return simple[name]()
        if name in ("c2", "c1", "c0"):
            return self.sextic(x)[3 - int(name[1])]
        return self.numbers[name]

    def _stiffness(self):
        a, b = (mp.matrix(self.start[n:n + 3]) for n in (3, 6))
        return _bent(lambda t: self.V(_turned(a, t), _turned(b, t)), 3)

    def _energy(self, x):
        pi, a, b = (mp.matrix(x[n:n + 3]) for n in (0, 3, 6))
        beta = -self.rate * a if "orbit" in self.table else mp.matrix([0, 0, 0])
        return dot(pi, self.tensor ** -1 * pi) / 2 + dot(beta, pi) + self.U(a, b)

    def _inertia(self):
        return mp.matrix([[self.jacobian_of_rate()[i, j] for j in range(3)] for i in range(3)]) ** -1

    def jacobian_of_rate(self):
        """∂ω/∂π."""
        columns = [self.omega(_shifted(self.start, i, 1)) - self.omega(self.start) for i in range(3)]
        return mp.matrix([[column[i] for column in columns] for i in range(3)])

    def _gyroscopic(self):
        """−(m − what π = −Iβ gains), from the part of the torque that is linear in θ̇."""
        I = self._inertia()
        start = mp.matrix(self.start)

        def force(rates):
            x = [*(start[:3] + I * rates), *start[3:]]
            return self.field(x)[:3] - self._carried(x)

        columns = [(force(mp.matrix(unit)) - force(-mp.matrix(unit))) / 2
                   for unit in ([1, 0, 0], [0, 1, 0], [0, 0, 1])]
        return -mp.matrix([columns[1][2], columns[2][0], columns[0][1]])

    def _carried(self, x):
        """d/dt of π = −Iβ: of a satellite ω0 Iṅ, of fixed fields 0."""
        return self.rate * self.tensor * self.field(x)[3:6] if "orbit" in self.table else mp.matrix([0, 0, 0])

    def called(self, name, arguments, x):
        if name == "dt":
            way = self.field(x)
            return rate(lambda s: arguments[0]([c + s * d for c, d in zip(x, way)]))
        return super().called(name, arguments, x)


def _shifted(v, i, s):
    return [c + s * (i == j) for j, c in enumerate(v)] if isinstance(v, list) else mp.matrix(
        [c + s * (i == j) for j, c in enumerate(v)])


def _turned(a, t):
    """a + a × t + (a × t) × t/2."""
    across = cross(a, t)
    return a + across + cross(across, t) / 2


def _bent(f, size):
    """Second derivatives at 0."""
    step = mp.mpf(10) ** -9
    unit = [mp.matrix([step * (i == j) for j in range(size)]) for i in range(size)]
    return mp.matrix([[(f(u + v) - f(u - v) - f(v - u) + f(-u - v)) / (4 * step**2) for v in unit]
                      for u in unit])
