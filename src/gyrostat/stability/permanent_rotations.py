"""The permanent rotations of a free body or gyrostat: every equilibrium on a momentum sphere."""
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from sympy import Add, Expr, Mul, Rational, S, sqrt

from ..algebra.exact import proved_sign
from ..algebra.roots import real_roots
from ..errors import ScopeError, ValuesError
from ..mechanics.body import Gyrostat
from ..mechanics.principal import principal_rotation
from ..mechanics.system import System, assemble, at_numbers, names_of_scene
from ..notation import Stored, symbol
from ..shown import Shown
from .analysis import analyze
from .asked import exact_point
from .decision import Decision, Verdict
from .sphere import DRIFTS

MU, LENGTH = symbol("mu"), symbol("M")
EXTREMUM = Decision(Verdict.STABLE, "Lyapunov", (), "the energy is an extremum on the momentum sphere", ())
SADDLE = Decision(Verdict.UNSTABLE, "spectral", (), "the energy is a saddle on the momentum sphere: an "
                  "eigenvalue has a positive real part", ())
ON_CIRCLE = Decision(Verdict.UNSTABLE, "Lyapunov", (), DRIFTS, ())
OPEN = Decision(Verdict.UNDECIDED, "", (), "the second variation is degenerate, and the axis is no principal "
                "one that carries l", ())


@dataclass(frozen=True, repr=False)
class PermanentRotation(Shown, Stored):
    """A rotation about an axis fixed in the body and in space: M = I ω + l with ω = μ M.

    Parameters
    ----------
    momentum : tuple of Expr, shape (3,)
        M, exact [M L²/T]
    energy : Expr
        [M L²/T²]
    decision : Decision
    circle : int or None
        the axis about which the point may be turned: a circle of equilibria

    Examples
    --------
    >>> import gyrostat as gs
    >>> box = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)))
    >>> rotation = gs.relative_equilibria(box, {"M": 1})[0]
    >>> rotation.momentum, rotation.energy, rotation.decision.verdict.name
    ((0, 0, -1), 1/6, 'STABLE')
    """

    momentum: tuple[Expr, ...]
    energy: Expr
    decision: Decision
    circle: int | None = None


def rotations_at(scene: System, values: Mapping[str, Any]) -> list[PermanentRotation]:
    """Every permanent rotation of a scene without a field, at numbers for its names and M = abs(π + l)."""
    needed = {s.name for s in names_of_scene(scene)}
    if LENGTH.name in needed:
        raise ScopeError("the body depends on M, which is the length of the momentum here: rename it")
    numbers = exact_point(scene, values, needed | {LENGTH.name})
    if missing := sorted((needed | {LENGTH.name}) - values.keys()):
        raise ValuesError(f"the permanent rotations need {', '.join(missing)}: give a number for each; M is "
                          "the length of π + l")
    if proved_sign(numbers[LENGTH]) != 1:
        raise ValuesError(f"M = {numbers[LENGTH]} is not the radius of a momentum sphere: give a positive "
                          "number")
    return permanent_rotations(at_numbers(scene, numbers).body, numbers[LENGTH])


def permanent_rotations(body: Gyrostat, radius: Expr) -> list[PermanentRotation]:
    """Every equilibrium of a free gyrostat on abs(M) = radius, at numbers; complete, by energy.

    M (1 − μ I) = l: μ is a root of Σ l²/(1 − μ I)² = abs(M)², or 1/I of an axis without a rotor. The energy
    is an extremum, hence the point stable, or a saddle, hence it is not, as Σ Mᵢ² (1/Iⱼ − μ) (1/Iₖ − μ) is
    positive or negative. Where it is 0, Report.verdict decides the rotations about principal axes.

    Parameters
    ----------
    body : Gyrostat
        with its numbers
    radius : Expr
        positive

    Raises
    ------
    ScopeError
        all moments are equal and l = 0: every point is an equilibrium

    References
    ----------
    Hughes, Spacecraft Attitude Dynamics (1986), chapter 6; else derived.

    Examples
    --------
    >>> for rotation in permanent_rotations(Gyrostat((1, 2, 3), (0, 0, 0)), Rational(1))[::2]:
    ...     print(rotation.momentum, rotation.energy, rotation.decision.verdict.name)
    (0, 0, -1) 1/6 STABLE
    (0, -1, 0) 1/4 UNSTABLE
    (-1, 0, 0) 1/2 STABLE
    """
    inertia, rotor = body.inertia, body.gyrostatic_momentum
    if len(set(inertia)) == 1 and not any(rotor):
        raise ScopeError(f"inertia = {inertia} and l = 0: every point of the sphere is an equilibrium; "
                         "give different moments, or a rotor")
    secular = Add(*(l**2 / (1 - MU * moment) ** 2 for l, moment in zip(rotor, inertia))) - radius**2
    found = []
    for mu in real_roots(secular, MU) or ():
        M = [l / (1 - mu * moment) if l else S.Zero for l, moment in zip(rotor, inertia)]
        found.append(_rotation(body, mu, M))
    for moment in dict.fromkeys(inertia):
        axes = [n for n in range(3) if inertia[n] == moment]
        if any(rotor[n] for n in axes):
            continue
        M = [S.Zero if n in axes else rotor[n] / (1 - inertia[n] / moment) for n in range(3)]
        rest = radius**2 - Add(*(m**2 for m in M))
        if proved_sign(rest) != 1:
            continue
        for side in (1, -1)[:3 - len(axes)]:
            M[axes[0]] = side * sqrt(rest)
            found.append(_rotation(body, 1 / moment, M, 3 - sum(axes) if len(axes) == 2 else None))
    return sorted(found, key=lambda point: (float(point.energy), *map(float, point.momentum)))


def _rotation(body: Gyrostat, mu: Expr, M: Sequence[Expr], circle: int | None = None) -> PermanentRotation:
    rates = [(m - l) / moment for m, l, moment in zip(M, body.gyrostatic_momentum, body.inertia)]
    energy = Add(*(Rational(1, 2) * moment * rate**2 for moment, rate in zip(body.inertia, rates)))
    if circle is not None:
        return PermanentRotation(tuple(M), energy, ON_CIRCLE, circle)
    curvature = [1 / moment - mu for moment in body.inertia]
    sign = proved_sign(Add(*(Mul(M[n] ** 2, *(c for k, c in enumerate(curvature) if k != n))
                             for n in range(3))))
    if sign == 0:
        return PermanentRotation(tuple(M), energy, _degenerate(body, rates))
    return PermanentRotation(tuple(M), energy, EXTREMUM if sign == 1 else SADDLE)


def _degenerate(body: Gyrostat, rates: Sequence[Expr]) -> Decision:
    """Where the second variation is only semidefinite.

    The decision on a rotation about a principal axis that carries l.
    """
    axes = [n + 1 for n in range(3) if rates[n] or body.gyrostatic_momentum[n]]
    if len(axes) != 1:
        return OPEN
    report = analyze(principal_rotation(assemble(body), axes[0]))
    return report.verdict({f"omega{axes[0]}_0": rates[axes[0] - 1]})
