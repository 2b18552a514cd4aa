"""Draws permanent rotations in the plane of omega and sigma: the real curve abs(k) = 1, with verdicts."""
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from sympy import Expr, oo

from ..algebra.enclosures.floats import Array, row
from ..algebra.reals.exact import proved_sign
from ..algebra.text.numbers import exact_number
from ..arguments import checked, several
from ..equilibria.curves.arc import Arc, End, Piece
from ..equilibria.curves.inertia_axes import InertiaAxes
from ..equilibria.curves.staude import staude_cone
from ..errors import ValuesError
from ..mechanics.scenes.system import System
from ..stability.decision import Verdict
from .along_arcs import along, changes_of, floats, halved, placed
from .beside import Marks
from .captions import headed
from .globe import curves_of, dots_of
from .headings import number, of_scene
from .looks import GREY, axes_of, axis, line, with_dimension
from .staude_cone import FILLS, FOLD, REST, change

STEP, BEYOND, MARGIN = 0.02, 1.2, 1.25                 # of the window; where a curve may be cut; around marks
SAMPLES, LEAST = 201, 1e-9                             # of a parabola; beside an end
AXES = {"color": GREY, "linewidth": 0.7, "zorder": 1}


@checked
def draw_staude_plane(scene: System, values: Mapping[str, Any] | None = None,
                      omega: Sequence[Any] | None = None, ax: Any = None, **kwargs: Any) -> Any:
    """Draw the permanent rotations of a heavy body against their rate, in the plane of omega and sigma.

    With ∇U = omega² Ik + omega l + sigma k and U = c·k they are the real curve Σ (c_i − omega l_i)²/(sigma +
    omega² I_i)² = 1, in the look of their verdicts: a line across it at one omega meets every rotation of
    that rate. Upwards is sigma + omega² I of the middle moment I, so that the branches are apart. Circles:
    folds, two become one; diamonds: changes of the verdict; crosses: ±c, at rest; grey: sigma = −omega² I_i,
    k along principal axis i, where they go as omega → ±∞.

    Parameters
    ----------
    scene : System
        with U = c·k; with a rotor, of rational numbers
    values : mapping of name to number, or None
        for every name of the scene
    omega : (low, high) or None
        the range of rates; None: all that is marked
    ax : matplotlib Axes
        new ones where they are left out
    **kwargs : Any
        of the curve: of Axes.plot

    Returns
    -------
    matplotlib Axes

    Raises
    ------
    ScopeError
        U is not c·k, every direction, or every one of a circle, is that of a
        permanent rotation; with a rotor, a number is not rational
    ValuesError
        a name is missing or unknown, a number is not admissible, or the range is empty
    MissingExtraError
        pip install "gyrostat[plot]"

    References
    ----------
    Derived.

    Examples
    --------
    >>> import gyrostat as gs
    >>> from matplotlib.figure import Figure
    >>> U = gs.general_potential(lambda k1, k2, k3: k1 + k2 + k3)
    >>> scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)), U)
    >>> ax = gs.plotting.draw_staude_plane(scene, ax=Figure().subplots())
    >>> [text.get_text() for text in ax.get_legend().get_texts()]
    ['stable', 'unstable', 'fold']
    >>> sorted(text.get_text() for text in ax.texts)
    ['at rest', 'stable to unstable']
    """
    arcs = staude_cone(scene).arcs(values or {})
    plane = _Plane(arcs[0].scene)
    folds = [place for arc in arcs for place in plane.folds(arc)]
    changes = [(place, said) for arc in arcs for x, said in changes_of(arc) for place in plane.at(arc, x)]
    rest = [np.array([0.0, side * np.linalg.norm(plane.c)]) for side in (1, -1)]
    low, high = plane.rates([*folds, *(place for place, _ in changes)]) if omega is None else _range(omega)
    bottom, top = plane.heights(max(-low, high))
    window = np.array([max(-low, high), max(-bottom, top)])
    ax, handles = axes_of(ax), []
    rates = np.linspace(low, high, SAMPLES)
    for moment in plane.moments:
        ax.plot(rates, (plane.middle - moment) * rates**2, **AXES)
    for verdict in Verdict:
        own = [curve for arc in arcs for piece in arc.pieces if piece.decision.verdict is verdict
               for curve in plane.curves(arc, piece, window)]
        handles += curves_of(ax, own, {**line(verdict), **kwargs}, verdict.name.lower())
    marks = [Marks(handle, points) for points, look, name in (
        *(([place for place, what in changes if what == said], change(fill), said)
          for said, fill in FILLS.items()), (folds, FOLD, "fold"), (rest, REST, "at rest"))
        for handle in dots_of(ax, points, look, name)]
    upwards = rf"$\sigma + {number(plane.exact, str(plane.exact))}\,\omega^2$"
    ax.set(xlim=(low, high), ylim=(bottom, top), xlabel=axis("omega"),
           ylabel=with_dimension(upwards, (1, 2, 0)))
    headed(ax, r"Permanent rotations in the plane of $\omega$ and $\sigma$", of_scene(scene, values or {}),
           handles, marks=marks,
           after=r"On grey curves $\sigma = -\omega^2 I_i$")
    return ax


