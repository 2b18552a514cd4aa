"""Precessions of a symmetric gyrostat in a circular orbit, and how its axis moves in the orbital frame."""
from collections.abc import Callable

from sympy import Expr, ImmutableMatrix, Rational, S, Symbol, sqrt

from ...algebra.reals.exact import sign_of_constant
from ...algebra.text.numbers import shown
from ...arguments import checked
from ...errors import EquilibriumError, ScopeError, brief
from ...notation import symbol
from ..equilibrium.equilibrium import Equilibrium
from ..scenes.body import Gyrostat
from ..scenes.kind import Kind
from ..scenes.potential import DIRECTIONS, Potential
from ..scenes.system import System, system_of
from .circular_orbit import along_velocity, by_gradient_alone, orbital_rate, resting_at

HEIGHT = symbol("n3")
KINDS = ("cylindrical", "hyperbolic", "conical")


@checked
def orbital_precession(scene: System, kind: str) -> Equilibrium:
    """Return a symmetric gyrostat in orbit whose axis is at rest in the orbital frame.

    If it is cylindrical, the axis is along the normal n of the orbit; if hyperbolic, in the plane of n and
    the velocity t, with l = (I1 − I3) ω0 n3; if conical, in the plane of n and the vertical r, with l = 4 (I1
    − I3) ω0 n3; n3 is the cosine of the angle between the axis and n. Some authors exchange the last two
    names. A body that spins against the frame at the rate s is the same with l + I3 s in place of l, but for
    damping.

    Parameters
    ----------
    scene : System
        of a body of revolution and circular_orbit()
    kind : str
        "cylindrical", "hyperbolic" or "conical"

    Returns
    -------
    Equilibrium
        modulo the turn about the axis; a family in n3 if the rotor is a name, l

    Raises
    ------
    ScopeError
        the scene is no body of revolution in orbit
    EquilibriumError
        another kind; or the body does not precess so: its rotor is too strong, or I1 = I3

    References
    ----------
    Likins, J. Astronaut. Sci. 12 (1965); Pringle, AIAA J. 2 (1964); derived.

    Examples
    --------
    >>> import gyrostat as gs
    >>> scene = gs.assemble(gs.symmetric_gyrostat(), gs.circular_orbit())
    >>> conical = gs.orbital_precession(scene, "conical")
    >>> conical.relations
    ((l, n3*omega0*(4*I1 - 4*I3)),)
    >>> print(gs.analyze(conical).sufficient)
    I₁ > I₃, modulo the flow of π₃
    """
    I1, _, I3 = scene.body.moments
    if scene.kind is not Kind.ORBIT or not scene.body.is_of_revolution():
        raise ScopeError("orbital_precession is for a body of revolution in orbit, moments I1, I1, I3 and "
                         "rotor 0, 0, l, and this scene is none: use assemble(symmetric_gyrostat(), "
                         "circular_orbit())")
    if kind not in KINDS:
        raise EquilibriumError(f"kind = {brief(kind)} is no precession: give one of {', '.join(KINDS)}")
    if kind == "cylindrical":
        return Equilibrium(kind, scene, resting_at(scene, (0, 0, 1), (1, 0, 0)))
    rotor = scene.body.gyrostatic_momentum[2]
    slope = (1 if kind == "hyperbolic" else 4) * (I1 - I3) * orbital_rate(scene)
    height, relations = _height(kind, rotor, slope)
    across = sqrt(1 - height**2)
    r = (S.Zero, S.One, S.Zero) if kind == "hyperbolic" else (-height, S.Zero, across)
    return Equilibrium(kind, scene, resting_at(scene, (across, 0, height), r), relations,
                       (1 - height**2,), tuple(name.name for name, _ in relations))


def _height(kind: str, rotor: Expr, slope: Expr) -> tuple[Expr, tuple[tuple[Symbol, Expr], ...]]:
    """Return n3, and the relation that holds on the family: the rotor is slope · n3."""
    if isinstance(rotor, Symbol):
        return HEIGHT, ((rotor, slope * HEIGHT),)
    if rotor == 0:
        return S.Zero, ()
    if slope == 0:
        raise EquilibriumError(f"there is no {kind} precession of a sphere with the rotor {rotor}: its axis "
                               "rests along the normal only; use cylindrical")
    height = rotor / slope
    if not height.free_symbols and sign_of_constant(1 - height**2) != 1:
        raise EquilibriumError(f"a {kind} precession needs n3 = l/({slope}) between −1 and 1, here it is "
                               f"{shown(height)}: the rotor is too strong, the axis goes along the normal; "
                               "use cylindrical, or a weaker rotor")
    return height, ()


def moving_axis(eq: Equilibrium, at: Callable[[Expr], Expr]) -> Equilibrium | None:
    """Return where the axis of a symmetric body is in the orbital frame, as an equilibrium in one direction.

    The axis z moves as k does of a spherical body of the moment A across the axis, with the rotor −A ω0 e_n,
    in U = (3/2) ω0² (C − A) z_r², on the level k·M = −P, where P is the momentum along the axis. The
    components are those in the axes (t, n, r) of the frame; spatial components of M have the bracket of the
    other sign, hence M → −M.

    Parameters
    ----------
    eq : Equilibrium
        in orbit
    at : callable
        what inserts numbers in its expressions

    Returns
    -------
    Equilibrium or None
        None where there is not one integral along a principal axis

    References
    ----------
    Derived in docs/explanation/derivations/satellite.md, section 8, by Routh's reduction.
    """
    scene = eq.system
    if not by_gradient_alone(scene) or len(scene.linear_integrals) != 1:
        return None
    gradient = scene.space.gradient(scene.linear_integrals[0]).flat()[:3]
    if sum(x != 0 for x in gradient) != 1:
        return None
    axis = next(i for i, x in enumerate(gradient) if x != 0)
    body = scene.body.changed(lambda x: at(eq.insert(x)))
    along, across = body.tensor[axis, axis], body.tensor[axis - 1, axis - 1]
    point = [at(eq.insert(x)) for x in eq.point]
    n, r = ImmutableMatrix(point[3:6]), ImmutableMatrix(point[6:])
    M = ImmutableMatrix(point[:3]) + ImmutableMatrix(body.gyrostatic_momentum)
    frame = [along_velocity(n, r), n, r]
    rate = at(eq.insert(orbital_rate(scene)))
    rotor = (S.Zero, -across * rate, S.Zero)
    U = Potential(DIRECTIONS, Rational(3, 2) * rate**2 * (along - across) * DIRECTIONS[2] ** 2)
    pi = [-M.dot(a) - x for a, x in zip(frame, rotor)]
    sphere = system_of(Gyrostat((across, across, across), rotor), U)
    return Equilibrium("the axis in the frame of the orbit", sphere, (*pi, *(a[axis] for a in frame)))


