"""Initial value problems in floats: heyoka's Taylor method, or SciPy's DOP853, from one time to the next."""
import math
import operator
from collections.abc import Callable, Mapping, Sequence
from copy import copy
from functools import lru_cache, partial, reduce
from typing import Any

import numpy as np
from sympy import Expr, Rational, Symbol

from ...algebra.enclosures.arithmetic import Arithmetic, in_arithmetic
from ...algebra.enclosures.floats import Array
from ...algebra.text.bounded_parts import FUNCTIONS
from ...errors import AccuracyError, ScopeError, optional
from ..periods import nearest

Rates = tuple[tuple[Symbol, Expr], ...]
Rounding = Callable[[Expr], float]


def beside(number: Expr) -> float:
    """Return a number that is a double as it is; any other is rounded to the next double above the nearest.

    That is as bad a rounding, and another.
    """
    value = nearest(number)
    return value if Rational(value) == number else math.nextafter(value, math.inf)


def integrable(values: Mapping[Symbol, Any], constant: Callable[[Expr], Any], add: Callable[[Any, Any], Any],
               multiply: Callable[[Any, Any], Any], power: Callable[[Any, float], Any],
               function: Callable[[str], Callable[[Any], Any]]) -> Arithmetic:
    """Return the arithmetic of a method: a whole power is a product, any but FUNCTIONS are refused.

    Raises
    ------
    ScopeError
        when it is used: a function or a power that no potential here has, such as a Bessel function
    """
    def leaf(node: Expr) -> Any:
        if isinstance(node, Symbol):
            return values[node]
        return NotImplemented if node.free_symbols else constant(node)

    def raised(base: Any, exponent: Rational) -> Any:
        if exponent.is_integer and exponent > 0:
            return reduce(multiply, [base] * int(exponent))
        return power(base, float(exponent))

    def applied(node: Expr, parts: Sequence[Any]) -> Any:
        name = type(node).__name__
        if name not in FUNCTIONS or len(parts) != 1:
            raise ScopeError(f"{node} cannot be integrated: write U with + - * /, rational powers and "
                             f"{', '.join(FUNCTIONS)}")
        return function(name)(parts[0])

    return Arithmetic(leaf, partial(reduce, add), partial(reduce, multiply), raised, applied)


def _function(name: str) -> Callable[[Any], Any]:
    function = getattr(math, name)
    return lambda a: lambda x: function(a(x))


def floats(values: Mapping[Symbol, Callable[[Sequence[float]], float]], rounding: Rounding) -> Arithmetic:
    """Return the arithmetic of functions of a point, which is a sequence of floats.

    Examples
    --------
    >>> import gyrostat as gs
    >>> x = gs.symbol("x")
    >>> first = floats({x: lambda point: point[0]}, nearest)
    >>> in_arithmetic(x**3 / 2 - 1, first)((2.0,))
    3.0
    """
    def constant(number: Expr) -> Callable[[Sequence[float]], float]:
        value = rounding(number)
        return lambda x: value

    return integrable(values, constant, lambda a, b: lambda x: a(x) + b(x),
                      lambda a, b: lambda x: a(x) * b(x),
                      lambda a, c: lambda x: math.pow(a(x), c), _function)


class Taylor:
    """The adaptive Taylor method of heyoka: the order follows from the tolerance.

    Numbers are parameters of its code, so that it is compiled once for all bodies in equations of one form.
    """

    FINE, COARSE = 2.0**-52, 2.0**-40

    def __init__(self, rates: Rates, start: Array, rounding: Rounding, tolerance: float):
        system, numbers = _with_parameters(rates)
        self.start, self.steps = start, 0
        self.limit = optional("heyoka", "heyoka").taylor_outcome.time_limit
        self.integrator = copy(_compiled(system, tolerance))
        self.integrator.pars[:] = [rounding(x) for x in numbers]
        self.restart()

    @property
    def time(self) -> float:
        """The time at which it is."""
        return float(self.integrator.time)

    def restart(self) -> None:
        """Go back to the time 0."""
        self.integrator.time, self.integrator.state[:] = 0.0, self.start

    def reach(self, times: Array) -> Array:
        """Return the values at times further and further on."""
        ahead = int(times[0] != self.time)
        grid = np.concatenate([[self.time], times]) if ahead else times
        outcome, *_, steps, _, values = self.integrator.propagate_grid(grid)
        if outcome != self.limit:
            time = self.time if math.isfinite(self.time) else grid[len(values) - 1]
            self.restart()
            raise beyond(time)
        self.steps += steps
        return values[ahead:]


