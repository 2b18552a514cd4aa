"""The verdict, the rung that decided it, and the decision that holds both together with the reason."""
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from enum import Enum
from functools import lru_cache
from typing import Any, NoReturn

from sympy import Expr

from .._display import Shown
from ..errors import ArgumentError, require
from ..notation import Stored, symbol
from .notion import Notion

C1 = symbol("C1")                                          # M·k, where a proof holds on its level alone


class Verdict(Enum):
    """The answer to a question of stability; each value says what the answer means.

    A verdict is equal to the text of its name. It is neither true nor false: bool(verdict) raises an
    ArgumentError, and so does the comparison with a text that names no verdict.

    Examples
    --------
    >>> import gyrostat as gs
    >>> [verdict.name for verdict in gs.Verdict]
    ['STABLE', 'UNSTABLE', 'UNDECIDED']
    >>> gs.Verdict.STABLE == "STABLE", gs.Verdict.UNSTABLE == "STABLE"
    (True, False)
    """

    STABLE = "a sufficient condition for stability is proved to hold"
    UNSTABLE = "a necessary condition for stability is proved to fail"
    UNDECIDED = "neither a sufficient condition is proved to hold nor a necessary one to fail"

    @classmethod
    def of(cls, stable: bool | None) -> "Verdict":
        """Return the verdict for something that is stable, unstable, or neither proved.

        Parameters
        ----------
        stable : bool or None
            None if neither is proved

        Returns
        -------
        Verdict

        Raises
        ------
        ArgumentError
            it is neither true, false nor None
        """
        if stable is None:
            return cls.UNDECIDED
        require(stable, bool, "stable")
        return cls.STABLE if stable else cls.UNSTABLE

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, str):
            return self is other
        if other not in Verdict.__members__:
            raise ArgumentError(f"{other!r} is the name of no verdict: compare with "
                                f"{', '.join(map(repr, Verdict.__members__))}")
        return self.name == other

    def __hash__(self) -> int:
        return hash(self.name)

    def __bool__(self) -> NoReturn:
        raise ArgumentError(f"the verdict {self.name} is neither true nor false: write "
                            "verdict == 'STABLE', or ask decision.stable")


class Rung(Enum):
    """The step of the ladder of criteria and theorems that decided an equilibrium, the first that could.

    Each value is the name that charts and JSON write.

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> report = gs.analyze(gs.upright(top))
    >>> report.verdict({"I1": 1, "l": 0, "m0": 1, "pi3_0": 2}).rung
    <Rung.REDUCED_MOTION: 'reduced motion'>
    """

    NOTHING = "nothing"                                    # it is undecided
    SECOND_VARIATION = "second variation"                  # it is definite (Lagrange, Dirichlet; Arnold)
    SPECTRUM = "spectrum"                                  # an eigenvalue has a positive real part
    TWIST_POSITIVE = "D4 > 0"                              # Arnold's determinant; no resonance to order 4
    TWIST_NEGATIVE = "D4 < 0"
    SIXTH_ORDER = "D6"                                     # the same, where D4 = 0
    RESONANCE = "resonance"                                # 1:1, 1:2 or 1:3 (Sokolskii, Markeev)
    INTEGRAL = "integral"                                  # h + Σ α F is definite, F given integrals
    REDUCED_MOTION = "reduced motion"                      # that of the tilt of a body of revolution
    FOURTH_ORDER = "fourth order"                          # that of the energy on the momentum sphere
    LEADING_FORM = "leading form"                          # of the amended potential, its degree 3 or more
    LEAST_ON_SET = "least on a set"                        # the energy is, on a closed curve of equilibria
    NO_TORQUE = "no torque"                                # the momentum is fixed in space
    DRIFT = "drift"                                        # equilibria nearby move along its orbit
    WHOLE_ORBIT = "whole orbit"                            # nothing moves on its orbit
    NEGATIVE_SQUARES = "negative squares"                  # of the energy, and the body has damping inside
    TWIST = "D4"                                           # it is not 0 along an arc, except at single points

    @property
    def by_condition(self) -> bool:
        """Whether a sufficient condition that is printed holds there, or a necessary one fails."""
        return self in (Rung.SECOND_VARIATION, Rung.SPECTRUM, Rung.INTEGRAL, Rung.NEGATIVE_SQUARES)


class Judged:
    """The base of what has a verdict: stable, unstable, or neither, but neither true nor false."""

    verdict: Verdict

    @property
    def stable(self) -> bool:
        """Whether it is proved to be stable."""
        return self.verdict is Verdict.STABLE

    @property
    def unstable(self) -> bool:
        """Whether it is proved to be unstable."""
        return self.verdict is Verdict.UNSTABLE

    def __bool__(self) -> NoReturn:
        raise ArgumentError(f"a decision, here {self.verdict.name}, is neither true nor false: ask "
                            "decision.stable or decision.unstable")


