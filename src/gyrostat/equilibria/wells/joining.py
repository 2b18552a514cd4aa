"""How the wells of a level become one as the energy rises."""
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cmp_to_key
from itertools import pairwise

from flint import arb
from sympy import Expr

from ...algebra.reals.exact import evaluate, proved_sign
from ..relative_equilibrium import RelativeEquilibrium
from .merge_tree import joins
from .paths import Paths

Value = Callable[[RelativeEquilibrium], Expr]              # V at an equilibrium
NO_PATH = "the way down from an equilibrium is not proved: no pass lies below it, what lies above is open"
NOT_ISOLATED = "a degenerate equilibrium lies above: no pass lies below it, what lies above is open"


@dataclass(frozen=True)
class Merge:
    """Wells that become one at a height.

    Parameters
    ----------
    height : Expr
        above the equilibrium whose level this is, exact; of a maximum of the energy below it [M L²/T²]
    over : tuple of RelativeEquilibrium
        the passes between them
    wells : tuple of tuple of RelativeEquilibrium
        the stable equilibria in each of them
    """

    height: Expr
    over: tuple[RelativeEquilibrium, ...]
    wells: tuple[tuple[RelativeEquilibrium, ...], ...]


@dataclass(frozen=True)
class Tree:
    """How all wells of a level become one.

    Parameters
    ----------
    merges : tuple of Merge
        the lowest first
    reason : str
        why those above the last one are not known; "" if all are
    """

    merges: tuple[Merge, ...]
    reason: str


def tree(rotation: RelativeEquilibrium, paths: Paths, value: Value) -> Tree:
    """Return how the wells of the level of an equilibrium become one."""
    points, indices = paths.landscape.points, paths.indices
    levels = [part for level in in_classes(paths.values) for part in (
        told_apart(points, level, value) if sum(indices[n] == 1 for n in level) > 1 else [level])]
    found, lost = joins(levels, indices, paths.ends)
    merges = (Merge(evaluate(value(points[join.over[0]]) - value(rotation), {}),
                    tuple(points[n] for n in join.over),
                    tuple(tuple(points[n] for n in well) for well in join.wells)) for join in found)
    return Tree(tuple(merges), "" if lost is None else NOT_ISOLATED if indices[lost] is None else NO_PATH)


def in_classes(values: Sequence[arb]) -> list[list[int]]:
    """Return the numbers of the points in classes that balls do not tell apart."""
    levels: list[list[int]] = []
    for n in sorted(range(len(values)), key=lambda n: float(values[n].mid())):
        if levels and values[levels[-1][-1]].overlaps(values[n]):
            levels[-1].append(n)
        else:
            levels.append([n])
    return levels


def told_apart(points: Sequence[RelativeEquilibrium], level: list[int], value: Value) -> list[list[int]]:
    """Return one class in classes of exactly equal V, the lowest first."""
    def compared(a: int, b: int) -> int:
        return proved_sign(evaluate(value(points[a]) - value(points[b]), {}))

    ordered = sorted(level, key=cmp_to_key(compared))
    parts = [ordered[:1]]
    for before, n in pairwise(ordered):
        parts.append([n]) if compared(before, n) else parts[-1].append(n)
    return parts
