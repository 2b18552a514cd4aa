"""Computes both sides of a formula at a point by the library, and by Newton and Euler's equations."""
from collections.abc import Sequence
from typing import Any

from sympy import Expr, MatrixBase

from ...algebra.reals.exact import sign_of_constant
from ...errors import PublishedError
from ...notation import symbol
from ..independent.counterexample import Values
from ..independent.frame_equations import model_of
from ..independent.names_at_numbers import number
from ..language import decimal
from ..statements import Doubt, Seen, entry_of
from .readings import Reading


def formula_at(r: Reading, values: Values, doubt: Doubt) -> Seen | None:
    """Compare both sides of a formula at a point; None if they are not seen to differ there.

    The library gives them, and again Newton and Euler's equations, or the product of three turns.
    """
    if r.statement.kind == "solution":
        return _solution(r, values, doubt)
    sides = tuple(e.subs(dict(values)) for e in doubt.sides)
    quantity = number(_entry(r.independently(r.statement.quantity, values), doubt.place), r.scene, values)
    if sides[0].evalf(20).is_real is False:
        # the grammar refuses to read what is not real
        return _compared(r, values, sides, (sides[0], quantity), doubt)
    printed = number(_entry(r.independently(r.statement.printed, values), doubt.place), r.scene, values)
    return _compared(r, values, sides, (printed, quantity), doubt)


def _solution(r: Reading, values: Values, doubt: Doubt) -> Seen | None:
    """Compare the slope of a printed solution with the rate along the motion.

    If the functions satisfy the equations, show a start that no choice of their constants reaches.
    """
    quantity = list(map(str, r.statement.quantity))
    if doubt.place is None:
        for name, f, side in zip(quantity, doubt.printed.subs(symbol("t"), 0), doubt.sides):
            if f.is_number and sign_of_constant(side.subs(dict(values)) - f) in (1, -1):
                return Seen(f, side.subs(dict(values)),
                            f"{name} may start there; the printed functions start it at {f} for every choice "
                            f"of {', '.join(r.statement.constants)}", True)
        return None
    for f in (f.subs(dict(values)) for f in doubt.printed):
        if f.evalf(20).is_real is False:
            return Seen("not real", "a real number", f"the printed value there is {f.evalf(8)}", True)
    moving = {**values, **{x: f.subs(dict(values)) for x, f in doubt.moving.items()}}
    p, d = (e.subs(dict(values)) for e in doubt.sides)
    rate = number(r.independently(f"dt({quantity[doubt.place[0]]})", moving), r.scene, moving)
    return _compared(r, values, (p, d), [p, rate], doubt)


def _entry(value: Any, place: Any) -> Any:
    return value[place] if isinstance(value, MatrixBase) else value


def _compared(r: Reading, values: Values, library: Sequence[Expr], again: Sequence[Any],
              doubt: Doubt) -> Seen | None:
    """Return both sides if they differ; raise PublishedError if the two routes disagree on one of them."""
    (p, d), (x, y) = library, again
    for one, other in ((d, y), (p, x)):
        if (
            not isinstance(other, Expr)
            or other.free_symbols
            or not abs((other - one).evalf(25)) <= 1e-18 * max(1, abs(one.evalf(25)))
        ):
            raise PublishedError(f"computed independently it is {other} at {dict(values)}, by the library "
                                 f"{one}")
    sides = x.evalf(30), y.evalf(30)
    if sides[1].is_real is not True or abs(sides[0] - sides[1]) <= 1e-20:
        return None
    by = "three turns of the body" if "angles" in r.scene.table else "Newton and Euler's equations"
    which = entry_of(doubt.place, doubt.derived)
    if sides[0].is_real is not True:
        return Seen("not real", d,
                    f"{which}the printed value there is {p.evalf(8)}, and {by} give {_short(y)}", True)
    return Seen(p, d, f"{which}{by} give {_short(y)} at these numbers", True)


def _short(value: Expr) -> str:
    return str(value) if value.is_Rational else str(value.evalf(20))


def decimal_at(r: Reading, values: Values, doubt: Doubt) -> Seen | None:
    """Compare a printed decimal with the number that Newton and Euler's equations give."""
    printed, half = decimal(str(r.statement.printed))
    value = number(r.independently(r.statement.quantity, values), r.scene, values)
    if abs((value - doubt.derived).evalf(25)) > 1e-18 * max(1, abs(doubt.derived.evalf(25))):
        raise PublishedError(f"computed independently it is {value}, by the library {doubt.derived}")
    if abs((value - printed).evalf(30)) <= half:
        return None
    return Seen(printed, doubt.derived, f"Newton and Euler's equations give {_short(value)} at these numbers",
                True)


def rest_at(r: Reading, values: Values, doubt: Doubt) -> Seen | None:
    """Show a rate that does not vanish at a point that is printed as an equilibrium."""
    model = model_of(r.scene, values)
    at = dict(zip(model.coordinates, r.independently(r.statement.printed, values)))
    name, rate = model.coordinates[doubt.place[0]], model.field.subs(at)[doubt.place[0]].subs(dict(values))
    if sign_of_constant(rate - doubt.sides[0].subs(dict(values))) != 0:
        raise PublishedError(f"Newton and Euler's equations give the rate {rate}, the library "
                             f"{doubt.sides[0].subs(dict(values))}")
    if sign_of_constant(rate) in (0, None):
        return None
    why = f"by Newton and Euler's equations the rate of {name} there is {rate}, not 0"
    return Seen("an equilibrium", f"d{name}/dt = {rate}", why, True)
