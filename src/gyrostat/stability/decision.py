"""A verdict, the decision that gives its notion and reason, and the interface of what decides."""
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from enum import Enum
from typing import NamedTuple, Protocol

from sympy import Expr, Symbol

from ..notation import Stored
from ..shown import Shown


class Verdict(Enum):
    """What is known of an equilibrium; each value says what the answer means.

    Examples
    --------
    >>> import gyrostat as gs
    >>> [verdict.name for verdict in gs.Verdict]
    ['STABLE', 'UNSTABLE', 'UNDECIDED']
    """

    STABLE = "a sufficient condition for stability is proved to hold"
    UNSTABLE = "a necessary condition for stability is proved to fail"
    UNDECIDED = "neither a sufficient condition is proved to hold nor a necessary one to fail"

    @classmethod
    def of(cls, stable: bool | None) -> "Verdict":
        """What it is called that something is stable, unstable, or neither proved.

        Parameters
        ----------
        stable : bool or None

        Returns
        -------
        Verdict
        """
        if stable is None:
            return cls.UNDECIDED
        return cls.STABLE if stable else cls.UNSTABLE


@dataclass(frozen=True, repr=False)
class Decision(Shown, Stored):
    """A verdict at given numbers, with its reason.

    Parameters
    ----------
    verdict : Verdict
    notion : str
        the notion that is proved ("Lyapunov") or violated ("spectral"); "" if undecided
    modulo : tuple of Expr
        integrals whose flow is divided out; for a spin about the axis, (pi3,)
    reason : str
    margins : tuple of (margin, value)
        exact values of the margins that were used
    note : str
        what is unusual about the numbers, if anything
    growing : int or None
        under internal damping, the number of growing modes; None where it is not asked for, or not proved
    names : tuple of str
        where there are no integrals, what each margin is of: p, q, p² − 4q, t, s or a minor; "" if none
    pointwise : bool
        decided by a normal form: at other numbers where the margins have these signs it may be another
    certificate : tuple of (integral, rational)
        F and α of Σ α F, where integrals that were given decide: the second variation of h + Σ α F is
        definite on the orbit
    rung : str
        what decided: "second variation", "spectrum", "integral", "resonance", "D4 > 0", "D4 < 0", "D6"; ""
        where that is another, on the boundary, or nothing

    Examples
    --------
    >>> import gyrostat as gs
    >>> report = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())))
    >>> decision = report.verdict({"I1": 1, "l": 0, "m0": 1, "pi3_0": 3})
    >>> decision.verdict.name, decision.notion, decision.margins
    ('STABLE', 'Lyapunov', ((-4*I1*m0 + l**2 + 2*l*pi3_0 + pi3_0**2, 5),))
    """

    verdict: Verdict
    notion: str
    modulo: tuple[Expr, ...]
    reason: str
    margins: tuple[tuple[Expr, Expr], ...]
    note: str = ""
    growing: int | None = None
    names: tuple[str, ...] = ()
    pointwise: bool = False
    certificate: tuple[tuple[Expr, Expr], ...] = ()
    rung: str = ""


class Finding(NamedTuple):
    """Whether an equilibrium is stable, None if that is not proved; the notion, "" then; why; and where.

    With the certificate of integrals, and what decided.
    """

    stable: bool | None
    notion: str
    why: str
    pointwise: bool = False
    certificate: tuple[tuple[Expr, Expr], ...] = ()
    rung: str = ""


def settled(stable: bool | None, why: str, notion: str = "Lyapunov", pointwise: bool = False,
            rung: str = "") -> Finding:
    """What is proved, of a notion."""
    return Finding(stable, "" if stable is None else notion, why, pointwise, (),
                   "" if stable is None else rung)


class Decider(Protocol):
    """What decides an equilibrium where its criteria do not: Boundary, MomentumSphere, Drift."""

    def decide(self, numbers: Mapping[Symbol, Expr], margins: dict[Expr, Expr]) -> tuple[bool | None, str]:
        """Whether it is stable at exact numbers, None if that is not proved, and why.

        The margins used are entered.
        """


class Ends(Protocol):
    """What says which ends of a set of values belong to it: Boundary, MomentumSphere."""

    def ladder(self, limit: int | None = None) -> Iterable[Expr]:
        """Where the margin vanishes: the end belongs to the set where the first that is not 0 is positive."""


class Between(Decider, Ends, Protocol):
    """What decides between the two criteria at numbers, and at the ends of what is solved for."""
