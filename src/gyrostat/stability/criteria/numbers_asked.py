"""Reads the numbers at which a report is asked: named, exact, admissible, and on the family."""
from collections.abc import Iterable, Mapping, Sequence
from difflib import get_close_matches
from typing import Any

from sympy import Add, Expr, Rational, S, Symbol

from ...algebra.enclosures.balls import ball, finite_ball, is_undefined
from ...algebra.reals.exact import Point, compiled, evaluate, sign_of_constant
from ...algebra.text.numbers import exact_number, shown
from ...algebra.text.quantities import not_mixed
from ...errors import ScopeError, ValuesError, brief, require
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.equilibrium.unit_vectors import in_any_direction
from ...notation import NOTATION, Use, jet, symbol
from ...registry import use_of
from .conditions import Criterion

K3 = symbol("k3")


def exact_values(eq: Equilibrium, values: Mapping[str, Any], required: Sequence[str],
                 known: Sequence[str]) -> Point:
    """Return the values as exact numbers, every one of them checked.

    A doubt is noted in the point if it is not proved that a number is positive, or that the point is on the
    family.

    Raises
    ------
    ValuesError
        a required name is missing, a name is unknown, a number is not exact and finite, or the point is
        proved not to be on the family
    """
    require(values, Mapping, "what is given for the names")
    given = {str(name): value for name, value in values.items()}
    for name in given:
        if name not in known and not (eq.system.unspecified and jet(name)):
            raise ValuesError(unknown(name, known, eq.label))
    if missing := [name for name in required if name not in given]:
        raise ValuesError(f"{eq.label} needs {', '.join(map(_described, missing))}: give a number for each")
    not_mixed(given.items())
    numbers = Point({symbol(name): exact_number(value, name) for name, value in given.items()})
    for name, number in numbers.items():
        if not isinstance(number, Rational) and not finite_ball(number, 64).is_finite():
            raise ValuesError(f"{name} = {number} cannot be enclosed: write it with rationals, roots, pi, "
                              "exp, log and the like")
        if name.is_positive and not is_positive(name.name, number):
            numbers.doubt = f"whether {name} = {shown(number)} is positive is not proved"
    if eq.system.potential is not None:
        eq.system.potential.check_size(numbers)
    numbers.doubt = numbers.doubt or _exists(eq, numbers) or _on_family(eq, numbers)
    return numbers


def is_positive(name: str, number: Expr) -> bool:
    """Tell whether a number, for a name that is positive, is proved to be positive.

    ValuesError if it is proved not to be.

    Raises
    ------
    ValuesError
        it is proved not to be positive
    """
    sign = sign_of_constant(number)
    if sign in (0, -1):
        own = ", or write another letter for a number of your own" if use_of(name) is Use.FIELD else ""
        raise ValuesError(f"{name} = {shown(number) if sign else 0}, but {_described(name)} must be "
                          f"positive: give a positive number{own}")
    return sign == 1


def check_names(given: Iterable[str], names: Sequence[str], where: str) -> None:
    """Raise ValuesError if a name is unknown or missing."""
    for name in given:
        if name not in names:
            raise ValuesError(unknown(name, names, where))
    if missing := [name for name in names if name not in given]:
        raise ValuesError(f"{where} needs {', '.join(missing)}: give a number or an array for each")


def check_family(eq: Equilibrium, given: Iterable[str], required: Sequence[str], parameters: Sequence[str],
                 how: str) -> None:
    """Raise ValuesError unless the names are what a verdict on a family needs.

    Names that the others express are not among them.
    """
    refuse_any_direction(eq)
    known = [name for name in parameters if name not in eq.eliminated or name in required]
    for name in given:
        if name in eq.eliminated and name not in known:
            raise ValuesError(f"{name} follows from the other names on {eq.label}, {name} = "
                              f"{dict(eq.relations)[symbol(name)]}: omit it")
        if name not in known and not (eq.system.unspecified and jet(name)):
            raise ValuesError(unknown(name, known, eq.label))
    if missing := [name for name in required if name not in given]:
        raise ValuesError(f"{eq.label} needs {', '.join(missing)}: {how}")


def refuse_any_direction(eq: Equilibrium) -> None:
    """Raise ScopeError for a family in k1, k2, k3: no range of them stays on the sphere."""
    if in_any_direction(eq):
        raise ScopeError(f"{eq.label} has the names k1, k2, k3 with |k| = 1, and ranges of them leave the "
                         "sphere: give a direction by stereographic coordinates u1, u2, "
                         "permanent_rotation(scene, stereographic()), --direction stereographic")


def unknown(name: str, known: Sequence[str], where: str) -> str:
    """Return what to say about a name that is not a parameter."""
    other = {"pi3_0": "omega3_0", "omega3_0": "pi3_0"}
    close = [other[name]] if other.get(name) in known else get_close_matches(
        name, [*known, *(other[n] for n in known if n in other)], 1)
    hint = f"did you mean {close[0]}? Its" if close else "its"
    by_rate = "omega3_0" in (name, *close) and "omega3_0" not in known
    spin = ' (with spin="omega3_0" in place of pi3_0)' if by_rate else ""
    return f"{where} has no parameter {brief(name)[1:-1]}: {hint} parameters are {', '.join(known)}{spin}"


