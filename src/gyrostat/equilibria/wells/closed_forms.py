"""Barriers and kicks in closed form, with names for numbers: of tops, free gyrostats and satellites."""
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace

from sympy import (
    Abs,
    And,
    Expr,
    Gt,
    ImmutableMatrix,
    Lt,
    Max,
    Min,
    Piecewise,
    Rational,
    Symbol,
    asin,
    cancel,
    nan,
    oo,
    sin,
    sqrt,
    tan,
    zoo,
)

from ...algebra.reals.exact import proved_sign
from ...algebra.rings.polynomials import derivatives
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.equilibrium.reduction import K3, OMEGA, P, V, reduce
from ...mechanics.families.circular_orbit import by_gradient_alone, orbital_rate
from ...mechanics.families.named_families import E3, EARTH_POINTING, POLES, PRINCIPAL
from ...mechanics.scenes.kind import Kind
from ...mechanics.scenes.system import names_of_scene
from ...notation import Stored, symbol

THETA, Z = symbol("theta"), symbol("z")
# of the moments across the axis, that nearer to the one about it; the two ways out of a satellite
NEAR, FAR, BY_YAW, BY_PITCH = map(symbol, ("I_near", "I_far", "by_yaw", "by_pitch"))
OWN = {THETA, Z, NEAR, FAR, BY_YAW, BY_PITCH}


@dataclass(frozen=True)
class ClosedForm(Stored):
    """What a well is in closed form: where it holds, its barrier, and the kick below which the motion stays.

    Parameters
    ----------
    scene : str
        what is kept, which way out is meant and what the kick is
    conditions : tuple of Expr
        it holds where all of them are positive
    barrier : Expr
        height of the first other equilibrium [M L²/T²]; oo if there is none
    kick : Expr or None
        the impulsive torque below which the motion stays [M L²/T]; a name theta in it is an angle from the
        place of the axis, within which it stays. A Piecewise has no value where no formula is known; None
        if these are its numbers
    tilt : Expr or None
        the angle below which the body may be turned, at rest in the orbit
    root : str
        which root z of the equation stands in the barrier; "" if none does
    equation : Expr or None
        what vanishes there
    names : tuple of (Symbol, Expr)
        what other names in these stand for, such as p_psi and p_phi
    """

    scene: str
    conditions: tuple[Expr, ...]
    barrier: Expr
    kick: Expr | None
    tilt: Expr | None = None
    root: str = ""
    equation: Expr | None = None
    names: tuple[tuple[Symbol, Expr], ...] = ()

    def at(self, values: Mapping[Symbol, Expr]) -> "ClosedForm | None":
        """Return the form with exact numbers in the place of names; None if a condition does not hold there.

        Examples
        --------
        >>> import gyrostat as gs
        >>> from sympy import S
        >>> satellite = gs.assemble(gs.Gyrostat((60, 70, 35), (0, 0, 0)), gs.circular_orbit())
        >>> [form] = closed_forms(gs.earth_pointing(satellite))
        >>> there = form.at({gs.symbol("omega0"): S.One})
        >>> there.barrier, there.kick
        (5, 5*sqrt(14))
        """
        meant = {name: _finite(x.xreplace(dict(values))) for name, x in self.names}
        # a name that stays stands for what it means
        given = {**{name: x for name, x in meant.items() if not x.free_symbols}, **values}
        conditions = [x.xreplace(given) for x in self.conditions]
        if any(proved_sign(x) != 1 for x in conditions if not x.free_symbols):
            return None
        barrier, kick, tilt, equation = (None if x is None else x.xreplace(given) for x in (
            self.barrier, self.kick, self.tilt, self.equation))
        return replace(self, conditions=tuple(x for x in conditions if x.free_symbols), barrier=barrier,
                       kick=None if kick is nan else kick, tilt=tilt, equation=equation,
                       names=tuple((name, x) for name, x in meant.items() if name not in given))


def _finite(x: Expr) -> Expr:
    """Without the cases that two equal moments exclude."""
    return Piecewise(*(case for case in x.args if not case[0].has(zoo))) if isinstance(x, Piecewise) else x


