"""The amended potential V(n, r) = U − ½ ω0² n·In of a satellite: its terms, derivatives and stiffness K."""
from collections.abc import Mapping, Sequence
from functools import lru_cache
from math import prod
from typing import Any

from flint import arb
from sympy import Add, Expr, Poly

from ...algebra.enclosures.balls import ball
from ...algebra.enclosures.precision import own_precision
from ...algebra.rings.matrices import cross
from ...errors import ScopeError, brief
from ...mechanics.families.circular_orbit import NORMAL, VERTICAL, orbital_rate
from ...mechanics.scenes.system import System
from ...notation import components
from ...stability.criteria.amended_form import dot

DIRECTIONS = (*components(NORMAL), *components(VERTICAL))
Exponents = tuple[int, ...]
Terms = Sequence[tuple[Exponents, Any]]


@lru_cache(maxsize=16)
def amended_terms(scene: System) -> dict[Exponents, Expr]:
    """Return V as a polynomial in n1, n2, n3, r1, r2, r3, its coefficients by exponents.

    Raises
    ------
    ScopeError
        it is no polynomial
    """
    assert scene.potential is not None
    U, n, rate = scene.potential.expression, components(NORMAL), orbital_rate(scene)
    kinetic = Add(*(x * y * entry for x, row in zip(n, scene.body.tensor.tolist())
                    for y, entry in zip(n, row)))
    if not U.is_polynomial(*DIRECTIONS):
        raise ScopeError(f"U = {brief(U)} is no polynomial in n1, n2, n3, r1, r2, r3, and all attitudes are "
                         "found in one of degree 2 in n, r and n × r: give an attitude, steady_motion(scene, "
                         "n, r)")
    V = Poly(U - rate**2 * kinetic / 2, *DIRECTIONS, domain="EX")
    return {e: c for e, c in V.as_dict().items() if any(e)}


@lru_cache(maxsize=16)
def _terms_in_balls(scene: System, precision: int) -> dict[Exponents, arb]:
    return {e: ball(c, precision) for e, c in amended_terms(scene).items()}


def energy(scene: System, directions: Sequence[Any], precision: int) -> arb:
    """Return V at n and r in balls."""
    with own_precision(precision):
        return _value([*_terms_in_balls(scene, precision).items()], directions)


def stiffness(scene: System, n: Sequence[Any], r: Sequence[Any], precision: int | None) -> list[list[Any]]:
    """Return K in body axes, in balls or exactly: the second variation of V if the body is turned.

    K = Σ_a [V_a aᵀ − (V_a·a) 1] + Σ_ab hat(a)ᵀ V_ab hat(b), over a and b in (n, r). Derived in
    docs/explanation/derivations/satellite.md, section 2.
    """
    terms = amended_terms(scene) if precision is None else _terms_in_balls(scene, precision)
    place = [*n, *r]
    first = [_slope(terms, i) for i in range(6)]
    slopes = [_value(f, place) for f in first]
    bends = [[_value(_slope(dict(f), j), place) for j in range(6)] for f in first]
    level = dot(slopes[:3], n) + dot(slopes[3:], r)
    K = [[slopes[i] * n[j] + slopes[3 + i] * r[j] - (level if i == j else 0) for j in range(3)]
         for i in range(3)]
    for i, a in enumerate((n, r)):
        for j, b in enumerate((n, r)):
            rows = [cross(row[3 * j:3 * j + 3], b) for row in bends[3 * i:3 * i + 3]]
            columns = [cross(column, a) for column in zip(*rows)]
            K = [[x + columns[q][p] for q, x in enumerate(row)] for p, row in enumerate(K)]
    return [[K[max(i, j)][min(i, j)] for j in range(3)] for i in range(3)]     # symmetric at an equilibrium


def _slope(terms: Mapping[Exponents, Any], place: int) -> list[tuple[Exponents, Any]]:
    """Return the derivative of a polynomial along one of its variables."""
    return [((*e[:place], e[place] - 1, *e[place + 1:]), c * e[place]) for e, c in terms.items() if e[place]]


def _value(terms: Terms, place: Sequence[Any]) -> Any:
    """Return the value of a polynomial.

    By products, since ** gives no finite power of a ball that contains 0.
    """
    return sum(prod((x for x, n in zip(place, e) for _ in range(n)), start=c) for e, c in terms)
