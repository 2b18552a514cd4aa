"""The permanent rotations of a body in a field at a rate, over a range of a name, and where they meet."""
import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from flint import fmpq_mpoly, fmpq_poly
from sympy import Add, Expr, Matrix, Rational, S, eye

from ...algebra.enclosures.balls import accurate, ball, fraction_of
from ...algebra.enclosures.floats import Array
from ...algebra.reals.exact import Point, evaluate, proved_sign
from ...algebra.reals.number_fields import at_root, common_divisor, in_one
from ...algebra.rings.matrices import adjugate
from ...algebra.rings.polynomials import by_degree
from ...algebra.solving.pencils import along_kernel
from ...algebra.solving.plane_curves import PlaneCurve
from ...algebra.solving.roots import in_order, real_roots, roots_of_factor
from ...errors import ScopeError, ValuesError
from ...mechanics.scenes.system import System, names_of_scene
from ...notation import symbol
from ...stability.criteria.numbers_asked import unknown
from ...stability.decision import Verdict
from ..finders.heavy import heavy_forms
from ..finders.heavy_form import HeavyForm, data_at
from ..finders.heavy_polynomials import degree_in_k
from ..finders.rate_level_tilt import exact_point
from ..relative_equilibrium import RelativeEquilibrium
from .meeting_values import BifurcationPoint
from .stations_at_rate import admissible, within

OMEGA, SIGMA = symbol("omega"), symbol("sigma")
# between two stations; how near the first and the last are to them; of a change of the verdict, halvings
NODES, NEAR, HALVINGS = 12, Fraction(1, 2**20), 10
SAME = 1e-9                                                # of sigma
PRECISION = 128                                            # bits


@dataclass(frozen=True, eq=False)
class HeavyPiece:
    """Permanent rotations in a field over part of a range, of one verdict.

    Parameters
    ----------
    parameter : array, shape (n,)
    k : array, shape (n, 3)
        of a circle of rotations one of them
    verdict : Verdict
        exact at the nodes
    """

    parameter: Array
    k: Array
    verdict: Verdict


@dataclass(frozen=True, eq=False)
class HeavyContinuation:
    """Permanent rotations in a field at a rate, over a range of one name, and where they meet.

    Parameters
    ----------
    pieces : list of HeavyPiece
        none goes on through a value where two rotations meet; where the verdict differs between two nodes the
        change is enclosed by halving, and two changes between the same nodes are not seen
    marks : list of BifurcationPoint
        exact and complete

    Examples
    --------
    >>> import gyrostat as gs
    >>> U = gs.general_potential(lambda k1, k2, k3: k1 + k2 + k3)
    >>> scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)), U)
    >>> found = gs.continuation(scene, "omega", (1, 2), {})
    >>> [(mark.kind, round(float(mark.value), 4)) for mark in found.marks]
    [('fold', 1.7046), ('fold', 1.7046)]
    >>> [piece.verdict.name for piece in found.pieces if piece.parameter[0] < 1.01]
    ['STABLE', 'UNSTABLE']
    """

    pieces: list[HeavyPiece]
    marks: list[BifurcationPoint]


