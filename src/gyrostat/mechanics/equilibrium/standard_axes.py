"""An equilibrium of a scene that was recognised as a body of revolution, in the standard scene, where its
axis is the third.
"""
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import TYPE_CHECKING

from sympy import Expr, ImmutableMatrix, S, sqrt

from ..._lazy import loaded
from ...algebra.reals.exact import Point, evaluate, sign_of_constant
from ...algebra.solving.margins import Signs
from ...errors import EquilibriumError
from ...notation import jet
from ..scenes.kind import Kind
from ..scenes.system import System, at_numbers, names_of_scene
from .derived_once import once
from .equilibrium import Equilibrium

if TYPE_CHECKING:
    from .recognition import Recognition, Vector


@dataclass(frozen=True)
class Seen:
    """An equilibrium of a scene that was recognised, in the standard axes."""

    recognition: "Recognition"
    equilibrium: Equilibrium
    where: str = ""

    @property
    def sentence(self) -> str:
        """What was recognised, and whether only at the numbers given."""
        return f"{self.where}{self.recognition.sentence}"

    def worded(self, reason: str) -> str:
        """What was recognised, and what follows, in the axes of the scene."""
        return f"{self.sentence}: {self.recognition.worded(reason)}"

    @property
    def modulo(self) -> tuple[Expr, ...]:
        """The flow that is divided out, at a tilt."""
        return () if self.equilibrium.at**2 == 1 else (self.recognition.modulo,)


@once
def seen(eq: Equilibrium) -> Seen | None:
    """A family of a scene that is not entered in the standard way, in the standard axes.

    None where it is not recognised.
    """
    if _plain(eq.system) or any(jet(name.name) for name, _ in eq.relations):
        return None
    return _turned(eq, [eq.insert(x) for x in eq.point])


def _plain(scene: System) -> bool:
    """Whether there is nothing to recognise: it is entered in the standard way.

    Or U is constant and π is fixed, whatever the axis.
    """
    return scene.kind is Kind.REVOLUTION or scene.coupled or len(scene.linear_integrals) == 3


def seen_at(eq: Equilibrium, numbers: Point) -> Seen | None:
    """The same, of a family that is recognised only at the numbers given."""
    if eq.system.kind is Kind.FREE or _plain(eq.system) or seen(eq):
        return None
    body = eq.system.body
    if not isinstance(body.inertia, ImmutableMatrix):
        moments = [evaluate(eq.insert(m), numbers) for m in body.moments]
        if all(not (a - b).free_symbols and sign_of_constant(a - b) for a, b in combinations(moments, 2)):
            return None                                    # proved different: no body of revolution
    here = placed(eq, numbers)
    if len(here.system.linear_integrals) == 3:
        return None
    return _turned(here, here.point, "at these numbers ")


def placed(eq: Equilibrium, numbers: Point) -> Equilibrium:
    """The point at numbers, of the scene at numbers."""
    known = {s: evaluate(eq.insert(s), numbers) for s in names_of_scene(eq.system)}
    relations = tuple((name, evaluate(eq.insert(value), numbers))
                      for name, value in eq.relations if jet(name.name))
    point = tuple(evaluate(eq.insert(x), numbers) for x in eq.point)
    return Equilibrium(eq.label, at_numbers(eq.system, known), point, relations)


def _turned(eq: Equilibrium, point: Sequence[Expr], where: str = "") -> Seen | None:
    """An equilibrium at a point of the scene, in the standard one and turned to k2 = 0.

    None where the scene is not recognised, or the point not proved to be one there.

    As k̇ = 0, ω = omega k with omega = ω·k; its relations and its domain hold as they do in the scene.
    """
    found: Recognition | None = loaded("mechanics.equilibrium.recognition:recognise")(eq.system)
    if not found:
        return None
    lowest = loaded("mechanics.scenes.functions_on_sphere:lowest")
    pi, k, moments = point[:3], point[3:], found.standard.body.moments
    k3, across = found.along(k), lowest(1 - found.along(k) ** 2)
    if loaded("mechanics.scenes.functions_on_sphere:vanishes")(across):
        place: Vector = (S.Zero, S.Zero, found.along(pi), S.Zero, S.Zero, S(sign_of_constant(k3)))
    elif across.free_symbols and not _inclined(across, eq):
        return None
    else:
        omega = lowest(ImmutableMatrix(k).dot(found.scene.body.inverse * ImmutableMatrix(pi)))
        k1 = sqrt(across)
        place = (moments[0] * omega * k1, S.Zero, moments[2] * omega * k3, k1, S.Zero, k3)
    relations = tuple(pair for pair in eq.relations if not jet(pair[0].name)
                      or found.standard.potential == eq.system.potential)
    try:
        turned = Equilibrium(eq.label, found.standard, place, relations, eq.domain, eq.eliminated)
    except EquilibriumError:
        return None
    return Seen(found, turned, where)


def _inclined(across: Expr, eq: Equilibrium) -> bool:
    """Whether 1 − k3², or its numerator, is positive on the whole family."""
    signs = Signs.over([across], eq.domain)
    return signs.of(signs.ring.numerator(across)) == 1
