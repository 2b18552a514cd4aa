"""What is asked of a scene: the texts of its options, and the body and the field that they name."""
import argparse
from collections.abc import Collection, Sequence
from dataclasses import dataclass, fields, replace
from functools import lru_cache

from sympy import Expr

from ...errors import ValuesError, brief
from ...mechanics.equilibrium.unit_vectors import direction_in
from ...mechanics.families.scene_tables import AXIAL, NONE, SceneTable
from ...mechanics.scenes.system import System
from ...stability.criteria.numbers_asked import names_in

ROTOR = ("l1", "l2", "l3")


@dataclass(frozen=True)
class Asked:
    """The texts that name a scene, and what of its equilibria is asked for; None where one is left out.

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
    orbit : str or None
        its rate, or mu=…,radius=…
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

    def of_body(self, names: Collection[str]) -> "Asked":
        """With a body, where none is given: that which the names belong to.

        I1, I3, or with I2, or k1 and k2 in U, or without a field I1, I2, I3; l, in orbit along the axis of
        pitch, or l1, l2, l3.
        """
        left_out = AXIAL if self.orbit is None else NONE
        potential = left_out if self.potential is None else self.potential
        inertia, momentum = self.inertia, self.gyrostatic_momentum
        if inertia is None:
            three = self.orbit is not None or _of_three(potential) or "I2" in names
            inertia = f"I1,{'I2' if three else 'I1'},I3"
        if momentum is None:
            rotor = [name for name in ROTOR if name in names]
            if rotor and "l" in names:
                raise ValuesError(f"both l and {rotor[0]} are given, l is the rotor along axis 3: give l, or "
                                  f"{', '.join(ROTOR)}")
            axis = 3 if self.orbit is None else abs(pointing_of(self.pointing)[1])
            momentum = ",".join(ROTOR if rotor else ("l" if n == axis else "0" for n in (1, 2, 3)))
        return replace(self, potential=potential, inertia=inertia, gyrostatic_momentum=momentum)


def asked_of(given: argparse.Namespace, names: Collection[str]) -> Asked:
    """What the options say, with the body that the names belong to."""
    texts = {entry.name: getattr(given, entry.name, None) for entry in fields(Asked)}
    if texts["integrals"] is not None:
        texts["integrals"] = tuple(texts["integrals"])
    return Asked(**texts).of_body(names)


@lru_cache(maxsize=64)
def scene_of(asked: Asked) -> System:
    """The scene of a body in a field."""
    rows = [row.split(",") for row in str(asked.inertia).split(";")]
    body = {"inertia": rows if len(rows) > 1 else rows[0],
            "gyrostatic_momentum": str(asked.gyrostatic_momentum).split(",")}
    orbit = {} if asked.orbit is None else {"orbit": asked.orbit}
    return SceneTable({"potential": asked.potential, **body, **orbit,
                       "integrals": list(asked.integrals or ())}).system


@lru_cache(maxsize=64)
def _of_three(potential: str) -> bool:
    """Whether it is a field of a body of three moments."""
    field = SceneTable({"potential": potential}).potential
    return field is None or not field.axial


def direction_of(asked: Asked) -> tuple[Expr, ...] | None:
    """The direction of --direction; None where it is left out."""
    if asked.direction is None:
        return None
    return direction_in(SceneTable({"direction": asked.direction}).table["direction"])


def pointing_of(text: str | None) -> Sequence[int]:
    """The body axes along roll, pitch and yaw."""
    axes: Sequence[int] = SceneTable({"pointing": text or "1,2,3"}).table["pointing"]
    return axes


def whole_scene(given: argparse.Namespace, names: Collection[str]) -> System:
    """The scene of a motion: every name in it has a number."""
    if given.potential is None and given.orbit is None:
        raise ValuesError('--potential is missing, and an unspecified U moves nothing: write --potential '
                          '"m0*k3", or none for a free body')
    scene = scene_of(asked_of(given, names))
    body, potential = scene.body, scene.potential
    if potential is not None and not potential.given:
        raise ValuesError(f'--potential is {potential.expression}, and an unspecified U moves nothing: write '
                          '--potential "m0*k3", or none for a free body')
    parameters = potential.parameters if potential else ()
    if missing := [name for name in names_in([*body.entries, *body.gyrostatic_momentum, *parameters])
                   if name not in names]:
        moments, momentum = (f"({', '.join(map(str, vector))})"
                             for vector in (body.entries, body.gyrostatic_momentum))
        raise ValuesError(f"--set gives no number for {', '.join(missing)}, and the body has the moments "
                          f"{moments}, the rotor {momentum}: "
                          f"add --set {' '.join(f'{name}=…' for name in missing)}")
    return scene


def one_for_each(option: str, text: str, scene: System) -> Sequence[str]:
    """The texts of a point or a state, one for each coordinate."""
    texts, names = text.split(","), [str(s) for s in scene.space.coordinates]
    if len(texts) != len(names):
        raise ValuesError(f"{option} {brief(text)[1:-1]} has {len(texts)} numbers, the body {len(names)} "
                          f"coordinates: give {','.join(names)}")
    return texts
