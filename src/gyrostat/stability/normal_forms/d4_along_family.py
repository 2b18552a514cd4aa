"""Arnold's condition along a family: D4 as a rational function of its names, by averages."""
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import prod
from typing import NamedTuple

from flint import fmpq_mpoly
from sympy import Expr, Mul, Pow, Symbol

from ..._display import Shown
from ...algebra.enclosures.rationals import to_sympy
from ...algebra.reals.exact import evaluate
from ...algebra.rings.polynomials import Ring, by_degree, lcm
from ...algebra.rings.rational_functions import RationalFunction
from ...algebra.solving.margins import Signs
from ...algebra.solving.roots import real_roots
from ...errors import ScopeError
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.scenes.coupled import in_one_direction
from ...notation import Stored
from ..criteria.numbers_asked import refuse_any_direction
from .d4_by_averages import averages
from .local_motion import LocalMotion, motion_along
from .windows import ROUGH, resonance_margins

DEGREE, MOST = 4, 3                                        # derivatives of U; names, if h3 is not 0


@dataclass(frozen=True, repr=False)
class Window(Shown, Stored):
    """Arnold's condition if p, q and p² − 4q are positive and the second variation is not definite.

    It is stable if no resonance holds and D4 is not 0; each of the other points is decided by a verdict.

    Parameters
    ----------
    p, q : Expr
        the coefficients of λ⁴ + p λ² + q [1/T², 1/T⁴]
    resonances : tuple of (int, int, Expr)
        m, n and a polynomial that is 0 if the frequencies are as m to n
    D4 : Expr
        Arnold's determinant, factored
    margin : Expr
        the primitive integer polynomial that has the sign of D4 in the window
    zeros : tuple of Expr
        factors of D4 that do not change its sign, but make it 0
    at : Expr
        the k3 at which derivatives of U are taken

    References
    ----------
    Arnold, Sov. Math. Dokl. 2 (1961) 247-249.

    Examples
    --------
    >>> import gyrostat as gs
    >>> body = gs.Gyrostat((5, 4, 3), (0, 0, 0))
    >>> field = gs.general_potential(lambda k1, k2, k3: k3)
    >>> spin = gs.upright(gs.assemble(body, field))
    >>> found = gs.analyze(spin).window()
    >>> found.q
    (pi3_0**2 + 9)*(2*pi3_0**2 + 9)/1620
    >>> found.resonances[0], found.margin
    ((1, 2, 26*pi3_0**4 - 771*pi3_0**2 - 396), 1)
    """

    p: Expr
    q: Expr
    resonances: tuple[tuple[int, int, Expr], ...]
    D4: Expr
    margin: Expr
    zeros: tuple[Expr, ...]
    at: Expr


class _Held(NamedTuple):
    """The p, q and D4 of a motion, in a ring of its names."""

    ring: Ring
    p: RationalFunction
    q: RationalFunction
    D4: RationalFunction

    @property
    def discriminant(self) -> RationalFunction:
        """The discriminant p² − 4q."""
        return self.p**2 - 4 * self.q


def window_of(eq: Equilibrium, numbers: Mapping[Symbol, Expr]) -> Window:
    """Return D4 and the conditions beside it; Report.window describes them."""
    domain = [evaluate(e, numbers) for e in eq.existence()]
    held = _held(eq.label, motion_in_field(eq, numbers), domain)
    ring, (p, q, D4) = held.ring, held[1:]
    signs = Signs(ring, [*domain, *(_factored(ring, x) for x in (p, q, held.discriminant))])
    resonances = []
    for m, n, at in resonance_margins(p, q):
        odd, squares = signs.split(at.top, ring.one)
        resonances.append((m, n, ring.expression(prod(squares, start=odd))))
    margin, even = signs.split(D4.top, D4.bottom)
    return Window(_factored(ring, p), _factored(ring, q), tuple(resonances), _factored(ring, D4),
                  ring.expression(margin), tuple(map(ring.expression, even)), eq.at)


