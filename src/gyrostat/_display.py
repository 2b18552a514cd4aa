"""Says how what is derived shows itself: typeset in Jupyter, in Unicode as text."""
from collections.abc import Callable
from typing import Any, ClassVar


class Shown:
    """What Jupyter shows typeset and what prints as a person reads it.

    The package root says how, since printing stands above this module.
    """

    formula: ClassVar[Callable[[Any], str]]                # in LaTeX
    plain: ClassVar[Callable[[Any], str]]                  # in Unicode

    def _repr_latex_(self) -> str:
        return rf"$\displaystyle {Shown.formula(self)}$"

    def __str__(self) -> str:
        return Shown.plain(self)

    def __repr__(self) -> str:
        return str(self)
