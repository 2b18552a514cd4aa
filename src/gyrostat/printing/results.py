"""What is found beyond a report, as sentences and displays.

Sets of a parameter, branches, bifurcations, the reduced motion.
"""
from functools import singledispatch
from typing import Any

from sympy import Abs, CRootOf, Expr, Pow, S, oo, sqrt

from ..algebra.readable import readable
from ..mechanics.reduction import Reduction
from ..notation import symbol
from ..stability.bifurcations import KINDS, Bifurcation, BifurcationPoint
from ..stability.boundary import Boundary
from ..stability.branch import Branch
from ..stability.drift import Drift
from ..stability.linearization import rational_root
from ..stability.permanent_rotations import PermanentRotation
from ..stability.sets import EXCLUDED, INCLUDED, Interval, Ladder, Solution, SolvedCondition
from .blocks import Block, Display, Sentence, Word, drift_displays, existence, ladder, rung_display

# operations under a root, more of which are given a name
LONG = 8
_RELATION = {"<": "<", ">": ">", "=": "=", "!=": "≠"}


@singledispatch
def result_blocks(obj: Any) -> list[Block]:
    """The blocks of one result."""
    raise TypeError(f"{type(obj).__name__} is no result")


@result_blocks.register
def _solution(solution: Solution) -> list[Block]:
    premises = [p for p in solution.parts if p.meaning == "exists"
                and symbol(solution.name) not in p.margin.free_symbols]
    blocks: list[Block] = (
        [Sentence("Where it exists:"), *(existence(p.margin, p.at) for p in premises)] if premises else []
    )
    for meaning, title in _TITLES.items():
        parts = [p for p in solution.parts if p.meaning == meaning and p not in premises]
        if len(parts) > 1:
            blocks.append(Sentence(f"{title} where all of these hold:" if meaning != "necessary"
                                   else f"{title} all of these hold:"))
        blocks += [block for n, p in enumerate(parts, 1)
                   for block in _part(p, solution.name, title if len(parts) == 1 else f"({n})")]
    if any(p.meaning == "sufficient" for p in solution.parts):
        blocks.append(Sentence("Where it is neither proved stable nor proved unstable, nothing is claimed."))
    return blocks


_TITLES = {"exists": "It exists", "stable": "Stable", "sufficient": "Proved stable",
           "necessary": "Unstable unless",
           "undecided": "Nothing is proved for"}


def _part(part: SolvedCondition, name: str, title: str) -> list[Block]:
    """One line for each case."""
    x = symbol(name)
    blocks: list[Block] = []
    names: dict[Expr, Expr] = {}
    for case in part.cases:
        when = "for " * bool(case.when) + " and ".join(f"{{}} {_RELATION[relation]} 0"
                                                       for _, relation in case.when)
        template, parts = _set(case.intervals, x)
        shown = [_abbreviated(p, names) for p in (*(readable(e) for e, _ in case.when), *parts)]
        blocks.append(Sentence(f"{title}{f' {when}' if when else ''}: {template}.", tuple(shown), part.at))
    return blocks + ([Sentence("There:"), *(Display(name, _tidy(e), part.at) for e, name in names.items())]
                     if names else [])


def _abbreviated(value: Any, names: dict[Expr, Expr]) -> Any:
    """A part of a sentence, with names R1, R2, … for what is long under its roots, inner roots first."""
    if not isinstance(value, Expr):
        return value
    done: dict[Expr, Expr] = {}
    for root in sorted((p for p in value.atoms(Pow) if p.exp == S.Half), key=lambda p: p.count_ops()):
        if root.base.count_ops() > LONG:
            done[root] = sqrt(names.setdefault(root.base.xreplace(done), symbol(f"R{len(names) + 1}")))
    return value.xreplace(done)


def _set(intervals: tuple[Interval, ...], x: Expr) -> tuple[str, tuple[Any, ...]]:
    """A union of intervals in words, and what stands in its places."""
    if not intervals:
        return "no {}", (x,)
    lowest = S.Zero if x.is_positive else -oo
    ends = [(end, rungs) for i in intervals for end, rungs in ((i.low, i.low_if), (i.high, i.high_if))
            if end not in (lowest, oo)]
    shared = ends[0][1] if ends and all(rungs == ends[0][1] for _, rungs in ends) else None
    if not ends:
        return "every {}", (x,)
    first, second = intervals[0], intervals[-1]
    parts: tuple[Any, ...]
    touching = (
        len(intervals) == 2
        and first.high == second.low
        and shared is not None
        and not any(i.tilt for i in intervals)
    )
    if touching and shared == INCLUDED:
        return "every {}", (x,)
    if touching:
        text, parts = "{} ≠ {}", (x, number(first.high))
    else:
        pieces = [_interval(i, x, lowest, shared) for i in intervals]
        text, parts = " or ".join(t for t, _ in pieces), tuple(p for _, ps in pieces for p in ps)
    if shared in (EXCLUDED, INCLUDED):
        return text, parts
    several = len({end for end, _ in ends}) > 1
    for end, rungs in [(None, shared)] if shared is not None and several else dict(ends).items():
        if rungs is not None and rungs != INCLUDED and any(not (-rung).is_nonnegative for rung in rungs):
            condition, more = _included(rungs)
            text += f"; {'{} = {}' if end is not None else 'the ends'} too where {condition}"
            parts += (*((x, number(end)) if end is not None else ()), *more)
    return text, parts


