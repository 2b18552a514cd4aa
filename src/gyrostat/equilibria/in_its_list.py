"""Finds an equilibrium that is named among all relative equilibria of its level, at numbers."""
from collections.abc import Mapping, Sequence

from sympy import Expr, Matrix, sqrt

from ..algebra.enclosures.balls import ball
from ..algebra.reals.exact import evaluate
from ..errors import ScopeError
from ..mechanics.equilibrium.equilibrium import Equilibrium
from ..mechanics.scenes.kind import Kind
from ..mechanics.scenes.system import System, at_numbers, names_of_scene
from ..notation import symbol
from .relative_equilibrium import RelativeEquilibrium
from .search import relative_equilibria
from .wells.in_balls import BITS


def in_its_list(named: Equilibrium, values: Mapping[str, Expr]) -> RelativeEquilibrium:
    """Return the relative equilibrium that a named one is at numbers.

    Parameters
    ----------
    named : Equilibrium
    values : mapping of name to number
        for every name that it has

    Returns
    -------
    RelativeEquilibrium
        of the level of the named one, or of its rate

    Raises
    ------
    ScopeError
        names are left, there is no list of its level, or the point stands for a curve in the list
    """
    known = {symbol(name): x for name, x in values.items()}
    given = dict(named.relations)
    known |= {name: evaluate(named.insert(name), known) for name in given.keys() - known.keys()}
    own = names_of_scene(named.system)
    scene = at_numbers(named.system, {name: x for name, x in known.items() if name in own})
    point = [evaluate(named.insert(x), known) for x in named.point]
    if left := set().union(own - known.keys(), *(x.free_symbols for x in point)):
        missing = ", ".join(sorted(map(str, left)))
        raise ScopeError(f"{named.label} has names without a number: give {missing}")
    near = [e for e in relative_equilibria(scene, _level(scene, point))
            if _near(_told(scene, e.point), _told(scene, point))]
    if len(near) == 1:                                     # the list is complete, and it is one of them
        return near[0]
    raise ScopeError(f"{named.label} is no single point in the list of relative equilibria: name none, and "
                     "all are decided")


def _level(scene: System, point: list[Expr]) -> dict[str, Expr]:
    """What is asked for, so that the point is in the list: its level, or its rate in a field."""
    if scene.kind is Kind.ORBIT:
        return {}
    M = Matrix(point[:3]) + Matrix(scene.body.gyrostatic_momentum)
    if scene.kind is Kind.FREE:
        return {"M": sqrt(evaluate(M.dot(M), {}))}
    if scene.kind is Kind.REVOLUTION:
        return {"pi3_0": point[2], "C1": evaluate(M.dot(Matrix(point[3:])), {})}
    return {"omega": evaluate(Matrix(point[3:]).dot(scene.body.inverse * Matrix(point[:3])), {})}


def _told(scene: System, point: Sequence[Expr]) -> Sequence[Expr]:
    """The coordinates that tell points of the list apart: without a turn about the axis of the body."""
    return [point[2], point[5]] if scene.kind is Kind.REVOLUTION else point


def _near(one: Sequence[Expr], other: Sequence[Expr]) -> bool:
    """Whether two points may be one; enclosures of equal numbers overlap."""
    return all(ball(a, BITS).overlaps(ball(b, BITS)) for a, b in zip(one, other))
