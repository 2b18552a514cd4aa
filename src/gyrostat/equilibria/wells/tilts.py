"""The well of a body of revolution in U(k3), in one dimension: how far its tilt is held, by which kick."""
from dataclasses import dataclass

from sympy import Expr, S, cos, oo, pi, sin, sqrt

from ...algebra.reals.exact import evaluate, plain, proved_sign
from ...algebra.text.numbers import exact_expression
from ...errors import ScopeError, ValuesError
from ...mechanics.equilibrium.reduction import K3
from ...notation import Stored
from ..finders.revolution_form import RevolutionForm
from ..relative_equilibrium import RelativeEquilibrium
from .tilt_line import Line, lowest

WALLS = "there is no pass: the walls of V hold it at every energy"
ROUND = "V falls beyond no other equilibrium of its level: none is a way out"
NO_MINIMUM = "its tilt is no strict minimum of V on its level: no energy bound holds it"
TURNS = "its momentum along the axis is lost by internal damping: it is no equilibrium there"


@dataclass(frozen=True)
class Pass:
    """A tilt at which the well first touches another equilibrium of its level.

    Parameters
    ----------
    k3 : Expr
        the tilt, an exact number
    height : Expr
        V there [M L²/T²]
    kind : str
        "well" at a maximum of V, beyond which V falls; "summit" at a pole, where k3 turns back;
        "shelf" at an inflection, beyond which V goes on to rise
    """

    k3: Expr
    height: Expr
    kind: str


@dataclass(frozen=True)
class TiltWell(Stored):
    """The well of a motion of constant tilt: barrier, passes, and the kicks below which it stays.

    Parameters
    ----------
    barrier : Expr or None
        V at the lower neighbouring equilibrium minus V here, exact [M L²/T²]; oo if there is none; None if
        the tilt is no strict minimum
    escape : Expr or None
        the least rise that leads to where V is lower again [M L²/T²]; oo if nothing does
    passes : tuple of Pass
        where V first reaches the barrier
    reason : str
        why the barrier is oo or None, or why a finite one is no way out; "" else
    potential : Expr
        V, a function of k3 with exact numbers [M L²/T²]
    tilt : Expr
        k3 of the motion
    moment : Expr
        I1, the moment across the axis [M L²]
    """

    barrier: Expr | None
    escape: Expr | None
    passes: tuple[Pass, ...]
    reason: str
    potential: Expr
    tilt: Expr
    moment: Expr

    @property
    def kick(self) -> Expr | None:
        """The transversal kick √(2 I1 barrier), about the line of nodes, below which it stays [M L²/T]."""
        return None if self.barrier is None else sqrt(2 * self.moment * self.barrier)

    def within(self, degrees: Expr | float | str) -> Expr:
        """Return the rise of V that keeps the tilt within an angle of that of the motion, at least.

        It is the greatest V on the way, to the side on which that is less. At a pole there is one side.

        Parameters
        ----------
        degrees : Expr, number or str
            above 0, below 180

        Returns
        -------
        Expr
            [M L²/T²]; oo if walls or poles are met before

        Raises
        ------
        ValuesError
            the angle is not between 0 and 180
        ScopeError
            the tilt is no strict minimum of V

        Examples
        --------
        >>> import gyrostat as gs
        >>> top = gs.assemble(gs.Gyrostat((1, 1, "8/5"), (0, 0, 0)), gs.axial_potential("k3"))
        >>> sleeping = gs.relative_equilibria(top, {"omega": 2})[0]
        >>> round(float(tilt_well(sleeping).kick_within(10)), 12)
        0.219078050883
        """
        angle = exact_expression(degrees, "degrees") * pi / 180
        if not (angle.is_number and 0 < angle < pi):
            raise ValuesError(f"{degrees}° is no angle of a cone: choose one above 0°, below 180°")
        if self.barrier is None:
            raise ScopeError(f"no kick however small keeps it within {degrees}°: {self.reason}")
        across = S.Zero if self.tilt**2 == 1 else sqrt(1 - self.tilt**2)
        ends = [(s, self.tilt * cos(angle) + s * across * sin(angle)) for s in (1, -1)
                if s * self.tilt != 1 and proved_sign(cos(angle) - s * self.tilt) == 1]
        line = Line(self.potential)
        return lowest(line.highest(self.tilt, s, end) for s, end in ends) - line.height(self.tilt)

    def kick_within(self, degrees: Expr | float | str) -> Expr:
        """Return the transversal kick below which the tilt stays within an angle, √(2 I1 within) [M L²/T]."""
        return sqrt(2 * self.moment * self.within(degrees))


