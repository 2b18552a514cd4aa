"""What confirms a counterexample: Newton and Euler's equations at rational numbers, by cross products and matrices.

Nothing here uses the bracket, the linearisation or the criteria of the library, nor any published formula.
"""
from collections.abc import Callable, Mapping
from typing import Any

import mpmath
from sympy import Expr, Float, Integer, Matrix, MatrixBase, Poly, Rational, Symbol, cos, diag, hessian, linsolve, sign, sin, sqrt

from ..errors import PublishedError
from ..notation import jet, symbol
from .scenes import Scene

Values = Mapping[Symbol, Expr]
PI, K = (Matrix([symbol(f"{x}{i}") for i in (1, 2, 3)]) for x in ("pi", "k"))
DIGITS = 50


class Model:
    """A scene at numbers: the field ẋ = f(x), and the point of the equilibrium if there is one."""

    def __init__(self, scene: Scene, values: Values):
        self.values = dict(values)
        self.inertia = [moment.subs(self.values) for moment in scene.body.inertia]
        self.rotor = Matrix([part.subs(self.values) for part in scene.body.gyrostatic_momentum])
        self.label = scene.table.get("equilibrium")
        self.coordinates = [*PI, *K] if scene.potential else [*PI]
        self.k3 = {"E1": Integer(1), "E2": Integer(-1)}.get(str(self.label), self.values.get(K[2], Integer(0)))
        self.U = self._potential(scene) if scene.potential else Integer(0)
        self.point = self._point() if self.label else [x.subs(self.values) for x in self.coordinates]
        if self.label and any(abs(x.evalf(30)) > 1e-20 for x in self.field.subs(dict(zip(self.coordinates, self.point)))):
            raise PublishedError(f"{self.label} is no equilibrium of Newton and Euler's equations at {self.values}")

    def _potential(self, scene: Scene) -> Expr:
        """U as a polynomial with the derivatives given, or the expression at its numbers."""
        potential = scene.potential
        assert potential is not None
        if potential.given:
            return potential.expression.subs({s: v for s, v in self.values.items() if s not in potential.variables})
        if not potential.axial:
            linear = sum((self.values.get(symbol(f"dU_{i}"), Integer(0)) * K[i - 1] for i in (1, 2, 3)), Integer(0))
            return linear - linear.subs(self.values) + self.values.get(symbol("U"), 0)
        slope = self.values.get(symbol("dU"))
        if self.label == "E3":                             # what balances the torques at the point
            omega, l = self.values[symbol("omega")], self.rotor[2]
            slope = omega * (l + self.inertia[2] * omega * self.k3) - omega**2 * self.inertia[0] * self.k3
        jets = [slope, *(self.values.get(symbol(f"d{n}U"), Integer(0)) for n in (2, 3))]
        rise, constant = K[2] - self.k3, self.values.get(symbol("U"), Integer(0))
        return sum((d * rise**n / (1, 2, 6)[n - 1] for n, d in enumerate(jets, 1) if d is not None), constant)

    def _point(self) -> list[Expr]:
        if self.label in ("E1", "E2"):
            spin = self.values.get(symbol("pi3_0"), self.inertia[2] * self.values.get(symbol("omega3_0"), Integer(0)))
            return [Integer(0), Integer(0), spin, Integer(0), Integer(0), self.k3]
        if self.label == "E3":
            k = [self.values.get(K[0], sqrt(1 - self.k3**2)), self.values.get(K[1], Integer(0)), self.k3]
            return [*(moment * self.values[symbol("omega")] * x for moment, x in zip(self.inertia, k)), *k]
        axis = int(str(self.label)[-1])
        return [self.inertia[axis - 1] * self.values[symbol(f"omega{i}_0")] if i == axis else Integer(0) for i in (1, 2, 3)]

    @property
    def omega(self) -> Matrix:
        """Angular velocity."""
        return Matrix([p / moment for p, moment in zip(PI, self.inertia)])

    @property
    def field(self) -> Matrix:
        """π̇ = (π + l) × ω + k × ∇U, k̇ = k × ω."""
        torque = K.cross(Matrix([self.U.diff(x) for x in K])) if self.U else Matrix([0, 0, 0])
        turning = (PI + self.rotor).cross(self.omega) + torque
        return Matrix([*turning, *K.cross(self.omega)]) if len(self.coordinates) == 6 else turning

    def jacobian(self) -> Matrix:
        """∂f/∂x at the point."""
        return self.field.jacobian(self.coordinates).subs(dict(zip(self.coordinates, self.point)))

    def growth(self) -> mpmath.mpf:
        """Largest real part of an eigenvalue, to 50 digits."""
        with mpmath.workdps(2 * DIGITS):
            J = self.jacobian()
            values, _ = mpmath.eig(mpmath.matrix([[mpmath.mpf(int(x.p)) / int(x.q) for x in J.row(i)] for i in range(J.rows)]))
            return max(mpmath.re(v) for v in values)

    def polynomial(self) -> Expr:
        """Characteristic polynomial on the orbit: each Casimir gives a factor λ of that of the whole field."""
        lamda = symbol("lamda")
        casimirs = 2 if len(self.coordinates) == 6 else 1
        return Poly(self.jacobian().charpoly().all_coeffs()[:-casimirs], lamda).as_expr()

    def level_set(self) -> int:
        """1 if the level set of all integrals near the point is only its orbit under the spin, -1 if motions leave along it, else 0.

        1 proves Lyapunov stability, -1 instability, both modulo the spin. For a body of revolution I1² k̇3² = g(k3), where g has a
        multiple root at the equilibrium: its leading coefficient there decides; a pole is approached from inside. On so(3)* the energy
        has a strict extremum on the sphere, or none.
        """
        if len(self.coordinates) == 3:
            axis = int(str(self.label)[-1])
            slope = self.omega[axis - 1].subs(PI[axis - 1], self.point[axis - 1]) / (self.point[axis - 1] + self.rotor[axis - 1])
            excess = [1 / moment - slope for i, moment in enumerate(self.inertia, 1) if i != axis]
            return int(sign(excess[0] * excess[1]))
        at = dict(zip(self.coordinates, self.point))
        z, x, M = symbol("z"), symbol("x"), PI + self.rotor
        energy = (sum(p**2 / moment for p, moment in zip(PI[:2], self.inertia)) / 2 + self.U).subs(at)
        momentum, total = M.dot(K).subs(at), M[2].subs(at)
        g = 2 * self.inertia[0] * (energy - self.U.subs(K[2], z)) * (1 - z**2) - (momentum - total * z) ** 2
        pole = self.label in ("E1", "E2")
        shifted = Poly(g.subs(z, self.k3 * (1 - x) if pole else self.k3 + x).expand(), x)
        if shifted.is_zero:
            return 0
        (power,), coefficient = shifted.terms()[-1]
        return -1 if coefficient > 0 or not pole and power % 2 else 1

    def inertia_of_second_variation(self) -> tuple[int, int, int]:
        """Numbers of positive, zero and negative squares of D²(h + ν·C) on ker dC1 ∩ ker dC2."""
        at = dict(zip(self.coordinates, self.point))
        h = sum(p**2 / moment for p, moment in zip(PI, self.inertia)) / 2 + self.U
        C = [(PI + self.rotor).dot(K), K.dot(K)]
        gradients = Matrix([[f.diff(x) for x in self.coordinates] for f in (h, *C)]).subs(at)
        a, b = symbol("a"), symbol("b")
        ((nu1, nu2),) = linsolve(list(gradients.row(0) + a * gradients.row(1) + b * gradients.row(2)), [a, b])
        form = hessian(h + nu1 * C[0] + nu2 * C[1], self.coordinates).subs(at)
        kernel = Matrix.hstack(*gradients[1:, :].nullspace())
        roots = Poly((kernel.T * form * kernel).charpoly().all_coeffs(), symbol("lamda"))
        zero = min(monomial[0] for monomial in roots.monoms())
        positive = roots.count_roots(0, None) - (1 if zero else 0)
        return positive, zero, roots.degree() - zero - positive


