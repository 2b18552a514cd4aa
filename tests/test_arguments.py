"""The kinds of arguments: what is asked of them, and what is left to the verb."""
from collections.abc import Callable, Iterable, Mapping, Sequence
from decimal import Decimal
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from sympy import Expr, ImmutableMatrix, Integer, Symbol

import gyrostat as gs
from gyrostat.arguments import checked, several
from gyrostat.errors import ArgumentError


@checked
def verb(eq: gs.Equilibrium | None = None, number: float = 0, count: int = 1, name: str = "",
         why: bool = False, pair: tuple[Any, Any] = (1, 2), row: Sequence[float] = (),
         verbs: Iterable[Expr] = (), entries: tuple[gs.System, ...] = (),
         values: Mapping[str, Any] | None = None, pairs: Sequence[tuple[Any, Any]] = (),
         change: Callable[[Any], Any] = abs, what: Any = None, **more: Any) -> str:
    """A verb of every kind of argument."""
    return "done"


@pytest.mark.parametrize("given", [
    {"eq": None}, {"number": 3}, {"number": 0.5}, {"number": Fraction(1, 2)}, {"number": Decimal(1)},
    {"number": np.float32(1)}, {"count": np.int8(3)}, {"count": 10**99}, {"name": "k3"}, {"why": True},
    {"why": np.True_}, {"pair": [1, 2]}, {"pair": np.zeros(2)}, {"row": range(3)},
    {"row": ImmutableMatrix([1, 2])}, {"row": np.zeros((3, 3))}, {"row": [object()]},
    {"verbs": (Symbol("x"),)}, {"values": {}}, {"values": None}, {"pairs": [(1, 2), [3, 4]]},
    {"change": int}, {"what": object()}, {"what": "text"}, {"other": b""}])
def test_what_is_of_the_kind_reaches_the_verb(given):
    """Numbers of any library, arrays as sequences; what is annotated as Any is not looked at."""
    assert verb(**given) == "done"


@pytest.mark.parametrize("given, message", [
    ({"eq": "E1"}, "the equilibrium is a str, not an Equilibrium or None: check the order and kind of the "
                   "arguments"),
    ({"eq": gs.Equilibrium}, "the equilibrium is a type, not an Equilibrium or None"),
    ({"number": "3"}, "number = '3' is a str, not a number"), ({"number": True}, "number = True is a bool"),
    ({"number": 1j}, "number = 1j is a complex, not a number"), ({"number": None}, "number = None is a None"),
    ({"count": 3.0}, "count = 3.0 is a float, not a whole number"),
    ({"count": False}, "count = False is a bool, not a whole number"),
    ({"name": b"k3"}, "name = b'k3' is a bytes, not a text"),
    ({"why": 1}, "why = 1 is an int, not True or False"),
    ({"pair": (1, 2, 3)}, "pair = (1, 2, 3) is a tuple, not 2 entries"),
    ({"pair": "12"}, "is a str, not 2 entries"),
    ({"row": "123"}, "row = '123' is a str, not several entries, (1, 2)"),
    *(({"row": x}, "not several entries") for x in (
        {"a": 1}, b"12", list, np.float64(1), np.array(1), {1, 2}, iter([1]))),
    ({"entries": (1, 2)}, "not a sequence in which each entry is a System"),
    ({"values": [("I1", 1)]}, 'values = [(\'I1\', 1)] is a list, not a mapping of names, {"I1": 1} or None'),
    *(({"pairs": x}, "not a sequence in which each entry is 2 entries") for x in (
        [1, 2], [(1, 2, 3)], ["ab"], np.zeros(2), [{1: 2, 3: 4}])),
    ({"row": range(10**9)}, "not at most 10000000 entries"), ({"values": {1: 2}}, "not a mapping of names"),
    ({"values": "I1=1"}, "not a mapping of names"), ({"change": 3}, "change = 3 is an int, not a function")])
def test_what_is_of_another_kind_is_refused(given, message):
    """With what was given, what is wanted, and what to do; by name and by position."""
    for call in (lambda: verb(**given), lambda: verb(*verb_defaults(given))):
        with pytest.raises(ArgumentError) as refused:
            call()
        assert message in str(refused.value) and len(str(refused.value)) <= 300


def verb_defaults(given):
    """The arguments by position, defaults before the one that is given."""
    code = verb.__wrapped__.__code__
    defaults = dict(zip(code.co_varnames, verb.__wrapped__.__defaults__)) | given
    return list(defaults.values())


def test_messages_are_short_whatever_is_given():
    """A value is quoted by its beginning, or by its kind where Python has no digits for it."""
    for value in ("x" * 10**6, ["x" * 1000] * 1000, 10**5000, [10**5000], object()):
        with pytest.raises(ArgumentError) as refused:
            verb(change=value)
        assert len(str(refused.value)) <= 300


@pytest.mark.parametrize("given", [[1, 2, 3], (1, 2, 3), np.arange(3), ImmutableMatrix([1, 2, 3]), range(3)])
def test_several_are_entries_of_anything_in_an_order(given):
    """Arrays and matrices are sequences."""
    assert several(given, "axis", 3) == tuple(given) and several(given, "axis") == tuple(given)


@pytest.mark.parametrize("given, message", [
    ("123", "axis is a str, not several entries: give 3 in brackets, (1, 2, 3)"),
    ([1, 2], "axis has 2 entries: give 3 in brackets, (1, 2, 3)"), (5, "axis is an int"),
    (None, "axis is a NoneType"), (range(10**9), "axis has 1000000000 entries"),
    (np.array(1.0), "axis is a"), (Integer(3), "axis is an")])
def test_how_many_is_asked_before_they_are_read(given, message):
    """Of a range of 10⁹ none is made."""
    with pytest.raises(ArgumentError, match="axis") as refused:
        several(given, "axis", 3)
    assert message in str(refused.value)
