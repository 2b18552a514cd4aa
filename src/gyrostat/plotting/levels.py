"""The energy of a free gyrostat on the momentum sphere |M| = const: its critical points, and its level curves."""
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np
from sympy import Add, Expr, Mul, Rational, S, sqrt

from ..body import Gyrostat
from ..errors import ScopeError, optional
from ..exact import sign_of_constant
from ..families import principal_rotation
from ..grids import Array
from ..notation import symbol
from ..numeric import in_floats
from ..roots import real_roots
from ..stability import Verdict, analyze
from ..system import assemble

MU = symbol("mu")
CELLS, STEPS = 64, 40                                      # of a face of the cube; of Newton's method


@dataclass(frozen=True)
class RestPoint:
    """An equilibrium on the momentum sphere, M = I ω + l with ω = μ M.

    Parameters
    ----------
    momentum : tuple of Expr, shape (3,)      M, exact [M L²/T]
    energy : Expr                             [M L²/T²]
    verdict : Verdict
    circle : int or None                      the axis about which the point may be turned: a circle of equilibria
    """

    momentum: tuple[Expr, ...]
    energy: Expr
    verdict: Verdict
    circle: int | None = None


def rest_points(body: Gyrostat, radius: Expr) -> list[RestPoint]:
    """Every equilibrium of a free gyrostat on |M| = radius, at numbers; complete, by energy.

    M (1 − μ I) = l: μ is a root of Σ l²/(1 − μ I)² = |M|², or 1/I of an axis without a rotor. The energy is an extremum, hence the point
    stable, or a saddle, hence it is not, as Σ Mᵢ² (1/Iⱼ − μ) (1/Iₖ − μ) is positive or negative. Where it is 0, Report.verdict
    decides the rotations about principal axes.

    Parameters
    ----------
    body : Gyrostat
    radius : Expr       positive

    Raises
    ------
    ScopeError          all moments are equal and l = 0: every point is an equilibrium

    Examples
    --------
    >>> for point in rest_points(Gyrostat((1, 2, 3), (0, 0, 0)), Rational(1))[::2]:
    ...     print(point.momentum, point.energy, point.verdict.name)
    (0, 0, -1) 1/6 STABLE
    (0, -1, 0) 1/4 UNSTABLE
    (-1, 0, 0) 1/2 STABLE
    """
    inertia, rotor = body.inertia, body.gyrostatic_momentum
    if len(set(inertia)) == 1 and not any(rotor):
        raise ScopeError(f"inertia = {inertia} and l = 0: every point of the sphere is an equilibrium; give different moments, or a rotor")
    secular = Add(*(l**2 / (1 - MU * moment) ** 2 for l, moment in zip(rotor, inertia))) - radius**2
    found = [_point(body, mu, [l / (1 - mu * moment) if l else S.Zero for l, moment in zip(rotor, inertia)])
             for mu in real_roots(secular, MU) or ()]
    for moment in dict.fromkeys(inertia):
        axes = [n for n in range(3) if inertia[n] == moment]
        if any(rotor[n] for n in axes):
            continue
        M = [S.Zero if n in axes else rotor[n] / (1 - inertia[n] / moment) for n in range(3)]
        rest = radius**2 - Add(*(m**2 for m in M))
        if sign_of_constant(rest) != 1:
            continue
        for side in (1, -1)[:3 - len(axes)]:
            M[axes[0]] = side * sqrt(rest)
            found.append(_point(body, 1 / moment, M, 3 - sum(axes) if len(axes) == 2 else None))
    return sorted(found, key=lambda point: (float(point.energy), *map(float, point.momentum)))


def _point(body: Gyrostat, mu: Expr, M: Sequence[Expr], circle: int | None = None) -> RestPoint:
    rates = [(m - l) / moment for m, l, moment in zip(M, body.gyrostatic_momentum, body.inertia)]
    energy = Add(*(Rational(1, 2) * moment * rate**2 for moment, rate in zip(body.inertia, rates)))
    if circle is not None:                             # those beside the circle turn about its axis: they drift
        return RestPoint(tuple(M), energy, Verdict.UNSTABLE, circle)
    curvature = [1 / moment - mu for moment in body.inertia]
    sign = sign_of_constant(Add(*(Mul(M[n] ** 2, *(c for k, c in enumerate(curvature) if k != n)) for n in range(3))))
    return RestPoint(tuple(M), energy, {1: Verdict.STABLE, -1: Verdict.UNSTABLE}.get(sign or 0) or _degenerate(body, rates))


