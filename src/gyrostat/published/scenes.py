"""What a formula of a published file is about: a scene, and what the library derives for each of its names."""
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

from sympy import Expr, ImmutableMatrix, Integer, MatrixBase, Symbol, eye

from ..algebra import Ring
from ..attitude import ANGLES, RATES, angle_rates, angular_velocity, direction, lagrangian, nodes, reduced, rotation
from ..body import Gyrostat
from ..energy_casimir import multipliers
from ..equilibria import Equilibrium
from ..errors import PublishedError
from ..expressions import parse
from ..families import hanging, inclined, principal_rotation, upright
from ..freebody import polhode_period
from ..linearization import linearize
from ..notation import jet, jet_name, symbol
from ..potential import Potential, axial_potential, general_potential
from ..system import System, assemble
from .jacobi import cn, dn, sn

KEYS = {"inertia", "gyrostatic_momentum", "potential", "equilibrium", "spin", "eliminate", "angles", "vertical", "given", "parameters"}


class Names(Mapping[str, Any]):
    """Names of a scene, each derived when it is first asked for, with the values of `at` inserted."""

    def __init__(self, thunks: Mapping[str, Callable[[], Any]], at: Mapping[Symbol, Expr]):
        self._thunks, self._at, self._known = thunks, at, dict[str, Any]()

    def __getitem__(self, name: str) -> Any:
        if name not in self._known:
            value = self._thunks[name]()
            plain = isinstance(value, (Expr, MatrixBase)) and self._at
            self._known[name] = value.xreplace(self._at) if plain else value
        return self._known[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._thunks)

    def __len__(self) -> int:
        return len(self._thunks)


