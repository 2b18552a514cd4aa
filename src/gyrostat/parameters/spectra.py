"""Follows the eigenvalues of an equilibrium along a parameter, in continuous columns, to their collisions."""
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise, permutations
from typing import Any

import numpy as np
from sympy import Expr, Rational, Symbol

from ..algebra.enclosures.floats import Array, doubles, in_floats
from ..algebra.reals.exact import sign
from ..algebra.rings.polynomials import Ring
from ..algebra.solving.roots import in_order
from ..algebra.solving.zeros import changes_of_sign, inner, zeros_inside, zeros_of
from ..algebra.text.numbers import exact_number
from ..arguments import checked
from ..errors import ScopeError, ValuesError, brief
from ..mechanics.equilibrium.derivation_ring import signs_over
from ..mechanics.equilibrium.equilibrium import Equilibrium
from ..notation import symbol
from ..stability.criteria.conditions import Condition, condition_of
from ..stability.criteria.linearization import Linearization, linearize
from ..stability.criteria.numbers_asked import check_names, names_in, refuse_any_direction
from ..stability.criteria.sextic import factors_in_squares, items_of_factors
from ..stability.criteria.three_criteria import spectral_criterion


@dataclass(frozen=True, eq=False)
class Collision:
    """A value at which eigenvalues come together and the kind of the spectrum changes.

    Parameters
    ----------
    value : float
    kind : str
        "Hamiltonian Hopf": two pairs meet on the imaginary axis and leave it; "zero eigenvalue": a pair meets
        at 0; "real pairs meet" beside it
    changes : bool
        whether spectral stability changes there
    eigenvalues : array
        where they meet, each once
    """

    value: float
    kind: str
    changes: bool
    eigenvalues: Array


@dataclass(frozen=True, eq=False)
class Spectrum:
    """The eigenvalues along a parameter.

    Parameters
    ----------
    parameter : array, shape (n,)
        the samples, and where eigenvalues meet
    eigenvalues : complex array, shape (n, d)
        d = 2, 4 or 6; each column is continuous
    collisions : list of Collision

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> numbers = {"I1": 1, "I3": 1, "l": 0, "m0": 1}
    >>> found = gs.spectrum(gs.hanging(top), "pi3_0", (0, 1), numbers)
    >>> found.eigenvalues.shape[1], found.collisions
    (4, [])
    """

    parameter: Array
    eigenvalues: Array
    collisions: list[Collision]


@checked
def spectrum(eq: Equilibrium, name: str, samples: Sequence[float],
             values: Mapping[str, Any]) -> Spectrum:
    """Return the eigenvalues of an equilibrium at values of one parameter, and where they meet.

    They are the roots of λ⁴ + p λ² + q, or λ² + p; they collide where p² − 4q or q, or p if q is 0, changes
    its sign. With three degrees of freedom they are those of such factors. Between two collisions λ² = (−p ±
    √(p² − 4q))/2 are two continuous functions, since p² − 4q keeps its sign; at a collision each column goes
    on as the one that has its value there.

    Parameters
    ----------
    eq : Equilibrium
    name : str
        of the parameter
    samples : sequence of float
        values of the parameter, from one end to the other
    values : mapping of name to number
        for every other name in the spectrum

    Returns
    -------
    Spectrum

    Raises
    ------
    ValuesError
        names are missing or unknown, or somewhere between the samples there is no such equilibrium
    ScopeError
        the polynomial of three degrees of freedom does not split into such factors

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> sleeping = gs.upright(top, spin="omega3_0")
    >>> rates = [2 - n / 40 for n in range(81)]
    >>> numbers = {"I1": 1, "I3": "8/5", "l": 0, "m0": 1}
    >>> found = gs.spectrum(sleeping, "omega3_0", rates, numbers)
    >>> [(c.kind, c.value, c.changes) for c in found.collisions]
    [('Hamiltonian Hopf', 1.25, True)]
    """
    refuse_any_direction(eq)
    linear = linearize(eq)
    parts = _parts(linear)
    check_names([*values, name], names_in(c for part, _ in parts for c in part),
                f"the spectrum of {eq.label}")
    at, free = doubles(samples, "the samples"), symbol(name)
    if at.ndim != 1 or len(at) < 2 or not (np.diff(at) * (at[-1] - at[0]) > 0).all():
        raise ValuesError(f"samples are {brief(samples)}: give two values of {name} or more, increasing or "
                          "decreasing")
    numbers = {symbol(name): exact_number(value, name) for name, value in values.items()}
    low, high = (exact_number(float(x), name) for x in (at.min(), at.max()))
    placed = [[c.xreplace(numbers) for c in part] for part, _ in parts]
    _exists(eq, [c for part in placed for c in part], numbers, free, low, high)
    zeros: list[dict[Expr, str]] = []                      # of each part, with what changes its sign there
    touched = dict[Expr, None]()
    for part, conditions in parts:
        told = [c for c in conditions if c.source != "p" or not part[-1]]
        zeros.append({zero: c.source for c in told
                      for zero in changes_of_sign(eq.insert(c.margin).xreplace(numbers), free, low, high)})
        touched |= {zero: None for c in told for factor in (c.margin, *c.degenerate)
                    for zero in zeros_inside(eq.insert(factor).xreplace(numbers), free, low, high)}
    cuts = [low, *in_order(list(touched | {zero: None for of_part in zeros for zero in of_part})), high]
    stable = [all(sign(eq.insert(c.margin).xreplace(numbers), {free: inner(a, b)}) != -1
                  for _, conditions in parts for c in conditions) for a, b in pairwise(cuts)]
    collisions = [_collision(of_part[zero], zero, part, free, before != after)
                  for zero, before, after in zip(cuts[1:], stable, stable[1:])
                  for part, of_part in zip(placed, zeros) if zero in of_part]
    columns = [_columns(part, free, np.sort(at), cuts) for part in placed]
    order = slice(None) if at[0] < at[-1] else slice(None, None, -1)
    return Spectrum(columns[0][0][order], np.concatenate([roots for _, roots in columns], axis=1)[order],
                    collisions)


