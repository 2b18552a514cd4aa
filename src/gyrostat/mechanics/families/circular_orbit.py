"""A satellite in a circular orbit: the field of the gravity gradient in the frame that turns with it."""
from dataclasses import dataclass, replace
from numbers import Integral
from typing import Any, ClassVar

from sympy import Add, Expr, ImmutableMatrix, Rational, S, Symbol, expand

from ...algebra.reals.exact import is_identically_zero
from ...algebra.rings.matrices import cross
from ...algebra.text.numbers import exact_expression, shown
from ...arguments import checked
from ...errors import EquilibriumError, PotentialError, ScopeError, brief
from ...notation import components, symbol
from ..equilibrium.equilibrium import Equilibrium
from ..scenes.coupled import CoupledPotential, coupled_potential, unit_and_orthogonal
from ..scenes.kind import Kind
from ..scenes.lie_poisson import hat
from ..scenes.potential import DIRECTIONS
from ..scenes.system import System
from .orbit_rates import rate_of_orbit

NORMAL, VERTICAL = "n", "r"
VELOCITY = dict(zip(components("t"), cross(components(NORMAL), components(VERTICAL))))     # t = n × r

IN_ORBIT = "n1, n2, n3, the normal, r1, r2, r3, the vertical, and t1, t2, t3, along the velocity"


@dataclass(frozen=True)
class CircularOrbit(CoupledPotential):
    """The field of a satellite in a circular orbit.

    `alone` says that U is that of the gravity gradient of the body alone, and `beside` is the other energy
    as it was given, in n, r and t.
    """

    alone: bool = True
    beside: Expr = S.Zero
    kind: ClassVar[Kind] = Kind.ORBIT

    def with_free_rotors(self) -> "CircularOrbit":
        """Return the same field, which is not that of the tensor alone."""
        return replace(self, alone=False)


@checked
def circular_orbit(rate: Any = None, *, period: Any = None, height: Any = None, body: str | None = None,
                   mu: Any = None, radius: Any = None,
                   potential: Any = 0) -> CoupledPotential:
    """Return the field of a satellite in a circular orbit, in the frame that turns with the orbit.

    n is the normal of the orbit, r the local vertical, outwards, t = n × r along the velocity, all in body
    axes. h = T − ω0 n·(π + l) + (3/2) ω0² r·I r is the Jacobi integral; π is the angular momentum of the
    absolute rate ω, the rate against the frame is ω − ω0 n. The attitude does not act on the orbit, and the
    body is small beside it.

    Parameters
    ----------
    rate : number, text or Expr, or None
        ω0 > 0, such as "0.0011 rad/s"; default: the symbol omega0 [1/T]
    period : number, text or Expr
        in place of the rate: that of the orbit, "95 min" [T]
    height : text
        in place of the rate: above the equator of the body, with its unit, "500 km" [L]
    body : str
        of a height or a radius: "earth", "moon" or "mars"; default: the Earth
    mu, radius : number, text or Expr
        in place of the rate: the gravitational parameter [L³/T²] and the radius of the orbit [L],
        ω0² = mu/radius³
    potential : Expr, str or callable
        another energy beside the gravity gradient, or a text of it, in n1, n2, n3, r1, r2, r3, and t1, t2,
        t3 for n × r; or a function of the first six: −B n·μ of a magnet μ in a field B along the normal, f
        ρ·t of a constant drag f against the velocity at the point ρ of the body [M L²/T²]

    Returns
    -------
    CoupledPotential
        U in n, r, the entries I11, I12, … of the tensor on which gravity acts and the rotor l1, l2, l3,
        inserted by assemble

    Raises
    ------
    PotentialError
        what is given of the orbit is not positive, or is too much or too little; the other potential is of no
        such directions

    References
    ----------
    Hughes, Spacecraft Attitude Dynamics (1986), chapter 9; the bracket: Krishnaprasad & Marsden, Arch.
    Rational Mech. Anal. 98 (1987) 71-93. Celestial bodies: IERS Conventions (2010), table 1.1, for the Earth;
    JPL's DE440 and Archinal et al., Celest. Mech. Dyn. Astron. 130 (2018) 22, for the Moon and Mars.

    Examples
    --------
    >>> import gyrostat as gs
    >>> body = gs.Gyrostat(gyrostatic_momentum=(0, 0, 0))
    >>> scene = gs.assemble(body, gs.circular_orbit())
    >>> gs.earth_pointing(scene, roll=1, pitch=2, yaw=3).point
    (0, I2*omega0, 0, 0, 1, 0, 0, 0, 1)
    >>> low = gs.circular_orbit(height="500 km")
    >>> low.drift[0].evalf(6)
    -0.00110678*n1
    """
    omega0 = rate_of_orbit(rate, mu, radius, height, period, body)
    n, r, l = map(components, (NORMAL, VERTICAL, "l"))
    gravity = Add(*(symbol(f"I{min(i, j)}{max(i, j)}") * r[i - 1] * r[j - 1]
                    for i in (1, 2, 3) for j in (1, 2, 3)))
    U = Rational(3, 2) * omega0**2 * gravity - omega0 * Add(*(a * b for a, b in zip(n, l)))
    first, second, third = (-omega0 * x for x in n)
    given, other = _beside(potential)
    return CircularOrbit((*n, *r), U + other, False, (first, second, third),
                         unit_and_orthogonal((NORMAL, VERTICAL)), other == 0, given)