def names(scene: Scene, values: Values) -> dict[str, Any]:
    """The names of a scene at numbers; functions of the motion differentiate along the field of Newton and Euler."""
    return _turning(scene, values) if "angles" in scene.table else _moving(Model(scene, values))


def _functions() -> dict[str, Callable[..., Any]]:
    return {"cross": lambda a, b: a.cross(b), "dot": lambda a, b: (a.T * b)[0, 0], "transpose": lambda a: a.T,
            "inverse": lambda a: a.adjugate() / a.det(), "rank": lambda a: Integer(a.rank()), "diff": lambda f, x: f.diff(x),
            "entry": lambda a, i, j: a[i - 1, j - 1], "polhode_period": lambda *x: _period(x[:3], x[3:]),
            **{name: (lambda u, m, i=i: _jacobi(u, m)[i]) for i, name in enumerate(("sn", "cn", "dn"))}}


def _moving(model: Model) -> dict[str, Any]:
    x, field = model.coordinates, model.field
    h = sum(p**2 / moment for p, moment in zip(PI, model.inertia)) / 2 + model.U
    named: dict[str, Any] = {str(s): v for s, v in model.values.items() if s not in x and not jet(s.name)}
    named |= {str(s): s for s in x}
    M = PI + model.rotor
    named |= {f"omega{i}": model.omega[i - 1] for i in (1, 2, 3)}
    named |= {"vector_pi": PI, "vector_k": K, "vector_l": model.rotor, "vector_M": M, "vector_omega": model.omega, "h": h, "U": model.U,
              "T": h - model.U, "C": M.dot(M), "C1": M.dot(K), "C2": K.dot(K), "field": field, "state": Matrix(x)}
    if model.U:
        slope = model.U.diff(K[2])
        named |= {"dU": slope, "d2U": slope.diff(K[2]), "d3U": slope.diff(K[2], 2)}
        named |= {f"dU_{i}": model.U.diff(K[i - 1]) for i in (1, 2, 3)}
    if model.label:
        place = dict(zip(x, model.point))
        named = {name: v.subs(place) if isinstance(v, (Expr, MatrixBase)) else v for name, v in named.items()}
        J, polynomial, lamda = model.jacobian(), model.polynomial(), symbol("lamda")
        four = [0, 1, 3, 4] if len(x) == 6 else [i for i in range(3) if i + 1 != int(str(model.label)[-1])]
        named |= {"jacobian": J, "linearization": J.extract(four, four), "identity": diag(*[1] * len(four)),
                  "polynomial": polynomial.subs(model.values), "lamda": model.values.get(lamda, lamda), "q": polynomial.coeff(lamda, 0)}
        return named | ({"p": polynomial.coeff(lamda, 2)} if len(x) == 6 else {}) | _functions()

    def along(direction: Matrix) -> Callable[[Any], Any]:
        def one(f: Expr) -> Expr:
            return sum((f.diff(s) * rate for s, rate in zip(x, direction)), Integer(0))
        return lambda f: f.applyfunc(one) if isinstance(f, MatrixBase) else one(f)

    def bracket(f: Any, g: Expr) -> Any:
        """{f, g} = ∇f · (M × ∂πg + k × ∂kg, k × ∂πg)."""
        c, d = (Matrix([g.diff(s) for s in part]) for part in (PI, K))
        return along(Matrix([*(M.cross(c) + K.cross(d)), *K.cross(c)]))(f)

    delta = Matrix([model.values.get(symbol(f"delta_{s}"), Integer(0)) for s in x])
    named |= {"delta_pi": Matrix(delta[:3]), "delta_k": Matrix(delta[3:]), "dt": along(field), "variation": along(delta),
              "bracket": bracket, "gradient_pi": lambda f: Matrix([f.diff(s) for s in PI]),
              "gradient_k": lambda f: Matrix([f.diff(s) for s in K])}
    named |= {f: sum((model.values.get(symbol(f"{f}{i}"), Integer(0)) * s for i, s in enumerate(x, 1)), Integer(0)) for f in "FG"}
    return named | _functions()


