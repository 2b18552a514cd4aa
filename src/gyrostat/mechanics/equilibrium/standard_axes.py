"""Turns an equilibrium of a recognised body of revolution into the standard scene, its axis the third."""
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
        """The sentence that says what was recognised, and whether only at the numbers given."""
        return f"{self.where}{self.recognition.sentence}"

    def worded(self, reason: str) -> str:
        """Return what was recognised, and what follows, in the axes of the scene."""
        return f"{self.sentence}: {self.recognition.worded(reason)}"

    @property
    def modulo(self) -> tuple[Expr, ...]:
        """The integral whose flow is divided out, at a tilt; none at a pole."""
        return () if self.equilibrium.at**2 == 1 else (self.recognition.modulo,)


@once
def seen(eq: Equilibrium) -> Seen | None:
    """Return a family of a scene that is not entered in the standard way, in the standard axes.

    None if the scene is not recognised.
    """
    if _plain(eq.system) or any(jet(name.name) for name, _ in eq.relations):
        return None
    return _turned(eq, [eq.insert(x) for x in eq.point])


def _plain(scene: System) -> bool:
    """Tell whether there is nothing to recognise.

    The scene is entered in the standard way, or U is constant and π is fixed, whatever the axis.
    """
    return scene.kind is Kind.REVOLUTION or scene.coupled or len(scene.linear_integrals) == 3


def seen_at(eq: Equilibrium, numbers: Point) -> Seen | None:
    """Return a family in the standard axes if its scene is recognised only at given numbers, else None."""
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
    """Return the equilibrium at numbers, in the scene at numbers."""
    known = {s: evaluate(eq.insert(s), numbers) for s in names_of_scene(eq.system)}
    relations = tuple((name, evaluate(eq.insert(value), numbers))
                      for name, value in eq.relations if jet(name.name))
    point = tuple(evaluate(eq.insert(x), numbers) for x in eq.point)
    return Equilibrium(eq.label, at_numbers(eq.system, known), point, relations)


def _turned(eq: Equilibrium, point: Sequence[Expr], where: str = "") -> Seen | None:
    """Return an equilibrium at a point of the scene, in the standard scene and turned to k2 = 0.

    None if the scene is not recognised, or the point is not proved to be an equilibrium there. Since k̇ = 0,
    ω = omega k with omega = ω·k; its relations and its domain hold as they do in the scene.
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
    """Tell whether 1 − k3², or its numerator, is positive on the whole family."""
    signs = Signs.over([across], eq.domain)
    return signs.of(signs.ring.numerator(across)) == 1
