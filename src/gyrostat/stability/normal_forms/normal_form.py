"""Birkhoff's normal form at an equilibrium of a body in a field, exact at rational numbers.

At rational numbers it is computed in the field of the eigenvalues, at others in balls.
"""
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from flint import acb
from sympy import Expr, Float, Rational, S, Symbol, expand, sqrt

from ..._display import Shown
from ...algebra.enclosures.precision import own_precision
from ...algebra.reals.eigenvalues import eigenvalues_of, in_ratio
from ...algebra.reals.exact import evaluate, sign
from ...algebra.rings.series import Part, is_zero
from ...errors import ScopeError, ValuesError
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.scenes.coupled import in_one_direction
from ...notation import Stored
from .birkhoff import W1, W2, Z1, Z2, Modes, linear_motion, modes, normalised, twist
from .local_motion import LocalMotion, fraction, local_motion
from .windows import ROUGH, resonance_margin, resonances_up_to

PRECISION, DIGITS = 512, 20                                # bits; digits of a number that is not exact
Frequencies = tuple[Expr, Expr]
Form = tuple[tuple[tuple[int, int, Expr], ...], tuple[Expr, ...]]


@dataclass(frozen=True, repr=False)
class NormalForm(Shown, Stored):
    """The normal form h = ω1 J1 + ω2 J2 + Σ c J1^m J2^n + … near an equilibrium.

    J1 and J2 ≥ 0 are actions on the coadjoint orbit.

    Parameters
    ----------
    frequencies : tuple of Expr, shape (2,)
        ω1, ω2 [1/T], each with the sign of the energy of its oscillation
    coefficients : tuple of (int, int, Expr)
        m, n and c, of degree 2, then 3 in J1 and J2; exact at rational numbers, else to 20 digits
    twists : tuple of Expr
        D4, then D6: the terms of degree 2 and 3 at J1 = ω2, J2 = −ω1; D4 is rational if all numbers are
    resonances : tuple of (int, int)
        m and n with m abs(ω1) = n abs(ω2) or n abs(ω1) = m abs(ω2), up to the degree

    References
    ----------
    Birkhoff, Dynamical Systems (1927), chapter III; Arnold, Sov. Math. Dokl. 2 (1961) 247-249, for D4.

    Examples
    --------
    >>> import gyrostat as gs
    >>> body = gs.Gyrostat((3, 5, 4), (0, 0, 0))
    >>> U = gs.general_potential(lambda k1, k2, k3: 2 * (k2 + k3) / 3)
    >>> point = (-2, "-5/3", "-8/3", "2/3", "1/3", "2/3")
    >>> spin = gs.equilibrium(gs.assemble(body, U), point)
    >>> gs.analyze(spin).normal_form({}).twists
    (691181/6156000,)
    """

    frequencies: tuple[Expr, Expr]
    coefficients: tuple[tuple[int, int, Expr], ...]
    twists: tuple[Expr, ...]
    resonances: tuple[tuple[int, int], ...]


def normal_form(eq: Equilibrium, numbers: Mapping[Symbol, Expr], degree: int) -> NormalForm:
    """Return the normal form at an equilibrium; Report.normal_form describes it."""
    if degree not in (4, 6):
        raise ScopeError(f"degree = {degree}: the normal form is computed to degree 4 or 6")
    in_one_direction(eq.system.potential, "a normal form")
    if eq.system.potential is None:
        raise ScopeError(f"{eq.label} is of a free body, which has one degree of freedom: its verdict is "
                         "exact without a normal form, which is for a body in a field")
    motion = local_motion(eq, numbers, degree)
    if isinstance(motion, list):
        raise ValuesError(f"{eq.label} needs {', '.join(motion)} for a normal form of degree {degree}: "
                          "give a number for each")
    if motion.rough:
        raise ScopeError(f"{eq.label} has no normal form: {ROUGH}")
    _oscillates(eq, motion)
    resonant = tuple(pair for pair in resonances_up_to(degree)
                     if sign(resonance_margin(motion.p, motion.q, *pair), {}) == 0)
    frequencies = _frequencies(motion)
    try:
        form = (_exact(motion, degree, frequencies, (1, 3) in resonant) if motion.rational
                else _enclosed(motion, degree))
    except ZeroDivisionError:
        low = " and ".join(f"{m}:{n}" for m, n in resonant) or "that is not excluded"
        raise ScopeError(f"{eq.label}: the frequencies are in resonance {low}, and there is no normal form "
                         f"of degree {degree} in the actions alone") from None
    return NormalForm(frequencies, *form, resonant)


