"""Holds a verdict against the motion: how far motions go that start close to an equilibrium."""
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from sympy import Expr, ImmutableMatrix, Rational

from ..algebra.enclosures.floats import doubles
from ..algebra.reals.exact import Point, evaluate, sign_of_constant
from ..algebra.text.numbers import exact_number
from ..arguments import checked
from ..errors import AccuracyError, ValuesError, brief
from ..mechanics.equilibrium.equilibrium import Equilibrium
from ..mechanics.equilibrium.standard_axes import seen_at
from ..mechanics.scenes.coupled import in_one_direction
from ..stability.criteria.numbers_asked import exact_values
from ..stability.criteria.truth import sign_at
from ..stability.decision import Decision, Verdict
from ..stability.report.analysis import analyze
from ..stability.report.report import Report
from ..stability.standing import Standing
from ..stability.theorems.boundary import Boundary
from .excursions import SLOW, TURNED, Distance, excursion
from .models import free_names, motion, with_numbers

SIZES = tuple(Rational(1, 10**d) for d in range(2, 9))
# generic directions: they are in no plane of symmetry, and rational
TURNS = tuple(ImmutableMatrix(v) / 60 for v in ([20, -24, 30], [26, 15, -20]))
CHANGES = tuple(ImmutableMatrix(v) / 60 for v in ([-15, 30, 24], [30, 12, -25]))
# relative distance at which 1/2, 1/3, 1/4, 1/6, … are told apart; slope of no power; slope of a definite form
CLOSE, FLAT, STEEP = 0.12, 0.05, 0.9


@dataclass(frozen=True)
class Confirmation:
    """Excursions from an equilibrium, against the size of the perturbation.

    Parameters
    ----------
    decision : Decision
    sizes : tuple of float
        the ε; k is turned and π moved by about ε
    excursions : tuple of float
        the largest distance from the equilibrium, modulo the flow that the decision names
    slope : float
        the slope of log excursion against log ε, at the three smallest ε
    expected : float or None
        the slope that the verdict implies: 1 if the second variation is definite, less on a stable boundary,
        0 if it is unstable; None if no theorem tells
    routes : tuple of str
        how the motions were found
    complete : bool
        whether every motion was followed over a whole orbit
    failure : str
        why a motion could not be followed, if one could not; the sizes end there

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> report = gs.analyze(gs.upright(top))
    >>> slow = {"I1": 1, "I3": 1, "l": 0, "m0": 1, "pi3_0": 1}
    >>> fallen = gs.trajectories.confirm(report, slow)
    >>> fallen.decision.verdict.name, fallen.expected, fallen.agrees
    ('UNSTABLE', 0.0, True)
    """

    decision: Decision
    sizes: tuple[float, ...]
    excursions: tuple[float, ...]
    slope: float
    expected: float | None
    routes: tuple[str, ...]
    complete: bool
    failure: str = ""

    @property
    def agrees(self) -> bool | None:
        """Whether the motions do what the verdict says.

        It is None if the verdict is undecided, or the sizes are too large, as they may be close to a
        boundary.
        """
        verdict = self.decision.verdict
        if verdict is Verdict.UNDECIDED or math.isnan(self.slope):
            return None
        if verdict is Verdict.UNSTABLE:
            if self.slope < FLAT:
                return True
            return False if self.slope > STEEP and not self.failure else None
        if self.slope < FLAT:
            return False
        return True if self.expected is None or abs(self.slope / self.expected - 1) < CLOSE else None

    @property
    def why(self) -> str:
        """Why agrees is None; "" if it is not."""
        if self.agrees is not None:
            return ""
        if self.decision.verdict is Verdict.UNDECIDED:
            return "the verdict is undecided"
        if self.failure:
            return self.failure
        return (f"the excursions go as the power {self.slope:.2f} of the perturbation, {self.expected} is "
                "expected for small ones: the equilibrium is too close to a boundary for these sizes, give "
                "smaller ones")


