"""The permanent rotations of any body in a field: every one at a rate, on a level, or in a direction."""
import contextlib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

from flint import arb
from sympy import Add, Expr, Matrix, S, eye

from ..algebra.balls import ball
from ..algebra.exact import evaluate, proved_sign
from ..algebra.matrices import cross
from ..algebra.pencils import points_on_sphere
from ..algebra.precision import own_precision
from ..algebra.roots import real_roots
from ..errors import ScopeError, ValuesError
from ..kept import cached_property
from ..mechanics.claimed import equilibrium
from ..mechanics.equilibria import Equilibrium
from ..mechanics.system import System, at_numbers, names_of_scene
from ..notation import Stored, symbol
from ..shown import Shown
from .amended_form import AmendedForm, amended_form
from .asked import C1, exact_point
from .decision import Decision, Verdict
from .heavy_levels import rates_on_level
from .heavy_polynomials import DIRECTION, degree_in_k, directions_at_rate, rates_by_elimination
from .local_motion import LocalMotion
from .report import Report
from .secular import KEPT, LOST, modes
from .sphere import circle_in_words
from .windows import decide_window

OMEGA, SIGMA = symbol("omega"), symbol("sigma")
PRECISION = 128                                            # bits that decide, and put the rotations in order
LEAST = Decision(Verdict.STABLE, "Lyapunov", (), "the amended potential has a minimum", ())
SADDLE = Decision(Verdict.UNSTABLE, "spectral", (), "the amended potential has a saddle: an eigenvalue has a "
                  "positive real part", ())
LEAVES = Decision(Verdict.UNSTABLE, "spectral", (), "the amended potential has a maximum, and the gyroscopic "
                  "forces do not hold it: an eigenvalue has a positive real part", ())


class Data(NamedTuple):
    """Of a scene at numbers, in a direction: of the body, and of U."""

    inertia: list[list[Expr]]
    rotor: list[Expr]
    gradient: list[Expr]
    hessian: list[list[Expr]]


