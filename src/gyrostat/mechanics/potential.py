"""Potentials U(k3), unspecified or given, and U(k1, k2, k3); their jets."""
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import sympy
from sympy import Expr, Function, Pow, Rational, Symbol, acos, acosh, asin, atanh, cos, log
from sympy.core.function import AppliedUndef

from ..algebra import magnitudes
from ..algebra.numbers import exact_expression
from ..algebra.parts import BITS, enclosure, immoderate
from ..algebra.polynomials import Ring
from ..errors import PotentialError, ValuesError, brief
from ..notation import Shown, Stored, jet, jet_name, of_the_motion, symbol

_NOT_SMOOTH = (sympy.Abs, sympy.sign, sympy.Heaviside, sympy.DiracDelta, sympy.Piecewise, sympy.Max,
               sympy.Min, sympy.floor,
               sympy.ceiling, sympy.frac, sympy.Mod, sympy.re, sympy.im, sympy.arg, sympy.conjugate)
_ANGLES, _HEIGHTS = ("theta", "Theta", "th"), ("z", "Z", "K3", "k_3", "kz", "k_z", "zeta", "gamma3",
                                               "gamma_3", "costheta", "cos_theta")
DIRECTIONS = tuple(symbol(f"k{i}") for i in (1, 2, 3))
U = Function("U", real=True)
U.__module__ = __name__                                # pickle finds it by this name


@dataclass(frozen=True)
class Potential(Shown, Stored):
    """U as a function of k3 alone, or of k1, k2, k3.

    Its derivatives at a point, the jet, are symbols of their own (dU, d2U, … or dU_1, d2U_13, …) until
    a given U inserts their values.

    Parameters
    ----------
    variables : tuple of Symbol
        (k3,) or (k1, k2, k3)
    expression : Expr
        U [M L²/T²]
    revolution : bool
        whether the formula holds only for a body with I1 = I2

    Examples
    --------
    >>> import gyrostat as gs
    >>> U = gs.uniform_field()
    >>> U.variables, U.expression, U.parameters
    ((k3,), k3*m0, (m0,))
    """

    variables: tuple[Symbol, ...]
    expression: Expr
    revolution: bool = False

    def __post_init__(self) -> None:
        if taken := of_the_motion(self.parameters):
            raise PotentialError(f"U = {self.expression} depends on {', '.join(taken)}, which is not a "
                                 "parameter of a "
                                 f"potential in {', '.join(map(str, self.variables))}: rename it, or use "
                                 "general_potential")
        if self.expression.free_symbols and not self.expression.free_symbols & set(self.variables):
            raise PotentialError(f"U = {self.expression} does not depend on "
                                 f"{', '.join(map(str, self.variables))}: "
                                 f"write it in the components of k{_meant(self.expression)}")
        if self.expression.is_real is False or self.expression.is_finite is False:
            raise PotentialError(f"U = {self.expression} is not a finite real number: check roots, "
                                 "logarithms and denominators")
        for power in self.expression.atoms(Pow):
            if power.exp.is_negative and not (ring := Ring([power.base])).reduce(
                ring.fraction(power.base)[0]
            ):
                raise PotentialError(f"U = {self.expression} divides by {power.base}, which is 0 "
                                     "identically: check the denominators")

    @property
    def given(self) -> bool:
        """Whether U is an expression, not an unspecified function."""
        return not isinstance(self.expression, AppliedUndef)

    @property
    def axial(self) -> bool:
        """Whether U depends on k3 alone."""
        return len(self.variables) == 1

    @property
    def parameters(self) -> tuple[Symbol, ...]:
        """The symbols of U other than k, by name."""
        return tuple(sorted(self.expression.free_symbols - set(self.variables), key=str))

    def check_size(self, numbers: Mapping[Symbol, Expr]) -> None:
        """Refuse numbers at which a function in U would be asked at one of more than 4000 bits.

        Parameters
        ----------
        numbers : mapping of Symbol to Expr

        Raises
        ------
        ValuesError
            U = tan(exp(a*k3)) at a = 10⁸, which asks for the tangent of a number of 43 million digits
        """
        if not self._asks:
            return
        known = {s: magnitudes.at_most_one() for s in self.variables}
        known |= {s: ball for s, x in numbers.items() if s not in known
                  and (ball := enclosure(x)) is not None}
        if (function := immoderate(self.expression, known)) is not None:
            raise ValuesError(f"{function} in U is asked at a number of more than {BITS} bits there: give "
                              "smaller numbers")

    @cached_property
    def _asks(self) -> bool:
        """Whether U has functions, or roots."""
        return bool(self.expression.atoms(Function)) or any(not p.exp.is_Integer
                                                            for p in self.expression.atoms(Pow))

    def gradient(self) -> tuple[Expr, ...]:
        """∇U in the symbols of the jet, shape (3,)."""
        return (
            (Rational(0), Rational(0), symbol("dU"))
            if self.axial
            else tuple(symbol(jet_name(1, a)) for a in "123")
        )

    def following(self, derivative: Symbol) -> tuple[Expr, ...]:
        """Derivatives along k1, k2, k3 of a symbol of the jet.

        Parameters
        ----------
        derivative : Symbol
            dU, say

        Returns
        -------
        tuple of Expr, shape (3,)
        """
        order, axes = jet(derivative.name) or (0, "")
        if self.axial:
            return Rational(0), Rational(0), symbol(jet_name(order + 1))
        return tuple(symbol(jet_name(order + 1, "".join(sorted(axes + a)))) for a in "123")

    def value(self, derivative: Symbol) -> Expr:
        """What a symbol of the jet stands for, as an expression in k.

        Parameters
        ----------
        derivative : Symbol
            dU, say

        Returns
        -------
        Expr
            [M L²/T²]
        """
        order, axes = jet(derivative.name) or (0, "")
        along = self.variables * order if self.axial else tuple(DIRECTIONS[int(a) - 1] for a in axes)
        return self.expression.diff(*along)


