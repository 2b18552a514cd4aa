"""Holds what is asked of a scene as texts, and makes the scene of the body and the field."""
from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

from sympy import Expr

from ..errors import ValuesError, brief
from ..mechanics.equilibrium.unit_vectors import direction_in
from ..mechanics.families.scene_tables import AXIAL, NONE, SceneTable
from ..mechanics.scenes.system import System

ROTOR = ("l1", "l2", "l3")
REPEATED = ("integrals", "rotors")                     # texts of an option that may be repeated
# the defaults of a file, which are those of a formula
BODY: dict[str, Any] = {"inertia": ["I1", "I2", "I3"], "gyrostatic_momentum": ["0", "0", "0"],
                        "potential": NONE}


@dataclass(frozen=True)
class Asked:
    """The texts that name a scene, and what is asked of its equilibria; None for what is not given.

    Parameters
    ----------
    potential : str or None
    inertia, gyrostatic_momentum : str or None
        three expressions, with , between them; of a tensor three rows of them, with ; between these
    point : str or None
        an expression for each coordinate
    spin, eliminate : str or None
        the name of the spin of E1 and E2; the name that the relation of E3 expresses
    direction : str or None
        of a permanent rotation: three expressions, or stereographic
    products : str or None
        the sign of the products of inertia: negative or positive
    rotors : tuple of str or None
        axis=… axial=… rate=… of each, in place of the gyrostatic momentum
    lumped : bool or None
        whether the inertia includes the rotors; None: it does
    orbit : str or None
        its rate, or height=…, period=…, mu=… radius=…
    pointing : str or None
        the body axes along roll, pitch and yaw
    integrals : tuple of str or None
        beside those that are found
    """

    potential: str | None = None
    inertia: str | None = None
    gyrostatic_momentum: str | None = None
    point: str | None = None
    spin: str | None = None
    eliminate: str | None = None
    direction: str | None = None
    orbit: str | None = None
    pointing: str | None = None
    integrals: tuple[str, ...] | None = None
    products: str | None = None
    rotors: tuple[str, ...] | None = None
    lumped: bool | None = None

    def of_body(self, names: Collection[str]) -> "Asked":
        """The same with a body; if none is given, the one to which the names belong.

        The moments are I1, I1, I3, or I1, I2, I3 if I2 is named, if U contains k1 or k2, without a field,
        and in orbit. The rotor is l along axis 3, in orbit along the axis of pitch; or l1, l2, l3 if one of
        them is named.
        """
        left_out = AXIAL if self.orbit is None else NONE
        potential = left_out if self.potential is None else self.potential
        inertia, momentum = self.inertia, self.gyrostatic_momentum
        if inertia is None:
            three = self.orbit is not None or _of_three(potential) or "I2" in names
            inertia = f"I1,{'I2' if three else 'I1'},I3"
        if self.rotors is not None and momentum is not None:
            raise ValuesError("wheels and the gyrostatic momentum are both given, and l is that of the "
                              "wheels: leave out one of the two")
        if momentum is None and self.rotors is None:
            rotor = [name for name in ROTOR if name in names]
            if rotor and "l" in names:
                raise ValuesError(f"both l and {rotor[0]} are given, and l is the rotor along axis 3: give "
                                  f"l, or {', '.join(ROTOR)}")
            axis = 3 if self.orbit is None else abs(pointing_of(self.pointing)[1])
            momentum = ",".join(ROTOR if rotor else ("l" if n == axis else "0" for n in (1, 2, 3)))
        return replace(self, potential=potential, inertia=inertia, gyrostatic_momentum=momentum)


@lru_cache(maxsize=64)
def scene_of(asked: Asked) -> System:
    """The scene of a body in a field."""
    return table_of(asked).system


def table_of(asked: Asked) -> SceneTable:
    """The table of a body in a field."""
    table: dict[str, Any] = {name: getattr(asked, name) for name in (
        "potential", "inertia", "products", "gyrostatic_momentum", "orbit", "pointing")}
    if asked.rotors is not None:
        table |= {"rotors": list(asked.rotors), "lumped": asked.lumped is not False}
    return SceneTable({**{name: x for name, x in table.items() if x is not None},
                       "integrals": list(asked.integrals or ())})


@lru_cache(maxsize=64)
def _of_three(potential: str) -> bool:
    """Whether the field is for a body of three moments: U contains k1 or k2, or there is none."""
    field = SceneTable({"potential": potential}).potential
    return field is None or not field.axial


def direction_of(asked: Asked) -> tuple[Expr, ...] | None:
    """The direction that is given; None if none is."""
    if asked.direction is None:
        return None
    return direction_in(SceneTable({"direction": asked.direction}).table["direction"])


def pointing_of(text: str | None) -> Sequence[int]:
    """The body axes along roll, pitch and yaw."""
    axes: Sequence[int] = SceneTable({"pointing": text or "1,2,3"}).table["pointing"]
    return axes


def one_for_each(what: str, text: str, scene: System) -> Sequence[str]:
    """The texts of a point or a state, one for each coordinate."""
    texts, names = text.split(","), [str(s) for s in scene.space.coordinates]
    if len(texts) != len(names):
        raise ValuesError(f"{what} {brief(text)[1:-1]} has {len(texts)} numbers, and the body has "
                          f"{len(names)} coordinates: give {','.join(names)}")
    return texts


def entries_of(scene: SceneTable) -> dict[str, Any]:
    """The entries with their defaults; rotors take the place of the gyrostatic momentum."""
    family = {} if scene.family is None else {"equilibrium": scene.family.asked_for}
    without = {"gyrostatic_momentum"} if "rotors" in scene.table else set[str]()
    return {**{name: x for name, x in BODY.items() if name not in without}, **scene.table, **family}


def asked_value(name: str, value: Any) -> Any:
    """A value of a table as Asked holds it."""
    if name == "lumped":
        return value
    return tuple(map(text_of, value)) if name in REPEATED else text_of(value)


def text_of(value: Any) -> str:
    """A value of a table as the text of an option; semicolons separate the rows of a tensor."""
    if isinstance(value, str | bool):
        return str(value)
    if isinstance(value, dict):
        return " ".join(f"{name}={text_of(text)}" for name, text in value.items())
    rows = [text_of(row) if isinstance(row, list) else str(row) for row in value]
    return (";" if any(isinstance(row, list) for row in value) else ",").join(rows)