@dataclass(frozen=True, repr=False)
class Decision(Judged, Shown, Stored):
    """A verdict with the notion of stability, the reason, and everything that it holds for.

    A decision is neither true nor false: bool(decision) raises an ArgumentError.

    Parameters
    ----------
    verdict : Verdict
    rung : Rung
        what decided
    reason : str
        the proof in a sentence, or what is missing for one
    notion : Notion
        the notion that is proved (LYAPUNOV) or violated (SPECTRAL); NOTHING if undecided
    modulo : tuple of Expr
        integrals whose flow is divided out; for a spin about the axis, (pi3,)
    level : tuple of Expr
        Casimirs or integrals whose values have to be kept: the proof is for motions on that level alone
    locus : str
        the set of equilibria that is stable as a whole, if the point by itself is not proved to be; "" if the
        decision is about the point
    margins : tuple of (margin, value)
        exact values of the margins that were used
    note : str
        what is unusual about the numbers, if anything
    growing : int or None
        under internal damping, the number of growing modes; None if it is not asked for, or not proved
    names : tuple of str
        the source of each margin: p, q, p² − 4q, t, s or a minor, "" if it has none; () if the scene has
        integrals
    pointwise : bool
        whether the decision is for these numbers alone, as one by a normal form: at other numbers at which
        the margins have the same signs it may be another
    certificate : tuple of (integral, rational)
        F and α of Σ α F, if integrals that were given decide: the second variation of h + Σ α F is definite
        on the orbit

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> report = gs.analyze(gs.upright(top))
    >>> decision = report.verdict({"I1": 1, "l": 0, "m0": 1, "pi3_0": 3})
    >>> decision.verdict.name, decision.notion
    ('STABLE', <Notion.LYAPUNOV: 'Lyapunov'>)
    >>> decision.margins
    ((-4*I1*m0 + l**2 + 2*l*pi3_0 + pi3_0**2, 5),)
    >>> decision.stable, decision.unstable, decision.scope
    (True, False, '')
    """

    verdict: Verdict
    rung: Rung
    reason: str
    notion: Notion = Notion.NOTHING
    modulo: tuple[Expr, ...] = ()
    level: tuple[Expr, ...] = ()
    locus: str = ""
    margins: tuple[tuple[Expr, Expr], ...] = ()
    note: str = ""
    growing: int | None = None
    names: tuple[str, ...] = ()
    pointwise: bool = False
    certificate: tuple[tuple[Expr, Expr], ...] = ()

    @property
    def scope(self) -> str:
        """What the name of the verdict does not say, in words; "" if it is about the point itself.

        It names the flows that are divided out, the level on which the proof holds, and the set that is
        stable as a whole.
        """
        parts = [f"modulo the flow of {_listed(self.modulo)}"] if self.modulo else []
        parts += [f"on its level of {_listed(self.level)}"] if self.level else []
        return ", ".join([*parts, *([f"as a set, {self.locus}"] if self.locus else [])])

    @property
    def proved(self) -> str:
        """What is proved, as a sentence without its full stop.

        It says that one of the two conditions decides, or that a theorem does where both are silent.
        """
        if self.verdict is Verdict.UNDECIDED or self.rung.by_condition:
            return self.verdict.value
        conditions = "condition does" if self.notion == Notion.SECULAR else "two conditions do"
        return f"the {conditions} not decide, a theorem does"


def with_margins(found: Decision, margins: Mapping[Expr, Expr], note: str,
                 names: tuple[str, ...]) -> Decision:
    """Return a decision with the margins that were used, the source of each, and a note on the scene."""
    decision = object.__new__(Decision)
    decision.__dict__.update(found.__dict__, margins=tuple(margins.items()), note=note, names=names)
    return decision


def settled(stable: bool, why: str, rung: Rung, notion: Notion = Notion.LYAPUNOV, **more: Any) -> Decision:
    """Return the decision that stability, or instability, is proved: by a rung, and in which notion."""
    return Decision(Verdict.of(stable), rung, why, notion, **more)


@lru_cache(maxsize=256)                                    # lines of a batch want the same names
def undecided(why: str) -> Decision:
    """Return the decision that nothing is proved, and why."""
    return Decision(Verdict.UNDECIDED, Rung.NOTHING, why)


def _listed(expressions: Iterable[Expr]) -> str:
    return ", ".join(map(str, expressions))
