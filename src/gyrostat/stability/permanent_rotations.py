"""The permanent rotations of a free body or gyrostat: every equilibrium on a momentum sphere."""
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from flint import arb, arb_mat
from sympy import Add, Expr, ImmutableMatrix, Matrix, Rational, S, eye, sqrt

from ..algebra.balls import ball
from ..algebra.exact import Point, proved_sign
from ..algebra.pencils import points_on_sphere
from ..algebra.precision import own_precision
from ..algebra.roots import real_roots
from ..errors import ValuesError
from ..kept import cached_property
from ..mechanics.body import Gyrostat
from ..mechanics.system import System, at_numbers, names_of_scene
from ..notation import Stored, symbol
from ..shown import Shown
from .asked import exact_point, refuse_as_level
from .decision import Decision, Verdict
from .rotors_in_rpm import explained, without_pi
from .secular import KEPT, LOST, modes
from .sphere import DRIFTS, circle_in_words, extremum
from .values import unknown

NU, LENGTH = symbol("nu"), symbol("M")
PRECISION = 128                                            # bits that put the rotations in order
EXTREMUM = Decision(Verdict.STABLE, "Lyapunov", (), "the energy is an extremum on the momentum sphere", ())
SADDLE = Decision(Verdict.UNSTABLE, "spectral", (), "the energy is a saddle on the momentum sphere: an "
                  "eigenvalue has a positive real part", ())
ON_CIRCLE = Decision(Verdict.UNSTABLE, "Lyapunov", (), DRIFTS, ())
ANYWHERE = Decision(Verdict.STABLE, "Lyapunov", (), "M stays where it is: all moments are equal, "
                    "and there is no rotor", ())
AT_REST = Decision(Verdict.STABLE, "Lyapunov", (), "M = 0 is the whole orbit", ())


@dataclass(frozen=True, repr=False)
class PermanentRotation(Shown, Stored):
    """A rotation about an axis fixed in the body and in space: M = I ω + l with ω = ν M.

    Parameters
    ----------
    body : Gyrostat
    momentum : tuple of Expr, shape (3,)
        M, exact [M L²/T]
    nu : Expr or None
        ν [1/(M L²)]; None where M = 0
    decision : Decision
    circle : tuple of Expr, shape (3,), or None
        along the axis about which the point may be turned: a circle of equilibria
    sphere : bool
        whether every point of the momentum sphere is an equilibrium

    Examples
    --------
    >>> import gyrostat as gs
    >>> box = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)))
    >>> rotation = gs.relative_equilibria(box, {"M": 1})[2]
    >>> rotation.momentum, rotation.energy, rotation.decision.verdict.name, rotation.growth_rate
    ((0, -1, 0), 1/4, 'UNSTABLE', sqrt(3)/6)
    """

    body: Gyrostat
    momentum: tuple[Expr, ...]
    nu: Expr | None
    decision: Decision
    circle: tuple[Expr, ...] | None = None
    sphere: bool = False

    @cached_property
    def energy(self) -> Expr:
        """½ Σ (M − l)²/I [M L²/T²]."""
        body = self.body
        pi = [m - l for m, l in zip(self.momentum, body.gyrostatic_momentum)]
        if isinstance(body.inertia, ImmutableMatrix):
            return body.kinetic_energy(pi)
        rates = [p / moment for p, moment in zip(pi, body.moments)]
        return Add(*(Rational(1, 2) * moment * rate**2 for moment, rate in zip(body.moments, rates)))

    @cached_property
    def curvature(self) -> Expr:
        """Δ = M·adj(I⁻¹ − ν) M [1/T²]: the eigenvalues are ±√−Δ.

        In principal axes M₁² d₂ d₃ + M₂² d₃ d₁ + M₃² d₁ d₂ with dᵢ = 1/Iᵢ − ν.
        """
        if self.nu is None or self.decision not in (EXTREMUM, SADDLE):
            return S.Zero
        if isinstance(self.body.inertia, ImmutableMatrix):
            M = Matrix(self.momentum)
            return M.dot((self.body.inverse - self.nu * eye(3)).adjugate() * M)
        d = [1 / moment - self.nu for moment in self.body.moments]
        return Add(*(m**2 * d[n - 1] * d[n - 2] for n, m in enumerate(self.momentum)))

    @cached_property
    def damped(self) -> Decision:
        """The verdict under internal damping, which keeps M; of a circle, modulo the turns about its axis."""
        if self.nu is None or self.sphere:
            return replace(self.decision, notion="secular", growing=0)
        if self.decision not in (EXTREMUM, SADDLE, ON_CIRCLE):
            sign, why = extremum(self.body, self.momentum, self.nu)
            return _damped(sign if sign is None else sign == 1, why, 0 if sign == 1 else None)
        M, D = Matrix(self.momentum), self.body.inverse - self.nu * eye(3)
        rising = proved_sign(D.trace() * M.dot(M) - M.dot(D * M)) == 1
        growing = 1 if self.decision == SADDLE else 0 if rising else 1 if self.circle else 2
        along = Add(*(x * symbol(f"pi{n}") for n, x in enumerate(self.circle or (), 1)))
        return replace(_damped(not growing, "" if rising else modes(growing), growing),
                       modulo=(along,) if self.circle else ())

    @property
    def locus(self) -> str:
        """What it belongs to: "" for a point, else a circle or the sphere of equilibria, in words."""
        if self.sphere:
            return "the whole sphere"
        return "" if self.circle is None else circle_in_words(self.circle)

    @property
    def frequency(self) -> Expr | None:
        """√Δ, of the small motions of M about it in the body [1/T]; None where there are none."""
        return sqrt(self.curvature) if proved_sign(self.curvature) == 1 else None

    @property
    def growth_rate(self) -> Expr | None:
        """√−Δ, of the mode that leaves [1/T]; None where there is none."""
        return sqrt(-self.curvature) if proved_sign(self.curvature) == -1 else None


