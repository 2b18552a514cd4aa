"""Conditions in names that are defined in turn: what they stand for at numbers, and in any arithmetic.

Written out, long conditions could not be read. closed_form has the names of permanent rotations, and
sextic_in_names those of bodies at rest in the frame of two directions.
"""
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from flint import fmpq
from sympy import Expr, Symbol

from ..._cached import cached_property
from ...algebra.enclosures.rationals import to_sympy
from ...algebra.reals.exact import Point, compiled, evaluate
from ...mechanics.equilibrium.equilibrium import Equilibrium, Relation
from ...mechanics.scenes.system import names_of_scene
from ...notation import Stored, symbol
from ...registry import Letters
from ..notion import Notion
from .conditions import Criterion
from .numbers_asked import names_in

SHORT = 25                                                 # terms with which margins are written out


class Chosen:
    """Chooses the names in which the conditions of an equilibrium are written.

    If the scene, or the point, has one of them already, another one takes its place.
    """

    def __init__(self, eq: Equilibrium):
        found = (*eq.point, *(value for _, value in eq.relations))
        self._letters = Letters({s.name for s in names_of_scene(eq.system).union(
            *(x.free_symbols for x in found))})

    def of(self, *names: str) -> tuple[Symbol, ...]:
        """Return a symbol for each name."""
        return tuple(symbol(self._letters.of(name)) for name in names)

    def symmetric(self, name: str) -> list[list[Symbol]]:
        """Return the entries K11, K12, … of a symmetric matrix by a name."""
        return [list(self.of(*(f"{name}{min(i, j)}{max(i, j)}" for j in (1, 2, 3)))) for i in (1, 2, 3)]


@dataclass(frozen=True)
class DefinedNames(Stored, ABC):
    """What decides an equilibrium, by names that are defined in turn.

    Parameters
    ----------
    equilibrium : Equilibrium
    """

    equilibrium: Equilibrium

    @property
    @abstractmethod
    def named(self) -> Any:
        """The names in which the conditions are written."""

    @property
    @abstractmethod
    def definitions(self) -> tuple[Relation, ...]:
        """Each name with its definition, by names of the family and those before it."""

    @property
    @abstractmethod
    def margins(self) -> list[Expr]:
        """The margins of all conditions in the names of the family."""

    @property
    @abstractmethod
    def determinant(self) -> Expr:
        """What vanishes if and only if the second variation is degenerate, in the names of the family."""

    @property
    @abstractmethod
    def polynomial(self) -> Expr:
        """The characteristic polynomial in lamda, in these names."""

    @property
    @abstractmethod
    def blocks(self) -> list[tuple[Expr, ...]]:
        """The elementary symmetric functions e1, …, em of the eigenvalues of each block of the form."""

    @abstractmethod
    def criterion(self, notion: Notion) -> Criterion:
        """Return the spectral, formal or secular criterion in these names."""

    @property
    @abstractmethod
    def _flat(self) -> list[Expr]:
        """The data of the family from which all is computed."""

    @abstractmethod
    def _computed(self, flat: Sequence[Any]) -> Iterator[tuple[Symbol, Any]]:
        """Yield the names in the conditions with their values, by the data in any arithmetic."""

    @cached_property
    def required(self) -> tuple[str, ...]:
        """The names that a verdict needs."""
        eq = self.equilibrium
        return names_in([*self._flat, *eq.existence(), *eq.constraints, *eq.point[3:]])

    def at(self, numbers: Point) -> dict[Symbol, Expr]:
        """Return the names with their exact values, without inserting the definitions into each other."""
        try:
            entries, places = self._program or ([], [])
            known = [_value(entry, numbers) for entry in entries]
        except KeyError:                                   # a number that is not rational
            places = []
        if not places:
            return dict(self._computed([evaluate(e, numbers) for e in self._flat]))
        return {name: to_sympy(fmpq(x)) for name, x in self._computed([known[n] for n in places])}

    def with_names(self, numbers: Point) -> Point:
        """Return numbers with those of the names besides in which the conditions are written."""
        return numbers.joined(self.at(numbers).items())

    def values(self, number: Callable[[Expr], Any]) -> dict[Symbol, Any]:
        """Return the names with their values, if number gives expressions of the family in an arithmetic."""
        return dict(self._computed([number(e) for e in self._flat]))

    @cached_property
    def _program(self) -> tuple[list[Any], list[int]] | None:
        """The different data, compiled, and the place of each; None if one is no fraction."""
        entries = list(dict.fromkeys(self._flat))
        program = list(map(compiled, entries))
        return None if None in program else (program, [entries.index(e) for e in self._flat])


def _value(entry: Any, numbers: Point) -> fmpq:
    """Return the value of a compiled fraction at numbers; KeyError if one of them is not rational."""
    symbols, top, bottom = entry
    point = [numbers.rational[s] for s in symbols]
    return top(*point) if bottom is None else top(*point) / bottom(*point)
