"""The permanent rotations of a free gyrostat over a range of a name, as pieces of one verdict."""
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from typing import Any

import numpy as np
from sympy import Expr, Rational

from ...algebra.enclosures.balls import ball, fraction_of
from ...algebra.enclosures.floats import Array
from ...algebra.reals.exact import Point, evaluate, proved_sign
from ...algebra.solving.plane_curves import PlaneCurve
from ...algebra.solving.roots import in_order
from ...algebra.solving.stations import between
from ...errors import ValuesError
from ...mechanics.scenes.body import Gyrostat
from ...mechanics.scenes.system import System, assemble, at_numbers
from ...notation import symbol
from ...stability.decision import Verdict
from ..finders.free import rotations_on_sphere
from ..finders.free_form import FreeForm
from ..finders.rate_level_tilt import LENGTH, numbers_of_rotations
from ..relative_equilibrium import RelativeEquilibrium
from .free_meetings import body_at, rotation_curve
from .meeting_values import BifurcationPoint, bifurcation_points
from .stations_at_rate import admissible, within

# between two stations, closer together at both; how near the first and the last are to them
NODES, NEAR = 48, 2**30
PRECISION = 128                                            # bits


@dataclass(frozen=True, eq=False)
class RotationPiece:
    """Permanent rotations over part of a range, of one verdict.

    Parameters
    ----------
    parameter, nu : arrays, shape (n,)
        ω = ν M
    momentum : array, shape (n, 3)
        M; of a circle of rotations one of them
    verdict : Verdict
        exact, between its ends
    """

    parameter: Array
    nu: Array
    momentum: Array
    verdict: Verdict


@dataclass(frozen=True, eq=False)
class RotationContinuation:
    """Permanent rotations over a range of one name, and where they meet.

    Parameters
    ----------
    pieces : list of RotationPiece
        none goes on through a value where two values of ν are one
    marks : list of BifurcationPoint

    Examples
    --------
    >>> import gyrostat as gs
    >>> spun_up = gs.assemble(gs.Gyrostat((1, 2, 3), ("1/20", "1/10", gs.symbol("l3"))))
    >>> found = gs.continuation(spun_up, "l3", (0, 1), {"M": 1})
    >>> [(mark.kind, round(float(mark.value), 4)) for mark in found.marks]
    [('fold', 0.2036)]
    >>> [piece.verdict.name for piece in found.pieces if piece.parameter[-1] == 1]
    ['STABLE', 'UNSTABLE', 'STABLE', 'STABLE']
    """

    pieces: list[RotationPiece]
    marks: list[BifurcationPoint]


def followed_rotations(scene: System, name: str, low: Expr, high: Expr,
                       values: Mapping[str, Any]) -> RotationContinuation:
    """Every rotation over a range, cut where two values of ν meet.

    Between two such values the values of ν are simple and in a fixed order, and no Δ vanishes.
    """
    numbers, free = numbers_of_rotations(scene, values, name), symbol(name)
    body, radius = at_numbers(scene, numbers).body, numbers.get(LENGTH, LENGTH)
    if free == LENGTH and proved_sign(low) != 1:
        raise ValuesError(f"M goes from {low} to {high}, and is the length of the momentum: give a range in "
                          "which it is positive")
    admissible(body.positive, numbers, free, low, high)
    curve = rotation_curve(body, radius, free)
    inner = {t for t, _ in curve.double if within(t, low, high)} - {low, high}
    pieces = [piece for a, b in pairwise([low, *in_order(list(inner)), high])
              for piece in _between(curve, body, radius, a, b)]
    return RotationContinuation(pieces, [point for point in bifurcation_points(scene, name, values)
                                         if within(point.value, low, high)])


def _between(curve: PlaneCurve, body: Gyrostat, radius: Expr, a: Expr, b: Expr) -> Iterator[RotationPiece]:
    """The rotations between two stations: exact at a fraction, from there on in the order of ν."""
    middle, nodes = between(a, b), _nodes(a, b)
    here = curve.roots(middle)
    samples = [_sample(curve, body, radius, t, len(here)) for t in nodes]
    parameter = np.array([float(a), *map(float, nodes[1:-1]), float(b)])
    groups: dict[int, list[FreeForm]] = {}
    at = Point({curve.t: Rational(middle.numerator, middle.denominator)})
    for rotation in rotations_on_sphere(assemble(body_at(body, at)), evaluate(radius, at)):
        apart = [abs(root - ball(rotation.nu, PRECISION)) for root in here]
        groups.setdefault(min(range(len(here)), key=lambda n: float(apart[n].mid())), []).append(rotation)
    for n, rotations in groups.items():
        about = rotations[0].circle
        at_pole = len(rotations) - 1 if about is None else 2 if any(about) else 3
        nu, momenta = np.array([sample.nu[n] for sample in samples]), _momenta(samples, n, at_pole)
        for rotation, M in zip(rotations, momenta):
            yield RotationPiece(parameter, nu, M, RelativeEquilibrium(rotation).decision.verdict)


@dataclass(frozen=True)
class _Sample:
    """The body at a node, in doubles, and every ν of the curve."""

    inertia: Array
    rotor: Array
    radius: float
    nu: list[float]


def _sample(curve: PlaneCurve, body: Gyrostat, radius: Expr, t: Fraction, count: int) -> _Sample:
    at = Point({curve.t: Rational(t.numerator, t.denominator)})
    here = body_at(body, at)
    return _Sample(np.array(here.tensor.tolist(), float), np.array(here.gyrostatic_momentum, float),
                   float(evaluate(radius, at)), [float(root.mid()) for root in curve.roots(t, count)])


def _momenta(samples: Sequence[_Sample], n: int, at_pole: int) -> list[Array]:
    """M along the n-th ν; where that is a pole, up to three times, M on either side of what is across it."""
    found, along = [], np.zeros(3)
    for sample in samples:
        turned = np.eye(3) - sample.nu[n] * sample.inertia
        if not at_pole:
            found.append([np.linalg.solve(turned, sample.rotor)])
            continue
        sizes, axes = np.linalg.eigh(turned)
        kernel = np.argsort(abs(sizes))[:at_pole]
        others = np.delete(np.arange(3), kernel)
        across = axes[:, others] @ (axes[:, others].T @ sample.rotor / sizes[others])
        inside = axes[:, kernel]
        along = inside @ (inside.T @ along) if along.any() else inside[:, 0]
        along = along / np.linalg.norm(along)
        high = np.sqrt(max(sample.radius**2 - across @ across, 0.0)) * along
        found.append([across + high, across - high])
    return list(np.moveaxis(np.array(found), 1, 0))


def _nodes(a: Expr, b: Expr) -> list[Fraction]:
    """Fractions between two numbers, the first and the last beside them."""
    low, high = (fraction_of(ball(t, PRECISION).mid()) for t in (a, b))
    parts = (1 - np.cos(np.pi * np.arange(1, NODES) / NODES)) / 2
    inside = [Fraction(1, NEAR), *map(Fraction, parts.tolist()), 1 - Fraction(1, NEAR)]
    return [Fraction(round((low + (high - low) * part) * NEAR**2), NEAR**2) for part in inside]
