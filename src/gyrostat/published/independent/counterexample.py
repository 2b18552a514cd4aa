"""Confirms a counterexample by Newton and Euler's equations at rational numbers.

The equations are written with cross products and matrices. Nothing here uses the bracket, the linearisation
or the criteria of the library, nor any published formula.
"""
from collections.abc import Mapping
from typing import Any

import mpmath
from sympy import Add, Expr, Float, Integer, Matrix, Poly, Symbol, hessian, linsolve, sqrt

from ..._cached import cached_property
from ...algebra.reals.exact import sign_of_constant
from ...errors import PublishedError
from ...notation import symbol
from ..scenes import Scene
from .signs import first_term, signs_on_sphere, squares_of

Values = Mapping[Symbol, Expr]
PI, K = (Matrix([symbol(f"{x}{i}") for i in (1, 2, 3)]) for x in ("pi", "k"))
DIGITS = 50
FAR = 10**6                                                # of a multiplier that may have any value


class Model:
    """A scene at numbers: the field ẋ = f(x), and the point of the equilibrium if there is one."""

    def __init__(self, scene: Scene, values: Values):
        self.values = dict(values)
        self.inertia = [moment.subs(self.values) for moment in scene.body.moments]
        self.rotor = Matrix([part.subs(self.values) for part in scene.body.gyrostatic_momentum])
        self.claimed = scene.claimed
        self.label = "E" if self.claimed else scene.table.get("equilibrium")
        self.spins = scene.body.is_of_revolution() and scene.potential is not None and scene.potential.axial
        self.coordinates = [*PI, *K] if scene.potential else [*PI]
        k3 = (self.claimed[5].subs(self.values) if len(self.claimed) == 6
              else self.values.get(K[2], Integer(0)))
        self.k3 = {"E1": Integer(1), "E2": Integer(-1)}.get(str(self.label), k3)
        self.U = self._potential(scene) if scene.potential else Integer(0)
        self.point = self._point() if self.label else [x.subs(self.values) for x in self.coordinates]
        rates = self.field.subs(self.place) if self.label else ()
        # not a number where the field is not defined
        if not all(x.is_finite and abs(x.evalf(30)) < 1e-20 for x in rates):
            raise PublishedError(f"{self.label} is no equilibrium of Newton and Euler's equations at "
                                 f"{self.values}")

    def _potential(self, scene: Scene) -> Expr:
        """Return U: a polynomial with the derivatives given, or the expression at its numbers."""
        potential = scene.potential
        assert potential is not None
        if potential.given:
            return self.number(potential.expression)
        if not potential.axial:
            linear = sum((self.values.get(symbol(f"dU_{i}"), Integer(0)) * K[i - 1] for i in (1, 2, 3)),
                         Integer(0))
            return linear - linear.subs(self.values) + self.values.get(symbol(scene.derived("U")), 0)
        slope = self.values.get(symbol("dU"))
        if self.label == "E3":                             # what balances the torques at the point
            omega, l = self.values[symbol("omega")], self.rotor[2]
            slope = omega * (l + self.inertia[2] * omega * self.k3) - omega**2 * self.inertia[0] * self.k3
        jets = [slope, *(self.values.get(symbol(f"d{n}U"), Integer(0)) for n in (2, 3))]
        rise, constant = K[2] - self.k3, self.values.get(symbol(scene.derived("U")), Integer(0))
        return sum((d * rise**n / (1, 2, 6)[n - 1] for n, d in enumerate(jets, 1) if d is not None), constant)

    def _point(self) -> list[Expr]:
        if self.label in ("E1", "E2"):
            spin = self.values.get(symbol("pi3_0"),
                                   self.inertia[2] * self.values.get(symbol("omega3_0"), Integer(0)))
            return [Integer(0), Integer(0), spin, Integer(0), Integer(0), self.k3]
        if self.label == "E3":
            k = [self.values.get(K[0], sqrt(1 - self.k3**2)), self.values.get(K[1], Integer(0)), self.k3]
            return [*(moment * self.values[symbol("omega")] * x for moment, x in zip(self.inertia, k)), *k]
        if self.claimed:
            return [x.subs(self.values) for x in self.claimed]
        axis = int(str(self.label)[-1])
        return [self.inertia[axis - 1] * self.values[symbol(f"omega{i}_0")] if i == axis else Integer(0)
                for i in (1, 2, 3)]

    @property
    def place(self) -> dict[Any, Any]:
        """The value of each coordinate at the point."""
        return dict(zip(self.coordinates, self.point))

    def number(self, value: Any) -> Any:
        """Return a value at the numbers of the parameters, its coordinates left as they are."""
        return value.subs({s: x for s, x in self.values.items() if s not in self.coordinates})

    def has_a_unit_k(self) -> bool:
        """Return whether k is a unit vector at the point; True on so(3)*, where there is no k."""
        return len(self.point) == 3 or sign_of_constant(sum(x**2 for x in self.point[3:]) - 1) == 0

    @cached_property
    def omega(self) -> Matrix:
        """The angular velocity."""
        return Matrix([p / moment for p, moment in zip(PI, self.inertia)])

    @cached_property
    def field(self) -> Matrix:
        """The field π̇ = (π + l) × ω + k × ∇U, k̇ = k × ω."""
        torque = K.cross(Matrix([self.U.diff(x) for x in K])) if self.U else Matrix([0, 0, 0])
        turning = (PI + self.rotor).cross(self.omega) + torque
        return Matrix([*turning, *K.cross(self.omega)]) if len(self.coordinates) == 6 else turning

    @cached_property
    def jacobian(self) -> Matrix:
        """The derivative ∂f/∂x of the field at the point."""
        return self.field.jacobian(self.coordinates).subs(self.place)

    @cached_property
    def energy(self) -> Expr:
        """The energy h as a function of the momenta and k."""
        return sum(p**2 / moment for p, moment in zip(PI, self.inertia)) / 2 + self.U

    @cached_property
    def casimirs(self) -> list[Expr]:
        """The Casimirs M·k and k·k; that of a free body is M·M."""
        M = PI + self.rotor
        return [M.dot(K), K.dot(K)] if len(self.coordinates) == 6 else [M.dot(M)]

    def growth(self) -> mpmath.mpf:
        """Return the largest real part of an eigenvalue, to 50 digits."""
        with mpmath.workdps(2 * DIGITS):
            J = self.jacobian
            values, _ = mpmath.eig(mpmath.matrix([[mpmath.mpf(Float(x.evalf(2 * DIGITS))._mpf_)
                                                   for x in J.row(i)] for i in range(J.rows)]))
            return max(mpmath.re(v) for v in values)

    @cached_property
    def polynomial(self) -> Expr:
        """The characteristic polynomial on the orbit.

        Each Casimir gives a factor λ of that of the whole field.
        """
        found = self.jacobian.charpoly().all_coeffs()[:-len(self.casimirs)]
        return Poly([x.expand() for x in found], symbol("lamda")).as_expr()

    def grows(self) -> bool:
        """Return whether an eigenvalue is proved to have a positive real part.

        On the orbit the characteristic polynomial is λ⁴ + pλ² + q, for a free body λ² + q.
        """
        *_, p, _, q = [Integer(0)] * 3 + Poly(self.polynomial, symbol("lamda")).all_coeffs()
        if len(self.coordinates) == 3:
            return sign_of_constant(q) == -1
        return -1 in [sign_of_constant(e) for e in (p, q, p**2 - 4 * q)]

    def stability(self) -> tuple[int, str]:
        """Return 1 if it is proved stable, at a tilt modulo the spin, -1 if unstable, else 0; and why."""
        if self.grows():
            return -1, ("the linearised equations of Newton and Euler have an eigenvalue with "
                        f"the real part {mpmath.nstr(self.growth(), 15)}: unstable")
        level = self.level_set()
        if level == -1:
            return -1, ("motions with the same energy and momenta, or with momenta as near as one likes, "
                        "leave it: unstable")
        if level == 0:
            return 0, ""
        if not self.spins:
            return 1, ("the energy, on the level set of the Casimirs, has a strict extremum there: Lyapunov "
                       "stable")
        if self.is_at_pole:
            return 1, "the level set of all integrals there is the point alone: Lyapunov stable"
        return 1, ("the level set of all integrals there is the orbit of the point under the spin: Lyapunov "
                   "stable, modulo the spin")

    def is_on_boundary(self) -> bool:
        """Return whether the second variation of a body of revolution does not decide.

        Then k̇3² vanishes to the second order in k3.
        """
        return self.spins and self._leading()[0] != 2

    def level_set(self) -> int:
        """Return 1 if the level set of all integrals near the point is only its orbit under the spin.

        1 proves Lyapunov stability. -1 proves instability: motions leave along the level set, or along one
        that is as near as one likes. 0 proves neither. All of it is modulo the spin. On so(3)* the energy has
        a strict extremum on the sphere, or none. Otherwise, unless the body is one of revolution, a definite
        second variation isolates the point.
        """
        if len(self.coordinates) == 3:
            first, second = self.signs_on_sphere() or (1, 1)   # none where the sphere is a point
            return (first or 0) * (second or 0)
        if not self.spins:
            return int(self.is_definite() is True)
        power, slope = self._leading()
        # with a little more energy, or less momentum, k3 moves away
        if power == 0:
            return -1
        if slope == 0:
            return 0
        return -1 if slope > 0 or not self.is_at_pole and power % 2 else 1

    @property
    def is_at_pole(self) -> bool:
        """Whether k is along the axis of a body of revolution."""
        return self.label in ("E1", "E2") or bool(self.claimed) and self.k3**2 == 1

    def signs_on_sphere(self) -> list[int | None]:
        """Return the signs of the two squares of the energy about the point on the sphere."""
        return signs_on_sphere(self.inertia, [*(Matrix(self.point) + self.rotor)], self.point)

    def _leading(self) -> tuple[int, int]:
        """Return the power and the sign of the first term of g at the equilibrium.

        A body of revolution satisfies I1² k̇3² = g(k3), where g has a multiple root there. (0, 0) means that g
        is 0 throughout; the sign is 0 if it is not proved, or the term lies beyond the sixth power.
        """
        z, at, M = symbol("z"), self.place, PI + self.rotor
        energy = (sum(p**2 / moment for p, moment in zip(PI[:2], self.inertia)) / 2 + self.U).subs(at)
        momentum, total = M.dot(K).subs(at), M[2].subs(at)
        g = 2 * self.inertia[0] * (energy - self.U.subs(K[2], z)) * (1 - z**2) - (momentum - total * z) ** 2
        # g and its slope vanish at an equilibrium
        power, sign = first_term(g, self.k3, self.is_at_pole, 2)
        return power, sign or 0

    def is_definite(self) -> bool | None:
        """Return whether D²(h + ν·C) is definite on the tangent space of the orbit.

        None if a sign is not proved.
        """
        squares = self.inertia_of_second_variation()
        return squares and not squares[1] and 0 in squares[::2]

    @cached_property
    def _gradients(self) -> Matrix:
        """The gradients of h and of the Casimirs at the point, in rows."""
        rows = Matrix([[f.diff(x) for x in self.coordinates] for f in (self.energy, *self.casimirs)])
        return rows.subs(self.place)

    def multipliers(self, far: int = FAR) -> list[Expr]:
        """Return ν with ∇h + Σ ν ∇C = 0 at the point: far for one that is free, [] if there are none."""
        names, rows = [symbol(f"x{n}") for n, _ in enumerate(self.casimirs, 1)], self._gradients
        force = rows[0, :] + Add(*(x * rows[n, :] for n, x in enumerate(names, 1)), evaluate=False).doit()
        return [x.subs(dict.fromkeys(names, far)) for nu in linsolve(list(force), names) for x in nu]

    def inertia_of_second_variation(self, far: int = FAR, spin: bool = False) -> tuple[int, int, int] | None:
        """Return the numbers of positive, zero and negative squares of D²(h + ν·C) on the kernel of dC.

        If spin is True, π3 is fixed too. None if there is no ν, or a sign is not proved.
        """
        if not (nu := self.multipliers(far)):              # parallel directions, and it turns about them
            return None
        form = hessian(self.energy + Add(*(x * c for x, c in zip(nu, self.casimirs))), self.coordinates)
        held = [*self._gradients[1:, :].tolist(), *[[int(x == PI[2]) for x in self.coordinates]] * spin]
        kernel = Matrix.hstack(*Matrix(held).nullspace())
        return squares_of(kernel.T * form.subs(self.place) * kernel)
