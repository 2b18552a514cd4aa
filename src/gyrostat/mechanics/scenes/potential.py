"""A potential U(k3) or U(k1, k2, k3), unspecified or given, and its jet: its derivatives at a point."""
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any, ClassVar

from flint import arb
from sympy import Expr, Function, Pow, Rational, Symbol, acos, acosh, asin, atanh, log
from sympy.core.function import AppliedUndef

from ..._cached import cached_property
from ..._display import Shown
from ...algebra.rings.polynomials import Ring
from ...algebra.rings.subexpressions import occurring
from ...algebra.text.bounded_parts import BITS, enclosure, immoderate
from ...arguments import checked
from ...errors import PotentialError, ValuesError, brief
from ...notation import Stored, components, jet, jet_name, symbol
from .kind import Kind
from .potential_hints import why_not, without_k

DIRECTIONS = components("k")
U = Function("U", real=True)
U.__module__ = __name__                                # pickle finds it by this name


def expression_of(given: Any, variables: Sequence[Symbol]) -> Any:
    """Return what is given as U, or if it is a function its value at the components.

    Raises
    ------
    PotentialError
        the function cannot be asked there, or it is no expression
    """
    names = ", ".join(map(str, variables))
    if callable(given) and not isinstance(given, Expr):
        try:
            given = given(*variables)
        except (ArithmeticError, AttributeError, LookupError, TypeError, ValueError) as error:
            raise PotentialError(f"U = {brief(given)} cannot be evaluated at the symbols {names} "
                                 f"({brief(str(error))}): "
                                 "give an expression, or a function that makes one, with sympy.cos for "
                                 "numpy.cos") from error
    if isinstance(given, bool):
        raise PotentialError(f"U = {brief(given)} is not an expression: build it from symbol('k3'), or "
                             f"give a function of {names}")
    return given


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
    kind: ClassVar[Kind] = Kind.FIELD                      # of the scene of any body in it

    def __post_init__(self) -> None:
        self._check_names()
        if self.expression.free_symbols and not self.expression.free_symbols & set(self.variables):
            raise PotentialError(f"U = {self.expression} does not depend on "
                                 f"{', '.join(map(str, self.variables))}: write it in the components of k"
                                 f"{without_k(self.expression, self.variables)}")
        if self.expression.is_real is False or self.expression.is_finite is False:
            raise PotentialError(f"U = {self.expression} is not a finite real number: check roots, "
                                 "logarithms and denominators")
        for power in occurring(self.expression, Pow):
            if power.exp.is_negative and not Ring([power.base]).numerator(power.base):
                raise PotentialError(f"U = {self.expression} divides by {power.base}, which is 0 "
                                     "identically: check the denominators")

    def _check_names(self) -> None:
        """Refuse names that are not parameters of a potential."""
        if self.expression.free_symbols & set(self.variables) and (
                why := why_not(self.expression, self.variables)):
            raise PotentialError(f"U = {self.expression} {why}")

    @property
    def given(self) -> bool:
        """Whether U is an expression, not an unspecified function."""
        return not isinstance(self.expression, AppliedUndef)

    @property
    def coupled(self) -> bool:
        """Whether there is a second direction, or a term β·π in the energy: a CoupledPotential."""
        return self.kind in (Kind.ORBIT, Kind.COUPLED)

    @property
    def directions(self) -> tuple[str, ...]:
        """The names of the directions."""
        return tuple(x.name[:-1] for x in self.variables[::3])

    @checked
    def changed(self, change: Callable[[Expr], Expr]) -> "Potential":
        """Return the potential with its expression changed, for example by inserting numbers.

        Parameters
        ----------
        change : callable

        Returns
        -------
        Potential
        """
        return replace(self, expression=change(self.expression))

    @property
    def axial(self) -> bool:
        """Whether U depends on k3 alone."""
        return len(self.variables) == 1

    @cached_property
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
        known = {s: arb(0, 1) for s in self.variables}     # components of directions: from −1 to 1
        known |= {s: ball for s, x in numbers.items() if s not in known
                  and (ball := enclosure(x)) is not None}
        if (function := immoderate(self.expression, known)) is not None:
            raise ValuesError(f"{function} in U would be evaluated at a number of more than {BITS} bits: "
                              "give smaller numbers")

    @cached_property
    def _asks(self) -> bool:
        """Whether a given U has functions, or roots."""
        return self.given and (bool(self.expression.atoms(Function)) or any(
            not p.exp.is_Integer for p in self.expression.atoms(Pow)))

    def with_free_rotors(self) -> "Potential":
        """Return the same potential for a body with free rotors."""
        return self

    def gradient(self) -> tuple[Expr, ...]:
        """Return ∇U in the symbols of the jet, shape (3,)."""
        return self.following(symbol("U"))

    @checked
    def following(self, derivative: Symbol) -> tuple[Expr, ...]:
        """Return the derivatives along k1, k2, k3 of a symbol of the jet.

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

    @checked
    def value(self, derivative: Symbol) -> Expr:
        """Return what a symbol of the jet stands for, as an expression in k.

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
        return derivative_along(self.expression, *along)


@lru_cache(maxsize=1024)
def derivative_along(expression: Expr, *variables: Symbol) -> Expr:
    """Return the derivative of an expression, along each of the variables in turn."""
    return expression.diff(*variables)


@lru_cache(maxsize=256)
def smooth_where_positive(expression: Expr) -> tuple[Expr, ...]:
    """Return what has to be positive for the expression to be real and smooth.

    These are, for example, x in √x and log x, and 1 − x² in asin x.
    """
    roots = [p for p in occurring(expression, Pow) if p.exp.is_Rational and not p.exp.is_Integer]
    found: list[Expr] = [root.base for root in roots]
    found += [f.args[0] for f in occurring(expression, log)]
    found += [f.args[0] - 1 for f in occurring(expression, acosh)]
    found += [1 - f.args[0] ** 2 for f in occurring(expression, asin, acos, atanh)]
    return tuple(dict.fromkeys(found))
