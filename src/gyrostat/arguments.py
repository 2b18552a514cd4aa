"""Checks the kinds of the arguments of public verbs where they are called.

A kind is what the annotation says: the reference, the type checker and the check read the same words.
"""
from collections.abc import Callable, Iterable, Mapping, Sequence
from decimal import Decimal
from fractions import Fraction
from functools import wraps
from numbers import Integral, Rational, Real
from types import NoneType, UnionType
from typing import Any, ParamSpec, TypeVar, Union, get_args, get_origin

from .errors import ArgumentError, article, brief

P = ParamSpec("P")
R = TypeVar("R")
Check = Callable[[Any], str]                               # what a value is not; "" if it is of the kind
_NAMES = {"eq": "the equilibrium", "scene": "the scene", "body": "the body", "report": "the report",
          "motion": "the motion", "rotor": "the rotor", "potential": "the potential"}
_WORDS: dict[Any, str] = {
    NoneType: "None", str: "a text", int: "a whole number", float: "a number", bool: "True or False",
    Callable: "a function", Mapping: 'a mapping of names, {"I1": 1}', Sequence: "several entries, (1, 2)"}
_WIDER: dict[type, Any] = {int: Integral, float: (Real, Decimal), Fraction: Rational}
MOST = 10**7                                               # entries of a sequence
_NOT_SEVERAL = (str, bytes, bytearray, memoryview, Mapping, type)


def checked(verb: Callable[P, R]) -> Callable[P, R]:
    """Return the verb with a check that refuses arguments of another kind than their annotations.

    What is annotated as Any, and the numbers in a sequence or a mapping, are left to the verb.

    Examples
    --------
    >>> @checked
    ... def half(number: float, why: str = ""):
    ...     return number / 2
    >>> half(3)
    1.5
    >>> half("3")  # doctest: +NORMALIZE_WHITESPACE
    Traceback (most recent call last):
    gyrostat.errors.ArgumentError: number = '3' is a str, not a number:
    check the order and kind of the arguments
    """
    inner: Any = verb
    while hasattr(inner, "__wrapped__"):
        inner = inner.__wrapped__
    places = inner.__code__.co_varnames[:inner.__code__.co_argcount]
    checks = {name: check for name, kind in inner.__annotations__.items() if (check := _check_of(kind))}
    checks.pop("return", None)

    @wraps(verb)
    def asked(*args: P.args, **kwargs: P.kwargs) -> R:
        for name, value in (*zip(places, args), *kwargs.items()):
            if name in checks and (missed := checks[name](value)):
                given = _NAMES.get(name) or f"{name} = {brief(value)}"
                raise ArgumentError(f"{given} is {article(type(value))}, not {missed}: check the order and "
                                    "kind of the arguments")
        return verb(*args, **kwargs)

    return asked


def several(given: Any, what: str, count: int | None = None) -> tuple[Any, ...]:
    """Return the entries of a sequence, an array or a matrix.

    Their number is asked for before they are read.

    Parameters
    ----------
    given : Any
    what : str
        its name in a message
    count : int or None
        how many there have to be; default: any number

    Raises
    ------
    ArgumentError
        it is no sequence, or has another number of entries

    Examples
    --------
    >>> several([1, 2, 3], "axis", 3)
    (1, 2, 3)
    >>> several("123", "axis", 3)  # doctest: +NORMALIZE_WHITESPACE
    Traceback (most recent call last):
    gyrostat.errors.ArgumentError: axis is a str, not several entries:
    give 3 in brackets, (1, 2, 3)
    """
    wanted = f"{count} in brackets, (1, 2, 3)" if count else "them in brackets, (1, 2)"
    if not _is_sequence(given):
        raise ArgumentError(f"{what} is {article(type(given))}, not several entries: give {wanted}")
    if len(given) > MOST or count is not None and len(given) != count:
        raise ArgumentError(f"{what} has {len(given)} entries: give {wanted}")
    return tuple(given)


def _check_of(kind: Any) -> Check | None:
    """Return the check that says what a value is not; None for a kind that is not checked."""
    origin, inside = get_origin(kind) or kind, get_args(kind)
    if origin in (Union, UnionType):
        checks = [_check_of(part) for part in inside]
        return None if None in checks else _one_of([check for check in checks if check])
    if _is_pair(kind):
        return lambda value: "" if _is_sequence(value) and len(value) == len(inside) else (
            f"{len(inside)} entries")
    if origin in (Sequence, Iterable, tuple):
        return _entries_of(inside[0] if inside else Any)
    if origin is Mapping and inside and inside[0] is str:
        return lambda value: "" if isinstance(value, Mapping) and all(
            isinstance(name, str) for name in value) else _WORDS[Mapping]
    if origin is Callable or getattr(origin, "__name__", "") == "Callable":
        return lambda value: "" if callable(value) else _WORDS[Callable]
    protocol = getattr(origin, "_is_protocol", False) and not getattr(origin, "_is_runtime_protocol", False)
    if isinstance(origin, type) and origin is not Any and not protocol:
        return lambda value: "" if _is(value, origin) else _WORDS.get(origin, article(origin))
    return None


def _one_of(checks: list[Check]) -> Check:
    def check(value: Any) -> str:
        missed = [one(value) for one in checks]
        return " or ".join(missed) if all(missed) else ""

    return check


def _entries_of(kind: Any) -> Check:
    """Return the check of a sequence; its entries are checked, too, if they are no numbers."""
    asked = _is_pair(kind) or isinstance(kind, type) and not _of_mathematics(kind)
    inner = _check_of(kind) if asked else None

    def check(value: Any) -> str:
        if not _is_sequence(value):
            return _WORDS[Sequence]
        if len(value) > MOST:
            return f"at most {MOST} entries"
        missed = next(filter(None, map(inner, value)), "") if inner else ""
        return f"a sequence in which each entry is {missed}" if missed else ""

    return check


def _is(value: Any, kind: type) -> bool:
    if kind is NoneType:
        return value is None
    if kind is bool:
        return isinstance(value, bool) or type(value).__module__ == "numpy" and "bool" in type(value).__name__
    return isinstance(value, _WIDER.get(kind, kind)) and not (
        kind in _WIDER and isinstance(value, bool))


def _is_sequence(value: Any) -> bool:
    """Tell whether it has entries in an order: arrays and matrices have, a number of NumPy has not."""
    return not isinstance(value, _NOT_SEVERAL) and hasattr(value, "__len__") and hasattr(
        value, "__getitem__") and getattr(value, "shape", None) != ()


def _is_pair(kind: Any) -> bool:
    """Tell whether it is a tuple of a number of entries, such as tuple[Any, Any]."""
    return get_origin(kind) is tuple and Ellipsis not in get_args(kind)


def _of_mathematics(kind: type) -> bool:
    """Tell whether it is a kind of numbers or expressions, which the verb makes exact."""
    return kind in (int, float, object) or kind.__module__.startswith("sympy")
