"""Both sides of a printed formula at the numbers shown.

Motions as functions, derivatives by differences. Imports nothing of gyrostat.
"""
import ast

import held
import mpmath as mp
import rotating
from differences import cross, dot, rate

_BINARY = {ast.Add: lambda a, b: a + b, ast.Sub: lambda a, b: a - b, ast.Mult: lambda a, b: a * b,
           ast.Div: lambda a, b: a / b}
_COMPARED = {ast.Lt: lambda a, b: a < b, ast.LtE: lambda a, b: a <= b, ast.Gt: lambda a, b: a > b,
             ast.GtE: lambda a, b: a >= b}
PLAIN = {"sqrt": mp.sqrt, "sin": mp.sin, "cos": mp.cos, "exp": mp.exp, "cosh": mp.cosh, "tanh": mp.tanh,
         "log": mp.log, "abs": abs}


def period(I1, I2, I3, M1, M2, M3):
    E2, L2 = M1**2 / I1 + M2**2 / I2 + M3**2 / I3, M1**2 + M2**2 + M3**2
    if L2 < E2 * I2:
        I1, I3 = I3, I1
    n = mp.sqrt((I3 - I2) * (L2 - E2 * I1) / (I1 * I2 * I3))
    return 4 * mp.ellipk((I2 - I1) * (E2 * I3 - L2) / ((I3 - I2) * (L2 - E2 * I1))) / abs(n)


class Texts:
    """Texts at numbers; a name of the source's own may use those before it."""

    def __init__(self, numbers, let=()):
        self.numbers, self.let = numbers, list(let)

    def value(self, text, x, depth=None):
        """What a text, or a list of texts, is at a state."""
        if isinstance(text, list):
            rows = [[self.value(e, x, depth) for e in row] if isinstance(row, list)
                    else [self.value(row, x, depth)] for row in text]
            return mp.matrix(rows)
        depth = len(self.let) if depth is None else depth
        return self._of(ast.parse(str(text).strip(), mode="eval").body, str(text).strip(), x, depth)

    def named(self, name, x, depth):
        for i in reversed(range(depth)):
            if self.let[i][0] == name:
                return self.value(self.let[i][1], x, i)
        return self.base(name, x)

    def base(self, name, x):
        return self.numbers[name]

    def called(self, name, arguments, x):
        values = [f(x) for f in arguments]
        if name in PLAIN:
            return PLAIN[name](*values)
        if name in ("sn", "cn", "dn"):
            return mp.ellipfun(name, u=values[0], m=values[1])
        if name in ("cross", "dot", "polhode_period"):
            return {"cross": cross, "dot": dot, "polhode_period": period}[name](*values)
        if name == "entry":
            return values[0][int(values[1]) - 1, int(values[2]) - 1]
        if name in ("transpose", "inverse"):
            return values[0].T if name == "transpose" else values[0] ** -1
        if name == "rank":
            return mp.mpf(sum(s > 1e-15 for s in mp.svd_r(values[0], compute_uv=False)))
        raise KeyError(name)

    def _of(self, node, text, x, depth):
        if isinstance(node, ast.Constant):
            return mp.mpf(ast.get_source_segment(text, node))
        if isinstance(node, ast.Name):
            return self.named(node.id, x, depth)
        if isinstance(node, ast.UnaryOp):
            inner = self._of(node.operand, text, x, depth)
            return -inner if isinstance(node.op, ast.USub) else inner
        if isinstance(node, ast.Call):
            return self.called(node.func.id,
                               [lambda y, part=part: self._of(part, text, y, depth) for part in node.args], x)
        if isinstance(node, ast.BoolOp):
            return all(self._of(part, text, x, depth) for part in node.values)
        if isinstance(node, ast.Compare):
            sides = [self._of(side, text, x, depth) for side in (node.left, *node.comparators)]
            return all(_COMPARED[type(op)](a, b) for op, a, b in zip(node.ops, sides, sides[1:]))
        left, right = self._of(node.left, text, x, depth), self._of(node.right, text, x, depth)
        if isinstance(node.op, ast.Pow):
            return left ** (int(right) if right == int(right) else right)
        return _BINARY[type(node.op)](left, right)


