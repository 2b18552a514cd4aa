"""Precessions of a symmetric gyrostat in a circular orbit, and how its axis moves in the orbital frame."""
from collections.abc import Callable, Sequence

from sympy import Add, Expr, ImmutableMatrix, Poly, S, Symbol, sqrt

from ..._lazy import loaded
from ...algebra.reals.exact import sign_of_constant
from ...algebra.text.numbers import shown
from ...arguments import checked
from ...errors import EquilibriumError, ScopeError, brief
from ...notation import components, symbol
from ..equilibrium.equilibrium import Equilibrium
from ..scenes.body import Gyrostat
from ..scenes.kind import Kind
from ..scenes.potential import DIRECTIONS, Potential
from ..scenes.system import System, system_of
from .circular_orbit import NORMAL, VERTICAL, along_velocity, orbital_rate, resting_at

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
        of a body of revolution about any axis, its rotor along it, and circular_orbit()
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
    axis = loaded("mechanics.equilibrium.recognition:axis_of_satellite")
    if scene.kind is not Kind.ORBIT or (found := axis(scene.body)) is None:
        raise ScopeError("orbital_precession is for a body of revolution in orbit with the rotor along its "
                         "axis, as moments I1, I1, I3 and rotor 0, 0, l, and this scene is none: use "
                         "assemble(symmetric_gyrostat(), circular_orbit())")
    c, turn, I1, I3 = found
    if kind not in KINDS:
        raise EquilibriumError(f"kind = {brief(kind)} is no precession: give one of {', '.join(KINDS)}")
    if kind == "cylindrical":
        point = _turned_to(scene, turn, (S.Zero, S.Zero, S.One), (S.One, S.Zero, S.Zero))
        return Equilibrium(kind, scene, point)
    rotor = Add(*(x * y for x, y in zip(c, scene.body.gyrostatic_momentum)))
    slope = (1 if kind == "hyperbolic" else 4) * (I1 - I3) * orbital_rate(scene)
    height, relations = _height(kind, rotor, slope)
    across = sqrt(1 - height**2)
    r = (S.Zero, S.One, S.Zero) if kind == "hyperbolic" else (-height, S.Zero, across)
    point = _turned_to(scene, turn, (across, S.Zero, height), r)
    return Equilibrium(kind, scene, point, relations, (1 - height**2,),
                       tuple(name.name for name, _ in relations))


def _turned_to(scene: System, turn: ImmutableMatrix, n: Sequence[Expr], r: Sequence[Expr]
               ) -> tuple[Expr, ...]:
    """Return the point with n and r given in axes x' = R x of which the third is that of the body."""
    return resting_at(scene, *(turn.T * ImmutableMatrix(x) for x in (n, r)))


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
    in the potential as a function of z, U = (3/2) ω0² (C − A) z_r² in the gravity gradient alone, on the
    level k·M = −P, where P is the momentum along the axis. The components are those in the axes (t, n, r) of
    the frame; spatial components of M have the bracket of the other sign, hence M → −M.

    Parameters
    ----------
    eq : Equilibrium
        in orbit
    at : callable
        what inserts numbers in its expressions

    Returns
    -------
    Equilibrium or None
        None where there is not one integral, or U is of degree 3 or more in n and r

    References
    ----------
    Derived in docs/explanation/derivations/satellite.md, section 8, by Routh's reduction.
    """
    scene = eq.system
    if scene.kind is not Kind.ORBIT or len(scene.linear_integrals) != 1:
        return None
    along = scene.space.gradient(scene.linear_integrals[0]).flat()[:3]
    c = ImmutableMatrix([at(eq.insert(x)) for x in along])
    axis = c / sqrt(c.dot(c))
    body = scene.body.changed(lambda x: at(eq.insert(x)))
    point = [at(eq.insert(x)) for x in eq.point]
    across = at((body.tensor.trace() - axis.dot(body.tensor * axis)) / 2)
    n, r = ImmutableMatrix(point[3:6]), ImmutableMatrix(point[6:])
    M = ImmutableMatrix(point[:3]) + ImmutableMatrix(body.gyrostatic_momentum)
    frame = [along_velocity(n, r), n, r]
    rate = at(eq.insert(orbital_rate(scene)))
    rotor = (S.Zero, -across * rate, S.Zero)
    if (U := _of_axis(scene, axis, lambda x: at(eq.insert(x)))) is None:
        return None
    pi = [-M.dot(a) - x for a, x in zip(frame, rotor)]
    sphere = system_of(Gyrostat((across, across, across), rotor), Potential(DIRECTIONS, U))
    return Equilibrium("the axis in the frame of the orbit", sphere, (*pi, *(at(axis.dot(a)) for a in frame)))


def _of_axis(scene: System, c: ImmutableMatrix, at: Callable[[Expr], Expr]) -> Expr | None:
    """Return the potential without the rotor as a function of the axis z = (t·c, n·c, r·c).

    It does not change as the body turns about c, so it is its mean: that of n·v is n·c v·c, that of a·Mb is
    c·Mc (a·c)(b·c) + ½ (tr M − c·Mc)(a·b − (a·c)(b·c)), and for a = n, b = r and M = s × it is −(s·c) t·c.
    """
    assert scene.potential is not None
    variables = (*components(NORMAL), *components(VERTICAL))
    if not scene.potential.expression.is_polynomial(*variables):
        return None
    U = Poly(scene.potential.expression, *variables, domain="EX")     # n3 may name the height besides
    if U.total_degree() > 2:
        return None
    l = [at(x) for x in scene.body.gyrostatic_momentum]
    z, rate = DIRECTIONS, at(orbital_rate(scene))
    found = Add(*(rate * x * y for x, y in zip(l, c))) * z[1]              # without −ω0 n·l
    for exponents, factor in U.terms():
        factor, places = at(factor), [divmod(i, 3) for i, e in enumerate(exponents) for _ in range(e)]
        if len(places) == 1:
            ((a, i),) = places
            found += factor * c[i] * z[1 + a]
        elif places:
            (a, i), (b, j) = places
            whole = c[i] * c[j]
            rest = (int(i == j) - whole) / 2
            found += factor * (whole - rest) * z[1 + a] * z[1 + b] + int(a == b) * factor * rest
            if a != b and i != j:
                k = 3 - i - j
                found += factor * c[k] * z[0] / (2 if (j - i) % 3 == 1 else -2)
    return at(found.expand())