def _beside(potential: Any) -> tuple[Expr, Expr]:
    """Return another energy in the directions of the orbit, as it is given and in n and r alone."""
    given = None if callable(potential) else exact_expression(potential, "U")
    potential = potential if given is None else given.xreplace(VELOCITY)
    names: set[Symbol] = getattr(potential, "free_symbols", set())
    if fixed := sorted(str(k) for k in names & set(DIRECTIONS)):
        raise PotentialError(f"U = {brief(potential)} has {', '.join(fixed)}, a direction fixed in space, "
                             "and in an orbit the directions turn: leave U out, or write what acts beside "
                             f"the gravity gradient in {IN_ORBIT}")
    if names and not names & {*components(NORMAL), *components(VERTICAL)}:
        raise PotentialError(f"U = {brief(potential)} depends on no direction of the orbit: write what acts "
                             f"beside the gravity gradient in {IN_ORBIT}, as f*t1 for a drag")
    other = coupled_potential(potential, (NORMAL, VERTICAL)).expression
    return other if given is None else given, other


def by_gradient_alone(scene: System) -> bool:
    """Tell whether nothing but the gravity gradient acts on a satellite in orbit, with no free rotor."""
    return isinstance(scene.potential, CircularOrbit) and scene.potential.alone


def acting_beside(scene: System) -> Expr:
    """Return what acts on a satellite in orbit beside the gravity gradient of its tensor, as a potential."""
    assert scene.potential is not None
    r, rate = ImmutableMatrix(components(VERTICAL)), orbital_rate(scene)
    own = Rational(3, 2) * rate**2 * r.dot(scene.body.tensor * r)
    along = rate * Add(*(x * y for x, y in zip(components(NORMAL), scene.body.gyrostatic_momentum)))
    return expand(scene.potential.expression - own + along)


