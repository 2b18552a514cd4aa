"""The axis of a chart or a picture: NAME=LOW:HIGH:COUNT."""
from sympy import Expr

from ...algebra.text.inputs import name_of, unknown_letter
from ...algebra.text.numbers import exact_number
from ...algebra.text.tensors import rows_of
from ...errors import ValuesError, brief

LONGEST = 10**7                                        # values of an axis, rows of a table


def ends_of(text: str) -> list[str]:
    """The texts of both ends of an axis; a unit after the second alone is that of both."""
    return [str(end) for end in rows_of(",".join(text.partition("=")[2].split(":")[:2]))]


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
    low, high = (exact_number(end, name) for end in ends_of(text))
    return name, low, high, int(ends[2]) if ends[2:] else count
