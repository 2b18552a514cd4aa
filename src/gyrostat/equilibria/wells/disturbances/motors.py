"""Whether a motion is held when the speed of a rotor changes at once, by a motor inside the body."""
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from sympy import Add, Expr, S

from ....algebra.enclosures.balls import ball
from ....algebra.enclosures.precision import own_precision
from ....algebra.text.numbers import exact_expression
from ....errors import ScopeError, ValuesError
from ....mechanics.equilibrium.recognition import recognise
from ....mechanics.scenes.kind import Kind
from ....mechanics.scenes.system import assemble
from ...relative_equilibrium import RelativeEquilibrium
from ...search import relative_equilibria
from ..contained import inside
from ..in_balls import BITS, dot, in_balls, rows_in_balls
from ..landscape import NORMAL, level_of

TILTS = "of a body of revolution the tilt alone is known to be held"


def held_after(rotation: RelativeEquilibrium, change: Sequence[Any]) -> RelativeEquilibrium | None:
    """Return the equilibrium in whose well a motion is after l has changed; None if it is proved in none.

    A motor inside keeps M = π + l, and so C1: π becomes π − Δl where l becomes l + Δl. The energy is then
    that at the same place, with this π, of the scene with the new rotor.

    Parameters
    ----------
    rotation : RelativeEquilibrium
        from which the motion starts
    change : sequence of number, shape (3,)
        Δl, in the axes of the body [M L²/T]

    Raises
    ------
    ScopeError
        it is a body of revolution, or its level has no list of equilibria
    ValuesError
        the change is not three numbers

    Examples
    --------
    >>> import gyrostat as gs
    >>> craft = gs.assemble(gs.Gyrostat((60, 70, 35), (0, 0, 0)), gs.circular_orbit(1))
    >>> upright = next(e for e in gs.relative_equilibria(craft, {}) if e.decision.stable)
    >>> [held_after(upright, (0, spin, 0)) is not None for spin in (72, 73)]
    [True, False]
    """
    exact = [exact_expression(x, "l") for x in change]
    if len(exact) != 3:
        raise ValuesError(f"change = {tuple(change)} has {len(exact)} numbers: give three, in the axes of "
                          "the body")
    scene = rotation.scene
    rotor = tuple(Add(a, b) for a, b in zip(scene.body.gyrostatic_momentum, exact))
    potential = scene.potential
    if potential is not None and scene.kind is Kind.ORBIT:     # it holds −ω0 l·n
        turned = rotation.rates["omega0"] * Add(*(a * b for a, b in zip(exact, NORMAL)))
        potential = replace(potential, expression=potential.expression - turned)
    spun = assemble(replace(scene.body, gyrostatic_momentum=rotor), potential)
    if scene.kind is not Kind.FREE and (recognise(scene) or recognise(spun)):
        raise ScopeError(TILTS)
    with own_precision(BITS):
        vectors = [in_balls(v) for v in rotation.directions]
        turning = _momentum(rotation, vectors)
        state = [a - ball(b, BITS) for a, b in zip(turning, exact)] + [x for v in vectors for x in v]
    for e in relative_equilibria(spun, level_of(rotation)):
        well = e.well
        if well.paths is not None and well.found.passes and inside(
                e, well.paths, well.paths.values[well.found.passes[0]], state):
            return e
    return None


def _momentum(rotation: RelativeEquilibrium, vectors: list[list[Any]]) -> list[Any]:
    """The momentum π in balls, without it being written out."""
    if not vectors:
        return in_balls(rotation.point)
    rate: Expr = next(iter(rotation.rates.values()), S.Zero)
    return [ball(rate, BITS) * dot(row, vectors[0]) for row in rows_in_balls(rotation.scene.body.tensor)]