def closed_forms(eq: Equilibrium) -> tuple[ClosedForm, ...]:
    """Return the wells of an equilibrium in closed form; () if none is known.

    They are known for a rotation of a free gyrostat about the axis that carries l, once as least and once as
    greatest energy; for E1, E2 and E3 in a polynomial U(k3), those of a top also under damping; and for an
    Earth-pointing satellite whose l is along the axis of pitch.

    Parameters
    ----------
    eq : Equilibrium
        with names or numbers

    Returns
    -------
    tuple of ClosedForm

    References
    ----------
    Hughes, Spacecraft Attitude Dynamics (1986), chapters 6, 9 and 10; Goldstein, Classical Mechanics, §5.7.

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> closed_forms(gs.upright(top))[0].kick
    sqrt(-4*I1*m0*sin(theta/2)**2 + (l + pi3_0)**2*tan(theta/2)**2)
    """
    return () if OWN & names_of_scene(eq.system) else tuple(_found(eq))


def _found(eq: Equilibrium) -> Iterator[ClosedForm]:
    system, l = eq.system, eq.system.body.gyrostatic_momentum
    if not system.body.tensor.is_diagonal():
        return
    moments = tuple(system.body.tensor.diagonal())
    if system.kind is Kind.FREE:
        axis = next((n for n, family in enumerate(PRINCIPAL) if family.label == eq.label), None)
        if axis is not None:
            yield from _free(moments, axis, eq.point[axis], l[axis])
    elif system.kind is Kind.REVOLUTION and not system.unspecified:
        assert system.potential is not None
        U = system.potential.expression
        if not U.is_polynomial(K3):
            return
        if eq.label in (family.label for family in POLES.values()):
            yield from _pole(moments, l[2], U, eq.point[5], eq.point[2])
        elif eq.label == E3.label:
            yield _inclined(eq, U)
    elif system.kind is Kind.ORBIT and eq.label == EARTH_POINTING.label and by_gradient_alone(system):
        n, r = (ImmutableMatrix(eq.point[k:k + 3]) for k in (3, 6))
        pitch, yaw = (next((k for k in range(3) if abs(v[k]) == 1), None) for v in (n, r))
        if pitch is not None and yaw is not None and not any(x for k, x in enumerate(l) if k != pitch):
            roll = moments[3 - pitch - yaw]
            yield _satellite(roll, moments[pitch], moments[yaw], n[pitch] * l[pitch], orbital_rate(system))


def _free(moments: tuple[Expr, ...], axis: int, pi: Expr, l: Expr) -> Iterator[ClosedForm]:
    """The rotations of least and of greatest energy on the sphere of M; the lower saddle or the other end."""
    I, others = moments[axis], [x for n, x in enumerate(moments) if n != axis]
    rate, M, J, K = cancel(pi / I), pi + l, NEAR, FAR
    for s, near, far, word in ((1, Max, Min, "least"), (-1, Min, Max, "greatest")):
        D = s * (I - J)
        foot = D * rate + s * l
        saddle = Gt(D * Abs(M), J * Abs(l))
        barrier = Piecewise((I * foot**2 / (2 * J * D), saddle), (2 * s * M * l / I, True))
        across, below = I**2 * foot**2 * K, J * D * s * (I - K)
        kick = I * Abs(foot) * sqrt(K / below)
        if l == 0:
            barrier = barrier.args[0][0]
        else:                                              # a kick of -M leads to rest, another equilibrium
            kick = Piecewise((kick, And(saddle, Lt(across, M**2 * below))), (Abs(M), saddle))
        yield ClosedForm(f"It has the {word} energy at its angular momentum. The kick is the least that "
                         "leads out.", (M * foot, *((D, s * (I - K)) if l == 0 else ())), barrier, kick,
                         names=((NEAR, near(*others)), (FAR, far(*others))))