class Motion(Texts):
    """π̇ = (π + l) × ω + k × ∇U, k̇ = k × ω at numbers; a state is a list of three or six."""

    def __init__(self, table, numbers, let=()):
        super().__init__(numbers, let)
        self.table = table
        # any, where no formula has them
        plain = Texts({"I1": mp.mpf(1), "I2": mp.mpf(1), "I3": mp.mpf(1), **numbers})
        self.inertia = [plain.value(t, None) for t in table.get("inertia", ["I1", "I2", "I3"])]
        rotor = table.get("gyrostatic_momentum", ["0", "0", "0"])
        self.rotor, self.turned = mp.matrix([plain.value(t, None) for t in rotor]), set(rotor) != {"0"}
        self.label = table.get("equilibrium", "E" if "point" in table else None)
        self.potential = table.get("potential")
        self.size = 3 if self.potential in (None, "none") else 6
        self.names = [f"{c}{i}" for c in ("pi", "k") for i in (1, 2, 3)][:self.size]
        self.k3 = {"E1": mp.mpf(1), "E2": mp.mpf(-1)}.get(self.label, numbers.get("k3", mp.mpf(0)))
        self.start = (
            [plain.value(t, None) for t in table["point"]]
            if self.label == "E"
            else self._start()
            if self.label
            else [numbers.get(name, mp.mpf(0)) for name in self.names]
        )

    def _start(self):
        n = self.numbers
        if self.label.startswith("axis"):
            i = int(self.label[-1]) - 1
            return [self.inertia[i] * n[f"omega{i + 1}_0"] if j == i else mp.mpf(0) for j in range(3)]
        if self.label != "E3":
            return [mp.mpf(0), mp.mpf(0), n["pi3_0"] if "pi3_0" in n else self.inertia[2] * n["omega3_0"],
                    mp.mpf(0), mp.mpf(0), self.k3]
        k = [n.get("k1", mp.sqrt(1 - self.k3**2)), n.get("k2", mp.mpf(0)), self.k3]
        return [m * n["omega"] * x for m, x in zip(self.inertia, k)] + k

    def U(self, k):
        if self.potential == "U(k3)":
            n, r = self.numbers, k[2] - self.k3
            slope = n.get("dU", mp.mpf(0))
            if self.label == "E3":
                slope = n["omega"] * (self.rotor[2] - n["omega"] * self.k3
                                      * (self.inertia[0] - self.inertia[2]))
            return n.get("U", 0) + slope * r + n.get("d2U", 0) * r**2 / 2 + n.get("d3U", 0) * r**3 / 6
        if self.potential == "U(k1, k2, k3)":
            old = [self.numbers.get(f"k{i}", mp.mpf(0)) for i in (1, 2, 3)]
            return self.numbers.get("U", 0) + sum(self.numbers.get(f"dU_{i + 1}", 0) * (k[i] - old[i])
                                                  for i in range(3))
        return Texts({**self.numbers, "k1": k[0], "k2": k[1], "k3": k[2]}).value(self.potential, None)

    def slope(self, k, i, order=1):
        return mp.diff(lambda s: self.U([s if j == i else c for j, c in enumerate(k)]), k[i], order)

    def omega(self, x):
        return mp.matrix([p / m for p, m in zip(x[:3], self.inertia)])

    def field(self, x):
        omega = self.omega(x)
        turned = cross(mp.matrix(x[:3]) + self.rotor, omega)
        if self.size == 3:
            return turned
        k = mp.matrix(x[3:])
        return mp.matrix([*(turned + cross(k, [self.slope(k, i) for i in range(3)])), *cross(k, omega)])

    def base(self, name, x):
        pi, omega, M = mp.matrix(x[:3]), self.omega(x), mp.matrix(x[:3]) + self.rotor
        k = mp.matrix(x[3:]) if self.size == 6 else None
        if name in self.names:
            return x[self.names.index(name)]
        if name in ("omega1", "omega2", "omega3"):
            return omega[int(name[-1]) - 1]
        if name in ("dU", "d2U", "d3U"):
            return self.slope(k, 2, int(name[1]) if name[1] != "U" else 1)
        if name in ("dU_1", "dU_2", "dU_3"):
            return self.slope(k, int(name[-1]) - 1)
        if name in held.QUANTITIES:
            return held.quantities(self.table, self.numbers)[name]
        T = dot(pi, omega) / 2
        simple = {"vector_pi": lambda: pi, "vector_k": lambda: k, "vector_l": lambda: self.rotor,
                  "vector_M": lambda: M,
                  "vector_omega": lambda: omega, "T": lambda: T, "U": lambda: self.U(k),
                  "h": lambda: T + (self.U(k) if k else 0),
                  "C": lambda: dot(M, M), "C1": lambda: dot(M, k), "C2": lambda: dot(k, k),
                  "field": lambda: self.field(x),
                  "state": lambda: mp.matrix(x), "delta_pi": lambda: mp.matrix(self._delta()[:3]),
                  "delta_k": lambda: mp.matrix(self._delta()[3:]), "F": lambda: self._linear("F", x),
                  "G": lambda: self._linear("G", x),
                  "jacobian": lambda: self.jacobian(x), "B": lambda: self.tensor(x),
                  "nu1": lambda: self._multipliers(x)[0],
                  "nu2": lambda: self._multipliers(x)[1],
                  "staude_cone": lambda: rotating.cone(self, x)[0],
                  "staude_rate": lambda: rotating.cone(self, x)[1],
                  "amended_trace": lambda: rotating.form(self, x)[0],
                  "amended_determinant": lambda: rotating.form(self, x)[1]}
        if name in simple:
            return simple[name]()
        axis = int((self.label or "E")[-1].replace("E", "1"))
        kept = [0, 1, 3, 4] if self.size == 6 else [i for i in range(3) if i + 1 != axis]
        if name == "linearization":
            J = self.jacobian(x)
            return mp.matrix([[J[i, j] for j in kept] for i in kept])
        if name == "identity":
            return mp.eye(len(kept))
        if name in ("p", "q", "polynomial") and self.label:
            c = self.characteristic(x)
            return {"p": c[2], "q": c[-1], "polynomial": mp.polyval(c, self.numbers.get("lamda", 0))}[name]
        return self.numbers[name]

    def _delta(self):
        return [self.numbers.get(f"delta_{name}", mp.mpf(0)) for name in self.names]

    def _linear(self, name, x):
        return sum(self.numbers.get(f"{name}{i}", 0) * c for i, c in enumerate(x, 1))

    def jacobian(self, x):
        columns = [rate(lambda s, i=i: self.field([c + s * (i == j) for j, c in enumerate(x)]))
                   for i in range(len(x))]
        return mp.matrix([[column[i] for column in columns] for i in range(len(x))])

    def characteristic(self, x):
        """On the orbit: each Casimir gives a factor λ of det(λ − J)."""
        J = self.jacobian(x)
        c, power = [mp.mpf(1)], mp.eye(J.rows)
        for n in range(1, J.rows + 1):
            power = J * power
            c.append(-sum(power[i, i] for i in range(J.rows)) / n)
            power = power + c[-1] * mp.eye(J.rows)
        return c[:-2] if self.size == 6 else c[:-1]

    def tensor(self, x):
        """{f, g} = −M·(f_π × g_π) − k·(f_π × g_k + f_k × g_π) of the coordinates."""
        unit, zero = mp.eye(3), mp.matrix(3, 1)
        grads = [(unit[:, i], zero) for i in range(3)] + [(zero, unit[:, i]) for i in range(self.size - 3)]
        return mp.matrix([[self._bracket(a, b, x) for b in grads] for a in grads])

    def _bracket(self, a, b, x):
        M, k = mp.matrix(x[:3]) + self.rotor, mp.matrix(x[3:]) if self.size == 6 else mp.matrix(3, 1)
        return -dot(M, cross(a[0], b[0])) - dot(k, cross(a[0], b[1]) + cross(a[1], b[0]))

    def gradient(self, f, x):
        slopes = [rate(lambda s, i=i: f([c + s * (i == j) for j, c in enumerate(x)])) for i in range(len(x))]
        return mp.matrix(slopes[:3]), mp.matrix(slopes[3:] or [0, 0, 0])

    def _multipliers(self, x):
        gradients = [[*a, *b] for a, b in (self.gradient(lambda y, n=n: self.base(n, y), x)
                                           for n in ("h", "C1", "C2"))]
        found, _ = mp.qr_solve(mp.matrix(gradients[1:]).T, -mp.matrix(gradients[0]))
        return found

    def called(self, name, arguments, x):
        if name in ("dt", "variation"):
            way = self.field(x) if name == "dt" else self._delta()
            return rate(lambda s: arguments[0]([c + s * d for c, d in zip(x, way)]))
        if name == "bracket":
            first, b = arguments[0](x), self.gradient(arguments[1], x)
            if isinstance(first, mp.matrix):
                return mp.matrix([self._bracket(self.gradient(lambda y, i=i: arguments[0](y)[i], x), b, x)
                                  for i in range(first.rows)])
            return self._bracket(self.gradient(arguments[0], x), b, x)
        if name in ("gradient_pi", "gradient_k"):
            return self.gradient(arguments[0], x)[name == "gradient_k"]
        return super().called(name, arguments, x)
