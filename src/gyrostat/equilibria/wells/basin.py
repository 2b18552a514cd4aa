"""A minimum of V and what closes it in: the height of the lowest pass, its kind, and what lies beyond."""
import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TypeVar

from flint import arb
from sympy import Expr, oo

from ..._cached import cached_property
from ..._display import Shown
from ...algebra.reals.exact import evaluate
from ...mechanics.scenes.kind import Kind
from ..relative_equilibrium import RelativeEquilibrium
from .joining import NO_PATH, NOT_ISOLATED, in_classes, told_apart
from .merge_tree import Outcome, outcome
from .paths import Paths
from .tilts import TiltWell


@dataclass(frozen=True, repr=False)
class Basin(Shown):
    """A minimum of V, and what the part of {V < E} round it first meets as E rises.

    Parameters
    ----------
    rotation : RelativeEquilibrium
    paths : Paths or None
        the paths down from all critical points of V; None if they are not known
    found : Outcome
        what is met first
    reason : str
        why there is no barrier, or why it is only a bound; "" else
    line : TiltWell or None
        of a body of revolution, whose tilt alone moves
    """

    rotation: RelativeEquilibrium
    paths: Paths | None = None
    found: Outcome = Outcome()
    reason: str = ""
    line: TiltWell | None = None

    @property
    def points(self) -> Sequence[RelativeEquilibrium]:
        """All critical points of V, equilibria, if they are known."""
        return () if self.paths is None else self.paths.landscape.points

    @cached_property
    def heights(self) -> Sequence[arb]:
        """V of each of them above that of the rotation, in balls [M L²/T²]."""
        return () if self.paths is None else self.paths.above(self.rotation)

    @cached_property
    def barrier(self) -> Expr | None:
        """The height of the lowest equilibrium that the well touches, exact; None if there is no answer."""
        if self.line is not None:
            return self.line.barrier
        return self._above(self.found.passes[0]) if self.found.passes else None

    @cached_property
    def escape(self) -> Expr | None:
        """The least height from which another minimum is reached, exact; oo if there is none."""
        if self.line is not None:
            return self.line.escape
        if self.found.escape is not None:
            return self._above(self.found.escape)
        return None if self.found.stopped is not None or not self.found.passes else oo

    @property
    def barrier_double(self) -> float | None:
        """The barrier as a double, without the exact number being written out [M L²/T²]."""
        if self.line is not None:
            return None if self.line.barrier is None else float(self.line.barrier)
        return float(self.heights[self.found.passes[0]].mid()) if self.found.passes else None

    @property
    def escape_double(self) -> float | None:
        """The escape as a double; infinity if there is no other minimum [M L²/T²]."""
        if self.line is not None:
            return None if self.line.escape is None else float(self.line.escape)
        if self.found.escape is not None:
            return float(self.heights[self.found.escape].mid())
        return None if self.escape is None else math.inf

    @property
    def bound(self) -> float | None:
        """What the barrier is at least, if it is not known [M L²/T²]."""
        stopped = self.found.stopped
        return None if self.found.passes or stopped is None else float(self.heights[stopped].lower())

    @property
    def kind(self) -> str:
        """Of the pass: "well", "round" (the well closes round a summit), "summit"; "" if there is none.

        Of a body of revolution it may be a "shelf", an inflection.
        """
        if self.line is not None:
            return self.line.passes[0].kind if self.line.passes else ""
        return self.found.kind

    @property
    def passes(self) -> tuple[RelativeEquilibrium, ...]:
        """The equilibria of the height of the barrier that the well touches."""
        return tuple(self.points[n] for n in self.found.passes)

    @property
    def beyond(self) -> tuple[RelativeEquilibrium, ...]:
        """The stable equilibria that are reached at the height of the escape."""
        return tuple(self.points[n] for n in self.found.beyond)

    def value(self, e: RelativeEquilibrium) -> Expr:
        """Return V at an equilibrium: the energy, round a maximum its negative [M L²/T²]."""
        turned = self.rotation.scene.kind is Kind.FREE and self.rotation.form.index != 0
        return -e.energy if turned else e.energy

    def _above(self, n: int) -> Expr:
        return evaluate(self.value(self.points[n]) - self.value(self.rotation), {})


AnyBasin = TypeVar("AnyBasin", bound=Basin)


def filled(empty: AnyBasin, paths: Paths) -> AnyBasin:
    """Return a basin with what it meets first, by the paths down from the critical points of its V."""
    points, indices = paths.landscape.points, paths.indices
    here, levels = paths.landscape.number(empty.rotation), in_classes(paths.values)
    found = outcome(here, levels, indices, paths.ends)
    if found.tied:
        levels = [part for level in levels for part in (
            told_apart(points, level, empty.value) if found.passes[0] in level else [level])]
        found = outcome(here, levels, indices, paths.ends)
    stopped = found.stopped
    reason = "" if stopped is None else NOT_ISOLATED if indices[stopped] is None else NO_PATH
    return replace(empty, paths=paths, found=found, reason=reason)
