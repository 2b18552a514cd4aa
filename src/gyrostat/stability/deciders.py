"""What decides between the two criteria: at numbers, and at the ends of what is solved for."""
from collections.abc import Iterable, Mapping
from typing import Protocol, runtime_checkable

from sympy import Expr, Symbol

from .decision import Decision


@runtime_checkable
class Ends(Protocol):
    """What says which ends of a set of values belong to it: Boundary, MomentumSphere."""

    def ladder(self, limit: int | None = None) -> Iterable[Expr]:
        """Where the margin vanishes: the end belongs to the set where the first that is not 0 is positive."""


class Between(Ends, Protocol):
    """What decides an equilibrium where its criteria do not, at numbers, and at the ends of what is solved
    for: Boundary, MomentumSphere.
    """

    def decide(self, numbers: Mapping[Symbol, Expr], margins: dict[Expr, Expr]) -> Decision:
        """The decision at exact numbers.

        The margins used are entered.
        """

    def expressions(self) -> Iterable[Expr]:
        """What may be asked for its sign; the first few of them, where they do not end."""