@dataclass(frozen=True, repr=False)
class HeavyRotation(Shown, Stored):
    """A permanent rotation of a body in a field: ω = omega k, k fixed in the body and in space.

    Parameters
    ----------
    scene : System
        at its numbers
    k : tuple of Expr, shape (3,)
        exact
    omega : Expr
        [1/T]
    circle : tuple of Expr, shape (3,), or None
        along the axis about which k may be turned, (0, 0, 0) for any: a continuum of equilibria

    Examples
    --------
    >>> import gyrostat as gs
    >>> U = gs.general_potential(lambda k1, k2, k3: k1 + k2 + k3)
    >>> scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)), U)
    >>> found = gs.relative_equilibria(scene, {"omega": 2})
    >>> [(f"{float(r.k[0]):.4f}", r.decision.verdict.name) for r in found][:2]
    [('-0.1444', 'STABLE'), ('-0.1965', 'UNSTABLE')]
    """

    scene: System
    k: tuple[Expr, ...]
    omega: Expr
    circle: tuple[Expr, ...] | None = None

    @cached_property
    def point(self) -> tuple[Expr, ...]:
        """π = omega Ik and k, in the coordinates of the scene."""
        along = self.scene.body.tensor * Matrix(self.k)
        return (*(evaluate(self.omega * x, {}) for x in along), *self.k)

    @property
    def locus(self) -> str:
        """What it belongs to: "" for a point, else a circle or the sphere of equilibria, in words."""
        if self.circle is None:
            return ""
        return circle_in_words(self.circle) if any(self.circle) else "the whole sphere"

    @cached_property
    def equilibrium(self) -> Equilibrium:
        """The same as a claimed point, for a report."""
        return equilibrium(self.scene, self.point, label="permanent rotation")

    @cached_property
    def form(self) -> AmendedForm:
        """Trace and determinant of the second variation across k, p and q of λ⁴ + p λ² + q; exact."""
        return amended_form(*self._data, self.k, self.omega)

    @cached_property
    def _data(self) -> Data:
        return _data(self.scene, self.k)

    @cached_property
    def decision(self) -> Decision:
        """The verdict on the point itself."""
        trace, determinant, p, discriminant = self.signs
        if determinant == -1:
            return SADDLE
        if determinant == 1 and trace == 1:
            return LEAST
        if determinant == 1 and trace == -1 and (p == -1 or discriminant == -1):
            return LEAVES
        if determinant == 1 and trace == -1 and p == discriminant == 1:
            found = decide_window(self._motion)
            return Decision(Verdict.of(found.stable), found.notion, (), found.why, (), pointwise=True)
        return Report(self.equilibrium).verdict({})

    @property
    def _motion(self) -> LocalMotion:
        inertia, U = self.scene.body.inverse.tolist(), self.scene.potential
        assert U is not None
        rotor = self._data.rotor
        momentum = tuple(evaluate(x + l, {}) for x, l in zip(self.point, rotor))
        return LocalMotion(tuple(map(tuple, inertia)), tuple(rotor), self.k, momentum, U.expression,
                           lambda: (evaluate(self.form.p, {}), evaluate(self.form.q, {})))

    @cached_property
    def damped(self) -> Decision:
        """The verdict under internal damping."""
        trace, determinant, *_ = self.signs
        if not (determinant and trace) or not self._reached:
            return Report(self.equilibrium).verdict({}, damped=True)
        growing = 1 if determinant == -1 else 0 if trace == 1 else 2
        reason = f"{LOST}, {modes(growing)}" if growing else KEPT
        return Decision(Verdict.of(not growing), "secular", (), reason, (), growing=growing)

    @cached_property
    def signs(self) -> tuple[int | None, ...]:
        """Of trace, determinant, p and p² − 4q."""
        with own_precision(PRECISION):
            k = [ball(x, PRECISION) for x in self.k]
            inertia, rotor, gradient, curved = self._data
            rows = [[[ball(e, PRECISION) for e in row] for row in matrix] for matrix in (inertia, curved)]
            vectors = [[ball(e, PRECISION) for e in vector] for vector in (rotor, gradient)]
            enclosed = amended_form(rows[0], vectors[0], vectors[1], rows[1], k, ball(self.omega, PRECISION))
            p, q = enclosed.p, enclosed.q
            found = [_sign(x) for x in (enclosed.trace, enclosed.determinant, p, p**2 - 4 * q)]
        if None not in found:
            return tuple(found)
        exact = self.form.trace, self.form.determinant, self.form.p, self.form.p**2 - 4 * self.form.q
        return tuple(proved_sign(evaluate(x, {})) if sign is None else sign for sign, x in zip(found, exact))

    @property
    def _reached(self) -> bool:
        """Whether internal damping reaches every motion: M × k or ∇U × k does not vanish."""
        _, rotor, gradient, _ = self._data
        M = [x + l for x, l in zip(self.point, rotor)]
        return any(proved_sign(evaluate(x, {})) for x in (*cross(M, self.k), *cross(gradient, self.k)))


def heavy_rotations(scene: System, values: Mapping[str, Any]) -> list[HeavyRotation]:
    """Every one at a rate omega, on a level C1, or in a direction k1, k2, k3; as relative_equilibria says."""
    needed, asked = {s.name for s in names_of_scene(scene)}, {"omega", "C1", *map(str, DIRECTION)}
    if taken := sorted(needed & asked):
        raise ScopeError(f"the scene depends on {', '.join(taken)}, a name of the motion: rename it")
    numbers = exact_point(scene, values, needed | asked)
    if missing := sorted(needed - values.keys()):
        raise ValuesError(f"the scene needs {', '.join(missing)}: give a number for each")
    here = at_numbers(scene, {s: x for s, x in numbers.items() if s.name in needed})
    given = values.keys() & asked
    if given == {"omega"}:
        return sorted(_at_rate(here, numbers[OMEGA]), key=_place)
    if given == {"C1"}:
        return sorted(_on_level(here, numbers[C1]), key=_place)
    if given == set(map(str, DIRECTION)):
        return _in_direction(here, tuple(numbers[x] for x in DIRECTION))
    raise ValuesError(f"given were {', '.join(sorted(given)) or 'no names of the motion'}: give omega, the "
                      "rate about the vertical, or C1, the value of M·k, or k1, k2, k3, a direction")