def _meant(expression: Expr) -> str:
    """What is likely to have been meant for a component of k."""
    meant = [f for f in sorted(expression.atoms(cos), key=str) if str(f.args[0]) in _ANGLES]
    meant += sorted((s for s in expression.free_symbols if s.name in _HEIGHTS), key=str)
    return (
        f"; k3 for {meant[0]}, as in U = {expression.xreplace(dict.fromkeys(meant, DIRECTIONS[2]))}"
        if meant
        else ""
    )


def axial_potential(expression: Expr | Callable[[Symbol], Expr] | None = None) -> Potential:
    """Axially symmetric potential U(k3).

    Parameters
    ----------
    expression : Expr, number, callable or None
        U in k3 and real parameters [M L²/T²]; a function of the symbol k3; or None, U left unspecified.
        Symbols are matched by name, floats are the dyadic rationals they are.

    Returns
    -------
    Potential

    Raises
    ------
    PotentialError
        U has parameters but no k3, or depends on k1, k2 or a name of the motion

    References
    ----------
    Vera & Viguera, Monografías de la Real Academia de Ciencias de Zaragoza 22 (2003) 141-150, §1.

    Examples
    --------
    >>> import gyrostat as gs
    >>> gs.axial_potential(lambda k3: k3**2 / 2).expression
    k3**2/2
    >>> gs.axial_potential().expression
    U(k3)
    """
    return _potential(DIRECTIONS[2:], expression)


def general_potential(expression: Expr | Callable[..., Expr] | None = None) -> Potential:
    """Potential U(k1, k2, k3).

    Parameters
    ----------
    expression : Expr, callable or None
        U in k1, k2, k3 and real parameters [M L²/T²]; a function of the three symbols; or None, U left
        unspecified

    Returns
    -------
    Potential

    Raises
    ------
    PotentialError
        U has parameters but no component of k, or depends on a name of the motion

    Examples
    --------
    >>> import gyrostat as gs
    >>> gs.general_potential(lambda k1, k2, k3: k1 * k2 + k3).gradient()
    (dU_1, dU_2, dU_3)
    """
    return _potential(DIRECTIONS, expression)


def smooth_where_positive(expression: Expr) -> tuple[Expr, ...]:
    """What has to be positive for the expression to be real and smooth.

    X of √x and log x, 1 − x² of asin x, and the like.
    """
    found: list[Expr] = [p.base for p in expression.atoms(Pow) if p.exp.is_Rational and not p.exp.is_Integer]
    found += [f.args[0] for f in expression.atoms(log)] + [f.args[0] - 1 for f in expression.atoms(acosh)]
    found += [1 - f.args[0] ** 2 for f in expression.atoms(asin, acos, atanh)]
    return tuple(dict.fromkeys(found))


def _potential(variables: tuple[Symbol, ...], given: Any) -> Potential:
    if given is None:
        return Potential(variables, U(*variables))
    if callable(given) and not isinstance(given, Expr):
        try:
            given = given(*variables)
        except (AttributeError, TypeError, ValueError) as error:
            names = ", ".join(map(str, variables))
            raise PotentialError(f"U = {brief(given)} cannot be asked at the symbols {names} "
                                 f"({brief(str(error))}): "
                                 "give an expression, or a function that makes one, with sympy.cos for "
                                 "numpy.cos") from error
    if isinstance(given, (str, bool)):
        raise PotentialError(f"U = {brief(given)} is not an expression: build it from symbol('k3'), or "
                             "give a function of "
                             f"{', '.join(map(str, variables))}")
    expression = exact_expression(given, "U")
    if rough := expression.atoms(*_NOT_SMOOTH):
        raise PotentialError(f"U = {expression} is not smooth, it contains {', '.join(map(str, rough))}: "
                             "stability needs two derivatives")
    if expression.atoms(AppliedUndef):
        raise PotentialError(f"U = {expression} contains an unspecified function: call without arguments "
                             "to leave U unspecified")
    return Potential(variables, expression)