def followed_heavy(scene: System, name: str, low: Expr, high: Expr,
                   values: Mapping[str, Any]) -> HeavyContinuation:
    """Every rotation over a range, cut where two meet; U of degree 1 or 2 in k."""
    needed = {s.name for s in names_of_scene(scene)} | {"omega"}
    if name not in needed:
        raise ValuesError(unknown(name, sorted(needed), "the scene"))
    if name in values:
        raise ValuesError(f"{name} is free, and has the value {values[name]} too: leave out one of the two")
    numbers = exact_point(scene, values, needed)
    if missing := sorted(needed - values.keys() - {name}):
        raise ValuesError(f"the permanent rotations need {', '.join(missing)}: give a number for each")
    admissible(scene.body.positive, numbers, free := symbol(name), low, high)
    if (degree := degree_in_k(scene, "at a rate omega")) > 2:
        raise ScopeError(f"U has degree {degree} in k: rotations are followed where it has degree 1 or 2; "
                         "relative_equilibria finds them at each value")
    pencil, vector = _system(scene, numbers)
    minors = Matrix(adjugate(pencil.tolist()))
    above, below = minors * vector, pencil[:, 0].dot(minors[:, 0])
    curve = PlaneCurve(above.dot(above) - below**2, SIGMA, free, ends=())
    if not curve.rational:
        raise ScopeError("rotations are followed at rational numbers: round the others to decimals")
    met = _double_points(curve, low, high)
    inner = in_order(list({t for t, _ in met} - {low, high}))
    spans = [_between(scene, name, values, a, b) for a, b in pairwise([low, *inner, high])]
    even = {t for t, left, right in zip(inner, spans, spans[1:]) if len(left) == len(right)}
    marks = []
    for t in in_order(list({t for t, _ in met})):
        N, b = (m.xreplace({free: t}) for m in (pencil, vector))
        here = [place for value, sigma in met if value == t for place in _met_at(N, b, sigma)]
        if len(here) == 1 and t in even:                   # none appears, none vanishes
            here = [("crossing", k) for kind, k in here if kind == "fold"]
        marks += [BifurcationPoint(kind, name, t, k[2], k=k) for kind, k in here]
    return HeavyContinuation([piece for span in spans for line in span for piece in line], marks)


def _system(scene: System, numbers: Point) -> tuple[Matrix, Matrix]:
    """N = omega² I − Q + sigma and b = c − omega l, of U = c·k + k·Qk/2: N k = b."""
    inertia, rotor, linear, curved = data_at(scene, (S.Zero,) * 3)
    omega = numbers.get(OMEGA, OMEGA)
    pencil = omega**2 * Matrix(inertia) - Matrix(curved) + SIGMA * eye(3)
    vector = Matrix(linear) - omega * Matrix(rotor)
    return pencil.xreplace(numbers), vector.xreplace(numbers)


def _double_points(curve: PlaneCurve, low: Expr, high: Expr) -> list[tuple[Expr, Expr]]:
    """(t, sigma) of every double point over the range: common roots in sigma at roots of resultants in t."""
    x, t = curve.place
    found: list[tuple[Expr, Expr]] = []

    def by_sigma(F: fmpq_mpoly) -> list[fmpq_poly]:
        return [in_one(c, t) for c in by_degree(F, x, curve.degree(F, 0))]

    for n, F in enumerate(curve.components):
        for G in (F.derivative(x), *curve.components[n + 1:]):
            if not curve.degree(G, 0):
                continue
            resultant = in_one(F.resultant(G, F.context().names()[x]), t)
            for factor, _ in resultant.factor()[1]:
                if not (roots := [r for r in roots_of_factor(factor) if within(r, low, high)]):
                    continue
                shared = common_divisor(by_sigma(F), by_sigma(G), factor)
                for root in roots:
                    both = Add(*(at_root(c, root) * SIGMA**n for n, c in enumerate(shared)))
                    one = [-at_root(shared[0], root)] if len(shared) == 2 else real_roots(both, SIGMA) or []
                    found += [(root, sigma) for sigma in one]
    return list(dict.fromkeys(found))


def _met_at(pencil: Matrix, vector: Matrix, sigma: Expr) -> Iterator[tuple[str, tuple[Expr, ...]]]:
    """(kind, k) of what meets at a double root sigma of abs(adj(N) b)² = det(N)²."""
    minors = Matrix(adjugate(pencil.tolist()))
    above, below = minors * vector, pencil[:, 0].dot(minors[:, 0]).expand()
    under = evaluate(below, {SIGMA: sigma})
    if proved_sign(under) != 0:
        yield "fold", tuple(evaluate(x, {SIGMA: sigma}) / under for x in above)
        return
    here = pencil.xreplace({SIGMA: sigma})
    singular = Matrix(adjugate(here.tolist()))
    for _, k, circle in along_kernel(pencil, above, below, S.One, SIGMA, sigma):
        if circle is not None:
            yield "circle at this value alone", k
        elif not any(proved_sign(evaluate(x, {})) for x in singular):
            yield "circle leaves an axis", k
        elif not any(proved_sign(evaluate(x, {})) for x in singular * Matrix(k)):
            across = here.trace() - Matrix(k).dot(here * Matrix(k))
            yield "pitchfork" if proved_sign(evaluate(across, {})) else "umbilic", k