def rotations_at(scene: System, values: Mapping[str, Any]) -> list[PermanentRotation]:
    """Every permanent rotation of a scene without a field, at numbers for its names and M = abs(π + l)."""
    numbers = numbers_of_rotations(scene, values)
    return permanent_rotations(at_numbers(scene, numbers).body, numbers[LENGTH])


def numbers_of_rotations(scene: System, values: Mapping[str, Any], free: str | None = None) -> Point:
    """The values as exact numbers, one for every name of a scene without a field and for M, but for one that
    is free.
    """
    needed = {s.name for s in names_of_scene(scene)}
    refuse_as_level(scene, LENGTH.name)
    needed |= {LENGTH.name}
    if free is not None and free not in needed:
        raise ValuesError(unknown(free, sorted(needed), "the scene"))
    numbers = exact_point(scene, values, needed)
    if free is not None and free in values:
        raise ValuesError(f"{free} is free, and has the value {values[free]} too: leave out one of the two")
    if missing := sorted(needed - values.keys() - {free}):
        raise ValuesError(f"the permanent rotations need {', '.join(missing)}: give a number for each; M is "
                          "the length of the angular momentum Iω + l")
    if LENGTH in numbers and proved_sign(numbers[LENGTH]) not in ((0, 1) if free is None else (1,)):
        raise ValuesError(f"M = {numbers[LENGTH]} is not the radius of a momentum sphere: give a number that "
                          f"is {'not negative' if free is None else 'positive'}")
    return numbers


def permanent_rotations(body: Gyrostat, radius: Expr) -> list[PermanentRotation]:
    """Every equilibrium of a free gyrostat on abs(M) = radius, at numbers; complete, by energy.

    M (1 − ν I) = l: ν is a root of Σ l²/(1 − ν I)² = abs(M)², or 1/I of axes without a rotor. Δ > 0: the
    energy is an extremum, hence the rotation stable; Δ < 0: a saddle, hence it is not. Δ = 0: the energy is
    an extremum where Mᵢ = 0 = dᵢ and dⱼ dₖ > 0 for some i (three rotations meet), or about the axis of a
    body of revolution that carries l; else it is not.

    Parameters
    ----------
    body : Gyrostat
        with its numbers
    radius : Expr
        not negative

    References
    ----------
    Hughes, Spacecraft Attitude Dynamics (1986), chapter 6; where rotations meet, derived.

    Examples
    --------
    >>> for rotation in permanent_rotations(Gyrostat((1, 2, 3), (0, 0, 0)), Rational(1))[::2]:
    ...     print(rotation.momentum, rotation.energy, rotation.decision.verdict.name)
    (0, 0, -1) 1/6 STABLE
    (0, -1, 0) 1/4 UNSTABLE
    (-1, 0, 0) 1/2 STABLE
    """
    if proved_sign(radius) == 0:
        return [PermanentRotation(body, (S.Zero,) * 3, None, AT_REST)]
    if isinstance(body.inertia, ImmutableMatrix):
        inside, size, unit = without_pi(Matrix(body.gyrostatic_momentum), radius)
        points = explained(lambda: list(points_on_sphere(eye(3) - NU * body.tensor, inside, size, NU)), body,
                           radius)
        found = [_rotation(body, nu, [unit * x for x in M], axis) for nu, M, axis in points]
    else:
        found = list(_about_axes(body, radius))
    return [rotation for _, rotation in sorted(found, key=lambda pair: pair[0])]


