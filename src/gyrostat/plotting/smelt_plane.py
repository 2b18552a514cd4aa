"""Draws the Smelt plane: for which moments a satellite is stable Earth-pointing, with a rotor along pitch."""
from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import Any

import numpy as np
from sympy import Expr, ImmutableMatrix, Rational, expand

from ..algebra.reals.exact import evaluate, proved_sign, sign_of_constant
from ..algebra.text.numbers import exact_number, shown
from ..algebra.text.quantities import not_mixed
from ..arguments import checked, several
from ..charts.chart import stability_chart
from ..equilibria.finders.orbit import R
from ..equilibria.finders.rate_level_tilt import exact_point
from ..errors import ScopeError, ValuesError, brief
from ..mechanics.families.circular_orbit import acting_beside, circular_orbit, earth_pointing, orbital_rate
from ..mechanics.families.circular_orbit import axes_of as axes_along
from ..mechanics.scenes.body import Gyrostat
from ..mechanics.scenes.kind import Kind
from ..mechanics.scenes.principal_axes import principal_axes
from ..mechanics.scenes.system import System, assemble, at_numbers, names_of_scene
from ..notation import symbol
from ..stability.report.analysis import analyze
from ..stability.report.report import Report
from .beside import written_at
from .captions import headed
from .charts import draw_chart
from .headings import number, of_scene
from .legends import named, room
from .looks import DARK, axes_of

ROLL, YAW = symbol("k_R"), symbol("k_Y")
POINTS = 400
SATELLITE = "the satellite"
SPOT = {"marker": "o", "color": DARK, "markerfacecolor": "white", "linestyle": "none", "markersize": 4.5}
BESIDE = 9.0                                               # points of a mark and the edge of its disc
DISC = {"boxstyle": "circle,pad=0.15", "facecolor": "white", "edgecolor": DARK, "linewidth": 0.6}
NAMES = {"undecided": "gyroscopic, lost by damping"}