@checked
def confirm(report: Report, values: Mapping[str, Any], sizes: Sequence[Any] = SIZES) -> Confirmation:
    """Follow motions that start close to an equilibrium, and compare how far they go with the verdict.

    They start in two generic directions, with both signs; only abs(k) is kept. A motion with a period, as
    that of a body of revolution in U(k3) or of a free body, is followed over it, which is the whole orbit
    modulo the spin; any other over 20 turns of the linearised one, and for 10 times of growth after it has
    escaped, unless that takes too many steps: then `why` says so.

    Parameters
    ----------
    report : Report
    values : mapping of name to number
        those of the verdict, and those of the body and of U that it does not need, such as I3
    sizes : sequence of numbers
        positive, falling; at least three; default 10⁻², …, 10⁻⁸

    Returns
    -------
    Confirmation

    Raises
    ------
    ScopeError
        U is unspecified: there is no motion
    ValuesError
        as for a verdict; a name is missing that the motion needs; the sizes are not as described
    MissingExtraError
        a motion is to be integrated, and neither SciPy nor heyoka is installed

    References
    ----------
    The exponents on a boundary: docs/explanation/derivations/boundaries.md, section 5.

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> report = gs.analyze(gs.upright(top))
    >>> critical = {"I1": 1, "I3": 1, "l": 0, "m0": 1, "pi3_0": 2}
    >>> sleeping = gs.trajectories.confirm(report, critical)  # π3² = 4 I1 m0
    >>> sleeping.decision.verdict.name, sleeping.expected
    ('STABLE', 0.5)
    >>> round(sleeping.slope, 3), sleeping.agrees
    (0.5, True)
    """
    in_one_direction(report.equilibrium.system.potential, "a confirmation by motions")
    eq, decision = report.equilibrium, report.verdict(values)
    numbers = exact_values(eq, values, report.required, report.parameters)
    if numbers.doubt:
        raise ValuesError(f"there is nothing to confirm: {numbers.doubt}")
    steps = [exact_number(size, "sizes") for size in sizes]
    if len(steps) < 3 or not all(1 >= a > b > 0 for a, b in zip(steps, steps[1:])):
        raise ValuesError(f"sizes = {brief(sizes)}: give at least three, positive and falling from 1 or less")
    point = [evaluate(eq.insert(x), numbers) for x in eq.point]
    scene = with_numbers(eq.system, _scene_numbers(eq, numbers))
    rate, growth = _rates(report, numbers)
    share = len(steps) * 2 * len(TURNS)
    distance = Distance(eq, decision, point)
    far, routes, complete, failure = [], set(), True, ""
    for step in steps:
        here = []
        try:
            for turn, change in zip(TURNS, CHANGES):
                for sign in (1, -1):
                    moving = motion(scene, moved(point, sign * step * turn, sign * step * change))
                    routes.add(moving.route)
                    complete = complete and moving.period is not None
                    here.append(excursion(moving, distance, rate, growth, float(step), share))
        except (AccuracyError, ValuesError) as error:
            failure = f"from a perturbation of size {float(step):.0e} a motion is not followed: {error}"
            break
        far.append(max(here))
    if not failure and not complete and decision.verdict is Verdict.UNSTABLE and growth <= SLOW * rate:
        failure = (f"the motions that are integrated were followed for {TURNED} turns, and no linear growth "
                   "says when they leave: too few to tell")
    small = [float(step) for step in steps[:len(far)]]
    slope = float(np.polyfit(np.log(small[-3:]), np.log(far[-3:]), 1)[0]) if len(far) > 2 else math.nan
    return Confirmation(decision, tuple(small), tuple(far), slope, _expected(report, decision, numbers),
                        tuple(sorted(routes)), complete, failure)


def moved(point: Sequence[Expr], turn: ImmutableMatrix, change: ImmutableMatrix) -> tuple[Expr, ...]:
    """Return π changed, and k turned about a vector by twice the arctangent of half its length.

    The result is rational if all of them are.

    Examples
    --------
    >>> point, turn = (0, 0, 1, 0, 0, 1), ImmutableMatrix([1, 0, 0])
    >>> moved(point, turn, ImmutableMatrix([0, 2, 0]))
    (0, 2, 1, 0, -4/5, 3/5)
    """
    pi, k, a = ImmutableMatrix(point[:3]) + change, ImmutableMatrix(point[3:]), turn / 2
    if k:
        once = a.cross(k)
        k = k + 2 * (once + a.cross(once)) / (1 + a.dot(a))
    return tuple(x.expand() for x in (*pi, *k))


def _scene_numbers(eq: Equilibrium, numbers: Point) -> dict[str, Expr]:
    """Return the numbers of the body and of U, an eliminated one among them."""
    found = {s.name: evaluate(eq.insert(s), numbers) for s in free_names(eq.system)}
    if missing := [name for name, value in found.items() if value.free_symbols]:
        raise ValuesError(f"a motion from {eq.label} needs {', '.join(missing)}, a verdict may not: give a "
                          "number for each")
    return found


def _rates(report: Report, numbers: Point) -> tuple[float, float]:
    """Return the largest modulus and the largest real part of an eigenvalue of the linearised field.

    They come from the polynomial in λ², without its exact zeros, which would be large in doubles.
    """
    found = [evaluate(report.equilibrium.insert(c), numbers) for c in report.linearization.coefficients]
    while found and sign_of_constant(found[-1]) == 0:
        found.pop()
    roots = np.sqrt(np.roots(doubles([1, *found], "the linearised field")).astype(complex))
    return float(np.abs(roots).max(initial=0)), float(roots.real.max(initial=0))


def _expected(report: Report, decision: Decision, numbers: Point) -> float | None:
    """Return the slope that the verdict implies."""
    if decision.verdict is not Verdict.STABLE:
        return 0.0 if decision.verdict is Verdict.UNSTABLE else None
    if known := seen_at(report.equilibrium, numbers):      # of revolution at these numbers
        report = analyze(known.equilibrium)
    sufficient = Standing(report, numbers, {}).sufficient
    return 1.0 if sufficient else _on_boundary(report.boundary, numbers) if report.boundary else None


def _on_boundary(boundary: Boundary, numbers: Point) -> float | None:
    """Return the slope on a boundary with g = c xⁿ⁺² + …: 1/(n + 1).

    At a pole, where 1 − k3 is half the square of the distance, it is 1/(2n), unless π3 + l = 0.
    """
    n = float(next(rung.power for rung in boundary.rungs() if sign_at(rung.condition, numbers, {}))) - 2
    eq = boundary.equilibrium
    axial = evaluate(eq.insert(eq.point[2] + eq.system.body.gyrostatic_momentum[2]), numbers)
    return 1 / (2 * n) if boundary.pole and sign_of_constant(axial) != 0 else 1 / (n + 1)