class _Plane:
    """Places the rotations of a body in the plane of omega and sigma + omega² I, in doubles."""

    def __init__(self, scene: System):
        U, body = scene.potential, scene.body
        assert U is not None
        moments = [m for m in InertiaAxes(body).moments for _ in range(InertiaAxes(body).order(m))]
        self.exact = sorted(moments, key=float)[1]
        self.middle, self.moments = float(self.exact), np.array([float(x) for x in moments])
        self.tensor = np.array(body.tensor, float)
        self.rotor = np.array([float(x) for x in body.gyrostatic_momentum])
        self.c = np.array([float(U.value(x)) if x else 0.0 for x in U.gradient()])

    def of_end(self, end: End) -> Array:
        """The place of an end of finite rate."""
        k, omega = floats(end.k), float(end.omega)
        apart = omega**2 * (self.middle * k - self.tensor @ k)
        return np.array([omega, k @ (self.c - omega * self.rotor + apart)])

    def along(self, arc: Arc, parameters: Array) -> Array:
        """Places along an arc, without a rotor those of positive omega; shape (n, 2)."""
        _, omega, sigma = along(arc, parameters)
        return np.stack([omega, sigma + self.middle * omega**2], axis=1)

    def at(self, arc: Arc, x: Expr) -> list[Array]:
        """The places at a value of the parameter."""
        return _at_both_rates(arc, self.along(arc, np.array([float(x)]))[0])

    def folds(self, arc: Arc) -> list[Array]:
        """Where two rotations of one rate become one."""
        return [*(self.of_end(end) for end in arc.ends if end.omega not in (0, oo, -oo)),
                *(place for x in arc.folds for place in self.at(arc, x))]

    def rates(self, places: Sequence[Array]) -> tuple[float, float]:
        """A range with some places in it, or with what is usual for the body."""
        usual = np.sqrt(np.linalg.norm(self.c) / self.moments.sum())
        most = MARGIN * max([abs(float(place[0])) for place in places] or [2 * usual])
        return -most, most

    def heights(self, omega: float) -> tuple[float, float]:
        """Bounds of sigma + omega² I at all rates up to one."""
        still = float(np.linalg.norm(self.c) + omega * np.linalg.norm(self.rotor))
        apart = omega**2 * (self.middle - self.moments)
        return float(apart.min()) - still, float(apart.max()) + still

    def curves(self, arc: Arc, piece: Piece, window: Array) -> list[Array]:
        """A piece of an arc, cut outside the window."""
        def inside(places: Array) -> Array:
            return np.clip(places / window, -BEYOND, BEYOND)

        def on_arc(t: Array) -> Array:
            return inside(self.along(arc, placed(arc, piece, t)))

        first, last = (
            inside(self.of_end(end)) if at == own and end.omega not in (oo, -oo) else on_arc(np.array([t]))[0]
            for end, at, own, t in zip(arc.ends, (piece.low, piece.high), (arc.low, arc.high),
                                       (LEAST, 1 - LEAST)))
        return _at_both_rates(arc, window * halved(on_arc, first, last, STEP))


def _at_both_rates(arc: Arc, places: Array) -> list[Array]:
    """Without a rotor −omega is a rate, too."""
    return [places, places * (-1, 1)] if arc.both_ways else [places]


def _range(omega: Sequence[Any]) -> tuple[float, float]:
    low, high = (exact_number(x, "omega") for x in several(omega, "omega", 2))
    if proved_sign(high - low) != 1:
        raise ValuesError(f"omega goes from {low} to {high}: give the lower one first")
    return tuple(row([low, high], "omega").tolist())
