"""Confirms a counterexample about a body in two directions by its equations of motion at numbers.

They are Newton and Euler's for a satellite or a body in two fields, and Kirchhoff's for a vehicle. Nothing
here uses the bracket, the linearisation or the criteria of the library, nor any published formula.
"""
from typing import Any

from sympy import Expr, Matrix, Rational, pi, sqrt, zeros

from ..._cached import cached_property
from ...algebra.reals.exact import sign_of_constant
from ...algebra.text.grammar import parse
from ...algebra.text.quantities import in_si
from ...errors import PublishedError
from ...mechanics.families.orbit_rates import CELESTIAL
from ...notation import symbol
from ..names.kinematics import Later
from ..scenes import Scene
from .counterexample import FAR, PI, Model, Values


def model_of(scene: Scene, values: Values) -> Model:
    """Return the scene at numbers."""
    return InFrame(scene, values) if scene.system.coupled else Model(scene, values)


class InFrame(Model):
    """A scene in two directions a, b at numbers: its field, and its equilibrium if there is one."""

    def __init__(self, scene: Scene, values: Values):
        self.values = dict(values)
        self.coordinates = [*scene.system.space.coordinates]
        self.rotor = Matrix([part.subs(self.values) for part in scene.body.gyrostatic_momentum])
        self.claimed = scene.claimed
        self.label = scene.equilibrium.label if scene.equilibrium else None
        self.spins = scene.hull.is_of_revolution() and "orbit" in scene.table
        self.a, self.b = (Matrix(self.coordinates[n:n + 3]) for n in (3, 6))
        tensor = Matrix(scene.hull.tensor).subs(self.values)
        kind = _vehicle if "vehicle" in scene.table else _orbit if "orbit" in scene.table else _two_fields
        turning, self.turned, self.omega, self.energy = kind(self, scene, tensor)
        self.U = self.energy.subs(dict.fromkeys(PI, 0))
        self.field = Matrix([*turning, *self.a.cross(self.turned), *self.b.cross(self.turned)])
        self.casimirs = [self.a.dot(self.a), self.a.dot(self.b), self.b.dot(self.b)]
        self.point = [x.subs(self.values) for x in (scene.point or self.coordinates)]
        rates = self.field.subs(self.place) if self.label else ()
        if not all(x.is_finite and abs(x.evalf(30)) < 1e-20 for x in rates):
            raise PublishedError(f"{self.label} is no equilibrium of the equations of motion at "
                                 f"{self.values}")

    def has_a_unit_k(self) -> bool:
        """Return True: the directions are as the scene has them, which construction has checked."""
        return True

    @cached_property
    def coefficients(self) -> tuple[Expr, Expr, Expr]:
        """The coefficients c2, c1, c0 of λ⁶ + c2 λ⁴ + c1 λ² + c0."""
        a, b, c = (self.polynomial.coeff(symbol("lamda"), n) for n in (4, 2, 0))
        return a, b, c

    def grows(self) -> bool:
        """Return whether an eigenvalue is proved to have a positive real part.

        It has one if the cubic has a root λ² that is not real, or not ≤ 0.
        """
        a, b, c = self.coefficients
        discriminant = a**2 * b**2 - 4 * b**3 - 4 * a**3 * c + 18 * a * b * c - 27 * c**2
        return -1 in [sign_of_constant(e.expand()) for e in (a, b, c, discriminant)]

    def stability(self) -> tuple[int, str]:
        """Return 1 if it is proved stable (modulo the spin, if it has one), -1 if unstable, 0 if neither."""
        if self.grows():
            return super().stability()
        if self.is_definite():
            return 1, ("the energy, on the level set of the Casimirs" + (" and of π3" if self.spins else "")
                       + ", has a strict minimum there: Lyapunov stable"
                       + (", modulo the spin" if self.spins else ""))
        return 0, ""

    def is_on_boundary(self) -> bool:
        """Return False: a boundary is decided in one direction only."""
        return False

    def is_definite(self) -> bool | None:
        """Return whether the energy has a strict minimum; if the body spins, at fixed π3, modulo the spin."""
        found = [self.inertia_of_second_variation(far, self.spins) for far in (FAR, -FAR)]
        return None if None in found else any(s and not s[2] and not s[1] - self.spins for s in found)

    def is_least(self) -> bool | None:
        """Return the same on the level of the Casimirs alone; None if it is not proved."""
        found = [s for far in (FAR, -FAR) if (s := self.inertia_of_second_variation(far))]
        if any(not s[2] and s[1] == self.spins for s in found):
            return True
        return False if found and all(s[2] for s in found) else None

    @cached_property
    def _turned_by_a_little(self) -> tuple[Matrix, Matrix, Matrix]:
        """The tensor I, hat(g) and K of I θ̈ + g × θ̇ + K θ = 0.

        a and b change by a × θ and b × θ, and π changes such that the body turns at θ̇ in their frame.
        """
        rate = self.turned.jacobian(self.coordinates).subs(self.place)
        inertia = rate[:, :3].inv()
        follows = -inertia * rate[:, 3:]
        turn = Matrix.vstack(*(_hat(Matrix(self.point[n:n + 3])) for n in (3, 6)))
        own, along = self.jacobian[:3, :3], self.jacobian[:3, 3:]
        return inertia, follows * turn - own * inertia, -(own * follows + along) * turn


