"""Draws the effective potential of a body of revolution in U(k3) on a level of its momenta."""
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from sympy import Expr, S, together

from ..algebra.enclosures.floats import Array, in_floats
from ..algebra.reals.exact import evaluate, sign_of_constant
from ..algebra.solving.roots import between, in_order, real_roots
from ..algebra.text.numbers import exact_number
from ..arguments import checked
from ..equilibria.finders.rate_level_tilt import names_of
from ..equilibria.finders.revolution import revolution_forms
from ..equilibria.relative_equilibrium import RelativeEquilibrium
from ..errors import ValuesError
from ..mechanics.classical.lagrangian import effective_potential
from ..mechanics.equilibrium.reduction import ENERGY, K3, P, V, reduce
from ..mechanics.scenes.system import System
from ..notation import symbol
from ..printing.letters import letters_of
from ..stability.decision import Verdict
from .beside import written_at
from .captions import headed
from .globe import dots_of
from .headings import of_scene
from .legends import named, room
from .looks import BLUE, DARK, GREY, MARKER, axes_of, axis, label, marker, meaning
from .scene_numbers import in_own_axes, numbers_of

THETA = symbol("theta")
ANGLES = 801                                               # beside those about what is special


@dataclass(frozen=True)
class Well:
    """The effective potential on a level of p_phi and p_psi.

    Parameters
    ----------
    theta, height : arrays, shape (n,)
        V at angles inside (0, π), close together beside what is special; NaN where U is infinite
    equilibria : list of (theta, V, number in the list of relative_equilibria, RelativeEquilibrium)
    turning_points : list of Expr
        exact k3 at which V is the energy
    reach : list of (Expr, Expr)
        from which to which k3 the energy lets the body go
    level : bool
        V is constant: every tilt is an equilibrium
    """

    theta: Array
    height: Array
    equilibria: list[tuple[float, float, int, RelativeEquilibrium]]
    turning_points: list[Expr]
    reach: list[tuple[Expr, Expr]]
    level: bool


def well(scene: System, values: Mapping[str, Any], energy: Any = None) -> Well:
    """Return V(θ), its critical points with their verdicts, exact and complete, and the reach of an energy.

    Parameters
    ----------
    scene, values, energy
        as in draw_effective_potential

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> found = well(top, {"I1": 1, "I3": "1/2", "l": 0, "m0": 1, "p_phi": 2, "p_psi": 3}, energy=10)
    >>> [branch.decision.verdict.name for *_, branch in found.equilibria]
    ['STABLE']
    >>> [round(float(k3), 4) for k3 in found.turning_points]
    [0.2843, 0.7957]
    """
    names_of(scene, "draw_amended_potential is the picture of another body in a field")
    numbers = numbers_of(scene, values, ("p_phi", "p_psi"))
    potential = effective_potential(scene.body,
                                    scene.potential).xreplace(dict(numbers))  # type: ignore[arg-type]
    level = {"pi3_0": evaluate(P - scene.body.gyrostatic_momentum[2], numbers), "C1": numbers[V]}
    scenes = {s.name: x for s, x in numbers.items() if s not in (P, V)}
    motion = reduce(scene)
    field = scene.potential.expression.xreplace(dict(numbers))  # type: ignore[union-attr]
    infinite = real_roots(together(field).as_numer_denom()[1], K3, S.NegativeOne, S.One) or []
    forms = revolution_forms(scene, scenes | level)
    found = []
    for n, form in enumerate(forms, 1):
        if not form.every:
            # there (p_φ − p_ψ cos θ)²/sin² θ is 0/0, with the limit 0
            pole = form.k3**2 == 1
            at = motion.axial + motion.system.potential.expression if pole else motion.effective_potential()  # type: ignore[union-attr]
            height = in_floats(at.xreplace({**numbers, K3: form.k3}), np, {})
            found.append((float(np.arccos(float(form.k3))), float(height), n, RelativeEquilibrium(form)))
    turning_points, reach = [], []
    if energy is not None:
        g = motion.square().xreplace(dict(numbers)).xreplace({ENERGY: exact_number(energy, "energy")})
        turning_points = real_roots(g, K3, S.NegativeOne, S.One) or []
        ends = [S.NegativeOne, *in_order([*turning_points, *infinite]), S.One]
        reach = [(a, b) for a, b in zip(ends, ends[1:])
                 if sign_of_constant(g.xreplace({K3: between(a, b)})) == 1]
    beside = [float(np.arccos(float(k3))) for k3 in (*turning_points, *infinite)]
    beside += [theta for theta, *_ in found]
    theta = _angles([0.0, np.pi, *beside])
    height = np.array(np.broadcast_to(in_floats(potential, np, {THETA: theta}), theta.shape), dtype=float)
    for k3 in infinite:
        at_pole = float(np.arccos(float(k3)))
        place = np.searchsorted(theta, at_pole, side="right")
        theta, height = np.insert(theta, place, at_pole), np.insert(height, place, np.nan)
    return Well(theta, height, found, turning_points, reach, any(form.every for form in forms))


def _angles(special: Sequence[float]) -> Array:
    """Evenly spaced angles inside (0, π), and others ever closer to the special ones."""
    offsets = np.pi / (ANGLES + 1) * 0.5 ** np.arange(10)
    places = [np.linspace(0, np.pi, ANGLES + 2)[1:-1],
              *(at + side * offsets for at in special for side in (1, -1)), np.array(special)]
    theta = np.unique(np.concatenate(places))
    return theta[(theta > 0) & (theta < np.pi)]


