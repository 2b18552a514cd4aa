"""What decides for any body where the second variation is degenerate: elementary theorems, at numbers."""
from collections.abc import Callable, Mapping
from dataclasses import dataclass

from sympy import Expr, Symbol

from ..algebra.exact import sign
from ..kept import cached_property
from ..mechanics.equilibria import Equilibrium
from ..notation import symbol
from .amended import Amended
from .linearization import Linearization
from .sphere import extremum_at
from .torquefree import torque_free
from .values import names_in


@dataclass(frozen=True)
class Elementary:
    """The free body where no torque acts, else the amended potential to higher degree.

    Parameters
    ----------
    equilibrium : Equilibrium
    linearization : Linearization
    free : callable
        whether an equilibrium of a free body is stable, None if that is not proved, and why
    """

    equilibrium: Equilibrium
    linearization: Linearization
    free: Callable[[Equilibrium], tuple[bool | None, str]]

    @cached_property
    def _determinant(self) -> tuple[Expr, tuple[str, ...]]:
        """Of the linearised field, 0 where the second variation is degenerate; and the names in it."""
        determinant = self.equilibrium.insert(self.linearization.coefficients[-1])
        return determinant, names_in([determinant])

    def decide(self, numbers: Mapping[Symbol, Expr], margins: dict[Expr, Expr]) -> tuple[bool | None, str]:
        """Whether it is stable between the two criteria, None if that is not elementary; and why."""
        eq, (determinant, names) = self.equilibrium, self._determinant
        if missing := [name for name in names if symbol(name) not in numbers]:
            return None, f"the point lies between the two criteria; give {', '.join(missing)} to decide"
        if sign(determinant, numbers) != 0:
            return None, "the point lies between the two criteria"
        if eq.system.potential is None:
            found, why = extremum_at(eq, numbers)
            return (None if found is None else found != 0), why
        if torqueless := torque_free(eq, numbers):
            return torqueless.decide(self.free)
        return Amended(eq, numbers).decide()
