"""Staude's cone and its arcs, as sentences and displays."""
from typing import Any

from sympy import Add, Expr, S, oo, sqrt

from ..algebra.readable import readable
from ..notation import symbol
from ..stability.staude import StaudeCone
from ..stability.staude_arcs import End, StaudeArc
from .blocks import Block, Display, Word, equations, listed, sentence
from .ends import number

VECTOR, OMEGA = Word("k", "⟨vector_k⟩"), symbol("omega")
FAST = Word("ω → ∞", r"⟨omega⟩\to\infty")


def cone_blocks(cone: StaudeCone) -> list[Block]:
    """The polynomial, and the rate on it."""
    terms = Add.make_args(cone.polynomial) if cone.turned else (cone.polynomial,)
    rate = OMEGA if cone.turned else OMEGA**2
    admissible = "" if cone.turned else ", admissible where its square is positive"
    return [sentence("Permanent rotations are about the directions ", VECTOR, ", |", VECTOR, "| = 1, with:"),
            Display(Add(*map(readable, terms)), S.Zero), sentence(f"The rate{admissible}:"),
            Display(rate, readable(cone.rate))]


def arc_blocks(arc: StaudeArc) -> list[Block]:
    """Its ends, the direction and the rate along it, and the verdict of each part."""
    low, high = arc.ends
    length = sqrt(readable(arc.omega_squared**2))
    return [sentence("Arc from ", *_end(low), " to ", *_end(high), " along it:"),
            Display(OMEGA**2, length),
            *(Display(symbol(f"k{n}"), readable(x) / OMEGA**2) for n, x in enumerate(arc.n, 1)),
            *(sentence(*_interval(piece.low, arc.parameter, piece.high),
                       f": {piece.decision.verdict.name.lower()}") for piece in arc.pieces)]


def _end(end: End) -> tuple[Any, ...]:
    rate = equations([(OMEGA, S.Zero)]) if end.omega_squared == 0 else (FAST,)
    return (VECTOR, " = (", *listed(map(number, end.k)), "), where ", *rate, ",")


def _interval(low: Expr, x: Expr, high: Expr) -> tuple[Any, ...]:
    if low == -oo and high == oo:
        return "every ", x
    if low == -oo:
        return x, " < ", number(high)
    return (x, " > ", number(low)) if high == oo else (number(low), " < ", x, " < ", number(high))
