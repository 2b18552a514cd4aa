"""Parts of the branches of E1, E2 and E3 along a parameter.

Pieces of one verdict, marks between them, and what lies between marks.
"""
from dataclasses import dataclass

import numpy as np
from sympy import Expr

from ...algebra.enclosures.floats import Array
from ...stability.decision import Verdict

INFINITE = "U is infinite"


@dataclass(eq=False)
class Piece:
    """Part of a branch of one verdict.

    Parameters
    ----------
    label : str
        "E1", "E2" or "E3"
    parameter, k3 : arrays, shape (n,)
        n = 1: an isolated point
    verdict : Verdict
        exact, between its ends; of E3 modulo the spin
    """

    label: str
    parameter: Array
    k3: Array
    verdict: Verdict

    def extend(self, parameter: Array, k3: Array) -> None:
        """Go on from where it ends."""
        self.parameter, self.k3 = np.append(self.parameter, parameter[1:]), np.append(self.k3, k3[1:])


@dataclass(frozen=True)
class Mark:
    """A point where branches change.

    Parameters
    ----------
    kind : str
        a kind of BifurcationPoint, or INFINITE
    value, k3 : Expr
        exact
    changes : bool
        whether stability changes there; where U is infinite it may, with no equilibrium between
    """

    kind: str
    value: Expr
    k3: Expr
    changes: bool


@dataclass(frozen=True)
class Span:
    """What lies between two neighbouring stations.

    Verdicts of the tilts from below, and of E1 (1) and E2 (−1).
    """

    low: Expr
    high: Expr
    tilts: tuple[Verdict, ...]
    poles: dict[int, Verdict]