def _pole(moments: tuple[Expr, ...], l: Expr, U: Expr, s: Expr, pi3: Expr) -> Iterator[ClosedForm]:
    """E1 and E2: on the level of C1 and π3, and under damping on that of C1 if l = 0 and U is linear."""
    I1, _, I3 = moments
    total, slope = pi3 + l, s * derivatives(U, [K3])[0]
    margin = total**2 - 4 * I1 * slope.xreplace({K3: s})
    kept = "Without friction C1 and the spin are kept"
    side, linear = "greatest" if s == 1 else "least", not slope.has(K3)
    if linear:
        yield ClosedForm(f"{kept}, and there is no pass. A kick across the axis below this keeps it within "
                         "the angle theta of its place.", (margin,), oo,
                         sqrt(total**2 * tan(THETA / 2)**2 - 4 * I1 * slope * sin(THETA / 2)**2))
    else:
        rise = U.xreplace({K3: Z}) - U.xreplace({K3: s}) + total**2 * (1 - s*Z) / (2 * I1 * (1 + s*Z))
        yield ClosedForm(f"{kept}. The kick is across the axis.", (margin, total**2), rise,
                         sqrt(2 * I1 * rise),
                         root=f"the {side} between −1 and 1; if there is none, nothing leads out",
                         equation=I1 * slope.xreplace({K3: Z}) * (1 + s * Z)**2 - total**2)
    if linear and l == 0:
        N = I3 - I1
        rise = slope * (s * Z - 1) + pi3**2 * (1 / (I1 + N * Z**2) - 1 / I3) / 2
        yield ClosedForm("Under internal damping C1 alone is kept. The kick is across the axis.",
                         (slope, N, N * pi3**2 - I3**2 * slope), rise, sqrt(2 * I1 * rise),
                         root=f"the one between 0 and {s}",
                         equation=pi3**2 * N * s * Z - slope * (I1 + N * Z**2)**2)


def _inclined(eq: Equilibrium, U: Expr) -> ClosedForm:
    """E3 between its neighbouring maxima, on the level of C1 and π3."""
    (I1, *_), z = eq.system.body.tensor.diagonal(), eq.point[5]
    total = eq.insert(eq.point[2] + eq.system.body.gyrostatic_momentum[2])
    first, second = derivatives(U, [K3])[0], U.diff(K3, 2)
    height = U.xreplace({K3: Z}) + (V - P * Z)**2 / (2 * I1 * (1 - Z**2))
    rise = height - height.xreplace({Z: z})
    stiff = reduce(eq.system).restoring().xreplace({symbol("d2U"): second, K3: z})
    return ClosedForm("Without friction C1 and the spin are kept. The kick is about the line of nodes.",
                      (stiff, (V**2 - P**2)**2), rise, sqrt(2 * I1 * rise),
                      root=f"one next to {z}, between −1 and 1, that with the lower barrier; "
                           "if there is none, nothing leads out",
                      equation=I1 * first.xreplace({K3: Z}) * (1 - Z**2)**2 + (V - P * Z) * (V * Z - P),
                      names=((P, total), (V, I1 * OMEGA * (1 - z**2) + total * z)))


def _satellite(roll: Expr, pitch: Expr, yaw: Expr, l: Expr, rate: Expr) -> ClosedForm:
    """The lower of two ways out: a turn about the vertical, and one about the normal of the orbit."""
    D, barrier = pitch - roll, Min(BY_YAW, BY_PITCH)
    by_yaw, by_pitch = rate**2 * D / 2, Rational(3, 2) * rate**2 * (roll - yaw)
    conditions: tuple[Expr, ...] = (D, roll - yaw)
    if l != 0:
        conditions = (roll - yaw, l + rate * D, l + 4 * rate * (pitch - yaw))
        by_yaw = Piecewise(((rate * D + l)**2 / (2 * D), Lt(Abs(l), rate * D)), (2 * rate * l, True))
        # D < 0 there
        rolled = by_pitch + (4 * rate * D + l)**2 / (8 * D)
        by_pitch = Piecewise((rolled, Lt(l, -4 * rate * D)), (by_pitch, True))
    return ClosedForm("At rest in the orbit. The ways out are a turn about the vertical, of height by_yaw, "
                      "and one about the normal, of height by_pitch. The kick is in any direction.",
                      conditions, barrier, sqrt(2 * (Min(pitch, yaw) if l != 0 else yaw) * barrier),
                      None if l != 0 else asin(sqrt(barrier / (2 * rate**2 * (pitch - yaw)))),
                      names=((BY_YAW, by_yaw), (BY_PITCH, by_pitch)))
