"""Follows level curves of the energy of a free gyrostat on the momentum sphere, by its exact motion."""
from collections.abc import Sequence
from itertools import pairwise
from typing import cast

import numpy as np
from sympy import Expr, ImmutableMatrix

from ..algebra.enclosures.floats import Array, in_floats
from ..equilibria.finders.free import energy_and_momentum
from ..equilibria.finders.free_form import FreeForm
from ..equilibria.relative_equilibrium import RelativeEquilibrium
from ..mechanics.scenes.body import Gyrostat
from ..mechanics.scenes.system import System, assemble
from ..stability.decision import Verdict
from ..trajectories import motion
from .globe import refined

# of a turn at first; the longest chord; of halving, and of Newton's method
TIMES, STEP, STEPS = 128, 0.03, 40
# of the range of energies: how far below a saddle its curve is followed; where rotations meet M passes slower
SHIFT, FLAT = 1e-12, 1e-8


def floats(numbers: Sequence[Expr]) -> Array:
    """Return exact numbers in doubles."""
    return np.array([float(in_floats(number, np, {})) for number in numbers])


def energies_between(body: Gyrostat, points: Sequence[RelativeEquilibrium], count: int) -> Array:
    """Choose energies for level curves, so many in each band between two critical energies.

    Along the shortest arc from an equilibrium at one end of the band to one at the other, the curves are at
    equal distances on the sphere.
    """
    inverse, rotor = inverse_of(body), floats(body.gyrostatic_momentum)
    levels: dict[float, list[RelativeEquilibrium]] = {}
    for point in points:
        levels.setdefault(level_of(point), []).append(point)
    part, found = np.arange(1, count + 1) / (count + 1), []
    for low, high in pairwise(sorted(levels)):
        start, end = min(((place(p), _nearest(q, place(p)))
                          for p in levels[low] for q in levels[high]), key=lambda ends: -ends[0] @ ends[1])
        turn = part[:, None] * np.arccos(np.clip(start @ end / (start @ start), -1, 1))
        arc = np.cos(turn) * start + np.sin(turn) * np.cross(_normal(start, end), start)
        energies = energy_of(arc - rotor, inverse)
        rising = bool((np.diff([low, *energies, high]) > 0).all())     # an arc may leave the band
        found.append(energies if rising else low + (high - low) * part)
    return np.concatenate(found) if found else np.empty(0)


def level_of(point: RelativeEquilibrium) -> float:
    """Return the energy of a rotation of a free body in doubles."""
    return energy_and_momentum(cast(FreeForm, point.form))[0]


def place(point: RelativeEquilibrium) -> Array:
    """Return its momentum M in doubles."""
    return np.array(energy_and_momentum(cast(FreeForm, point.form))[1:])


def inverse_of(body: Gyrostat) -> Array:
    """Return the inverse I⁻¹ of the tensor in doubles, shape (3, 3)."""
    return np.array([floats(row) for row in body.inverse.tolist()])


def energy_of(pi: Array, inverse: Array) -> Array:
    """Return the energies of momenta, shape (n, 3)."""
    return np.asarray(((pi @ inverse) * pi).sum(axis=-1) / 2)


def _nearest(point: RelativeEquilibrium, to: Array) -> Array:
    """Return the equilibrium; for a circle of equilibria the one that is nearest to another point."""
    at = place(point)
    if point.form.circle is None:
        return at
    axis = floats(point.form.circle)
    aside = to - to @ axis * axis
    if not aside.any():
        return at
    height = at @ axis * axis
    return height + np.linalg.norm(at - height) / np.linalg.norm(aside) * aside


def level_curve(body: Gyrostat, points: Sequence[RelativeEquilibrium], radius: float, energy: float) -> Array:
    """The curve of an energy on the momentum sphere, shape (n, 3), NaN between its pieces, each of which ends
    where it begins.

    Every piece has an extremum of the energy on either side: those on the great circles between the extrema
    are all. Each is followed by the motion of the gyrostat over a turn, so that none is jumped to from
    another. The curve through a saddle is the limit of those below.

    Parameters
    ----------
    body : Gyrostat
        with its numbers
    points : of relative_equilibria
    radius, energy : float

    Examples
    --------
    >>> import gyrostat as gs
    >>> body = gs.Gyrostat((1, 2, 3), (0, 0, 0))
    >>> M = level_curve(body, gs.relative_equilibria(gs.assemble(body), {"M": 1}), 1.0, 0.3)
    >>> bool(np.nanmax(abs((M**2 / [1, 2, 3]).sum(axis=1) / 2 - 0.3)) < 1e-15), int(np.isnan(M[:, 0]).sum())
    (True, 1)
    """
    inverse, rotor = inverse_of(body), floats(body.gyrostatic_momentum)
    scene, turn = _standard(body)
    values = [level_of(point) for point in points]
    near = SHIFT * (max(values) - min(values))
    isolated = [(point, value) for point, value in zip(points, values) if point.form.circle is None]
    passed = [point for point, value in isolated
              if point.decision.verdict is Verdict.UNSTABLE and abs(value - energy) <= near]
    if any(point.form.signs[-1] == 0 for point in passed):
        near *= FLAT / SHIFT
    around = [place(point) for point, _ in isolated
              if point.decision.verdict is not Verdict.UNSTABLE]
    left = [(normal, seed) for other in around[1:]
            for normal, seeds in [_on_arc(around[0], other, inverse, rotor,
                                          energy - near if passed else energy)] for seed in seeds]
    pieces: list[Array] = []
    while left:
        curve = _turn(scene, turn @ left[0][1], turn @ rotor, radius) @ turn
        left = [(normal, seed) for normal, seed in left[1:]
                if not _meets(curve, normal, seed, [x for n, x in left if n is normal])]
        pieces += [_onto_level(curve, inverse, rotor, energy) if passed else curve, np.full((1, 3), np.nan)]
    return np.concatenate(pieces[:-1]) if pieces else np.empty((0, 3))