def _data(scene: System, k: Sequence[Expr]) -> Data:
    U = scene.potential
    assert U is not None
    at = dict(zip(DIRECTION, k))
    slopes = U.gradient()
    rows = slopes, *(U.following(d) if d else (S.Zero,) * 3 for d in slopes)
    first, *second = ([evaluate(U.value(d), at) if d else S.Zero for d in row] for row in rows)
    return Data(scene.body.tensor.tolist(), list(scene.body.gyrostatic_momentum), first, second)


def _at_rate(scene: System, omega: Expr) -> Iterator[HeavyRotation]:
    """(omega² I − Q + sigma) k = c − omega l, where U = c·k + k·Qk/2; any other polynomial by elimination."""
    if degree_in_k(scene, "at a rate omega") > 2:
        yield from (HeavyRotation(scene, k, omega) for k in directions_at_rate(scene, omega))
        return
    linear, curved = _quadratic(scene)
    pencil = omega**2 * scene.body.tensor - curved + SIGMA * eye(3)
    vector = linear - omega * Matrix(scene.body.gyrostatic_momentum)
    for _, k, circle in points_on_sphere(pencil, vector, S.One, SIGMA):
        yield HeavyRotation(scene, k, omega, circle)


def _on_level(scene: System, level: Expr) -> list[HeavyRotation]:
    """By resultants where U = c·k + k·Qk/2 and they tell all rotations apart, else by elimination."""
    if degree_in_k(scene, "on a level of C1") < 3:
        linear, curved = _quadratic(scene)
        inertia, rotor = scene.body.tensor, Matrix(scene.body.gyrostatic_momentum)
        with contextlib.suppress(ScopeError):
            return [HeavyRotation(scene, k, omega, circle)
                    for omega, k, circle in rates_on_level(inertia, curved, linear, rotor, level)]
    return [HeavyRotation(scene, k, omega) for omega, k in rates_by_elimination(scene, level)]


def _quadratic(scene: System) -> tuple[Matrix, Matrix]:
    """c and Q of U = c·k + k·Qk/2."""
    _, _, linear, curved = _data(scene, (S.Zero,) * 3)
    return Matrix(linear), Matrix(curved)


def _in_direction(scene: System, k: tuple[Expr, ...]) -> list[HeavyRotation]:
    """Where omega² Ik × k + omega l × k = ∇U × k."""
    length = evaluate(Add(*(x**2 for x in k)), {})
    if proved_sign(length - 1) != 0:
        raise ValuesError(f"k = ({', '.join(map(str, k))}) has |k|² − 1 = {length - 1}: k is a direction, "
                          "|k| = 1; divide it by its length")
    inertia, rotor, gradient, _ = _data(scene, k)
    sides = zip(cross(scene.body.tensor * Matrix(k), k), cross(rotor, k), cross(gradient, k))
    residuals = [OMEGA**2 * a + OMEGA * b - c for a, b, c in sides]
    rates = [real_roots(residual, OMEGA) for residual in residuals]
    if not (proper := [found for found in rates if found is not None]):
        raise ValuesError("in that direction every rate omega is that of a permanent rotation: give omega "
                          "too, to Report.verdict")
    return [HeavyRotation(scene, k, omega) for omega in proper[0]
            if all(proved_sign(evaluate(r, {OMEGA: omega})) == 0 for r in residuals)]


def _place(rotation: HeavyRotation) -> list[float]:
    """From the upright one down."""
    k1, k2, k3 = (float(ball(x, PRECISION).mid()) for x in rotation.k)
    return [-k3, k1, k2]


def _sign(x: arb) -> int | None:
    return 1 if x > 0 else -1 if x < 0 else None
