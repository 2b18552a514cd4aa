"""The interfaces of what decides between the two criteria: at numbers, and at the ends of a set of values."""
from collections.abc import Iterable, Mapping
from typing import Protocol, runtime_checkable

from sympy import Expr, Symbol

from .decision import Decision


@runtime_checkable
class Ends(Protocol):
    """The interface of what says which ends of a set of values belong to it: Boundary, MomentumSphere."""

    def ladder(self, limit: int | None = None) -> Iterable[Expr]:
        """Yield margins in turn: the end belongs to the set if the first that is not 0 is positive."""


class Between(Ends, Protocol):
    """The interface of what decides an equilibrium if its criteria do not: Boundary, MomentumSphere.

    It decides at numbers, and at the ends of a set of values that is solved for.
    """

    def decide(self, numbers: Mapping[Symbol, Expr], margins: dict[Expr, Expr]) -> Decision:
        """Return the decision at exact numbers.

        The margins that were used are entered into the second argument.
        """

    def expressions(self) -> Iterable[Expr]:
        """Yield what may be asked for its sign; the first few of them, if they do not end."""
