"""The permanent rotations of a free body or gyrostat: every equilibrium on a momentum sphere."""
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

from flint import arb, arb_mat
from sympy import Add, Expr, ImmutableMatrix, Matrix, S, eye, sqrt

from ...algebra.enclosures.balls import ball
from ...algebra.enclosures.precision import own_precision
from ...algebra.reals.exact import proved_sign
from ...algebra.solving.pencils import points_on_sphere
from ...algebra.solving.roots import real_roots
from ...mechanics.scenes.body import Gyrostat
from ...mechanics.scenes.system import System, at_numbers
from ...notation import symbol
from ...stability.criteria.number_notes import inertia_note
from ...stability.theorems.momentum_sphere import extremum
from .free_rotation import ANYWHERE, AT_REST, EXTREMUM, SADDLE, PermanentRotation, on_circle
from .rate_level_tilt import LENGTH, numbers_of_rotations
from .rotors_in_rpm import without_pi

NU = symbol("nu")
PRECISION = 128                                            # bits that put the rotations in order

def rotations_at(scene: System, values: Mapping[str, Any]) -> list[PermanentRotation]:
    """Every permanent rotation of a scene without a field, at numbers for its names and M = abs(π + l)."""
    numbers = numbers_of_rotations(scene, values)
    return permanent_rotations(at_numbers(scene, numbers).body, numbers[LENGTH])


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
    >>> for rotation in permanent_rotations(Gyrostat((1, 2, 3), (0, 0, 0)), S.One)[::2]:
    ...     print(rotation.momentum, rotation.energy, rotation.decision.verdict.name)
    (0, 0, -1) 1/6 STABLE
    (0, -1, 0) 1/4 UNSTABLE
    (-1, 0, 0) 1/2 STABLE
    """
    note = inertia_note(body, {})
    found = _by_energy(body, radius)
    return [replace(r, decision=replace(r.decision, note=note)) for r in found] if note else found


def _by_energy(body: Gyrostat, radius: Expr) -> list[PermanentRotation]:
    """The same, without what is said of the body."""
    if proved_sign(radius) == 0:
        return [PermanentRotation(body, (S.Zero,) * 3, None, AT_REST)]
    if isinstance(body.inertia, ImmutableMatrix):
        inside, size, unit = without_pi(Matrix(body.gyrostatic_momentum), radius)
        found = [_rotation(body, nu, [unit * x for x in M], axis)
                 for nu, M, axis in points_on_sphere(eye(3) - NU * body.tensor, inside, size, NU)]
    else:
        found = list(_about_axes(body, radius))
    return [rotation for _, rotation in sorted(found, key=lambda pair: pair[0])]


def _about_axes(body: Gyrostat, radius: Expr) -> Iterator[tuple[list[float], PermanentRotation]]:
    """In principal axes."""
    inertia, rotor = body.moments, body.gyrostatic_momentum
    inside, size, _ = without_pi(Matrix(rotor), radius)
    secular = Add(*(l**2 / (1 - NU * moment) ** 2 for l, moment in zip(inside, inertia))) - size**2
    for nu in real_roots(secular, NU) or ():
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
        rotation = replace(rotation, circle=circle, decision=on_circle(circle))
    elif curvature.contains(0):
        sign = proved_sign(rotation.curvature)
        met = extremum(body, M, nu).decision if sign == 0 else EXTREMUM if sign == 1 else SADDLE
        rotation = replace(rotation, decision=met)
    return [float(x.mid()) for x in (energy, *m)], rotation