@checked
def draw_smelt_plane(rotor: Any = 0, bodies: Mapping[str, Sequence[Any]] | None = None, ax: Any = None, *,
                     satellite: System | None = None, values: Mapping[str, Any] | None = None,
                     pointing: Sequence[int] = (1, 2, 3), **kwargs: Any) -> Any:
    """Draw where a satellite rests stably Earth-pointing, over its ratios of moments.

    The ratios are k_R = (I_pitch − I_yaw)/I_roll and k_Y = (I_pitch − I_roll)/I_yaw, between −1 and 1 for
    every body. Their names differ from book to book, the moments do not. A satellite is stable, with damping
    too, if the energy has a minimum: without a rotor this is Lagrange's region. In DeBra and Delp's region it
    is gyroscopically stabilised: spectrally stable, and unstable under any damping. Verdicts and boundaries
    are those of a chart, which are proved.

    Parameters
    ----------
    rotor : number or text
        l/(I_pitch ω0), of a rotor along the axis of pitch; if it is not rational, the double next to it is
        taken
    bodies : mapping of str to three numbers or texts
        marked by their numbers in the legend: I_roll, I_pitch, I_yaw
    ax : axes
        new ones where they are left out
    satellite : System
        of assemble(body, circular_orbit()), in place of the rotor: it is marked in the plane of its own rotor
    values : mapping of name to number
        of the names in the satellite
    pointing : sequence of three int
        the body axes of the satellite along t, n and r, as of earth_pointing; of a tensor its principal axis
        of the largest moment has the place of the axis with the largest diagonal entry, and so on
    **kwargs : Any
        of the image of the verdicts: as matplotlib.image.AxesImage takes them

    Returns
    -------
    axes

    Raises
    ------
    ValuesError
        the rotor or a moment is no number, or three moments are those of no body; or a rotor and a satellite
        are both given
    ScopeError
        the satellite is in no orbit; its rotor is not along pitch; or another torque acts
    MissingExtraError
        pip install "gyrostat[plot,charts]"

    References
    ----------
    Smelt; DeBra & Delp, J. Astronaut. Sci. 8 (1961) 14-17; Hughes, Spacecraft Attitude Dynamics (1986),
    chapter 9.

    Examples
    --------
    >>> import gyrostat as gs
    >>> from matplotlib.figure import Figure
    >>> bodies = {"pole": (60, 70, 35)}
    >>> ax = gs.plotting.draw_smelt_plane(bodies=bodies, ax=Figure().subplots())
    >>> [text.get_text() for text in ax.get_legend().get_texts()][-1]
    'pole'
    """
    ratio, marked, shown_too = exact_number(rotor, "l/(I_pitch ω0)"), dict(bodies or {}), list[str]()
    if satellite is not None:
        if ratio != 0:
            raise ValuesError(f"rotor = {brief(rotor)} and a satellite are both given, and the plane is that "
                              "of the satellite's own rotor: leave out one of the two")
        here = _at_numbers(satellite, values or {})
        own, ratio = pointed(here, pointing)
        marked = {SATELLITE: own, **marked}
        body = Gyrostat(here.body.gravitating.tolist(), here.body.gyrostatic_momentum)
        shown_too = of_scene(assemble(body, circular_orbit(orbital_rate(here))), {})[1]
    marks = {name: ratios(moments, name) for name, moments in marked.items()}
    middles = (2 * np.arange(POINTS) + 1) / POINTS - 1         # of cells between −1 and 1
    drawn = ratio if isinstance(ratio, Rational) else Rational(repr(float(ratio)))
    chart = stability_chart(_report(drawn), x=(ROLL.name, middles), y=(YAW.name, middles), damped=True,
                            progress=False)
    ax = axes_of(ax)
    draw_chart(chart, ax, **kwargs)
    handles = list(ax.get_legend().legend_handles)
    for handle in handles:
        handle.set_label(NAMES.get(handle.get_label(), handle.get_label()))
    at = [(float(across), float(up)) for across, up in marks.values()]
    for n, (name, place) in enumerate(zip(marks, at), 1):
        ax.plot(*place, **SPOT)
        handles.append(named({"marker": f"${n}$", "color": DARK, "linestyle": "none", "markersize": 7,
                              "markeredgewidth": 0.4}, name))
    ax.set_xlabel(r"$k_R = (I_\mathrm{pitch} - I_\mathrm{yaw})/I_\mathrm{roll}$")
    ax.set_ylabel(r"$k_Y = (I_\mathrm{pitch} - I_\mathrm{roll})/I_\mathrm{yaw}$")
    said = (rf"$l = {number(ratio)}\,I_{{\mathrm{{pitch}}}}\,\omega_0$" if ratio else "without a rotor")
    headed(ax, "Smelt plane of an Earth-pointing satellite", (["Earth-pointing"], [said, *shown_too]),
           handles)
    room(ax)
    for text in written_at(ax, [(str(n), place) for n, place in enumerate(at, 1)], BESIDE):
        text.set_bbox(DISC)
    return ax


def ratios(moments: Sequence[Any], name: str = "the body") -> tuple[Expr, Expr]:
    """k_R and k_Y of the moments about roll, pitch and yaw.

    Raises
    ------
    ValuesError
        they are not three moments of a body

    Examples
    --------
    >>> ratios((60, 32, 35))
    (-1/20, -4/5)
    """
    moments = several(moments, f"the moments of {name}")
    if len(moments) != 3:
        raise ValuesError(f"{name} has {len(moments)} moments: give those about roll, pitch and yaw")
    own = f"inertia of {name}"
    not_mixed([(own, x) for x in moments])
    about_roll, about_pitch, about_yaw = found = [exact_number(x, own) for x in moments]
    sides = [*found, *(sum(found) - 2 * x for x in found)]
    if any(sign_of_constant(x) != 1 for x in sides):
        raise ValuesError(f"{name} has the moments {', '.join(map(shown, found))} about roll, pitch and yaw, "
                          "which are those of no body: each is positive, and less than the sum of the other "
                          "two")
    return (about_pitch - about_yaw) / about_roll, (about_pitch - about_roll) / about_yaw