@checked
def draw_effective_potential(scene: System, values: Mapping[str, Any], energy: Any = None, ax: Any = None,
                             **kwargs: Any) -> Any:
    r"""Draw V(θ) of a body of revolution on a level of its momenta: ½ I1 θ̇² + V = energy.

    Circles are the regular precessions, E1 and E2 on the level: filled if stable, open if unstable, half
    filled if undecided. Their numbers are those in the list of relative_equilibria at pi3_0 and C1, and in
    the table of gyrostat decide. If an energy is given, a line shows where θ can be, between its turning
    points.

    Parameters
    ----------
    scene : System
        body of revolution in a U rational in k3, or about any other axis c, rational in k·c; θ and π3 + l are
        then those of c
    values : mapping of name to number
        for its parameters, p_phi = C1 and p_psi = π3 + l [M L²/T]
    energy : number or None
        [M L²/T²]
    ax : matplotlib Axes
        a new one where it is left out
    **kwargs : Any
        of the curve: of Axes.plot

    Returns
    -------
    matplotlib Axes

    Raises
    ------
    ScopeError
        the body is not of revolution, U is unspecified, or not rational in k3
    ValuesError
        numbers are missing, unknown or not admissible; no motion has the energy
    MissingExtraError
        pip install "gyrostat[plot]"

    References
    ----------
    Goldstein, Classical Mechanics, §5.7.

    Examples
    --------
    >>> import gyrostat as gs
    >>> from matplotlib.figure import Figure
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> body = {"I1": 1, "I3": "1/2", "l": 0, "m0": 1}
    >>> ax = gs.plotting.draw_effective_potential(
    ...     top, body | {"p_phi": 2, "p_psi": 3}, energy=10, ax=Figure().subplots())
    >>> ax.get_xlabel()
    '$\\theta$'
    """
    standard, left, _, about = in_own_axes(scene, values)
    found = well(standard, left, energy)
    if energy is not None and not found.reach and not found.turning_points:
        raise ValuesError(f"energy = {energy}: no motion has it on this level of p_phi and p_psi, V is "
                          "nowhere so low; give at least "
                          f"{np.nanmin(found.height):.6g}")
    ax = axes_of(ax)
    style = {"color": DARK, "linewidth": 1.6, **kwargs}
    ax.plot(found.theta, found.height, **style)
    heights = [height for _, height, *_ in found.equilibria] + ([float(exact_number(energy, "energy"))]
                                                               if energy is not None else [])
    finite = found.height[np.isfinite(found.height)]
    infinite = len(finite) < len(found.height)
    low = float(min([np.quantile(finite, 0.1) if infinite else finite.min(), *heights]))
    depth = max(heights, default=low) - low or float(np.quantile(finite, 0.4)) - low or 1.0
    ax.set(xlim=(0, np.pi), ylim=(low - 0.2 * depth, low + 2.2 * depth))
    handles = [named(style, "every tilt an equilibrium")] if found.level else []
    if energy is not None:
        handles.append(named(_energy(ax, found, heights[-1]), "motion at the energy"))
    for verdict in Verdict:
        points = [(x, y) for x, y, _, branch in found.equilibria if branch.decision.verdict is verdict]
        decisions = [branch.decision for *_, branch in found.equilibria if branch.decision.verdict is verdict]
        handles += dots_of(ax, points, marker(verdict), meaning(verdict, decisions), clip_on=False)
    ax.set_xticks(np.pi / 4 * np.arange(5), ["$0$", r"$\pi/4$", r"$\pi/2$", r"$3\pi/4$", r"$\pi$"])
    letters = letters_of(scene)
    ax.set(xlabel=label("theta"), ylabel=axis(letters.of("V"), (1, 2, 0)))
    shown = {} if energy is None else {letters.of("h"): energy}
    above, numbers = of_scene(scene, {**values, **shown})
    headed(ax, "Effective potential of a body of revolution", ([*above, *about], numbers), handles, 2)
    room(ax)
    written_at(ax, [(str(n), (x, y)) for x, y, n, _ in found.equilibria], MARKER)
    return ax


def _energy(ax: Any, found: Well, energy: float) -> dict[str, Any]:
    """The energy as a faint line, heavy where V is below it, with a tick at each turning point."""
    style = {"color": BLUE, "linewidth": 2.2, "linestyle": "-"}
    ax.axhline(energy, color=GREY, linewidth=0.7, zorder=1)
    for low, high in reversed(found.reach):
        b, a = (float(np.arccos(float(k3))) for k3 in (low, high))
        ax.plot([a, b], [energy, energy], zorder=2, solid_capstyle="butt", **style)
        inside = (found.theta >= a) & (found.theta <= b)
        ax.fill_between(found.theta[inside], np.minimum(found.height[inside], energy), energy,
                        color="#e9edf2", zorder=0, linewidth=0)
    turns = [float(np.arccos(float(k3))) for k3 in found.turning_points]
    ax.plot(turns, [energy] * len(turns), marker="|", markersize=11, markeredgewidth=2.2, linestyle="none",
            color=BLUE, zorder=3)
    return style
