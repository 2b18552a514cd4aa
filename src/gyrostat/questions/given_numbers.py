"""Reads numbers that are given by their names, exactly; the spin has one of its two names."""
from collections.abc import Collection, Mapping, Sequence
from typing import TypeVar

from sympy import Expr

from ..algebra.text.inputs import name_of, unknown_letter
from ..algebra.text.numbers import exact_number
from ..algebra.text.quantities import not_mixed
from ..errors import ValuesError, brief

SPINS = frozenset({"pi3_0", "omega3_0"})
Number = TypeVar("Number")


def numbers_of(settings: Sequence[str]) -> dict[str, Expr]:
    """The numbers of settings NAME=VALUE."""
    numbers: dict[str, Expr] = {}
    texts: dict[str, str] = {}
    for setting in settings:
        typed, equals, value = setting.partition("=")
        if not equals or "=" in value or value.endswith(",") or not (name := name_of(typed.strip())):
            raise ValuesError(f"the setting {brief(setting)[1:-1]} is not NAME=VALUE{unknown_letter(typed)}: "
                              "write, for example, I1=1.6 l=1/2")
        if name in numbers:
            raise ValuesError(f"{name} is given twice: give it once")
        numbers[name], texts[name] = exact_number(value, name), value
    not_mixed(texts.items())
    one_spin(numbers)
    return numbers


def one_spin(numbers: Mapping[str, object]) -> None:
    """Refuse both names of the spin."""
    if SPINS <= numbers.keys():
        raise ValuesError("both pi3_0 and omega3_0 = pi3_0/I3 are given: give one of them")


def spin_of(names: Mapping[str, object]) -> str:
    """The name of the spin of E1 and E2."""
    return "omega3_0" if "omega3_0" in names else "pi3_0"


def unless_given(numbers: Mapping[str, Number], names: Collection[str]) -> dict[str, Number]:
    """The numbers whose names are not given; if one name of the spin is given, neither of the two."""
    taken = {*names, *(SPINS if SPINS.intersection(names) else ())}
    return {name: number for name, number in numbers.items() if name not in taken}
