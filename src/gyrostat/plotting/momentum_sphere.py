"""Draws the momentum sphere of a free body or gyrostat: polhodes, separatrices, equilibria."""
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from ..algebra.enclosures.floats import Array, row
from ..algebra.reals.exact import sign_of_constant
from ..algebra.text.numbers import exact_number
from ..arguments import checked
from ..equilibria.finders.free import rotations_on_sphere
from ..equilibria.relative_equilibrium import RelativeEquilibrium
from ..errors import ScopeError, ValuesError
from ..mechanics.scenes.system import System, at_numbers
from ..stability.decision import Verdict
from .captions import BEHIND, headed
from .energy_levels import energies_between, floats, level_curve, level_of, place
from .globe import circle, curve_on, curves_of, dots_of, numbers_on, stage
from .headings import of_sphere
from .legends import named
from .looks import BLUE, DARK, axes_of, label, line, marker
from .scene_numbers import numbers_of

BAND = 5                                                   # polhodes between two critical energies


@checked
def draw_momentum_sphere(scene: System, momentum: Any, values: Mapping[str, Any] | None = None,
                         energies: Sequence[float] | None = None, ax: Any = None,
                         **kwargs: Any) -> Any:
    """Draw the sphere abs(M) = const of a free body or gyrostat, M = π + l, seen as ax.view_init says.

    A polhode is the curve on which the energy is constant: M moves along it in the body. Those through
    saddles, the separatrices, are heavy, and what is behind is faded. A filled marker is a stable rotation,
    an open one an unstable one, and a half-filled one is undecided. Its number is that in the list of
    relative_equilibria, and in the table of gyrostat decide. Each point of a solid circle, which a body of
    revolution has, is a rotation that is stable modulo the spin.

    Parameters
    ----------
    scene : System
        without a potential
    momentum : number
        abs(M) [M L²/T]
    values : mapping of name to number, or None
        for its parameters
    energies : sequence of float or None
        of the polhodes [M L²/T²]; None: a few between each two critical ones
    ax : axes of mplot3d
        new ones where they are left out
    **kwargs : Any
        of the polhodes: of Axes3D.plot

    Returns
    -------
    axes of mplot3d

    Raises
    ------
    ScopeError
        the scene has a field, or every point of the sphere is an equilibrium
    ValuesError
        numbers are missing, unknown or not admissible
    ArgumentError
        the axes are flat
    MissingExtraError
        pip install "gyrostat[plot]"

    References
    ----------
    Landau & Lifshitz, Mechanics, §37; Hughes, Spacecraft Attitude Dynamics (1986), chapters 4 and 6.

    Examples
    --------
    >>> import gyrostat as gs
    >>> from matplotlib.figure import Figure
    >>> body = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)))
    >>> sphere = Figure().add_subplot(projection="3d")
    >>> ax = gs.plotting.draw_momentum_sphere(body, 1, ax=sphere)
    >>> [text.get_text() for text in ax.get_legend().get_texts()]
    ['polhode', 'separatrix', 'stable', 'unstable']
    """
    if scene.potential is not None:
        raise ScopeError("M keeps its length only in a free body, the scene has the potential "
                         f"{scene.potential.expression}: "
                         "assemble the body alone")
    here, radius = at_numbers(scene, numbers_of(scene, values or {})), exact_number(momentum, "momentum")
    body = here.body
    if sign_of_constant(radius) != 1:
        raise ValuesError(f"momentum = {momentum} is not the radius of a sphere: give a positive number")
    points = [RelativeEquilibrium(form) for form in rotations_on_sphere(here, radius)]
    size, about = float(radius), points[0].form.circle
    if about is not None and not any(about):
        raise ScopeError(f"inertia = {body.moments} and l = 0: every point of the sphere is an equilibrium; "
                         "give different moments, or a rotor")
    least, most = (f(map(level_of, points)) for f in (min, max))
    slack = 1e-12 * most                                   # an energy of a rest point may be rounded
    given = None if energies is None or not len(energies) else row(energies, "energies").tolist()
    if off := [energy for energy in given or () if not least - slack <= energy <= most + slack]:
        raise ValuesError(f"energies = {off[0]}: there is no curve of it on |M| = {momentum}; give "
                          f"energies between {least:.6g} "
                          f"and {most:.6g}")
    ax = axes_of(ax, three=True)
    eye = stage(ax, size, [label(f"M{i}") for i in (1, 2, 3)])
    style = {"color": BLUE, "linewidth": 0.9, **kwargs}
    chosen = energies_between(body, points, BAND) if energies is None else given or []
    curve_on(ax, _joined([level_curve(body, points, size, level) for level in chosen]), eye, **style)
    handles = [named(style, "polhode")]
    saddles = {level_of(p) for p in points
               if p.decision.verdict is Verdict.UNSTABLE and p.form.circle is None}
    if saddles:
        heavy = {"color": DARK, "linewidth": 2.0}
        curve_on(ax, _joined([level_curve(body, points, size, level) for level in saddles]), eye, **heavy)
        handles.append(named(heavy, "separatrix"))
    for point in points:
        if point.form.circle is not None:
            axis, at = floats(point.form.circle), place(point)
            height = float(at @ axis)
            around = [circle(axis, float(np.sqrt(size**2 - height**2)), height)]
            handles += curves_of(ax, around, line(Verdict.STABLE), "equilibria, stable modulo the spin", eye)
    for verdict in Verdict:
        places = [place(p) for p in points
                  if p.decision.verdict is verdict and p.form.circle is None]
        handles += dots_of(ax, places, marker(verdict), verdict.name.lower(), eye)
    numbers_on(ax, [(n, place(p)) for n, p in enumerate(points, 1)], eye, size)
    headed(ax, "Momentum sphere of a free gyrostat", of_sphere(scene, values or {}, radius), handles,
           after=BEHIND)
    return ax


def _joined(curves: Sequence[Array]) -> Array:
    """Several curves as one, NaN between them."""
    gap = np.full((1, 3), np.nan)
    return np.concatenate([gap, *(part for curve in curves for part in (curve, gap))])
