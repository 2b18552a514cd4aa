"""Describes Staude's cone and its arcs."""
from collections.abc import Iterable, Iterator
from typing import Any

from sympy import Add, Expr, S, oo, sqrt

from ...algebra.rings.readable import readable
from ...equilibria.curves.arc import Arc, End, Piece
from ...equilibria.curves.cone_curves import TAU
from ...equilibria.curves.rate_curves import RateCurve
from ...equilibria.curves.staude import StaudeCone
from ...equilibria.relative_equilibrium import RelativeEquilibrium
from ...notation import components, symbol
from ...stability.decision import Rung
from ..blocks import Block, Display, Word, equations, listed, sentence
from ..letters import letter, letters_in
from ..numbers import in_sentence

VECTOR, OMEGA, SIGMA = Word("k", "⟨vector_k⟩"), symbol("omega"), symbol("sigma")
FAST = {oo: Word("ω → ∞", r"⟨omega⟩\to\infty"), -oo: Word("ω → −∞", r"⟨omega⟩\to-\infty")}


def cone_blocks(cone: StaudeCone) -> list[Block]:
    """Write the polynomial of the cone, and the rate on it."""
    terms = Add.make_args(cone.polynomial) if cone.turned else (cone.polynomial,)
    rate = OMEGA if cone.turned else OMEGA**2
    admissible = "" if cone.turned else ", which is admissible if its square is positive,"
    return [sentence("Permanent rotations are about the directions ", VECTOR, ", |", VECTOR, "| = 1, with:"),
            Display(Add(*map(readable, terms)), S.Zero), sentence(f"The rate{admissible} is:"),
            Display(rate, readable(cone.rate))]


def arc_blocks(arc: Arc) -> list[Block]:
    """Write the ends of an arc, direction and rate along it, the verdict of each part, and circles."""
    low, high = arc.ends
    known: tuple[Any, ...] = () if arc.both_ways else ("|", VECTOR, "| = 1 and ")
    found: list[Block] = [sentence("This arc leads from ", *_end(low), ", to ", *_end(high), ". ",
                                   *_parameter(arc)), sentence("Along the arc ", *known, "these hold:")]
    k = arc.k
    if arc.both_ways:
        found.append(Display(OMEGA**2, sqrt(readable(arc.omega_squared**2))))
        k = tuple(readable(x * OMEGA**2) / OMEGA**2 for x in k)
    return [*found, *(Display(symbol(f"k{n}"), x) for n, x in enumerate(k, 1) if x != symbol(f"k{n}")),
            *_verdicts(arc.parameter, arc.pieces), *map(_crossed, arc.circles)]


def _parameter(arc: Arc) -> tuple[Any, ...]:
    """Say what the parameter of an arc is."""
    unit = ("|", VECTOR, "| = 1")
    multiplier = (", where ", SIGMA, " is the multiplier of ", *unit, ".")
    if isinstance(arc.curve, RateCurve):
        told = ("; ", *multiplier[1:]) if any(x.has(SIGMA) for x in arc.k) else (".",)
        return "Its parameter is the rate ", OMEGA, *told
    if arc.parameter == TAU:
        return "Its parameter is ", *equations([(TAU, SIGMA / OMEGA**2)]), *multiplier
    axis = [x.diff(arc.parameter) for x in arc.curve.n]
    component = Add(*(x * k for x, k in zip(axis, components("k")))) / Add(*(x**2 for x in axis))
    return ("Its parameter is ", *equations([(arc.parameter, OMEGA**2 * component)]), ", and ",
            *equations([(SIGMA / OMEGA**2, arc.curve.tau)]), " is constant", *multiplier)


def _crossed(rotation: RelativeEquilibrium) -> Block:
    rate = in_sentence(rotation.rates["omega"])
    return sentence("At ", *equations([(OMEGA, rate)]), " every direction of ",
                    rotation.locus, ", through ", VECTOR, " = (",
                    *listed(map(in_sentence, rotation.directions[0])),
                    "), is that of a permanent rotation")


def _verdicts(parameter: Expr, pieces: Iterable[Piece]) -> Iterator[Block]:
    for piece in pieces:
        but: tuple[Any, ...] = ()
        if piece.decision.rung is Rung.TWIST:
            D4 = letter(letters_in([parameter]), "D4")
            but = ", except at single rates with ", *equations([(D4, S.Zero)])
        yield sentence(*_interval(piece.low, parameter, piece.high),
                       f": {piece.decision.verdict.name.lower()}", *but)


def _end(end: End) -> tuple[Any, ...]:
    if end.omega in FAST:
        rate: tuple[Any, ...] = (FAST[end.omega],)
    else:
        rate = equations([(OMEGA, in_sentence(end.omega))])
        rate = (*rate, " and two rotations meet") if end.omega else rate
    return (VECTOR, " = (", *listed(map(in_sentence, end.k)), "), where ", *rate)


def _interval(low: Expr, x: Expr, high: Expr) -> tuple[Any, ...]:
    if low == -oo and high == oo:
        return "every ", x
    if low == -oo:
        return x, " < ", in_sentence(high)
    if high == oo:
        return x, " > ", in_sentence(low)
    return in_sentence(low), " < ", x, " < ", in_sentence(high)
