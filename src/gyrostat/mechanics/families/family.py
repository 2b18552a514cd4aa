"""The record of what is known of a named family of equilibria."""
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from ..scenes.kind import Kind

if TYPE_CHECKING:
    from ..equilibrium.equilibrium import Equilibrium
    from ..scenes.system import System

IN_A_FIELD = (Kind.REVOLUTION, Kind.FIELD, Kind.COUPLED)   # a field with a coupling is refused by its maker


@dataclass(frozen=True)
class Family:
    """What is known of a named family of equilibria.

    Parameters
    ----------
    label : str
        of its equilibria, Equilibrium.label
    name : str
        the word of the field
    title : str
        how it moves; "" if the label says so
    make : callable
        of a scene, and of what the family is made with
    source : str
        the paper, book or chapter that has the family; reports name it
    made_with : str
        the argument that its maker takes besides: "spin", "eliminate", "direction", "pointing", or "" for
        none
    pole : int
        1 if k points upwards, −1 if downwards, 0 at a tilt, and of a free body
    kinds : tuple of Kind
        of the scenes in which it may be asked for
    asked_for : str
        what the command line and published files call it; "" if it is only found
    """

    label: str
    name: str
    title: str
    make: Callable[..., "Equilibrium"]
    source: str
    made_with: str = ""
    pole: int = 0
    kinds: tuple[Kind, ...] = IN_A_FIELD
    asked_for: str = ""

    @property
    def tilted(self) -> bool:
        """Whether it lies at a tilt, with a relation from which a name may be eliminated."""
        return self.made_with == "eliminate"

    def of(self, scene: "System", spin: str = "pi3_0", eliminate: str | None = None,
           direction: Sequence[Any] | None = None, pointing: Sequence[int] | None = None) -> "Equilibrium":
        """Return the equilibrium of a scene, made with what its maker takes."""
        given = {"spin": spin, "eliminate": eliminate, "direction": direction, "pointing": pointing}
        return self.make(scene, given[self.made_with]) if self.made_with else self.make(scene)
