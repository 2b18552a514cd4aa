"""Draws the Smelt plane: for which moments a satellite is stable Earth-pointing, with a rotor along pitch."""
from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import Any

import numpy as np
from sympy import Expr

from ..algebra.reals.exact import sign_of_constant
from ..algebra.text.numbers import exact_number, shown
from ..algebra.text.quantities import not_mixed
from ..arguments import checked, several
from ..charts.chart import stability_chart
from ..errors import ValuesError
from ..mechanics.families.circular_orbit import circular_orbit, earth_pointing
from ..mechanics.scenes.body import Gyrostat
from ..mechanics.scenes.system import assemble
from ..notation import symbol
from ..stability.report.analysis import analyze
from ..stability.report.report import Report
from .captions import headed
from .charts import draw_chart
from .headings import number
from .legends import named
from .looks import DARK, axes_of

ROLL, YAW = symbol("k_R"), symbol("k_Y")
POINTS = 400
NAMES = {"undecided": "gyroscopic, lost by damping"}


@checked
def draw_smelt_plane(rotor: Any = 0, bodies: Mapping[str, Sequence[Any]] | None = None, ax: Any = None,
                     **kwargs: Any) -> Any:
    """Draw where a satellite rests stably Earth-pointing, over its ratios of moments.

    The ratios are k_R = (I_pitch − I_yaw)/I_roll and k_Y = (I_pitch − I_roll)/I_yaw, between −1 and 1 for
    every body. Their names differ from book to book, the moments do not. A satellite is stable, with damping
    too, if the energy has a minimum: without a rotor this is Lagrange's region. In DeBra and Delp's region it
    is gyroscopically stabilised: spectrally stable, and unstable under any damping. Verdicts and boundaries
    are those of a chart, which are proved.

    Parameters
    ----------
    rotor : number or text
        l/(I_pitch ω0), of a rotor along the axis of pitch
    bodies : mapping of str to three numbers or texts
        marked by their numbers in the legend: I_roll, I_pitch, I_yaw
    ax : axes
        new ones where they are left out
    **kwargs : Any
        of the image of the verdicts: as matplotlib.image.AxesImage takes them

    Returns
    -------
    axes

    Raises
    ------
    ValuesError
        the rotor or a moment is no number, or three moments are those of no body
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
    ratio = exact_number(rotor, "l/(I_pitch ω0)")
    marks = {name: ratios(moments, name) for name, moments in (bodies or {}).items()}
    values = (2 * np.arange(POINTS) + 1) / POINTS - 1          # the middles of cells between −1 and 1
    chart = stability_chart(_report(ratio), x=(ROLL.name, values), y=(YAW.name, values), damped=True,
                            progress=False)
    ax = axes_of(ax)
    draw_chart(chart, ax, **kwargs)
    handles = list(ax.get_legend().legend_handles)
    for handle in handles:
        handle.set_label(NAMES.get(handle.get_label(), handle.get_label()))
    for n, (name, (across, up)) in enumerate(marks.items(), 1):
        style = {"marker": f"${n}$", "color": DARK, "linestyle": "none", "markersize": 7,
                 "markeredgewidth": 0.4}
        disc = {**style, "marker": "o", "markersize": 11, "markerfacecolor": "white"}
        ax.plot(float(across), float(up), **disc)
        ax.plot(float(across), float(up), **style)
        handles.append(named(style, name))
    ax.set_xlabel(r"$k_R = (I_\mathrm{pitch} - I_\mathrm{yaw})/I_\mathrm{roll}$")
    ax.set_ylabel(r"$k_Y = (I_\mathrm{pitch} - I_\mathrm{roll})/I_\mathrm{yaw}$")
    said = (rf"$l = {number(ratio)}\,I_{{\mathrm{{pitch}}}}\,\omega_0$" if ratio else "without a rotor")
    headed(ax, "Smelt plane of an Earth-pointing satellite", (["Earth-pointing"], [said]), handles)
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


@lru_cache(maxsize=32)
def _report(rotor: Expr) -> Report:
    """Earth-pointing of a body with these ratios, the rotor in units of I_pitch ω0."""
    moments = 1 - YAW, 1 - ROLL * YAW, 1 - ROLL
    body = Gyrostat(moments, (0, rotor * moments[1], 0))
    return analyze(earth_pointing(assemble(body, circular_orbit(1))))
