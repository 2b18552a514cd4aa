"""Reads the texts of a statement, in the names of its scene and its own abbreviations."""
from collections import ChainMap
from collections.abc import Iterable, Iterator, Mapping
from functools import partial
from typing import Any

from sympy import Expr, MatrixBase, Symbol

from ..._cached import cached_property
from ...algebra.text.spelling import names_in
from ...errors import PublishedError
from ...notation import symbol
from ..independent import names_at_numbers
from ..language import part_of, read
from ..names.derived_names import Names, names
from ..names.kinematics import Later
from ..scenes import DERIVED
from ..statements import Statement
from .comparisons import comparisons
from .criteria import Claim
from .sampling import points


class Reading:
    """A statement with its texts read."""

    def __init__(self, statement: Statement):
        self.statement, self.scene = statement, statement.scene
        bare = names(self.scene, {})
        self.at: dict[Symbol, Expr] = {}
        for name, text in statement.at.items():
            if name not in bare or not isinstance(bare[name], Symbol) and self.scene.equilibrium is None:
                raise PublishedError(f"at gives {name}, which is no parameter of the scene: its names are "
                                     f"{', '.join(sorted(bare))}")
            value = self.at[symbol(name)] = read(text, bare)
            if symbol(name).is_positive and value.is_positive is False:
                raise PublishedError(f"at gives {name} = {value}: moments of inertia are positive")
        for name, value in self.at.items():
            for other in sorted((value.free_symbols & self.at.keys()) - {name}, key=str):
                raise PublishedError(f"at gives {name} by {other}, and {other} too: write {name} with the "
                                     f"value of {other} in it")
        # where a formula differentiates, a coordinate gets its value afterwards, from finish
        moving = () if self.scene.equilibrium else self.scene.system.space.coordinates
        fixed = {name: value for name, value in self.at.items() if name not in moving}
        self.names = names(self.scene, fixed) if fixed else bare
        self._check_letters()
        self.own = _with_let(self.names, statement.let)
        given = [text for text in (self.scene.table.get("given", ""), statement.given) if text]
        conditions = [condition for text in given for condition in comparisons(text, self.names)]
        if not all(strict for _, strict in conditions):
            raise PublishedError(f"given = {'; '.join(given)}: equality is a case of its own, write > or <")
        self.given = tuple(margin for margin, _ in conditions)

    def _check_letters(self) -> None:
        """Refuse a quantity with a name that is a letter of the paper and a derived quantity as well."""
        if self.statement.kind not in ("identity", "family", "number"):
            return
        taken = [name for name in sorted(names_in(str(self.statement.quantity)))
                 if DERIVED + name in self.names and name not in self.statement.let]
        if taken:
            name = taken[0]
            raise PublishedError(f"quantity has {name}, a letter of the scene and a name of what is derived: "
                                 f"say which by let, let = {{ {name} = \"{name}\" }} for the letter of the "
                                 f"scene, let = {{ {name} = \"{DERIVED}{name}\" }} for what is derived")

    def finish(self, expression: Any) -> Any:
        """Return an expression on the family, with the values of at inserted."""
        return self.scene.finish(expression).xreplace(self.at)

    @cached_property
    def claim(self) -> Claim:
        """The scene where the claim is made."""
        return Claim(self.scene, tuple(map(self.finish, self.given)), self.at)

    def points(self, expressions: Iterable[Expr]) -> Iterator[dict[Symbol, Expr]]:
        """Yield rational points of the scene; a claim of existence is tried outside the domain too."""
        return points(self.scene, [*expressions, *self.mentioned], self.given, self.at,
                      self.statement.quantity != "existence")

    @cached_property
    def mentioned(self) -> set[Symbol]:
        """Every symbol behind the names in the texts, also those that cancel.

        A name that an abbreviation hides does not count.
        """
        s = self.statement
        found = names_in(str([s.given, self.scene.table.get("given", ""), s.at]))
        own = list(s.let)
        for n, text in enumerate([*s.let.values(), str([s.printed, s.quantity])]):
            found |= names_in(text) - set(own[:n])
        values = [self.names[name] for name in found if name in self.names]
        return {x for value in values if isinstance(value, (Expr, MatrixBase))
                for x in self.finish(value).free_symbols}

    def independently(self, text: Any, values: Mapping[Symbol, Expr]) -> Any:
        """Return a quantity at numbers, from Newton and Euler's equations."""
        return read(text, self.independent(values))

    def independent(self, values: Mapping[Symbol, Expr]) -> Mapping[str, Any]:
        """Return what the names and abbreviations stand for at numbers, by Newton and Euler's equations."""
        return _with_let(self.without_let(values), self.statement.let)

    def without_let(self, values: Mapping[Symbol, Expr]) -> Mapping[str, Any]:
        """Return the same without the abbreviations, which `given` and `at` do not read."""
        return names_at_numbers.names(self.scene, values)


def _with_let(scene_names: Mapping[str, Any], let: Mapping[str, str]) -> Mapping[str, Any]:
    """Return the names of a scene behind the abbreviations, each of which may use those before it."""
    layered = scene_names
    for name, text in let.items():
        read_later = Later(partial(part_of, text, layered))
        layered = Names(ChainMap({name: read_later}, layered), {})  # type: ignore[arg-type]
    return layered
