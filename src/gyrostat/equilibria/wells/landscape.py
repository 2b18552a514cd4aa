"""The function V whose wells hold the motions of a scene, on a sphere or on the attitudes."""
import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np
from flint import arb
from sympy import Add, CRootOf, Expr, Matrix, Poly, PolynomialError, Rational, Symbol, sqrt

from ..._cached import cached_property
from ...algebra.enclosures.balls import ball
from ...algebra.enclosures.precision import own_precision
from ...algebra.reals.exact import sign_of_constant
from ...errors import ScopeError
from ...mechanics.scenes.kind import Kind
from ...mechanics.scenes.potential import DIRECTIONS
from ...notation import components
from ..relative_equilibrium import RelativeEquilibrium
from ..search import relative_equilibria
from .in_balls import BITS, dot, form, in_balls, rows_in_balls

LARGEST = 10**15                                       # denominator of a level
NO_FRACTION = ("{} is no fraction of a small denominator here, and all equilibria of a level are found at "
               "such fractions: find the equilibrium by its level")
NO_RATE = ("the rate is not rational, and in a field of degree 3 or more all rotations of a rate are found "
           "if it is: find the rotation by its rate")
MOMENTUM, NORMAL, UPWARD = (tuple(components(name)) for name in ("pi", "n", "r"))


@dataclass(frozen=True)
class Terms:
    """A polynomial in directions: exponents, and coefficients of one kind of number."""

    exponents: tuple[tuple[int, ...], ...]
    coefficients: tuple[Any, ...]

    def at(self, y: Sequence[Any]) -> Any:
        """Return its value; the directions may be balls, power series of balls, or arrays."""
        total: Any = 0
        for powers, value in zip(self.exponents, self.coefficients):
            for x, power in zip(y, powers):
                for _ in range(power):
                    value = value * x
            total = total + value
        return total


@dataclass(frozen=True)
class Landscape:
    """V at any vector but 0, on whose direction alone it depends, and its critical points.

    Parameters
    ----------
    points : sequence of RelativeEquilibrium
        all of them, at least those that are not isolated included
    polynomials : sequence of Poly
        V as a polynomial in k, in M or in n and r; in a field what l·k is subtracted from, and k·Ik, too
    attitudes : bool
        whether the vectors are quaternions, and not directions
    """

    points: Sequence[RelativeEquilibrium]
    polynomials: Sequence[Poly]
    attitudes: bool = False

    @cached_property
    def places(self) -> list[list[arb]]:
        """The critical points in balls, each of shape (3,), or a quaternion of shape (4,)."""
        return [self._place(e) for e in self.points]

    def number(self, rotation: RelativeEquilibrium) -> int:
        """Return which of the critical points a relative equilibrium is."""
        place = self._place(rotation)
        signs = (1, -1) if self.attitudes else (1,)
        return next(n for n, there in enumerate(self.places) for sign in signs
                    if all((sign * a).overlaps(b) for a, b in zip(place, there)))

    def _place(self, rotation: RelativeEquilibrium) -> list[arb]:
        with own_precision(BITS):
            found = [in_balls(numbers) for _, numbers in rotation.form.described[:1 + self.attitudes]]
            return quaternion(*found) if self.attitudes else found[0]

    @cached_property
    def _exact(self) -> list[Terms]:
        return [Terms(tuple(p.monoms()), tuple(ball(c, BITS) for c in p.coeffs())) for p in self.polynomials]

    @cached_property
    def _doubles(self) -> list[Terms]:
        return [Terms(terms.exponents, tuple(float(c.mid()) for c in terms.coefficients))
                for terms in self._exact]

    def value(self, x: Sequence[Any]) -> Any:
        """Return V at a vector of balls, or of power series of balls."""
        return self._value(x, self._exact)

    def floats(self, x: Any) -> Any:
        """Return V at vectors of doubles, shape (..., 3) or (..., 4)."""
        return self._value(list(np.moveaxis(np.asarray(x, dtype=float), -1, 0)), self._doubles)

    def of_directions(self, y: Sequence[Any]) -> Any:
        """Return V of a satellite at components of n and r in doubles, in place of a quaternion."""
        return self._doubles[0].at(y)

    def _value(self, x: Sequence[Any], terms: Sequence[Terms]) -> Any:
        polynomial, *twist = terms
        square = sum((c * c for c in x[1:]), x[0] * x[0])
        if self.attitudes:
            y = _rows(x, square)
        else:
            length = square.sqrt() if hasattr(square, "sqrt") else np.sqrt(square)
            y = [c / length for c in x]
        found = polynomial.at(y)
        if twist:
            numerator, inertia = (part.at(y) for part in twist)
            found = found + numerator * numerator / (2 * inertia)
        return found