def _between(scene: System, name: str, values: Mapping[str, Any], a: Expr, b: Expr) -> list[list[HeavyPiece]]:
    """Each rotation between two stations; there the values of sigma are simple and in a fixed order."""
    def found(t: Fraction, before: list[_Node]) -> list[_Node]:
        at = {**values, name: Rational(t.numerator, t.denominator)}
        return _in_line([_node(t, r) for r in heavy_forms(scene, at)], before)

    low, high = (fraction_of(ball(t, PRECISION).mid()) for t in (a, b))
    parts = [Fraction(x) for x in ((1 - np.cos(np.pi * np.arange(1, NODES) / NODES)) / 2).tolist()]
    rows: list[list[_Node]] = []
    for part in (NEAR, *parts, 1 - NEAR):
        t = (low + (high - low) * part).limit_denominator(2**40)
        rows.append(found(t, rows[-1] if rows else []))
    return [[_piece(nodes) for nodes in _cut(rows, n, found)] for n in range(len(rows[0]))]


def _cut(rows: list[list["_Node"]], n: int, found: Callable[[Fraction, list["_Node"]], list["_Node"]]
         ) -> list[list["_Node"]]:
    """The nodes of one rotation, cut where the verdict changes."""
    pieces = [[rows[0][n]]]
    for before, row in pairwise(rows):
        left, right = [before[n]], [row[n]]
        while left[-1].verdict is not right[0].verdict and len(left) + len(right) < HALVINGS:
            middle = found((left[-1].t + right[0].t) / 2, before)[n]
            if middle.verdict is left[-1].verdict:
                left.append(middle)
            else:
                right.insert(0, middle)
        pieces[-1] += left[1:]
        if left[-1].verdict is right[0].verdict:
            pieces[-1] += right
        else:
            pieces.append(right)
    return pieces


def _piece(nodes: list["_Node"]) -> HeavyPiece:
    t, k = [float(node.t) for node in nodes], [node.k for node in nodes]
    return HeavyPiece(np.array(t), np.array(k), nodes[0].verdict)


class _Node(NamedTuple):
    """A rotation at a value of the name, in doubles."""

    t: Fraction
    sigma: float
    k: tuple[float, ...]
    verdict: Verdict


def _node(t: Fraction, rotation: HeavyForm) -> _Node:
    k = np.array([float(accurate(x, 60).mid()) for x in rotation.k])
    inertia, rotor, _, _ = data = data_at(rotation.scene, (S.Zero,) * 3)
    I, l, c, Q = (np.array(x, float) for x in (inertia, rotor, data.gradient, data.hessian))
    omega = float(accurate(rotation.omega, 60).mid())
    sigma = float(k @ (c + Q @ k - omega * l - omega**2 * I @ k))
    return _Node(t, sigma, tuple(k), RelativeEquilibrium(rotation).decision.verdict)


def _in_line(nodes: list[_Node], before: list[_Node]) -> list[_Node]:
    """In the order of sigma; of two of one sigma first that which is nearer to the first of them before."""
    nodes = sorted(nodes, key=lambda node: node.sigma)
    for n in range(len(before) - 1):
        one, other = nodes[n:n + 2]
        same = abs(one.sigma - other.sigma) < SAME * (1 + abs(one.sigma))
        if same and math.dist(one.k, before[n].k) > math.dist(other.k, before[n].k):
            nodes[n:n + 2] = other, one
    return nodes