@dataclass(frozen=True)
class Scene:
    """One [scene.NAME] table: a body, a field, perhaps an equilibrium or Euler angles.

    Parameters
    ----------
    table : mapping                     as in the file
    """

    table: Mapping[str, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        if unknown := set(self.table) - KEYS:
            raise PublishedError(f"a scene has no entry {', '.join(sorted(unknown))}: its entries are {', '.join(sorted(KEYS))}")

    @cached_property
    def body(self) -> Gyrostat:
        """The gyrostat; without entries a rigid body with three moments."""
        inertia, rotor = self.table.get("inertia", ["I1", "I2", "I3"]), self.table.get("gyrostatic_momentum", ["0", "0", "0"])
        return Gyrostat(tuple(map(parse, inertia)), tuple(map(parse, rotor)))

    @cached_property
    def potential(self) -> Potential | None:
        """none, U(k3), U(k1, k2, k3), or an expression in k3, or in k1, k2, k3."""
        text = self.table.get("potential", "none")
        if text == "none":
            return None
        if text in ("U(k3)", "U(k1, k2, k3)"):
            return axial_potential() if text == "U(k3)" else general_potential()
        expression = parse(text)
        return general_potential(expression) if expression.free_symbols & {symbol("k1"), symbol("k2")} else axial_potential(expression)

    @cached_property
    def system(self) -> System:
        """The Lie-Poisson system."""
        return assemble(self.body, self.potential)

    @cached_property
    def equilibrium(self) -> Equilibrium | None:
        """E1, E2, E3 or axis 1, 2, 3."""
        label, spin = self.table.get("equilibrium"), self.table.get("spin", "pi3_0")
        if label is None:
            return None
        if label in ("E1", "E2"):
            return (upright if label == "E1" else hanging)(self.system, spin)
        if label == "E3":
            return inclined(self.system, self.table.get("eliminate"))
        if label in ("axis 1", "axis 2", "axis 3"):
            return principal_rotation(self.system, int(label[-1]))
        raise PublishedError(f"equilibrium = {label!r}: give E1, E2, E3, axis 1, axis 2 or axis 3")

    @property
    def point(self) -> tuple[Expr, ...]:
        """The equilibrium; E3 at any k, not only at k2 = 0."""
        eq = self.equilibrium
        if eq is None:
            return ()
        if eq.label != "E3":
            return eq.point
        k = [symbol(f"k{i}") for i in (1, 2, 3)]
        return (*(moment * symbol("omega") * x for moment, x in zip(self.body.inertia, k)), *k)

    def finish(self, expression: Any) -> Any:
        """On the family: the relations of the equilibrium, a given U and its derivatives inserted."""
        if self.potential and self.potential.given:
            expression = expression.xreplace({symbol("U"): self.potential.expression.xreplace(dict(zip(
                self.system.space.coordinates, self.point)))})
        if self.equilibrium is None:
            if self.potential and self.potential.given:
                jets = [s for s in expression.free_symbols if jet(s.name)]
                return expression.xreplace({d: self.potential.value(d) for d in jets})
            return expression
        if self.potential and not self.potential.given:
            for name, value in self.equilibrium.relations:
                expression = expression.xreplace({name: value}) if jet(name.name) else expression
        return self.equilibrium.insert(expression)

    def names(self, at: Mapping[Symbol, Expr]) -> Names:
        """Everything a formula of this scene may name, as the library derives it."""
        thunks = {**_vectors(), **_symbols(self)}
        thunks |= _attitude(self) if "angles" in self.table else _phase_space(self)
        return Names(thunks, at)


def _symbols(scene: Scene) -> dict[str, Callable[[], Any]]:
    """Parameters: those of body and field, and those the file declares."""
    found = {s for e in (*scene.body.inertia, *scene.body.gyrostatic_momentum) for s in e.free_symbols}
    found |= set(scene.potential.parameters) if scene.potential else set()
    names = {s.name for s in found} | set(scene.table.get("parameters", ())) | {"t"}
    return {name: (lambda name=name: symbol(name)) for name in names}


def _vectors() -> dict[str, Callable[[], Any]]:
    functions = {"cross": lambda a, b: a.cross(b), "dot": lambda a, b: (a.T * b)[0, 0], "transpose": lambda a: a.T,
                 "inverse": lambda a: a.adjugate() / reduced(a.det()), "rank": lambda a: Integer(a.rank(iszerofunc=is_zero)),
                 "diff": lambda f, x: f.diff(x), "entry": lambda a, i, j: a[i - 1, j - 1],
                 "sn": sn, "cn": cn, "dn": dn, "polhode_period": lambda *x: polhode_period(x[:3], x[3:], 30)}
    return {name: (lambda f=f: f) for name, f in functions.items()}


def _phase_space(scene: Scene) -> dict[str, Callable[[], Any]]:
    """Names on so(3)* or e(3)*, all at the equilibrium where there is one."""
    system, body = scene.system, scene.body
    coordinates = system.space.coordinates
    place = dict(zip(coordinates, scene.point))

    field_value, slopes = symbol("U"), system.potential.gradient() if system.potential else ()

    def gradient(f: Expr) -> list[Expr]:
        outer = f.diff(field_value)
        return [f.diff(x) + outer * slope for x, slope in zip(coordinates, (0, 0, 0, *slopes))]

    def along(direction: ImmutableMatrix) -> Callable[[Any], Any]:
        """The derivative in a direction, of functions of the coordinates and the jet of U."""
        def one(f: Expr) -> Expr:
            total = sum((slope * rate for slope, rate in zip(gradient(f), direction)), Integer(0))
            for d in f.free_symbols:
                if jet(d.name) and system.potential:
                    total += f.diff(d) * sum(x * y for x, y in zip(system.potential.following(d), direction[3:6]))
            return total
        return lambda f: f.applyfunc(one) if isinstance(f, MatrixBase) else one(f)

    def vector(name: str) -> ImmutableMatrix:
        return ImmutableMatrix([symbol(f"{name}{i}") for i in (1, 2, 3)])

    pi, kinetic = vector("pi"), body.kinetic_energy(coordinates[:3])
    rotor = ImmutableMatrix(body.gyrostatic_momentum)
    omega = ImmutableMatrix([p / moment for p, moment in zip(pi, body.inertia)])
    thunks: dict[str, Callable[[], Any]] = {str(x): (lambda x=x: x) for x in coordinates}
    thunks |= {f"omega{i}": (lambda i=i: omega[i - 1]) for i in (1, 2, 3)}
    thunks |= {"vector_pi": lambda: pi, "vector_l": lambda: rotor, "vector_M": lambda: pi + rotor, "vector_omega": lambda: omega,
               "B": lambda: system.space.tensor, "h": lambda: kinetic + (field_value if system.potential else 0), "T": lambda: kinetic,
               "field": lambda: system.jet_field, "state": lambda: ImmutableMatrix(coordinates)}
    thunks |= {f"C{n if len(coordinates) > 3 else ''}": (lambda c=c: c) for n, c in enumerate(system.space.casimirs, 1)}
    test = {f: sum(symbol(f"{f}{i}") * x for i, x in enumerate(coordinates, 1)) for f in "FG"}
    thunks |= {f: (lambda f=f: test[f]) for f in test}
    if scene.potential:
        thunks |= {"U": lambda: field_value, "vector_k": lambda: vector("k")}
        thunks |= {d: (lambda d=d: symbol(d)) for d in _jet_names(scene.potential)}
    if scene.equilibrium is None:
        B, delta = system.space.tensor, ImmutableMatrix([symbol(f"delta_{x}") for x in coordinates])

        def bracket(f: Any, g: Expr) -> Any:
            flow = along(ImmutableMatrix(B * ImmutableMatrix(gradient(g))))
            return flow(f)

        thunks |= {"delta_pi": lambda: ImmutableMatrix(delta[:3]), "delta_k": lambda: ImmutableMatrix(delta[3:])}
        functions = {"dt": along(system.jet_field), "variation": along(delta), "bracket": bracket,
                     "gradient_pi": lambda f: ImmutableMatrix(gradient(f)[:3]), "gradient_k": lambda f: ImmutableMatrix(gradient(f)[3:])}
        return thunks | {name: (lambda f=f: f) for name, f in functions.items()}
    placed = {name: (lambda thunk=thunk: thunk().xreplace(place)) for name, thunk in thunks.items()}
    return placed | _at_equilibrium(scene.equilibrium, lambda e: e.xreplace(place))


def _at_equilibrium(eq: Equilibrium, placed: Callable[[Any], Any]) -> dict[str, Callable[[], Any]]:
    names = {s.name for e in (*eq.point, *eq.existence()) for s in e.free_symbols} | {"lamda"}
    thunks: dict[str, Callable[[], Any]] = {name: (lambda name=name: symbol(name)) for name in names}
    thunks |= {"jacobian": lambda: placed(eq.system.jet_jacobian), "linearization": lambda: linearize(eq).matrix,
               "polynomial": lambda: linearize(eq).characteristic_polynomial(), "identity": lambda: eye(linearize(eq).matrix.rows)}
    thunks |= {name: (lambda n=n: linearize(eq).coefficients[n]) for n, name in enumerate("pq" if eq.system.potential else "q")}
    if eq.system.potential:
        thunks |= {f"nu{n}": (lambda n=n: multipliers(eq, eq.system.space.casimirs)[n - 1]) for n in (1, 2)}
    return thunks


def _attitude(scene: Scene) -> dict[str, Callable[[], Any]]:
    """Names of the kinematics in Euler angles: functions of the angles and their first two derivatives."""
    convention = scene.table["angles"]
    body, potential = scene.body, scene.potential
    second = tuple(map(symbol, ("phi_ddot", "theta_ddot", "psi_ddot")))
    constants = {x: ImmutableMatrix([symbol(f"{x}{i}") for i in (1, 2, 3)]) for x in "mr"}
    A, A_dot = (ImmutableMatrix([symbol(f"A{i}{d}") for i in (1, 2, 3)]) for d in ("", "_dot"))
    inertia = ImmutableMatrix(3, 3, lambda i, j: symbol(f"J{min(i, j) + 1}{max(i, j) + 1}"))
    R, k, axes = rotation(convention), direction(convention), nodes(convention)
    omega, rates = angular_velocity(convention), dict(zip(RATES, RATES))
    if "vertical" in scene.table:                          # free motion, the momentum along z
        omega = ImmutableMatrix([symbol(scene.table["vertical"]) * x / moment for x, moment in zip(k, body.inertia)])
        rates = dict(zip(RATES, angle_rates(omega, convention)))
    pi = ImmutableMatrix([moment * rate for moment, rate in zip(body.inertia, omega)])

    def dt(f: Any) -> Any:
        pairs = [*zip(ANGLES, rates.values()), *zip(RATES, second), *zip(A, A_dot)]
        return sum((f.diff(x) * rate for x, rate in pairs), 0 * f)

    unit = [ImmutableMatrix([int(i == j) for j in range(3)]) for i in range(3)]
    values = {"R": R, "vector_k": k, "vector_omega": omega, "vector_pi": pi, "vector_A": A, "vector_m": constants["m"],
              "vector_r": constants["r"], "tensor": inertia, "vector_z": unit[2], "axis_1": unit[0], "axis_2": unit[1], "axis_3": unit[2],
              "axis_vertical": k, "axis_nodes": axes.col(1), "dt": dt, "delta": symbol("delta")}
    thunks: dict[str, Callable[[], Any]] = {name: (lambda v=value: v) for name, value in values.items()}
    thunks |= {f"{name}{i}": (lambda v=v, i=i: v[i - 1]) for name, v in (("k", k), ("omega", omega), ("pi", pi)) for i in (1, 2, 3)}
    thunks |= {str(angle): (lambda a=angle: a) for angle in ANGLES}
    thunks |= {str(rate): (lambda v=value: v) for rate, value in rates.items()}
    torque = lambda: R.T * dt(R * pi)                      # noqa: E731  the rate of the momentum in space, seen from the body
    thunks |= {"torque": torque, **{f"tau{i}": (lambda i=i: torque()[i - 1]) for i in (1, 2, 3)}}
    thunks |= {"tensor_torque": lambda: R.T * dt(R * inertia * omega),
               "T": lambda: sum(moment * rate**2 for moment, rate in zip(body.inertia, omega)) / 2,
               "lagrangian": lambda: lagrangian(body, potential, convention)}
    if "vertical" in scene.table:
        thunks[scene.table["vertical"]] = lambda: symbol(scene.table["vertical"])
    return thunks


def _jet_names(potential: Potential) -> list[str]:
    return [jet_name(n) for n in (1, 2, 3)] if potential.axial else [jet_name(1, a) for a in "123"]


def is_zero(expression: Expr) -> bool:
    """Whether an expression vanishes identically."""
    ring = Ring([expression])
    return not ring.reduce(ring.fraction(expression)[0])