def _oscillates(eq: Equilibrium, motion: LocalMotion) -> None:
    """Refuse an equilibrium that is unstable or degenerate, or has equal frequencies."""
    for name, value in (("q", motion.q), ("p", motion.p), ("p² − 4q", motion.p**2 - 4 * motion.q)):
        if (found := sign(value, {})) != 1:
            what = {0: "degenerate", -1: "unstable", None: "not proved to oscillate"}[found]
            raise ScopeError(f"{eq.label} is {what} there, {name} of λ⁴ + p λ² + q is "
                             f"{evaluate(value, {}).evalf(6)}: a normal form is for p, q, p² − 4q > 0")


def _frequencies(motion: LocalMotion) -> Frequencies:
    """Return ω1 and ω2, the greater in size first."""
    with own_precision(PRECISION):
        _, found = motion.in_balls(2, PRECISION)
        signs = [1 if value.imag > 0 else -1 for value in found.values]
    root = sqrt(motion.p**2 - 4 * motion.q)
    return signs[0] * sqrt((motion.p + root) / 2), signs[1] * sqrt((motion.p - root) / 2)


def _enclosed(motion: LocalMotion, degree: int) -> Form:
    """Return coefficients and twists to 20 digits."""
    with own_precision(PRECISION):
        parts, found = motion.in_balls(degree, PRECISION)
        h = normalised(parts, found)
        return (tuple((m, n, _decimal(acb(0, 1) ** (m + n) * c)) for m, n, c in _actions(h, found)),
                tuple(_decimal(twist(part, found)) for part in h[4::2]))


def _decimal(x: acb) -> Expr:
    if not x.is_finite():
        raise ZeroDivisionError
    return Float(x.real.str(DIGITS, radius=False), DIGITS)


def _exact(motion: LocalMotion, degree: int, frequencies: Frequencies, one_to_three: bool) -> Form:
    """Return coefficients and twists in the roots of p and q; D4 has none of these roots.

    At 1:3 they are in the field with λ1 = ±3 λ2, in which a resonant term that is 0 is seen to be 0.
    """
    p, q = fraction(motion.p), fraction(motion.q)
    parts = motion.energy(degree, fraction)
    fast, slow = frequencies
    same = fast.is_negative is slow.is_negative
    values = in_ratio(-p / 10, 3 if same else -3) if one_to_three else eigenvalues_of(p, q)
    found = modes(linear_motion(parts[2]), p, values)
    h = normalised(parts, found)
    root, both = slow if one_to_three else fast, -sqrt(motion.q) if same else sqrt(motion.q)
    return (tuple((m, n, _with_roots(c, m + n, root, both)) for m, n, c in _actions(h, found)),
            tuple(_with_roots(twist(part, found), 0, root, both) for part in h[4::2]))


def _actions(h: Sequence[Part], found: Modes) -> Iterator[tuple[int, int, Any]]:
    """Yield m, n and c of i^(m + n) c J1^m J2^n, with z_j w_j = i J_j/N_j."""
    first, second = (-1 * bracket for _, _, bracket in found.brackets)
    for half in range(2, len(h) // 2 + 1):
        for m in range(half, -1, -1):
            c = h[2 * half].get(m * (Z1 + W1) + (half - m) * (Z2 + W2), 0)
            yield m, half - m, c * first**m * second ** (half - m)


def _with_roots(x: Any, turns: int, frequency: Expr, both: Expr) -> Expr:
    """Return i^turns x, for λ = iω and λ1 λ2 = both; if turns is odd, x is odd in λ1 and λ2."""
    if is_zero(x):
        return S.Zero
    odd, square = turns % 2, -frequency**2
    value = S.Zero
    for polynomial, factor in ((x.a, S.One), (x.b, both)):
        for n, c in enumerate(polynomial.coeffs()):
            if c != 0 and n % 2 != odd:
                raise ArithmeticError("a coefficient of a normal form is not real")
            value += factor * Rational(int(c.p), int(c.q)) * square ** (n // 2)
    return expand(value * (frequency if odd else 1) * (-1) ** ((turns + odd) // 2))
