"""Permanent rotations and the amended potential of which they are critical points; satellites in orbit."""
from sympy import Add, Expr

from ...algebra.rings.readable import readable
from ...equilibria.curves.amended_potential import AmendedPotential, CriticalPoint
from ...equilibria.finders.free_rotation import PermanentRotation
from ...equilibria.finders.heavy_rotation import HeavyRotation
from ...equilibria.finders.orbital_equilibrium import OrbitalEquilibrium
from ...equilibria.finders.rate_level_tilt import C1
from ...notation import symbol
from ...registry import Letters
from ..blocks import Block, Display, Word, equations, listed, sentence
from ..letters import letters_of, word
from .interval_ends import number

DIRECTION, MOMENTUM = Word("k", "⟨vector_k⟩"), Word("M", "⟨vector_M⟩")
NORMAL, VERTICAL = Word("n", "n"), Word("r", "r")


def free_rotation(rotation: PermanentRotation) -> list[Block]:
    """Of a free body: where it is, and its verdict."""
    place = listed(map(number, rotation.momentum))
    return [sentence("permanent rotation at ", MOMENTUM, " = (", *place, f"){_ended(rotation)}")]


def heavy_rotation(rotation: HeavyRotation) -> list[Block]:
    """Of a body in a field: the direction and the rate, and its verdict."""
    return [sentence("permanent rotation at ", *_place(rotation), _ended(rotation))]


def orbital_equilibrium(found: OrbitalEquilibrium) -> list[Block]:
    """Of a satellite: the normal of the orbit and the vertical, and its verdict."""
    n, r = (listed(map(number, direction)) for direction in (found.n, found.r))
    return [sentence("equilibrium in orbit at ", NORMAL, " = (", *n, "), ", VERTICAL, " = (", *r,
                     f"){_ended(found)}")]


def critical_point(point: CriticalPoint) -> list[Block]:
    """Which one it is, the value there, and the rotation."""
    kind = "degenerate point" if point.kind == "degenerate" else point.kind
    amended = _amended(letters_of(point.rotation.scene))
    return [sentence(f"{kind} of ", amended, " = ", number(point.value), " at ", *_place(point.rotation),
                     _ended(point.rotation))]


def amended_potential(amended: AmendedPotential) -> list[Block]:
    """U_c = …, its two parts each as it reads best."""
    U = amended.scene.potential
    assert U is not None
    letters = letters_of(amended.scene)
    value = Add(readable(U.expression), readable(amended.expression - U.expression))
    return [Display(_amended(letters), value.xreplace({C1: symbol(letters.of(C1.name))}))]


def _amended(letters: Letters) -> Word:
    """U_c."""
    return word(letters, "⟨U⟩_c", "⟨U⟩_{c}")


def _place(rotation: HeavyRotation) -> tuple[Word | Expr | str, ...]:
    rate = equations([(symbol("omega"), number(rotation.omega))])
    return (DIRECTION, " = (", *listed(map(number, rotation.k)), "), ", *rate)


def _ended(rotation: HeavyRotation | PermanentRotation | OrbitalEquilibrium) -> str:
    circle = f", and on {rotation.locus}" if rotation.locus else ""
    return f"{circle}: {rotation.decision.verdict.name.lower()}"
