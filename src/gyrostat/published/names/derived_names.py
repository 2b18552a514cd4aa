"""Derives everything that a formula may name from the bracket, the Hamiltonian and the kinematics."""
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from sympy import Expr, ImmutableMatrix, Integer, MatrixBase, Symbol, eye

from ...algebra.rings.polynomials import Ring
from ...errors import ExpressionError
from ...mechanics.classical.attitude import reduced
from ...mechanics.classical.free_body import polhode_period
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...notation import jet, jet_name, symbol
from ...stability.criteria.energy_casimir import multipliers
from ...stability.criteria.linearization import linearize
from ..scenes import DERIVED, Scene
from .frames import frame_names, frame_names_at
from .jacobi import cn, dn, sn
from .kinematics import Later, turning
from .rotations import amended_names, cone_names
from .windows import normal_form_names


class Names(Mapping[str, Any]):
    """The names of a scene, with the values of `at` inserted.

    What is Later is derived when it is first asked for.
    """

    def __init__(self, meanings: Mapping[str, Any], at: Mapping[Symbol, Expr]):
        self._meanings, self._at, self._known = meanings, at, dict[str, Any]()

    def __getitem__(self, name: str) -> Any:
        if name not in self._known:
            value = self._meanings[name]
            value = value.derive() if isinstance(value, Later) else value
            self._known[name] = (
                value.xreplace(self._at) if self._at and isinstance(value, (Expr, MatrixBase)) else value
            )
        return self._known[name]

    def __contains__(self, name: object) -> bool:      # nothing is derived for that
        return name in self._meanings

    def __iter__(self) -> Iterator[str]:
        return iter(self._meanings)

    def __len__(self) -> int:
        return len(self._meanings)


def names(scene: Scene, at: Mapping[Symbol, Expr]) -> Names:
    """Return what each name of a scene stands for, with the values of `at` inserted."""
    derived = turning(scene) if "angles" in scene.table else _phase_space(scene, at)
    return Names(with_letters({**FUNCTIONS, **derived}, {name: symbol(name) for name in scene.letters}), at)


def with_letters(derived: Mapping[str, Any], own: Mapping[str, Any]) -> dict[str, Any]:
    """Return what is derived, behind the letters of the paper.

    A derived quantity with such a letter gets a prefix: derived_C if C is a moment of the paper.
    """
    hidden = {DERIVED + name: derived[name] for name, value in own.items()
              if name in derived and not (isinstance(value, Symbol) and derived[name] == value)}
    return {**derived, **own, **hidden}


def is_zero(expression: Expr) -> bool:
    """Return whether an expression vanishes identically."""
    return not Ring([expression]).numerator(expression)


def _entry(matrix: MatrixBase, i: Expr, j: Expr) -> Expr:
    if i not in range(1, matrix.rows + 1) or j not in range(1, matrix.cols + 1):
        raise ExpressionError(f"a {matrix.rows}×{matrix.cols} matrix has no entry {i}, {j}: rows and "
                              "columns count from 1")
    return matrix[int(i) - 1, int(j) - 1]


FUNCTIONS: Mapping[str, Any] = {
    "cross": lambda a, b: a.cross(b), "dot": lambda a, b: (a.T * b)[0, 0], "transpose": lambda a: a.T,
    "inverse": lambda a: a.adjugate() / reduced(a.det()),
    "rank": lambda a: Integer(a.rank(iszerofunc=is_zero)),
    "diff": lambda f, x: f.diff(x), "entry": _entry, "sn": sn, "cn": cn, "dn": dn,
    "polhode_period": lambda *x: polhode_period(x[:3], x[3:], 30)}