def _turning(scene: Scene, values: Values) -> dict[str, Any]:
    """Kinematics from the product of three turns at angles φ(t), θ(t), ψ(t), to 50 digits."""
    t, zero = Symbol("t"), Float(0, DIGITS)
    given = {str(s): Float(v, DIGITS) for s, v in values.items()}
    inertia = [Float(moment.subs(dict(values)), DIGITS) for moment in scene.body.inertia]
    unit = [Matrix([int(i == j) for j in range(3)]) for i in range(3)]

    def turn(axis: str, angle: Expr) -> Matrix:
        i, j = ("xyz".index(axis) + 1) % 3, ("xyz".index(axis) + 2) % 3
        R = Matrix.eye(3)
        R[i, i], R[i, j], R[j, i], R[j, j] = cos(angle), -sin(angle), sin(angle), cos(angle)
        return R

    first, second, third = (turn(axis, given[x]) for axis, x in zip(scene.table["angles"], ("phi", "theta", "psi")))
    k, line = (first * second * third).row(2).T, third.T * unit["xyz".index(scene.table["angles"][1])]
    rates = [given.get(f"{x}_dot", zero) for x in ("phi", "theta", "psi")]
    free = scene.table.get("vertical")
    if free:                                               # the rates of the momentum along z, ω = φ̇ k + θ̇ line + ψ̇ e3
        momentum = given[free] * k
        rates = list(Matrix.hstack(k, line, unit[2]).solve(Matrix([p / moment for p, moment in zip(momentum, inertia)])))
    bends = [zero if free else given.get(f"{x}_ddot", zero) for x in ("phi", "theta", "psi")]
    angles = [given[x] + rate * t + bend * t**2 / 2 for x, rate, bend in zip(("phi", "theta", "psi"), rates, bends)]
    R = Matrix.eye(3)
    for axis, angle in zip(scene.table["angles"], angles):
        R = R * turn(axis, angle)
    W, k = R.T * R.diff(t), R.row(2).T
    omega = Matrix([given[free] * x / moment for x, moment in zip(k, inertia)]) if free else Matrix([W[2, 1], W[0, 2], W[1, 0]])
    pi = Matrix([moment * rate for moment, rate in zip(inertia, omega)])
    A = Matrix([given.get(f"A{i}", zero) + given.get(f"A{i}_dot", zero) * t for i in (1, 2, 3)])
    J = Matrix(3, 3, lambda i, j: given.get(f"J{min(i, j) + 1}{max(i, j) + 1}", zero))
    torque = R.T * (R * pi).diff(t)
    named: dict[str, Any] = {**given, "R": R, "vector_k": k, "vector_omega": omega, "vector_pi": pi, "vector_A": A, "tensor": J,
                             "vector_z": unit[2], "axis_1": unit[0], "axis_2": unit[1], "axis_3": unit[2], "axis_vertical": k,
                             "axis_nodes": line, "torque": torque, "tensor_torque": R.T * (R * J * omega).diff(t), "T": pi.dot(omega) / 2}
    named |= {f"vector_{x}": Matrix([given.get(f"{x}{i}", zero) for i in (1, 2, 3)]) for x in "mr"}
    for name, v in (("k", k), ("omega", omega), ("pi", pi), ("tau", torque)):
        named |= {f"{name}{i}": v[i - 1] for i in (1, 2, 3)}
    named |= dict(zip(("phi", "theta", "psi"), angles))
    named |= {f"{x}_dot": angle.diff(t) for x, angle in zip(("phi", "theta", "psi"), angles)}
    named["lagrangian"] = named["T"] - (scene.potential.expression.subs(dict(values)).subs(symbol("k3"), k[2]) if scene.potential else 0)
    return named | _functions() | {"dt": lambda f: f.diff(t)}