def landscape_of(rotation: RelativeEquilibrium) -> Landscape:
    """Return V on the level of a relative equilibrium, with all critical points.

    In a field V is U_c = U + (C1 - l·k)²/(2 k·Ik) on the sphere of k; of a free body it is the energy on the
    momentum sphere, its negative at a maximum; of a satellite the energy at rest in the frame of the orbit.

    Raises
    ------
    ScopeError
        there is no list of all critical points
    """
    scene = rotation.scene
    if scene.kind is Kind.ORBIT:
        points = relative_equilibria(scene, {})
        rest = rotation.rates["omega0"] * scene.body.tensor * Matrix(NORMAL)
        V = scene.hamiltonian.xreplace(dict(zip(MOMENTUM, rest)))
        return Landscape(points, [_polynomial(V, (*NORMAL, *UPWARD), 2)], attitudes=True)
    body, l = scene.body, Matrix(scene.body.gyrostatic_momentum)
    if scene.kind is Kind.FREE:
        length = level_of(rotation)["M"]
        sign = -1 if rotation.form.index else 1
        V = sign * (length * Matrix(DIRECTIONS) - l).dot(body.inverse * (length * Matrix(DIRECTIONS) - l)) / 2
        return Landscape(relative_equilibria(scene, {"M": length}), [_polynomial(V, DIRECTIONS, 2)])
    if scene.kind is not Kind.FIELD or scene.potential is None:
        raise ScopeError(f"no wells are found of {scene.kind.value}")
    k = Matrix(DIRECTIONS)
    U = _polynomial(scene.potential.expression, DIRECTIONS, 2)
    level, points = _on_its_level(rotation)
    twist = _polynomial(level - l.dot(k), DIRECTIONS, 1), _polynomial(k.dot(body.tensor * k), DIRECTIONS, 2)
    return Landscape(points, [U, *twist])


def level_of(rotation: RelativeEquilibrium) -> dict[str, Expr]:
    """Return by which names and numbers all equilibria of the level of one are found.

    Raises
    ------
    ScopeError
        a number is no fraction
    """
    if rotation.scene.kind is Kind.ORBIT:
        return {}
    if rotation.scene.kind is Kind.FIELD:
        return {"C1": _on_its_level(rotation)[0]}
    M = Matrix(rotation.momentum)
    length = sqrt(_fraction(ball(M.dot(M), BITS)))
    if sign_of_constant(Add(M.dot(M), -length**2)) != 0:
        raise ScopeError(NO_FRACTION.format("the square of M"))
    return {"M": length}


def turning_landscape(rotation: RelativeEquilibrium) -> Landscape:
    """Return V = U − ω² k·Ik/2 − ω l·k on the sphere of k, at the rate ω of a rotation in a field.

    Its critical points are the rotations of that rate, whatever C1 is.

    Raises
    ------
    ScopeError
        there is no list of all of them
    """
    scene, omega, k = rotation.scene, rotation.rates["omega"], Matrix(DIRECTIONS)
    body, U = scene.body, scene.potential
    assert U is not None
    if _polynomial(U.expression, DIRECTIONS, math.inf).total_degree() > 2 and omega.has(CRootOf):
        raise ScopeError(NO_RATE)
    V = U.expression - omega**2 * k.dot(body.tensor * k) / 2 - omega * Matrix(body.gyrostatic_momentum).dot(k)
    return Landscape(relative_equilibria(scene, {"omega": omega}), [_polynomial(V, DIRECTIONS, math.inf)])


def _polynomial(expression: Expr, variables: Sequence[Symbol], degree: float) -> Poly:
    try:
        found = Poly(expression, *variables)
    except PolynomialError:
        found = None
    if found is None or found.total_degree() > degree:
        raise ScopeError(f"the potential is no polynomial of degree {degree} at most: not all equilibria of "
                         "the level are known, and a dimple inside the well may be one of them")
    return found


def _on_its_level(rotation: RelativeEquilibrium) -> tuple[Rational, list[RelativeEquilibrium]]:
    """The fraction that C1 = M·k is, and all equilibria of that level; the rotation is one of them."""
    scene, k = rotation.scene, in_balls(rotation.directions[0])
    with own_precision(BITS):
        rotor = in_balls(scene.body.gyrostatic_momentum)
        level = _fraction(ball(rotation.rates["omega"], BITS) * form(rows_in_balls(scene.body.tensor), k)
                          + dot(rotor, k))
    points = relative_equilibria(scene, {"C1": level})
    if any(e.rates["omega"] == rotation.rates["omega"] and e.directions[0] == rotation.directions[0]
           for e in points):
        return level, points
    if sign_of_constant(Add(Matrix(rotation.momentum).dot(Matrix(rotation.directions[0])), -level)) != 0:
        raise ScopeError(NO_FRACTION.format("C1"))
    return level, points


def _fraction(number: arb) -> Rational:
    """The fraction of a small denominator that is next to a number."""
    near = Fraction(number.mid().str(36, radius=False)).limit_denominator(LARGEST)
    return Rational(near.numerator, near.denominator)


def _rows(q: Sequence[Any], square: Any) -> list[Any]:
    """The vectors n and r of an attitude, from a quaternion of any length."""
    w, x, y, z = q
    n = 2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)
    r = 2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z
    return [c / square for c in (*n, *r)]


def quaternion(n: Sequence[arb], r: Sequence[arb]) -> list[arb]:
    """Return a quaternion of the attitude with the rows n and r, by its largest component."""
    t = [n[1] * r[2] - n[2] * r[1], n[2] * r[0] - n[0] * r[2], n[0] * r[1] - n[1] * r[0]]
    a, b, c = t, n, r
    squares = [1 + a[0] + b[1] + c[2], 1 + a[0] - b[1] - c[2], 1 - a[0] + b[1] - c[2], 1 - a[0] - b[1] + c[2]]
    largest = max(range(4), key=lambda i: float(squares[i].mid()))
    twice = squares[largest].sqrt()
    skew, even = (c[1] - b[2], a[2] - c[0], b[0] - a[1]), (b[0] + a[1], a[2] + c[0], c[1] + b[2])
    table = [[None, *skew], [skew[0], None, even[0], even[1]], [skew[1], even[0], None, even[2]],
             [skew[2], even[1], even[2], None]]
    return [twice / 2 if (x := table[largest][i]) is None else x / (2 * twice) for i in range(4)]