def motion_in_field(eq: Equilibrium, numbers: Mapping[Symbol, Expr]) -> LocalMotion:
    """Return the motion near an equilibrium whose D4 may be a rational function of what has no number."""
    potential = eq.system.potential
    if potential is None:
        raise ScopeError(f"{eq.label} is of a free body, which has one degree of freedom: its verdict needs "
                         "no D4")
    in_one_direction(potential, "a normal form")
    refuse_any_direction(eq)
    motion = motion_along(eq, numbers, DEGREE)
    if motion.rough:
        raise ScopeError(f"{eq.label} has no D4: {ROUGH}")
    if not potential.given and any(x.free_symbols for x in motion.k):
        raise ScopeError(f"{eq.label}: U is unspecified, and k is not a point: give U for D4")
    return motion


def cuts_in_windows(motion: LocalMotion, x: Symbol, low: Expr | None, high: Expr | None) -> list[Expr] | None:
    """Return values of the only name between which Arnold's condition does not change in a window.

    Between two of them it holds everywhere, or nowhere. None if they are not known: D4 is no rational
    function of the name, or is 0 everywhere, or a resonance holds everywhere.
    """
    try:
        held = _held("", motion, (), square_roots=True)
    except ScopeError:
        return None
    resonances = [at for _, _, at in resonance_margins(held.p, held.q)]
    margins = [held.p, held.q, held.discriminant, held.D4, *resonances]
    parts = [_norm(held.ring, part) for value in margins for part in (value.top, value.bottom)]
    if motion.names != {x} or not all(parts):
        return None
    polynomials = [part for part in parts if not part.is_constant()]
    return real_roots(Mul(*map(held.ring.expression, polynomials)), x, low, high)


def _norm(ring: Ring, polynomial: fmpq_mpoly) -> fmpq_mpoly:
    """Return the norm of a polynomial over its square roots: the product over either sign of each of them.

    It has no square roots, and is 0 wherever one of the factors is.
    """
    polynomial = ring.reduce(polynomial)
    for root, square in ring.squares.items():
        place = ring.generators.index(root)
        if polynomial.degrees()[place]:
            rest, factor = by_degree(polynomial, place, 1)
            polynomial = ring.reduce(rest**2 - factor**2 * square)
    return polynomial


def _held(label: str, motion: LocalMotion, domain: Sequence[Expr], square_roots: bool = False) -> _Held:
    """Return p, q and D4 by the averages of a multiple of the energy that is polynomial."""
    ring = Ring([*motion.entries, motion.potential, *domain])
    if not all(isinstance(g, Symbol) or square_roots and g in ring.squares for g in ring.generators):
        raise ScopeError(f"{label}: D4 is a rational function where numbers are rational and U and the "
                         "point are fractions of polynomials; give other numbers, or all for a verdict")
    parts = motion.energy(DEGREE, lambda x: RationalFunction(*ring.fraction(x)))
    if parts[3] and len(motion.names) > MOST:
        raise ScopeError(f"{label}: D4 in {', '.join(sorted(s.name for s in motion.names))} is too long: "
                         f"give numbers for all but {MOST} of them")
    scale = ring.one
    for part in parts[2:]:
        for x in part.values():
            scale = lcm(scale, x.bottom)
    whole = [{code: x.top * (scale / x.bottom) for code, x in part.items()} for part in parts[2:]]
    p, q, top, bottom = map(ring.reduce, averages([{}, {}, *whole]))
    for value, what in ((q, "q"), (p**2 - 4 * q, "p² − 4q"), (bottom, "4p² − 25q")):
        if not ring.reduce(value):
            raise ScopeError(f"{label}: {what} of λ⁴ + p λ² + q is 0 whatever the names are: there is no D4")
    # D4 is of degree 1 in the energy and of degree 2 in the actions, which are frequencies
    return _Held(ring, *(RationalFunction(value, scale**n * below) for value, n, below in (
        (p, 2, ring.one), (q, 4, ring.one), (top, 3, bottom))))


def _factored(ring: Ring, x: RationalFunction) -> Expr:
    """Return a rational function as a quotient of products."""
    (above, tops), (below, bottoms) = x.top.factor(), x.bottom.factor()
    powers = [(f, int(n)) for f, n in tops] + [(f, -int(n)) for f, n in bottoms]
    return Mul(to_sympy(above / below), *(Pow(ring.expression(f), n) for f, n in powers))