def _phase_space(scene: Scene, at: Mapping[Symbol, Expr]) -> dict[str, Any]:
    """Return the names on so(3)*, on e(3)* or in two directions; at an equilibrium, their values there."""
    system, body, potential = scene.system, scene.body, scene.potential
    coordinates, U = system.space.coordinates, symbol(scene.derived("U"))
    slopes = (0, 0, 0, *(system.potential.gradient() if system.potential else ()))

    def gradient(f: Expr) -> ImmutableMatrix:
        return ImmutableMatrix([f.diff(x) + f.diff(U) * slope for x, slope in zip(coordinates, slopes)])

    def along(direction: ImmutableMatrix) -> Callable[[Any], Any]:
        """Return the derivative in a direction, of functions of the coordinates and the jet of U."""
        def one(f: Expr) -> Expr:
            total = sum((slope * rate for slope, rate in zip(gradient(f), direction)), Integer(0))
            for d in f.free_symbols:
                if jet(d.name) and system.potential:
                    total += f.diff(d) * sum(x * y
                                             for x, y in zip(system.potential.following(d), direction[3:6]))
            return total
        return lambda f: f.applyfunc(one) if isinstance(f, MatrixBase) else one(f)

    pi, rotor = ImmutableMatrix(coordinates[:3]), ImmutableMatrix(body.gyrostatic_momentum)
    omega = body.inverse * pi
    kinetic = body.kinetic_energy(coordinates[:3])
    found: dict[str, Any] = {str(x): x for x in coordinates}
    found |= {f"omega{i}": rate for i, rate in enumerate(omega, 1)}
    found |= {"vector_pi": pi, "vector_l": rotor, "vector_M": pi + rotor, "vector_omega": omega,
              "B": system.space.tensor,
              "h": kinetic + (U if potential else 0), "T": kinetic, "field": system.jet_field,
              "state": ImmutableMatrix(coordinates)}
    found |= dict(zip(("C1", "C2", "C3") if potential else ("C",), system.space.casimirs))
    # any functions, to first order
    found |= {f: sum(symbol(scene.derived(f"{f}{i}")) * x for i, x in enumerate(coordinates, 1))
              for f in "FG"}
    if system.coupled:
        found = {**{name: x for name, x in found.items() if name not in ("T", "B", "F", "G")},
                 **frame_names(system)}
    elif potential:
        found |= {"U": U, "vector_k": ImmutableMatrix(coordinates[3:])}
        found |= {d: symbol(d) for d in ([jet_name(n) for n in (1, 2, 3)] if potential.axial
                                         else [jet_name(1, a) for a in "123"])}
    if scene.equilibrium is not None:
        place = dict(zip(coordinates, scene.point))
        return {name: value.xreplace(place)
                for name, value in found.items()} | _at_equilibrium(scene.equilibrium, place, at)
    if system.coupled:
        return found | {"dt": along(system.jet_field)}
    if potential:
        found |= cone_names(system)
    delta = ImmutableMatrix([symbol(f"delta_{x}") for x in coordinates])
    return found | {
        "delta_pi": ImmutableMatrix(delta[:3]), "delta_k": ImmutableMatrix(delta[3:]),
        "dt": along(system.jet_field),
        "variation": along(delta), "bracket": lambda f, g: along(system.space.tensor * gradient(g))(f),
        "gradient_pi": lambda f: ImmutableMatrix(gradient(f)[:3]),
        "gradient_k": lambda f: ImmutableMatrix(gradient(f)[3:])}


def _at_equilibrium(eq: Equilibrium, place: Mapping[Symbol, Expr], at: Mapping[Symbol, Expr]
                    ) -> dict[str, Any]:
    found: dict[str, Any] = {s.name: s for e in (*eq.point, *eq.existence())
                             for s in e.free_symbols} | {"lamda": symbol("lamda")}
    found |= {"jacobian": Later(lambda: eq.system.jet_jacobian.xreplace(place)),
              "linearization": Later(lambda: linearize(eq).matrix),
              "polynomial": Later(lambda: linearize(eq).characteristic_polynomial()),
              "q": Later(lambda: linearize(eq).coefficients[-1]),
              "identity": Later(lambda: eye(linearize(eq).matrix.rows))}
    if eq.system.coupled:
        return found | frame_names_at(eq)
    if eq.system.potential:
        nu = {f"nu{n + 1}": Later(lambda n=n: multipliers(eq, eq.system.space.casimirs)[n])  # type: ignore[misc]
              for n in (0, 1)}
        found |= {"p": Later(lambda: linearize(eq).coefficients[0]), **nu, **amended_names(eq),
                  **normal_form_names(eq, at)}
    return found