def _period(inertia: tuple[Expr, ...], momentum: tuple[Expr, ...]) -> Expr:
    """4 ∫ dM2/|Ṁ2| over a quarter of the polhode, M1 and M3 from the two conserved quantities (I1 < I2 < I3, M² > 2 E I2)."""
    with mpmath.workdps(DIGITS):
        (I1, I2, I3), M = ([mpmath.mpf(x.p) / x.q for x in xs] for xs in (inertia, momentum))
        total, twice = sum(m**2 for m in M), sum(m**2 / i for m, i in zip(M, (I1, I2, I3)))
        high, low = twice * I3 - total, total - twice * I1                 # M1² and M3² are affine in M2², M1 = 0 at the turning point
        top = high * I2 / (I3 - I2)

        def slope(angle: Any) -> Any:
            M2 = mpmath.sqrt(top) * mpmath.sin(angle)
            M3 = mpmath.sqrt((low - M2**2 * (1 - I1 / I2)) * I3 / (I3 - I1))
            amplitude = mpmath.sqrt(high * I1 / (I3 - I1))                 # M1 = amplitude cos(angle)
            return mpmath.sqrt(top) / (amplitude * M3 * (1 / I1 - 1 / I3))

        return Float(4 * mpmath.quad(slope, [0, mpmath.pi / 4, mpmath.pi / 2]), 30)


def _jacobi(u: Expr, m: Expr) -> list[Expr]:
    """y(u) of y1' = y2 y3, y2' = −y1 y3, y3' = −m y1 y2, y(0) = (0, 1, 1), by Taylor steps."""
    with mpmath.workdps(30):
        step, m = mpmath.mpf(u.p) / u.q / 48, mpmath.mpf(m.p) / m.q
        y = [mpmath.mpf(x) for x in (0, 1, 1)]
        for _ in range(48):
            c = [[x] for x in y]
            for n in range(45):
                product = [sum(c[i][j] * c[k][n - j] for j in range(n + 1)) for i, k in ((1, 2), (0, 2), (0, 1))]
                for series, sign, p in zip(c, (1, -1, -m), product):
                    series.append(sign * p / (n + 1))
            y = [mpmath.polyval(series[::-1], step) for series in c]
        return [Float(x, 25) for x in y]


def number(value: Expr, scene: Scene, values: Values) -> Any:
    """A value of these names at the instant of the counterexample: exact where it is rational, else to 30 digits."""
    place = {Symbol("t"): Integer(0)} if "angles" in scene.table else {s: v for s, v in values.items() if s in {*PI, *K}}
    at = value.subs(place)
    return at if isinstance(at, Rational) or at.free_symbols else at.evalf(30)
