"""Holds a published formula, what its check found, and the numbers that show a misprint."""
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any

from sympy import Expr, Symbol

from .scenes import Scene

KINDS = ("identity", "family", "equilibrium", "solution", "condition", "number", "count", "statement")


@dataclass(frozen=True)
class Statement:
    """One formula or claim of a source, exactly as printed, in the library's symbols.

    Parameters
    ----------
    source, key : str
    where : str
        section and equation number or position
    quantity : str or list
        what the formula is about, as an expression in the names of the scene, or a claim
    printed : str or (nested) list
        the right-hand side, the condition, the verdict
    kind : str
        identity, family (an identity on the family of an equilibrium), equilibrium, solution (of the
        equations of motion), condition, number, count, statement
    note : str
    scene : Scene
    let : mapping
        the source's own abbreviations, as printed
    at : mapping
        values inserted on both sides
    given : str
        comparisons under which the claim is made
    constants : tuple of str
        those of a solution that is called general
    corrected : as printed, or None
        what a misprint should read; checked as if it were printed
    file : str
        where it was read

    Examples
    --------
    >>> import gyrostat as gs
    >>> statement = gs.published.load("VV2003").statements[0]
    >>> statement.source, statement.kind
    ('VV2003', 'equilibrium')
    """

    source: str
    key: str
    where: str
    quantity: Any = field(hash=False)        # a list has no hash
    printed: Any = field(hash=False)
    kind: str
    note: str = ""
    scene: Scene = field(default_factory=Scene, hash=False)
    let: Mapping[str, str] = field(default_factory=dict, hash=False)
    at: Mapping[str, str] = field(default_factory=dict, hash=False)
    given: str = ""
    constants: tuple[str, ...] = ()
    corrected: Any = field(default=None, hash=False)
    file: str = ""


@dataclass(frozen=True)
class Counterexample:
    """Numbers at which a claim fails.

    Parameters
    ----------
    values : tuple of (str, Expr)
    printed : Any
        what the claim says there
    derived : Any
        what is true
    confirmation : str
        what confirms that without either formula

    Examples
    --------
    >>> import gyrostat as gs
    >>> findings = {f.statement.key: f for f in gs.published.check(["AR"])}
    >>> counterexample = findings["2K-dot"].outcome.counterexample
    >>> counterexample.printed != counterexample.derived
    True
    """

    values: tuple[tuple[str, Expr], ...]
    printed: Any = field(hash=False)
    derived: Any = field(hash=False)
    confirmation: str


@dataclass(frozen=True)
class Outcome:
    """What a check found; agrees is None if nothing can be checked, or nothing decides.

    Parameters
    ----------
    agrees : bool or None
    printed, derived, difference : Any
    counterexample : Counterexample or None
        the claim fails there
    not_sharp : Counterexample or None
        a point that the claim leaves out; it does not fail there, so this is no counterexample
    corrected : Any
        what a misprint should read, None without one
    remark : str
        what is known if there are no such numbers
    route : str
        how a confirmed statement was derived and compared

    Examples
    --------
    >>> import gyrostat as gs
    >>> outcome = gs.published.check(["AR"])[0].outcome
    >>> outcome.agrees, outcome.counterexample
    (True, None)
    """

    agrees: bool | None
    printed: Any = field(default=None, hash=False)
    derived: Any = field(default=None, hash=False)
    difference: Any = field(default=None, hash=False)
    counterexample: Counterexample | None = None
    not_sharp: Counterexample | None = None
    corrected: Any = field(default=None, hash=False)
    remark: str = ""
    route: str = ""


@dataclass(frozen=True)
class Doubt:
    """A claim that is not confirmed, and the points at which it may be seen to fail; evidence decides.

    Parameters
    ----------
    points : iterable of mapping
        numbers by symbol, drawn when they are asked for
    printed, derived, difference : Any
    sides : tuple of Expr
        for a formula, both sides of the entry that differs, as the library reads them
    place : tuple of int or None
        that entry
    moving : mapping
        for a solution, what its functions put in place of the coordinates
    """

    points: Iterable[Mapping[Symbol, Expr]]
    printed: Any = field(default=None, hash=False)
    derived: Any = field(default=None, hash=False)
    difference: Any = field(default=None, hash=False)
    sides: tuple[Any, ...] = ()
    place: Any = None
    moving: Mapping[Symbol, Expr] = field(default_factory=dict)


@dataclass(frozen=True)
class Seen:
    """What a claim says at a point, and what is true there.

    `why` proves the latter; `refutes` tells whether the claim fails there, or only leaves the point out.
    """

    printed: Any
    derived: Any
    why: str
    refutes: bool


def entry_of(place: Any, derived: Any) -> str:
    """Return in words which entry of a vector or matrix a place is; "" if there are no entries."""
    return f"entry {', '.join(str(i + 1) for i in place[:derived.cols])}: " if place else ""


def as_text(printed: Any) -> str:
    """Return a text as it is, and a list of texts in brackets."""
    return printed if isinstance(printed, str) else "[" + ", ".join(map(as_text, printed)) + "]"