def tilt_well(rotation: RelativeEquilibrium, damped: bool = False) -> TiltWell:
    """Return the well of E1, E2, E3 or another precession of a body of revolution in U(k3).

    V(z) = U(z) + π3²/(2 I3) + (C1 − P z)²/(2 I1 (1 − z²)), P = π3 + l, is the least energy at the tilt k3 = z
    on its level of C1 and π3; what is added is the square of the nutation. With damping C1 alone is kept,
    and V(z) = U(z) + (C1 − l z)²/(2 (I1 (1 − z²) + I3 z²)).

    Parameters
    ----------
    rotation : RelativeEquilibrium
        of a body of revolution
    damped : bool
        the well under internal damping

    Returns
    -------
    TiltWell

    Raises
    ------
    ScopeError
        the rotation is not one of a body of revolution in U(k3)

    References
    ----------
    Goldstein, Classical Mechanics, §5.7. LaSalle, IRE Trans. Circuit Theory 7 (1960) 520, for what damping
    brings back.

    Examples
    --------
    A sleeping top has no pass at any energy, but damping gives it a finite basin:

    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.Gyrostat((1, 1, "8/5"), (0, 0, 0)), gs.axial_potential("k3"))
    >>> sleeping = gs.relative_equilibria(top, {"omega": "3/2"})[0]
    >>> tilt_well(sleeping).escape
    oo
    >>> well = tilt_well(sleeping, damped=True)
    >>> round(float(well.barrier), 12), round(float(well.passes[0].k3), 12)
    (0.233367464231, 0.327885244991)
    """
    form = rotation.form
    if not isinstance(form, RevolutionForm):
        raise ScopeError(f"{rotation.label} is no motion of a body of revolution in U(k3), whose tilt alone "
                         "moves: ask for its well")
    potential, moment = _potential(form, damped), form.found.standard.body.moments[0]
    line = Line(potential)
    held = not (form.every or line.constant or damped and form.turns)
    place = line.place(form.k3) if held else 0
    ways = [line.way(place, step) for step in (-1, 1)] if held else []
    if not held or any(way and way[0][1] != 1 for way in ways):
        reason = TURNS if damped and form.turns else NO_MINIMUM
        return TiltWell(None, None, (), reason, potential, form.k3, moment)
    here = line.height(form.k3)
    first = [_pass(line, *way[0]) for way in ways if way]
    out = [line.height(way[-1][0]) for way in ways if way and way[-1][2] == -1]
    low = lowest(p.height for p in first)
    passes = tuple(p for p in first if proved_sign(p.height - low) == 0)
    barrier, escape = (x if x == oo else plain(x - here) for x in (low, lowest(out)))
    reason = "" if out else ROUND if first else WALLS
    return TiltWell(barrier, escape, passes, reason, potential, form.k3, moment)


def _potential(form: RevolutionForm, damped: bool) -> Expr:
    """V at these numbers, without the factors 1 ∓ z that cancel at C1 = ±P."""
    scene = form.found.standard
    body = scene.body
    assert scene.potential is not None
    (I1, _, I3), l = body.moments, body.gyrostatic_momentum[2]
    spin = form.pi3 + l
    level = evaluate(I1 * form.omega * (1 - form.k3**2) + spin * form.k3, {})
    U, z = scene.potential.expression, K3
    if damped:
        return U + (level - l * z) ** 2 / (2 * (I1 * (1 - z**2) + I3 * z**2))
    signs = [s for s in (1, -1) if proved_sign(level - s * spin) == 0]
    twist = {0: (level - spin * z) ** 2 / (1 - z**2), 2: S.Zero}.get(len(signs))
    if twist is None:
        twist = spin**2 * (1 - signs[0] * z) / (1 + signs[0] * z)
    return U + form.pi3**2 / (2 * I3) + twist / (2 * I1)


def _pass(line: Line, z: Expr, before: int, after: int) -> Pass:
    kind = "summit" if z**2 == 1 else "well" if after == -1 else "shelf"
    return Pass(z, line.height(z), kind)