@checked
def earth_pointing(scene: System, roll: int = 1, pitch: int = 2, yaw: int = 3) -> Equilibrium:
    """Return a satellite at rest in the frame of its circular orbit, its body axes along those of the orbit.

    Parameters
    ----------
    scene : System
        of assemble(body, circular_orbit())
    roll, pitch, yaw : int
        the body axes, 1, 2, 3 in some order, along the velocity t, the normal n and the vertical r; −2, say,
        for an axis that points the other way. That of roll follows from the other two: t = n × r

    Returns
    -------
    Equilibrium

    Raises
    ------
    ScopeError
        the scene is in no orbit
    EquilibriumError
        the axes are not three; or the body does not rest so: l needs l·t = −ω0 t·I n, l·r = −4 ω0 r·I n,
        and t·I r = 0

    References
    ----------
    Lagrange (1780); Hughes, Spacecraft Attitude Dynamics (1986), chapters 9 and 10.

    Examples
    --------
    >>> import gyrostat as gs
    >>> body = gs.Gyrostat(gyrostatic_momentum=(0, gs.symbol("l"), 0))
    >>> scene = gs.assemble(body, gs.circular_orbit())
    >>> pointing = gs.earth_pointing(scene, roll=1, pitch=2, yaw=3)
    >>> print(gs.analyze(pointing).sufficient)
    l + 4 ω₀ (I₂ − I₃) > 0 and I₁ > I₃ and l > ω₀ (I₁ − I₂)
    """
    if scene.kind is not Kind.ORBIT:
        raise ScopeError("earth_pointing is for a satellite in orbit, and this scene is in none: use "
                         "assemble(body, circular_orbit())")
    axes = axes_of(roll, pitch, yaw)
    if by_gradient_alone(scene):
        _check_rotor(scene, *map(ImmutableMatrix, axes))
    return Equilibrium("Earth-pointing", scene, resting_at(scene, *axes[1:]))


def _check_rotor(scene: System, t: ImmutableMatrix, n: ImmutableMatrix, r: ImmutableMatrix) -> None:
    """Refuse a body that does not rest so: what turns it is said in the axes of the orbit, with a remedy."""
    I, rate, l = scene.body.tensor, orbital_rate(scene), ImmutableMatrix(scene.body.gyrostatic_momentum)
    torques = {"t·Ir": t.dot(I * r), "l·t + ω0 t·In": t.dot(l) + rate * t.dot(I * n),
               "l·r + 4 ω0 r·In": r.dot(l) + 4 * rate * r.dot(I * n)}
    left = [f"{name} = {_short(x)}" for name, x in torques.items() if is_identically_zero(x) is False]
    if left:
        remedy = ("turn the body about the normal, as earth_pointing_gyrostat says" if left[0][:4] == "t·Ir"
                  else "give the momentum held, or that of earth_pointing_gyrostat")
        raise EquilibriumError(f"Earth-pointing is not an equilibrium of this body: {', '.join(left)}, and "
                               f"each must be 0: {remedy}")


def _short(value: Expr) -> str:
    text = shown(value, 12)
    return text if len(text) <= 24 else text[:23] + "…"


def axes_of(roll: int, pitch: int, yaw: int) -> list[list[int]]:
    """Return t, n and r in body axes for the body axes along them: t = n × r, whatever way roll points."""
    given = roll, pitch, yaw
    if not all(isinstance(axis, Integral) for axis in given) or sorted(map(abs, given)) != [1, 2, 3]:
        raise EquilibriumError(f"roll, pitch, yaw = {brief(given)}: give the body axes 1, 2, 3 in some "
                               "order, negative for one that points the other way")
    n, r = ([abs(axis) // axis if i == abs(axis) else 0 for i in (1, 2, 3)] for axis in (pitch, yaw))
    return [[int(x) for x in along_velocity(n, r)], n, r]


def resting_at(scene: System, n: Any, r: Any) -> tuple[Expr, ...]:
    """Return the point of a satellite at rest in the frame of its orbit, at n and r: π = ω0 In."""
    normal = ImmutableMatrix(n)
    return (*(orbital_rate(scene) * scene.body.tensor * normal), *normal, *ImmutableMatrix(r))


def orbital_rate(scene: System) -> Expr:
    """Return the ω0 of a scene."""
    assert isinstance(scene.potential, CoupledPotential)
    return -scene.potential.drift[0].diff(symbol(f"{NORMAL}1"))            # β = −ω0 n


def along_velocity(n: Any, r: Any) -> ImmutableMatrix:
    """Return t = n × r."""
    return ImmutableMatrix(hat(n) * ImmutableMatrix(r))
