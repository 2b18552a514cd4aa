"""Chooses the model in which a scene moves: an exact one if there is one, else one that is integrated."""
from collections.abc import Mapping, Sequence
from contextlib import suppress
from functools import lru_cache
from typing import Any

from sympy import Expr, ImmutableMatrix, Symbol

from ..algebra.text.numbers import exact_number
from ..algebra.text.quantities import not_mixed
from ..arguments import checked
from ..errors import AccuracyError, ResolutionError, ScopeError, ValuesError, brief
from ..mechanics.scenes.kind import Kind
from ..mechanics.scenes.system import System, at_numbers
from ..stability.criteria.numbers_asked import check_names
from .free.free_motion import FreeMotion
from .integrated.integrated_motion import Integration
from .motion import Motion
from .route import Route
from .states_in_digits import bits_of
from .top.level import Level
from .top.top_motion import AxialMotion
from .turned_motion import of_revolution, turned_free, turned_top

MOST_DIGITS = 10_000


@checked
def motion(scene: System, state: Sequence[Any], values: Mapping[str, Any] | None = None, *,
           precision: int | None = None, tolerance: float | None = None) -> Motion:
    """Return the motion of a scene from a state on, in the smallest model that has it.

    A body of revolution in U(k3) moves by elliptic functions (U of degree at most 2) or by one spectral
    quadrature: a state costs the same at any time. If its axis is another one, the body is recognised, and
    the motion turned. A free gyrostat moves by Jacobi's functions, or from one turn of its momentum, with a
    full tensor in its principal axes. Any other scene is integrated, twice, and monitored.

    Parameters
    ----------
    scene : System
    state : sequence, shape (n,)
        at the time 0, exact numbers: momenta [M L²/T], then directions [1]; a float is the dyadic rational it
        is
    values : mapping or None
        of names in the scene to numbers; default none
    precision : int or None
        decimal digits; by default states are doubles. A scene that is integrated has no others
    tolerance : float or None
        the error of the state that is accepted in an integration; default 10⁻³

    Returns
    -------
    Motion

    Raises
    ------
    ValuesError
        names are missing, numbers are not exact, or the state has another length
    ScopeError
        digits are asked for of a scene that is integrated
    AccuracyError
        the accuracy is not reached
    MissingExtraError
        a scene is to be integrated, and neither SciPy nor heyoka is installed

    References
    ----------
    Klein & Sommerfeld, Theorie des Kreisels (1897-1910), chapters I and VI, for the top; Landau & Lifshitz,
    Mechanics, §37, for the free body; Trefethen & Weideman, SIAM Review 56 (2014) 385-458, for quadratures;
    Jorba & Zou, Experimental Mathematics 14 (2005) 99-117, for Taylor's method.

    Examples
    --------
    >>> import gyrostat as gs
    >>> import numpy as np
    >>> scene = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> state = ("0.3", "-0.2", "1.5", "0.6", 0, "0.8")
    >>> numbers = {"I1": 1, "I3": "0.6", "l": "0.4", "m0": 1}
    >>> top = gs.trajectories.motion(scene, state, numbers)
    >>> top.route, round(top.period, 12)
    ('elliptic', 5.82463951502)
    >>> top(np.linspace(0, 1e6, 5)).shape
    (5, 6)
    >>> max(top.drift(np.linspace(0, 1e12, 100)).values()) < 1e-14
    True
    """
    scene = with_numbers(scene, values or {})
    if len(state) != len(scene.space.coordinates):
        raise ValuesError(f"the state has {len(state)} numbers, the scene {len(scene.space.coordinates)} "
                          f"coordinates: give {', '.join(map(str, scene.space.coordinates))}")
    point = tuple(exact_number(x, s.name) for x, s in zip(state, scene.space.coordinates))
    if precision is not None and not 1 <= precision <= MOST_DIGITS:
        raise ValuesError(f"precision = {brief(precision)}: give a number of decimal digits up to "
                          f"{MOST_DIGITS}")
    route = _route(scene, point, 53 if precision is None else bits_of(precision), tolerance)
    if precision is not None and not route.enclosed:
        raise ScopeError(f"this scene is integrated, in doubles: {precision} digits are had for a free "
                         "gyrostat, or a body of revolution in U(k3)")
    return Motion(scene, point, route, precision)


def _route(scene: System, point: tuple[Expr, ...], bits: int, tolerance: float | None) -> Route:
    """Return the model that computes the motion."""
    if scene.kind is Kind.FREE:
        if isinstance(scene.body.inertia, ImmutableMatrix):
            return turned_free(scene, point)
        return FreeMotion(scene, point)
    if scene.kind is Kind.REVOLUTION and any(point[3:]):
        try:
            return AxialMotion(Level(scene, point), bits)
        # k3 tends to a root of higher order, as a power of the time: no elliptic function does
        except ScopeError:
            pass
        except ResolutionError:                            # a singularity of U is close to the motion
            if bits > 53:
                raise
    elif any(point[3:]) and (found := of_revolution(scene, point)):
        # if the exact model refuses it, the scene can be integrated as it is
        with suppress(AccuracyError, ScopeError, ValuesError):
            return turned_top(found, point, bits)
    return Integration(scene, point, tolerance)


def with_numbers(scene: System, values: Mapping[str, Any]) -> System:
    """Return the scene with numbers for its names."""
    free = free_names(scene)
    if scene.unspecified:
        raise ScopeError("U(k3) is unspecified: give it to axial_potential, a motion needs numbers")
    check_names(values, [s.name for s in free], "the scene")
    not_mixed(values.items())
    numbers = {s: exact_number(values[s.name], s.name) for s in free}
    if scene.potential is not None:
        scene.potential.check_size(numbers)
    return _inserted(scene, tuple(numbers.items())) if values else scene


def free_names(scene: System) -> list[Symbol]:
    """Return the names for which a motion needs numbers, in order."""
    used = scene.hamiltonian.free_symbols.union(*(c.free_symbols for c in scene.space.casimirs))
    return sorted(used - set(scene.space.coordinates), key=str)


@lru_cache(maxsize=64)
def _inserted(scene: System, given: tuple[tuple[Symbol, Expr], ...]) -> System:
    return at_numbers(scene, dict(given))
