"""The energy-momentum diagram of a body of revolution in U(k3): critical values of (C1, h) at a fixed axial momentum."""
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from sympy import Expr, S

from ..algebra import Ring, by_degree
from ..branches import Branch, names_of, relative_equilibria
from ..errors import require
from ..exact import evaluate
from ..grids import Array
from ..notation import symbol
from ..numeric import in_floats
from ..reduction import K3, OMEGA, P, Reduction, V, reduce
from ..roots import real_roots
from ..stability import Verdict
from ..system import System
from .looks import axes_of, label, legend, line, marker, named, runs
from .scenes import numbers_of

TILTS, CELLS = 4000, 400                                   # values of k3 along the curves; of each axis, for the regions
BANDS = ("#ffffff", "#eceff3", "#d3dae3", "#b9c4d1")       # k3 has no place, one band, two bands, three or more


@dataclass(frozen=True)
class CriticalCurve:
    """Values of (C1, h) on regular precessions of one verdict.

    Parameters
    ----------
    k3, omega, momentum, energy : arrays, shape (n,)      tilt, rate about the vertical, C1 and h
    verdict : Verdict                                     exact, at the middle
    """

    k3: Array
    omega: Array
    momentum: Array
    energy: Array
    verdict: Verdict


@dataclass(frozen=True)
class EnergyMomentum:
    """Critical values of (C1, h): curves, points (C1, h, branch) of E1 and E2, and V(C1, k3) in doubles for the regions."""

    curves: list[CriticalCurve]
    poles: list[tuple[float, float, Branch]]
    potential: Expr

    def bands(self, momentum: Array, energy: Array) -> Array:
        """The number of bands of k3 in which the body can move, shape (len(energy), len(momentum))."""
        k3 = np.cos(np.linspace(0, np.pi, CELLS + 2)[1:-1])
        height = in_floats(self.potential, np, {V: momentum[:, None], K3: k3})
        below = height[None] <= energy[:, None, None]
        return below[..., 0].astype(int) + (below[..., 1:] & ~below[..., :-1]).sum(axis=-1)


def energy_momentum(scene: System, values: Mapping[str, Any]) -> EnergyMomentum:
    """Every critical value of (C1, h) at a fixed p_psi = π3 + l.

    On regular precessions I1 k3 W² − p_ψ W + U' = 0 has a slow and a fast root W at each tilt; C1 and h follow. The curves are in doubles,
    cut where stability changes; the verdict of each part is exact.

    Parameters
    ----------
    scene, values      as in draw_energy_momentum

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> found = energy_momentum(top, {"I1": 1, "I3": 1, "l": 0, "m0": 1, "p_psi": 1})
    >>> {curve.verdict.name for curve in found.curves}, [(v, h, pole.decision.verdict.name) for v, h, pole in found.poles]
    ({'STABLE'}, [(1.0, 1.5, 'UNSTABLE'), (-1.0, -0.5, 'STABLE')])
    """
    require(scene, System, "the scene")
    names_of(scene)                                    # in U(k3), given: or refused
    assert scene.potential is not None
    numbers, motion = numbers_of(scene, values, ("p_psi",)), reduce(scene)
    given = {name.name: x for name, x in numbers.items() if name != P} | {
        "pi3_0": evaluate(P - scene.body.gyrostatic_momentum[2], numbers)}
    level, height, margin = (e.xreplace(numbers) for e in _on_precessions(motion))
    k3, rates = _rates(motion.precession().xreplace(_jets(motion)).xreplace(numbers))
    curves = []
    for omega, sides in zip(rates, (np.ones_like(k3), np.sign(k3))):        # the fast one is infinite at k3 = 0
        with np.errstate(invalid="ignore"):
            v, h, sign = (np.broadcast_to(in_floats(e, np, {K3: k3, OMEGA: omega}), k3.shape) for e in (level, height, margin))
        kind = np.where(np.isfinite(omega), np.sign(sign) + 4 * sides, 0)
        for run in runs(kind):
            if not kind[run.start]:
                continue
            middle = (run.start + run.stop) // 2
            here = relative_equilibria(scene, {**given, "k3": float(k3[middle])})
            decision = here[int(np.argmin([abs(float(in_floats(branch.omega, np, {})) - omega[middle]) for branch in here]))].decision
            joined = run.stop < len(k3) and kind[run.stop] and sides[run.stop] == sides[run.start]
            part = slice(run.start, run.stop + bool(joined))
            curves.append(CriticalCurve(k3[part], omega[part], v[part], h[part], decision.verdict))
    poles = []
    for side, name in ((1, "E1"), (-1, "E2")):
        for branch in relative_equilibria(scene, {**given, "C1": side * numbers[P]}):
            if branch.label == name:
                at = (motion.axial + scene.potential.expression).xreplace({K3: S(side), **numbers})
                poles.append((float(side * numbers[P]), float(in_floats(at, np, {})), branch))
    return EnergyMomentum(curves, poles, motion.effective_potential().xreplace(numbers))


def _on_precessions(motion: Reduction) -> tuple[Expr, Expr, Expr]:
    """C1, h, and what is positive where they are stable, of regular precessions in k3 and the rate omega."""
    level = V - motion.twist + motion.system.body.inertia[0] * OMEGA * motion.across           # motion.rate is omega there
    return level, motion.effective_potential().xreplace({V: level}), motion.restoring().xreplace(_jets(motion))


