"""What options name: exact numbers, and the axis of a chart or a picture."""
from collections.abc import Collection, Mapping, Sequence
from typing import TypeVar

from sympy import Expr

from ...algebra.text.inputs import name_of, unknown_letter
from ...algebra.text.numbers import exact_number
from ...algebra.text.quantities import not_mixed
from ...errors import ValuesError, brief

SPINS = frozenset({"pi3_0", "omega3_0"})
Number = TypeVar("Number")
LONGEST = 10**7                                        # values of an axis, rows of a table


def numbers_of(settings: Sequence[str]) -> dict[str, Expr]:
    """The numbers of --set NAME=VALUE."""
    numbers: dict[str, Expr] = {}
    texts: dict[str, str] = {}
    for setting in settings:
        typed, equals, value = setting.partition("=")
        if not equals or "=" in value or value.endswith(",") or not (name := name_of(typed.strip())):
            raise ValuesError(f"--set {brief(setting)[1:-1]} is not NAME=VALUE{unknown_letter(typed)}: "
                              "write, for example, --set I1=1.6 l=1/2")
        if name in numbers:
            raise ValuesError(f"--set gives {name} twice: give it once")
        numbers[name], texts[name] = exact_number(value, name), value
    not_mixed(texts.items())
    one_spin(numbers)
    return numbers


def one_spin(numbers: Mapping[str, object]) -> None:
    """Refuse both names of the spin."""
    if SPINS <= numbers.keys():
        raise ValuesError("both pi3_0 and omega3_0 = pi3_0/I3 are given: give one of them")


def axis_of(option: str, text: str, form: str = "NAME=LOW:HIGH:COUNT",
            count: int = 0) -> tuple[str, Expr, Expr, int]:
    """Name, ends and number of values of an axis.

    Its COUNT may be left out where the form has it in brackets.
    """
    typed, equals, values = text.partition("=")
    name, ends = name_of(typed.strip()), [value.strip() for value in values.split(":")]
    if not equals or not name or len(ends) not in {form.count(":") + 1, 2 if "[" in form else 0}:
        raise ValuesError(f"{option} {brief(text)} is not {form}{unknown_letter(typed)}: write, "
                          f"for example, {option} l=-2:2{':400' if 'COUNT' in form else ''}")
    if ends[2:] and (not ends[2].isdecimal() or len(ends[2]) > 20 or not 2 <= int(ends[2]) <= LONGEST):
        raise ValuesError(f"{option} has the COUNT {brief(ends[2])[1:-1]}: give a whole number, 2 to "
                          f"{LONGEST}; one value goes to --set")
    low, high = (exact_number(end, name) for end in ends[:2])
    return name, low, high, int(ends[2]) if ends[2:] else count


def spin_of(names: Mapping[str, object]) -> str:
    """The name of the spin of E1 and E2."""
    return "omega3_0" if "omega3_0" in names else "pi3_0"


def unless_given(numbers: Mapping[str, Number], names: Collection[str]) -> dict[str, Number]:
    """The numbers of other names; where one name of the spin is given, neither."""
    taken = {*names, *(SPINS if SPINS.intersection(names) else ())}
    return {name: number for name, number in numbers.items() if name not in taken}