def rate_of(scene: Scene) -> Expr:
    """Return ω0 of the orbit of a scene."""
    given = {name: in_si(text, f"orbit {name}")[0] for name, text in scene.table["orbit"].items()
             if name != "body"}
    if "period" in given:
        return 2 * pi / given["period"]
    around = CELESTIAL[scene.table["orbit"].get("body", "earth").strip().lower()]
    if "height" in given:
        return sqrt(around.mu / (around.radius + given["height"]) ** 3)
    return given["rate"] if "rate" in given else sqrt(given.get("mu", around.mu) / given["radius"] ** 3)


def other_energy(scene: Scene, n: Matrix, r: Matrix) -> Expr:
    """Return what acts in an orbit beside the gravity gradient, with t = n × r inserted."""
    given = parse(scene.table.get("potential", "0").replace("none", "0"))
    return given.subs(dict(zip(map(symbol, ("t1", "t2", "t3")), n.cross(r))))


def _hat(v: Matrix) -> Matrix:
    return Matrix([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


Equations = tuple[Matrix, Matrix, Matrix, Expr]


def _orbit(model: InFrame, scene: Scene, tensor: Matrix) -> Equations:
    """Return π̇, the rate in the orbital frame, the absolute rate, and h; gravity acts on free rotors too."""
    n, r, rate = model.a, model.b, model.number(rate_of(scene))
    other = model.number(other_energy(scene, n, r))
    omega, free = tensor.inv() * PI, [x for x in scene.rotors if x.momentum is not None]
    mass = tensor + sum((model.number(Matrix(x.axial * x.along)) for x in free), zeros(3, 3))
    turning = (PI + model.rotor).cross(omega) + 3 * rate**2 * r.cross(mass * r) + _torque(model, other)
    energy = (PI.dot(omega) / 2 - rate * n.dot(PI + model.rotor)
              + Rational(3, 2) * rate**2 * r.dot(mass * r) + other)
    return turning, omega - rate * n, omega, energy


def _two_fields(model: InFrame, scene: Scene, tensor: Matrix) -> Equations:
    """Return π̇, ω as both rates, and h."""
    U, omega = model.number(parse(scene.table["potential"])), tensor.inv() * PI
    turning = (PI + model.rotor).cross(omega) + _torque(model, U)
    return turning, omega, omega, PI.dot(omega) / 2 + U


def _vehicle(model: InFrame, scene: Scene, tensor: Matrix) -> Equations:
    """Return π̇ = (π + l) × Ω + p × v + w × γ, Ω as both rates, and h; (π, p) = matrix of T times (Ω, v)."""
    table = scene.table["vehicle"]
    mass = [parse(x) for x in table["mass"]]
    D = model.number(Matrix([[parse(x) for x in row] for row in table.get("coupling", [["0"] * 3] * 3)]))
    M = model.number(Matrix.diag(*mass))
    weight = model.number(Matrix([parse(x) for x in table["weight"]]))
    whole = Matrix([[tensor, D], [D.T, M]])
    moving = whole.inv() * Matrix([*PI, *model.a])
    omega, velocity = Matrix(moving[:3]), Matrix(moving[3:])
    turning = (PI + model.rotor).cross(omega) + model.a.cross(velocity) + weight.cross(model.b)
    return turning, omega, omega, (PI.dot(omega) + model.a.dot(velocity)) / 2 - model.b.dot(weight)


def _torque(model: InFrame, U: Expr) -> Matrix:
    """Return the torque, the sum of a × ∂U/∂a over both directions."""
    a, b = (v.cross(Matrix([U.diff(x) for x in v])) for v in (model.a, model.b))
    return a + b


def frame_names(model: InFrame) -> dict[str, Any]:
    """Return I, g and K of I θ̈ + g × θ̇ + K θ = 0, and c2, c1, c0 of the sextic, by their names."""
    g = Later(lambda: Matrix([model._turned_by_a_little[1][i, j] for i, j in ((2, 1), (0, 2), (1, 0))]))
    return {
        "tensor": Later(lambda: model._turned_by_a_little[0]), "gyroscopic": g,
        "stiffness": Later(lambda: model._turned_by_a_little[2]),
        **{f"c{2 - n}": Later(lambda n=n: model.coefficients[n]) for n in range(3)}}  # type: ignore[misc]