def _at_numbers(satellite: System, values: Mapping[str, Any]) -> System:
    """Return the satellite at its numbers."""
    if satellite.kind is not Kind.ORBIT:
        raise ScopeError("Smelt's plane is that of a satellite in orbit: assemble(body, circular_orbit())")
    needed = {s.name for s in names_of_scene(satellite)}
    numbers = exact_point(satellite, values, needed)
    if missing := sorted(needed - values.keys()):
        raise ValuesError(f"the scene needs {', '.join(missing)}: give a number for each")
    return at_numbers(satellite, dict(numbers))


def pointed(here: System, pointing: Sequence[int]) -> tuple[list[Expr], Expr]:
    """Return the moments of a satellite about roll, pitch and yaw, and its rotor as l/(I_pitch ω0).

    Gravity acts on the tensor G of the locked body, U = (3/2) ω0² r·Gr − ω0 n·l. If a wheel along pitch runs
    freely with the momentum h, its moment J is missing in the tensor of the kinetic energy, and l = h − J ω0:
    the momentum of the body along n is the same, and so are the conditions.

    Examples
    --------
    >>> import gyrostat as gs
    >>> body = gs.Gyrostat((60, 52, 35), (0, 26, 0))
    >>> pointed(gs.assemble(body, gs.circular_orbit("1/2")), (1, 2, 3))
    ([60, 52, 35], 1)
    """
    roll, pitch, yaw = several(pointing, "pointing", 3)
    axes_along(roll, pitch, yaw)
    rate, other = orbital_rate(here), acting_beside(here)
    extra = here.body.gravitating - here.body.tensor
    r = ImmutableMatrix(R)
    if expand(other - Rational(3, 2) * rate**2 * r.dot(extra * r)) != 0:
        raise ScopeError(f"U = {brief(other)} acts beside the gravity gradient, and Smelt's plane is that of "
                         "the gravity gradient alone: draw the attitudes")
    locked = here.body.tensor + extra
    body, turn = principal_axes(Gyrostat(locked.tolist(), here.body.gyrostatic_momentum))
    order = _order(locked, body.moments, [abs(x) for x in (roll, pitch, yaw)])
    free, n = turn * extra * turn.T, order[1]
    left = [body.gyrostatic_momentum[i] for i in range(3) if i != n]
    left += [free[i, j] for i in range(3) for j in range(3) if (i, j) != (n, n)]
    way = proved_sign(turn[n, abs(pitch) - 1]) * (1 if pitch > 0 else -1)
    if not way or any(proved_sign(evaluate(x, {})) for x in left):
        raise ScopeError("the rotor of the satellite is not along the principal axis of pitch, and then its "
                         "axes do not rest along those of the orbit: put it along pitch, or draw the "
                         "attitudes")
    along = way * body.gyrostatic_momentum[n] - rate * free[n, n]
    return [body.moments[i] for i in order], evaluate(along / (body.moments[n] * rate), {})


def _order(tensor: ImmutableMatrix, moments: Sequence[Expr], axes: Sequence[int]) -> list[int]:
    """Return which principal moments are those about the given axes of the body: those of the same rank."""
    if tensor.is_diagonal():
        return [axis - 1 for axis in axes]
    entries = [float(tensor[axis - 1, axis - 1]) for axis in axes]
    ranks = np.argsort(np.argsort(entries))
    if len(set(entries)) < 3:
        raise ScopeError("two diagonal entries of the tensor are equal, and it is open which principal axis "
                         "is that of roll, pitch or yaw: give principal moments")
    by_size = np.argsort(list(map(float, moments)))
    return [int(by_size[rank]) for rank in ranks]


@lru_cache(maxsize=32)
def _report(rotor: Expr) -> Report:
    """Earth-pointing of a body with these ratios, the rotor in units of I_pitch ω0."""
    moments = 1 - YAW, 1 - ROLL * YAW, 1 - ROLL
    body = Gyrostat(moments, (0, rotor * moments[1], 0))
    return analyze(earth_pointing(assemble(body, circular_orbit(1))))