def _parts(linear: Linearization) -> list[tuple[list[Expr], Sequence[Condition]]]:
    """Return p and q, or p, of each factor of the characteristic polynomial, and its conditions."""
    eq = linear.equilibrium
    if len(linear.coefficients) < 3:
        return [([eq.insert(c) for c in linear.coefficients], spectral_criterion(linear).alternatives[0])]
    factors = factors_in_squares(linear.coefficients)
    if len(factors) == 1:
        raise ScopeError(f"the eigenvalues of {eq.label} are the roots of a polynomial of degree six that "
                         "does not factor, and are not followed along a parameter: "
                         "analyze(eq).linearization.eigenvalues() has them at given numbers")
    signs = signs_over(eq, [c for factor in factors for c in factor])
    return [([eq.insert(c / first) for c in others],
             [condition_of(signs.ring, item, eq) for item in items_of_factors([(first, *others)], signs)])
            for first, *others in factors]


def _exists(eq: Equilibrium, coefficients: Sequence[Expr], numbers: Mapping[Symbol, Expr], free: Symbol,
            low: Expr, high: Expr) -> None:
    """Refuse a range in which there is somewhere no such equilibrium."""
    for e in [*eq.existence(), *eq.system.body.positive, *([free] if free.is_positive else [])]:
        placed = e.xreplace(dict(numbers))
        if placed.free_symbols == {free} and (any(sign(placed, {free: end}) != 1 for end in (low, high))
                                              or changes_of_sign(placed, free, low, high)):
            raise ValuesError(f"{free} goes from {low} to {high}, and {eq.label} exists only if {e} > "
                              "0: give a range inside")
    for c in coefficients:
        ring = Ring([c, free])
        bottom = ring.expression(ring.fraction(c)[1])
        if bottom.has(free) and zeros_of(bottom, free, low, high):
            raise ValuesError(f"the eigenvalues of {eq.label} are infinite between {free} = {low} and "
                              f"{high}, at {bottom} = 0: give a range without that value")


def _columns(coefficients: Sequence[Expr], free: Symbol, at: Array,
             cuts: Sequence[Expr]) -> tuple[Array, Array]:
    """Return the samples with the collisions between them, and the eigenvalues, each column continuous."""
    nodes: list[Array] = []
    rows: list[Array] = []
    for a, b in pairwise(cuts):
        if float(a) == float(b):
            continue
        here = np.unique([float(a), *at[(at > float(a)) & (at < float(b))], float(b)])
        roots = _roots(coefficients, free, here, inner(a, b))
        # each column goes on as the one that has its value at the collision
        if rows:
            orders = np.array(list(permutations(range(roots.shape[1]))))
            roots = roots[:, orders[np.abs(roots[0][orders] - rows[-1][-1]).sum(axis=1).argmin()]]
            here, roots = here[1:], roots[1:]
        nodes.append(here)
        rows.append(roots)
    return np.concatenate(nodes), np.concatenate(rows)


def _roots(coefficients: Sequence[Expr], free: Symbol, at: Array, inner: Rational) -> Array:
    """Return eigenvalues at values between which p² − 4q keeps the sign that it has at an inner one."""
    p, *rest = (np.broadcast_to(np.asarray(in_floats(c, np, {free: at}), dtype=float), at.shape)
                for c in coefficients)
    if not rest:
        return np.stack([np.sqrt(-p + 0j), -np.sqrt(-p + 0j)], axis=1)
    side = sign(coefficients[0] ** 2 - 4 * coefficients[1], {free: inner}) or 0
    square = np.sqrt(np.abs(p**2 - 4 * rest[0])) if side else np.zeros_like(p)
    if side < 0:                                           # a complex quadruple
        one = np.sqrt((-p + 1j * square) / 2)
        return np.stack([one, -one, one.conj(), -one.conj()], axis=1)
    first, second = np.sqrt((-p + square) / 2 + 0j), np.sqrt((-p - square) / 2 + 0j)
    return np.stack([first, -first, second, -second], axis=1)


def _collision(source: str, zero: Expr, coefficients: Sequence[Expr], free: Symbol,
               changes: bool) -> Collision:
    value, p = float(zero), sign(coefficients[0], {free: zero})
    if source in ("p", "q") or not p or _one_pair(coefficients):
        return Collision(value, "zero eigenvalue", changes, np.zeros(1, dtype=complex))
    root = np.sqrt(complex(-float(in_floats(coefficients[0], np, {free: np.float64(value)})) / 2))
    return Collision(value, "Hamiltonian Hopf" if p == 1 else "real pairs meet", changes,
                     np.array([root, -root]))


def _one_pair(coefficients: Sequence[Expr]) -> bool:
    """Tell whether p² = 4q everywhere, as for a disc, I3 = 2 I1, without a rotor."""
    p, q = coefficients
    discriminant = p**2 - 4 * q
    return not Ring([discriminant]).fraction(discriminant)[0]