def _exists(eq: Equilibrium, numbers: Point) -> str:
    """Return what is not proved about the existence of the point, "" if nothing.

    A point that is proved not to exist is refused.
    """
    doubt = ""
    for expression in eq.existence():
        value = evaluate(expression, numbers)
        if value.free_symbols:
            continue
        if (sign := sign_of_constant(value)) is None and ball(value, 64).is_finite():
            doubt = (f"whether {eq.label} exists there is not proved: {expression} is {shown(value)}, and "
                     "has to be positive")
        elif sign != 1:
            here = "is not defined" if value is S.NaN else "is 0" if sign == 0 else f"is {shown(value)}"
            todo = "choose a point inside"
            if expression == 1 - K3**2 and K3 in numbers:
                todo = f"k3 = {shown(numbers[K3])}, give −1 < k3 < 1"
            raise ValuesError(f"{eq.label} exists only where {expression} > 0, here it {here}: {todo}")
    for expression in eq.field_values:
        if (fraction := compiled(expression)) is not None:
            symbols, _, bottom = fraction
            if bottom is None or (point := numbers.rational_at(symbols)) and bottom(*point):
                continue                                   # finite and real: no denominator, or it is not 0
        if not expression.free_symbols <= numbers.keys():
            continue
        value = evaluate(expression, numbers)
        if is_undefined(value):
            raise ValuesError(f"U or one of its derivatives, {expression}, is {shown(value)} there, not a "
                              "finite real number: choose another point")
    return doubt


def _on_family(eq: Equilibrium, numbers: Point) -> str:
    """Return what is not proved about the point's place on the family, "" if nothing.

    A point that is proved not to be on it is refused. Checked are abs(k) = 1 if k1, k2, k3 are given, the
    relations in which no name was eliminated, and the relation of an eliminated name that is given.
    """
    doubt = _unit_vector(eq, numbers) if in_any_direction(eq) else ""
    for residual in eq.constraints:
        if (value := evaluate(residual, numbers)).free_symbols:
            continue
        sign = sign_of_constant(value)
        if sign is None and ball(value, 64).is_finite():
            doubt = (f"whether the point is on {eq.label} is not proved: {residual} is {shown(value)}, and "
                     "has to be 0")
        elif sign != 0:
            raise ValuesError(f"the point is not on {eq.label}: {residual} is {shown(value)}, not 0; "
                              "correct the numbers")
    for name in map(symbol, eq.eliminated):
        if name in numbers:
            doubt = _satisfied(eq, name, numbers) or doubt
    return doubt


def _unit_vector(eq: Equilibrium, numbers: Point) -> str:
    """Return what is not proved about abs(k) = 1, "" if nothing; refuse another length."""
    rational = numbers.rational_at(eq.point[3:])
    if rational is not None and sum(x * x for x in rational) == 1:
        return ""
    k = [numbers[s] for s in eq.point[3:]]
    excess = Add(*(x**2 for x in k), -1)
    sign = sign_of_constant(excess)
    if sign is None and ball(excess, 64).is_finite():
        return f"whether k is a unit vector is not proved: |k|² − 1 is {shown(excess)}"
    if sign != 0:
        place = ", ".join(map(shown, k))
        raise ValuesError(f"k = ({place}) has |k|² − 1 = {shown(excess)}: k is a direction, |k| = 1; divide "
                          "it by its length, or give its stereographic coordinates")
    return ""


def _satisfied(eq: Equilibrium, name: Symbol, numbers: Mapping[Symbol, Expr]) -> str:
    """Return what is not proved about the relation of an eliminated name that is given.

    A value that is proved to be another is refused.
    """
    needed = eq.insert(dict(eq.relations)[name])
    if missing := left_open(names_in([needed]), numbers):
        raise ValuesError(f"to check {name} on {eq.label}, {', '.join(missing)} is needed: give it, or "
                          f"omit {name}")
    value = evaluate(needed, numbers)
    sign = sign_of_constant(difference := numbers[name] - value)
    if sign is None and ball(difference, 64).is_finite():
        return (f"whether the point is on {eq.label} is not proved: it needs {name} = {shown(value)}, given "
                f"was {shown(numbers[name])}")
    if sign != 0:
        given = shown(numbers[name])
        off = f", off by {shown(difference)}" if given == shown(value) else ""
        raise ValuesError(f"the point is not on {eq.label}: it needs {name} = {shown(value)}, given was "
                          f"{given}{off}; omit {name}, or "
                          "correct it")
    return ""


def names_needed(eq: Equilibrium, criteria: Iterable[Criterion]) -> tuple[str, ...]:
    """Return the names that a verdict by these criteria needs."""
    conditions = [c for criterion in criteria for a in criterion.alternatives for c in a]
    expressions = [e for c in conditions for e in (c.margin, *c.degenerate)] + list(eq.existence())
    return names_in([*expressions, *eq.constraints])


def names_accepted(eq: Equilibrium, required: Sequence[str]) -> tuple[str, ...]:
    """Return the names that a verdict accepts: those it needs, and others of scene and family."""
    scene = [eq.system.hamiltonian, *eq.system.body.entries, *eq.system.body.gyrostatic_momentum,
             *eq.point, *eq.existence()]
    own = set(names_in([*scene, *(e for pair in eq.relations for e in pair)])) | set(required)
    moving = set(map(str, eq.system.space.coordinates)) - set(names_in(eq.point))
    return tuple(sorted(n for n in own - moving if n in required or n in eq.eliminated or not jet(n)))


def names_of_motion(eq: Equilibrium) -> tuple[str, ...]:
    """Return the names that the motion near an equilibrium depends on, without those that others express."""
    known = {name.name for name, _ in eq.relations}
    return tuple(name for name in names_accepted(eq, ()) if name not in known)


def names_in(expressions: Iterable[Expr]) -> tuple[str, ...]:
    """Return the names of all symbols, sorted."""
    return tuple(sorted({s.name for e in expressions for s in e.free_symbols}))


def left_open(names: Iterable[str], numbers: Mapping[Symbol, Expr]) -> list[str]:
    """Return the names that have no number."""
    return [name for name in names if symbol(name) not in numbers]


def _described(name: str) -> str:
    return f"{name} ({NOTATION[name].meaning})" if name in NOTATION else name