def in_principal_axes(body: Gyrostat) -> tuple[Array, Array]:
    """Return the moments of a tensor, increasing, and the rotation R to its principal axes, in doubles."""
    moments, axes = np.linalg.eigh(np.array([floats(row) for row in body.tensor.tolist()]))
    return moments, axes.T * np.linalg.det(axes)


def _standard(body: Gyrostat) -> tuple[System, Array]:
    """Return the scene in principal axes, those of a tensor in doubles, and the rotation to them."""
    if not isinstance(body.inertia, ImmutableMatrix):
        return assemble(body), np.eye(3)
    moments, R = in_principal_axes(body)
    return assemble(Gyrostat(moments.tolist(), (R @ floats(body.gyrostatic_momentum)).tolist())), R


def _normal(start: Array, end: Array) -> Array:
    """Return the normal of the great circle through two points; if they are opposite, of any such circle."""
    aside = np.cross(start, end)
    if np.linalg.norm(aside) < 1e-9 * (start @ start):
        aside = np.cross(start, np.eye(3)[np.argmin(np.abs(start))])
    return aside / np.linalg.norm(aside)


def _on_arc(start: Array, end: Array, inverse: Array, rotor: Array,
            energy: float) -> tuple[Array, list[Array]]:
    """Return the normal of the great circle from one point to another, and its points at an energy."""
    normal = _normal(start, end)
    ahead = np.cross(normal, start)
    length = np.arctan2(end @ ahead, end @ start) % (2 * np.pi)

    def point(s: Array) -> Array:
        return np.cos(s)[..., None] * start + np.sin(s)[..., None] * ahead

    def excess(s: Array) -> Array:
        return energy_of(point(s) - rotor, inverse) - energy

    # h = Re(first e^{is} + second e^{2is}) + const
    first = -start @ inverse @ rotor + 1j * (ahead @ inverse @ rotor)
    second = (start @ inverse @ start - ahead @ inverse @ ahead) / 4 - 0.5j * (start @ inverse @ ahead)
    turns = np.angle(np.roots(np.array([2 * second, first, 0, -np.conj(first),
                                        -2 * np.conj(second)]))) % (2 * np.pi)
    cuts = np.unique(np.concatenate([[0.0], turns[turns < length], [length]]))
    low, high = cuts[:-1], cuts[1:]
    signs = np.sign(excess(low))
    low, high, signs = (x[signs * np.sign(excess(high)) < 0] for x in (low, high, signs))
    for _ in range(STEPS + 15):                            # h is monotone between its turns
        middle = (low + high) / 2
        below = np.sign(excess(middle)) == signs
        low, high = np.where(below, middle, low), np.where(below, high, middle)
    return normal, list(point((low + high) / 2))


def _turn(scene: System, seed: Array, rotor: Array, radius: float) -> Array:
    """A turn of M from a point on, closed, at times so close that no chord is longer than STEP of the radius.
    """
    moved = motion(scene, tuple(seed - rotor))
    if not moved.period:
        return seed[None]
    times = np.linspace(0, moved.period, TIMES + 1)
    M = refined(lambda t: moved(t) + rotor, times, moved(times) + rotor, STEP * radius, STEPS)
    M[-1] = M[0]
    return M


def _meets(curve: Array, normal: Array, seed: Array, seeds: Sequence[Array]) -> bool:
    """Whether a closed curve passes through a point of an arc.

    It crosses the plane there, and nearer to it than to the other points.
    """
    height = curve @ normal
    at = np.flatnonzero(height[:-1] * height[1:] <= 0)
    if not len(at):
        return False
    part = np.divide(height[at], height[at] - height[at + 1], out=np.zeros(len(at)),
                     where=height[at] != height[at + 1])[:, None]
    crossings = curve[at] + part * (curve[at + 1] - curve[at])
    off = np.linalg.norm(crossings - seed, axis=1).min()
    apart = min((np.linalg.norm(seed - other) for other in seeds if other is not seed), default=np.inf)
    return bool(off < min(apart / 4, STEP * np.linalg.norm(seed)))


def _onto_level(M: Array, inverse: Array, rotor: Array, energy: float) -> Array:
    """Points next to a level moved along the gradient on the sphere.

    Where the gradient vanishes there is no step.
    """
    radius = np.linalg.norm(M[0])
    for _ in range(STEPS):
        rates = (M - rotor) @ inverse
        slope = rates - (rates * M).sum(axis=1, keepdims=True) * M / radius**2
        excess = energy - ((M - rotor) * rates).sum(axis=1, keepdims=True) / 2
        square = (slope**2).sum(axis=1, keepdims=True)
        step = np.divide(excess * slope, square, out=np.zeros_like(M), where=square > 0)
        M = M + step / np.maximum(1, np.linalg.norm(step, axis=1, keepdims=True) / (STEP * radius))
        M = M * (radius / np.linalg.norm(M, axis=1, keepdims=True))
    return M