def _degenerate(body: Gyrostat, rates: Sequence[Expr]) -> Verdict:
    """Where the second variation is only semidefinite: the verdict on a rotation about a principal axis that carries l."""
    axes = [n for n in range(3) if rates[n] or body.gyrostatic_momentum[n]]
    if len(axes) != 1:
        return Verdict.UNDECIDED
    return analyze(principal_rotation(assemble(body), axes[0] + 1)).verdict({f"omega{axes[0] + 1}_0": rates[axes[0]]}).verdict


def floats(numbers: Sequence[Expr]) -> Array:
    """Exact numbers in doubles."""
    return np.array([float(in_floats(number, np, {})) for number in numbers])


def energies_between(points: Sequence[RestPoint], count: int) -> Array:
    """Energies for level curves: count in each band between the critical ones, closer together near a saddle."""
    levels = sorted({float(p.energy): p.verdict is Verdict.UNSTABLE and p.circle is None for p in points}.items())
    part = np.arange(1, count + 1) / (count + 1)
    ease = {(False, False): (1 - np.cos(np.pi * part)) / 2, (False, True): part**2, (True, False): 1 - (1 - part) ** 2,
            (True, True): part}
    return np.concatenate([low + (high - low) * ease[saddle, above] for (low, saddle), (high, above) in zip(levels, levels[1:])])


def level_curve(body: Gyrostat, radius: float, energy: float) -> Array:
    """The curve of an energy on the momentum sphere, shape (n, 3), NaN between its pieces.

    Marching squares on the six faces of a cube around the sphere, the points then moved along it onto the level by Newton's method.

    Examples
    --------
    >>> M = level_curve(Gyrostat((1, 2, 3), (0, 0, 0)), 1.0, 0.3)
    >>> bool(np.nanmax(abs((M**2 / [1, 2, 3]).sum(axis=1) / 2 - 0.3)) < 1e-15)
    True
    """
    contourpy = optional("contourpy", "plot")
    inertia, rotor = floats(body.inertia), floats(body.gyrostatic_momentum)
    angles = np.linspace(-np.pi / 4, np.pi / 4, CELLS + 1)
    across, up = np.meshgrid(angles, angles)
    pieces = []
    for axis, side in product(range(3), (1, -1)):
        face = _face(across, up, axis, side) * radius
        heights = ((face - rotor) ** 2 / inertia).sum(axis=-1) / 2
        for lines in contourpy.contour_generator(angles, angles, heights).lines(energy):
            pieces += [_onto_level(_face(lines[:, 0], lines[:, 1], axis, side) * radius, inertia, rotor, energy), np.full((1, 3), np.nan)]
    return np.concatenate(pieces[:-1]) if pieces else np.empty((0, 3))


def _face(u: Array, v: Array, axis: int, side: int) -> Array:
    """Directions through a face of the cube, shape (..., 3)."""
    point = np.empty((*u.shape, 3))
    point[..., axis], point[..., axis - 1], point[..., axis - 2] = side, np.tan(u), np.tan(v)
    return point / np.linalg.norm(point, axis=-1, keepdims=True)


def _onto_level(M: Array, inertia: Array, rotor: Array, energy: float) -> Array:
    """Points moved along the gradient on the sphere; a step is at most a cell, where the gradient vanishes there is none."""
    radius = np.linalg.norm(M[0])
    for _ in range(STEPS):
        rates = (M - rotor) / inertia
        slope = rates - (rates * M).sum(axis=1, keepdims=True) * M / radius**2
        excess = energy - ((M - rotor) * rates).sum(axis=1, keepdims=True) / 2
        square = (slope**2).sum(axis=1, keepdims=True)
        step = np.divide(excess * slope, square, out=np.zeros_like(M), where=square > 0)
        length = np.linalg.norm(step, axis=1, keepdims=True)
        M = M + step / np.maximum(1, length * CELLS / radius)
        M = M * (radius / np.linalg.norm(M, axis=1, keepdims=True))
    return M