@lru_cache(maxsize=64)
def _with_parameters(rates: Rates) -> tuple[Any, tuple[Expr, ...]]:
    """Return equations of motion in heyoka's expressions, and the numbers in them, its parameters."""
    heyoka = optional("heyoka", "heyoka")
    names = {s: heyoka.make_vars(f"x{i}") for i, (s, _) in enumerate(rates)}
    numbers: dict[Expr, int] = {}

    def parameter(number: Expr) -> Any:
        if number in (1, -1):                              # nothing is multiplied
            return heyoka.expression(float(number))
        return heyoka.par[numbers.setdefault(number, len(numbers))]

    arithmetic = integrable(names, parameter, operator.add, operator.mul, operator.pow,
                            lambda name: getattr(heyoka, name))
    system = tuple((names[s], in_arithmetic(rate, arithmetic)) for s, rate in rates)
    return system, tuple(numbers)


@lru_cache(maxsize=64)
def _compiled(system: Any, tolerance: float) -> Any:
    """Return heyoka's integrator of equations with parameters, to be copied."""
    heyoka = optional("heyoka", "heyoka")
    return heyoka.taylor_adaptive(list(system), [0.0] * len(system), tol=tolerance)


class RungeKutta:
    """The method DOP853 of order 8 of Dormand and Prince, in SciPy."""

    FINE, COARSE = 2.5e-14, 1e-12

    def __init__(self, rates: Rates, start: Array, rounding: Rounding, tolerance: float):
        self.method = optional("scipy.integrate", "trajectories").DOP853
        names = {s: operator.itemgetter(i) for i, (s, _) in enumerate(rates)}
        self.rates = [in_arithmetic(rate, floats(names, rounding)) for _, rate in rates]
        self.start, self.tolerance, self.steps = start, tolerance, 0
        self.restart()

    def restart(self) -> None:
        """Go back to the time 0."""
        self.time = 0.0
        self.solver: Any = None

    def field(self, _: float, x: Array) -> list[float]:
        """Return the rates at a point; NaN if U is singular, so that the step is made shorter."""
        point = x.tolist()
        try:
            return [rate(point) for rate in self.rates]
        except (ValueError, ZeroDivisionError, OverflowError):
            return [math.nan] * len(point)

    def reach(self, times: Array) -> Array:
        """Return the values at times further and further on."""
        if self.solver is None or self.solver.direction * times[-1] < 0:
            end = math.copysign(math.inf, times[-1])
            self.solver = self.method(self.field, 0.0, self.start, end, rtol=self.tolerance,
                                      atol=self.tolerance)
        found, done = np.empty((len(times), len(self.start))), 0
        while done < len(times):
            while self.solver.t_old is None or abs(times[done]) > abs(self.solver.t):
                with np.errstate(all="ignore"):        # a step that is not taken may overflow
                    self.solver.step()
                self.steps += 1
                if self.solver.status == "failed":
                    time = self.solver.t
                    self.restart()
                    raise beyond(time)
            ready = done + int(np.count_nonzero(np.abs(times[done:]) <= abs(self.solver.t)))
            found[done:ready] = self.solver.dense_output()(times[done:ready]).T
            self.time, done = self.solver.t_old, ready
        return found


METHODS: dict[str, type[Taylor] | type[RungeKutta]] = {"heyoka": Taylor, "DOP853": RungeKutta}


def beyond(time: float) -> AccuracyError:
    """Return the error to raise if there is no motion beyond a time."""
    return AccuracyError(f"the motion cannot be followed beyond t = {time}: U or its gradient is singular "
                         "there, or the numbers are too far from 1: ask for times before, or give them in "
                         "other units")