def _jets(motion: Reduction) -> dict[Any, Expr]:
    """U' and U'' of the scene."""
    potential = motion.system.potential
    assert potential is not None
    return {name: potential.value(name) for name in (symbol("dU"), symbol("d2U"))}


def _rates(relation: Expr) -> tuple[Array, tuple[Array, Array]]:
    """Tilts, among them those at which the two rates are one, and the slow and the fast rate there, NaN where there is none."""
    ring = Ring([relation, OMEGA])
    top, place = ring.reduce(ring.fraction(relation)[0]), ring.generators.index(OMEGA)
    c, b, a = (ring.expression(part) for part in by_degree(top, place, 2))
    double = np.array([float(root) for root in real_roots(b**2 - 4 * a * c, K3, S.NegativeOne, S.One) or ()])
    k3 = np.sort(np.concatenate([np.cos(np.linspace(0, np.pi, TILTS + 2)[1:-1]), double]))
    a, b, c = (np.broadcast_to(in_floats(part, np, {K3: k3}), k3.shape) for part in (a, b, c))
    square = np.where(np.isin(k3, double), 0.0, b**2 - 4 * a * c)
    with np.errstate(invalid="ignore", divide="ignore"):
        q = -(b + np.where(b < 0, -1, 1) * np.sqrt(square)) / 2             # no cancellation
        return k3, (c / q, q / a)


def draw_energy_momentum(scene: System, values: Mapping[str, Any], window: tuple[float, float, float, float] | None = None, ax: Any = None,
                         **kwargs: Any) -> Any:
    """Draw the energy-momentum diagram of a body of revolution in U(k3): h against C1 at a fixed p_psi = π3 + l.

    The curves are the regular precessions, the points E1 and E2: solid or filled where stable, dashed or open where unstable, dotted or
    half filled where undecided. Grey is where motion is possible; the darker, the more bands of k3 there are at the same C1 and h.

    Parameters
    ----------
    scene : System                                body of revolution in a U rational in k3
    values : mapping of name to number            for its parameters, and p_psi [M L²/T]
    window : (C1, C1, h, h) or None               lower and upper ends of the axes; None: around what is critical
    ax : matplotlib Axes                          a new one where it is left out
    kwargs                                        of the curves: of Axes.plot

    Returns
    -------
    matplotlib Axes

    Raises
    ------
    ScopeError             the body is not of revolution, U is unspecified, or not rational in k3
    ValuesError            numbers are missing, unknown or not admissible
    MissingExtraError      pip install "gyrostat[plot]"

    Source
    ------
    Smale, Inventiones Mathematicae 10 (1970) 305-331; Cushman & Bates, Global Aspects of Classical Integrable Systems (1997), chapter V.

    Examples
    --------
    >>> import gyrostat as gs
    >>> from matplotlib.figure import Figure
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> ax = draw_energy_momentum(top, {"I1": 1, "I3": 1, "l": 0, "m0": 1, "p_psi": 1}, ax=Figure().subplots())
    >>> [text.get_text() for text in ax.get_legend().get_texts()]
    ['stable', 'unstable', 'one band of $k_3$']
    """
    found = energy_momentum(scene, values)
    ax = axes_of(ax)
    left, right, low, high = _window(found) if window is None else window
    momentum, energy = np.linspace(left, right, CELLS), np.linspace(low, high, CELLS)
    bands = found.bands(momentum, energy)
    ax.contourf(momentum, energy, bands, levels=[0.5, 1.5, 2.5, 99], colors=BANDS[1:], zorder=0)
    for curve in found.curves:
        ax.plot(curve.momentum, curve.energy, **{**line(curve.verdict), **kwargs})
    for v, h, branch in found.poles:
        ax.plot([v], [h], zorder=4, **marker(branch.decision.verdict))
        ax.annotate(branch.label, (v, h), xytext=(7, -4), textcoords="offset points", va="top")
    ax.set(xlim=(left, right), ylim=(low, high))
    ax.set_xlabel(label("C1"))
    ax.set_ylabel(label("h"))
    seen = {x.verdict for x in found.curves} | {branch.decision.verdict for *_, branch in found.poles}
    legend(ax, [named({**marker(x), **line(x), **kwargs}, x.name.lower()) for x in Verdict if x in seen] + _areas(int(bands.max())))
    return ax


def _areas(most: int) -> list[Any]:
    """What stands in the legend for the regions."""
    from matplotlib.patches import Patch
    names = ("one band of $k_3$", "two bands", "three bands or more")
    return [Patch(facecolor=color, edgecolor="none", label=name) for color, name in list(zip(BANDS[1:], names))[:most]]


def _window(found: EnergyMomentum) -> tuple[float, float, float, float]:
    """Around E1, E2 and half of the precessions."""
    momenta = np.abs(np.concatenate([curve.momentum for curve in found.curves]))
    width = 1.5 * max([float(np.median(momenta)), *(abs(v) for v, _, _ in found.poles)])
    near = np.concatenate([[h for _, h, _ in found.poles], *(curve.energy[np.abs(curve.momentum) < width] for curve in found.curves)])
    low, high = float(near.min()), float(near.max())
    return -width, width, low - 0.08 * (high - low), high + 0.15 * (high - low)
