"""Makes potentials U(k3) and U(k1, k2, k3) of an expression or a function, or leaves them unspecified."""
from collections.abc import Callable
from typing import Any

import sympy
from sympy import Expr, Symbol
from sympy.core.function import AppliedUndef

from ...algebra.rings.subexpressions import occurring
from ...algebra.text.numbers import exact_expression
from ...arguments import checked
from ...errors import PotentialError
from .potential import DIRECTIONS, Potential, U, expression_of

_NOT_SMOOTH = (sympy.Abs, sympy.sign, sympy.Heaviside, sympy.DiracDelta, sympy.Piecewise, sympy.Max,
               sympy.Min, sympy.floor,
               sympy.ceiling, sympy.frac, sympy.Mod, sympy.re, sympy.im, sympy.arg, sympy.conjugate)


@checked
def axial_potential(expression: Expr | float | str | Callable[[Symbol], Expr] | None = None) -> Potential:
    """Return an axially symmetric potential U(k3).

    Parameters
    ----------
    expression : Expr, str, number, callable or None
        U in k3 and real parameters [M L²/T²]; a text of it, as on the command line; a function of the symbol
        k3; or None or "U(k3)", U left unspecified. Symbols are matched by name, floats are the dyadic
        rationals they are.

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
    >>> gs.axial_potential("m0*k3").expression
    k3*m0
    >>> gs.axial_potential().expression
    U(k3)
    """
    return _potential(DIRECTIONS[2:], expression)


@checked
def general_potential(expression: Expr | float | str | Callable[..., Expr] | None = None) -> Potential:
    """Return a potential U(k1, k2, k3).

    Parameters
    ----------
    expression : Expr, str, callable or None
        U in k1, k2, k3 and real parameters [M L²/T²]; a text of it, as on the command line; a function of the
        three symbols; or None or "U(k1,k2,k3)", U left unspecified

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


def _potential(variables: tuple[Symbol, ...], given: Any) -> Potential:
    if isinstance(given, str) and "".join(given.split()) == f"U({','.join(map(str, variables))})":
        given = None
    if given is None:
        return Potential(variables, U(*variables))
    expression = exact_expression(expression_of(given, variables), "U")
    if rough := occurring(expression, *_NOT_SMOOTH):
        raise PotentialError(f"U = {expression} is not smooth, it contains {', '.join(map(str, rough))}: "
                             "stability needs two derivatives; give a smooth U")
    if expression.atoms(AppliedUndef):
        raise PotentialError(f"U = {expression} contains an unspecified function: call without arguments "
                             "to leave U unspecified")
    return Potential(variables, expression)