def _interval(i: Interval, x: Expr, lowest: Expr, shared: Ladder | None) -> tuple[str, tuple[Any, ...]]:
    text: str = "{}"
    parts: tuple[Any, ...] = (x,)
    if i.low == i.high:
        text, parts = "{} = {}", (x, number(i.low))
    else:
        if i.low != lowest:
            text, parts = f"{{}} {'≤' if i.low_if == INCLUDED else '<'} " + text, (number(i.low), *parts)
        if i.high != oo:
            text, parts = text + f" {'≤' if i.high_if == INCLUDED else '<'} {{}}", (*parts, number(i.high))
        elif i.low != lowest and not i.tilt:
            text, parts = f"{{}} {'≥' if i.low_if == INCLUDED else '>'} {{}}", (x, number(i.low))
    if i.tilt:
        text, parts = text + " ({} from {} to {})", (*parts, symbol("k3"), *map(number, i.tilt))
    return text, parts


def _included(rungs: Ladder) -> tuple[str, tuple[Any, ...]]:
    """When an end belongs to the set: the first that is not 0 is positive."""
    clauses: list[str] = []
    parts: tuple[Any, ...] = ()
    for n, rung in enumerate(rungs):
        if (-rung).is_nonnegative:                         # it cannot be positive
            continue
        zeros = " and ".join(["{} = 0"] * n)
        positive = "" if rung == 1 else "{} > 0"
        clauses.append(" and ".join(filter(None, (zeros, positive))))
        parts += (*map(_vanishing, rungs[:n]), *(() if rung == 1 else (readable(rung),)))
    return ", or ".join(clauses), parts


def _vanishing(rung: Expr) -> Expr:
    """What is 0 where the rung is: of a negative square its root."""
    return readable(rational_root(-rung) or rung if (-rung).is_nonnegative else rung)


def number(value: Expr) -> Any:
    """An end as it reads best: the root of a polynomial as a decimal, a fraction factored."""
    if value.has(CRootOf):
        digits = str(value.evalf(12))
        return Word(f"{digits.replace('-', '−')}…", rf"{digits}\dots")
    return _tidy(value)


def _tidy(value: Expr) -> Expr:
    """A fraction of polynomials factored, anything else as it is."""
    rational = all(p.exp.is_Integer for p in value.atoms(Pow)) and not value.atoms(Abs)
    return readable(value) if value.free_symbols and rational else value


@result_blocks.register
def _branch(branch: Branch) -> list[Block]:
    place = [(branch.along, branch.k3), (symbol("omega"), branch.omega), (symbol("sigma"), branch.sigma)]
    given = [(name, number(value)) for name, value in place if value is not None]
    text = ", ".join("{} = {}" for _ in given)
    every = "" if branch.k3 is not None else ", every {}" if given else "every {}"
    parts = (*(part for pair in given for part in pair), *((branch.along,) if every else ()))
    return [Sentence(f"{branch.label} at {text}{every}: {branch.decision.verdict.name.lower()}", parts)]


@result_blocks.register
def _permanent_rotation(rotation: PermanentRotation) -> list[Block]:
    parts = (Word("M", "M"), *map(number, rotation.momentum))
    circle = "" if rotation.circle is None else f", and on the circle about axis {rotation.circle + 1}"
    verdict = rotation.decision.verdict.name.lower()
    return [Sentence(f"permanent rotation at {{}} = ({{}}, {{}}, {{}}){circle}: {verdict}", parts)]


@result_blocks.register
def _bifurcation(b: Bifurcation) -> list[Block]:
    return [Sentence(f"{b.kind} ({KINDS[b.kind]}):"),
            *(Display(readable(e), S.Zero, b.at) for e in b.equations)]


@result_blocks.register
def _point(point: BifurcationPoint) -> list[Block]:
    places = (symbol(point.name), point.value), (symbol("k3"), point.k3)
    return [Sentence(f"{point.kind} at {{}} = {{}}, {{}} = {{}}",
                     tuple(part for name, x in places for part in (name, number(x))))]


@result_blocks.register
def _boundary(boundary: Boundary) -> list[Block]:
    return [*map(rung_display, ladder(boundary)[0])]


@result_blocks.register
def _drift(drift: Drift) -> list[Block]:
    return drift_displays(drift)


@result_blocks.register
def _reduction(motion: Reduction) -> list[Block]:
    return [Display(Word("I₁² k̇₃²", r"I_1^2 \dot{k}_3^2"), motion.square())]


RESULTS = (Solution, Branch, PermanentRotation, Bifurcation, BifurcationPoint, Boundary, Drift, Reduction)