def _about_axes(body: Gyrostat, radius: Expr) -> Iterator[tuple[list[float], PermanentRotation]]:
    """In principal axes."""
    inertia, rotor = body.moments, body.gyrostatic_momentum
    inside, size, _ = without_pi(Matrix(rotor), radius)
    secular = Add(*(l**2 / (1 - NU * moment) ** 2 for l, moment in zip(inside, inertia))) - size**2
    for nu in explained(lambda: real_roots(secular, NU), body, radius) or ():
        M = [l / (1 - nu * moment) if l else S.Zero for l, moment in zip(rotor, inertia)]
        yield _rotation(body, nu, M, None)
    for moment in dict.fromkeys(inertia):
        axes = [n for n in range(3) if inertia[n] == moment]
        if any(rotor[n] for n in axes):
            continue
        M = [S.Zero if n in axes else rotor[n] / (1 - inertia[n] / moment) for n in range(3)]
        rest = radius**2 - Add(*(m**2 for m in M))
        if proved_sign(rest) != 1:
            continue
        about = tuple(S.Zero if n in axes else S.One for n in range(3)) if len(axes) > 1 else None
        for side in (1, -1) if about is None else (1,):
            M[axes[0]] = side * sqrt(rest)
            yield _rotation(body, 1 / moment, M, about)


def _rotation(body: Gyrostat, nu: Expr, M: Sequence[Expr],
              circle: tuple[Expr, ...] | None) -> tuple[list[float], PermanentRotation]:
    """The rotation at M, with its place in the order; the axis about which it may be turned, 0 for any."""
    with own_precision(PRECISION):
        inverse = [[ball(e, PRECISION) for e in row] for row in body.inverse.tolist()]
        m, rotor = ([ball(e, PRECISION) for e in vector] for vector in (M, body.gyrostatic_momentum))
        pi, slope = [x - y for x, y in zip(m, rotor)], ball(nu, PRECISION)
        energy = sum((x * inverse[i][j] * y for i, x in enumerate(pi) for j, y in enumerate(pi)), arb(0)) / 2
        D = arb_mat([[x - slope * (i == j) for j, x in enumerate(row)] for i, row in enumerate(inverse)])
        # adj(D) M·M = det(M Mᵀ + D) − det D
        curvature = (D + arb_mat([[x * y for y in m] for x in m])).det() - D.det()
    rotation = PermanentRotation(body, tuple(M), nu, EXTREMUM if curvature > 0 else SADDLE)
    if circle and not any(circle):
        rotation = replace(rotation, decision=ANYWHERE, sphere=True)
    elif circle:
        rotation = replace(rotation, decision=ON_CIRCLE, circle=circle)
    elif curvature.contains(0):
        sign = proved_sign(rotation.curvature)
        met = _degenerate(body, M, nu) if sign == 0 else EXTREMUM if sign == 1 else SADDLE
        rotation = replace(rotation, decision=met)
    return [float(x.mid()) for x in (energy, *m)], rotation


def _damped(stable: bool | None, why: str, growing: int | None) -> Decision:
    reason = why if stable is None else f"{KEPT if stable else LOST}{why and f': {why}'}"
    return Decision(Verdict.of(stable), "" if stable is None else "secular", (), reason, (), growing=growing)


def _degenerate(body: Gyrostat, M: Sequence[Expr], nu: Expr) -> Decision:
    """Δ = 0."""
    found, why = extremum(body, M, nu)
    stable = found if found is None else found != 0
    return Decision(Verdict.of(stable), "" if stable is None else "Lyapunov", (), why, ())
