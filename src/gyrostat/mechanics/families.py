"""The named families: upright E1, hanging E2, inclined E3 and its limit at rest, principal rotations of a
free body.

FAMILIES is the one list of them: a family that is added to it is known to the command line, to documents, to
pictures and to published files.
"""
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

from sympy import Expr, S, sqrt

from ..algebra.exact import plain, sign_of_constant
from ..errors import EquilibriumError, ScopeError, require
from ..notation import symbol
from .equilibria import Equilibrium, equilibrium
from .relations import affine, solved_for
from .system import System

K3, OMEGA, DU = symbol("k3"), symbol("omega"), symbol("dU")


def upright(scene: System, spin: str = "pi3_0") -> Equilibrium:
    """E1: spinning about the upward vertical, k3 = 1.

    Parameters
    ----------
    scene : System
        on e(3)*
    spin : str
        "pi3_0", the momentum [M L²/T], or "omega3_0", the body rate [1/T], π3 = I3 ω3

    Returns
    -------
    Equilibrium

    Raises
    ------
    ScopeError
        the scene has no field
    EquilibriumError
        another spin; or the point is none, in a field that is not axial

    References
    ----------
    Vera & Viguera (2003), §3.

    Examples
    --------
    >>> import gyrostat as gs
    >>> gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())).point
    (0, 0, pi3_0, 0, 0, 1)
    """
    return _vertical(E1, scene, spin)


def hanging(scene: System, spin: str = "pi3_0") -> Equilibrium:
    """E2: spinning about the downward vertical, k3 = -1.

    Parameters
    ----------
    scene : System
        on e(3)*
    spin : str
        "pi3_0", the momentum [M L²/T], or "omega3_0", the body rate [1/T], π3 = I3 ω3

    Returns
    -------
    Equilibrium

    Raises
    ------
    ScopeError
        the scene has no field
    EquilibriumError
        another spin; or the point is none, in a field that is not axial

    References
    ----------
    Vera & Viguera (2003), §3.

    Examples
    --------
    >>> import gyrostat as gs
    >>> gs.hanging(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())).point
    (0, 0, pi3_0, 0, 0, -1)
    """
    return _vertical(E2, scene, spin)


def _vertical(family: "Family", scene: System, spin: str) -> Equilibrium:
    require(scene, System, "the scene")
    if scene.potential is None:
        raise ScopeError(f"{family.label} needs a field, the scene has none: use principal_rotation(scene, "
                         "3)")
    if spin not in ("pi3_0", "omega3_0"):
        raise EquilibriumError(f"spin = {spin!r} is not a parameter of {family.label}: use 'pi3_0' or "
                               "'omega3_0'")
    momentum = symbol(spin) if spin == "pi3_0" else scene.body.inertia[2] * symbol(spin)
    return equilibrium(scene, (0, 0, momentum, 0, 0, family.pole), label=family.label)


def principal_rotation(scene: System, axis: int) -> Equilibrium:
    """Rotation of a free body about a principal axis that also carries l, where M ≠ 0.

    Parameters
    ----------
    scene : System
        on so(3)*
    axis : int
        1, 2 or 3; the body rate about it is omega1_0, omega2_0 or omega3_0 [1/T]

    Returns
    -------
    Equilibrium

    Raises
    ------
    ScopeError
        the scene has a field
    EquilibriumError
        there is no such axis, or it does not carry l

    References
    ----------
    Hughes, Spacecraft Attitude Dynamics (1986), chapter 6.

    Examples
    --------
    >>> import gyrostat as gs
    >>> gs.principal_rotation(gs.assemble(gs.Gyrostat(gyrostatic_momentum=(0, 0, 0))), 2).point
    (0, I2*omega2_0, 0)
    """
    require(scene, System, "the scene")
    if scene.potential is not None:
        raise ScopeError("principal_rotation is for a free body, the scene has a field: use upright, "
                         "hanging or inclined")
    if axis not in (1, 2, 3):
        raise EquilibriumError(f"axis = {axis!r} is not a principal axis: give 1, 2 or 3")
    momentum = scene.body.inertia[axis - 1] * symbol(f"omega{axis}_0")
    point = [momentum if i == axis else 0 for i in (1, 2, 3)]
    total = momentum + scene.body.gyrostatic_momentum[axis - 1]
    return equilibrium(scene, point, domain=(total**2,), label=PRINCIPAL[axis - 1].label)


def inclined(scene: System, eliminate: str | None = None) -> Equilibrium:
    """E3: precession at the rate omega about the vertical, tilted at 0 < θ < π, k3 = cos θ; ω = omega·k.

    U'(k3) = ω l − ω² k3 (I1 − I3); by the spin symmetry the point shown has k2 = 0, k1 > 0.

    Parameters
    ----------
    scene : System
        body of revolution in U(k3)
    eliminate : str or None
        the name that the relation expresses by the others; it must enter affinely. None: dU where U is
        unspecified; else l; else k3, or a parameter of U; else none, and the relation is checked at every
        point asked for

    Returns
    -------
    Equilibrium
        a family in k3 and omega

    Raises
    ------
    ScopeError
        the body is not of revolution, or U is not U(k3)
    EquilibriumError
        the relation is not affine in the name

    References
    ----------
    Vera & Viguera (2003), §3.

    Examples
    --------
    >>> import gyrostat as gs
    >>> gs.inclined(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field()), eliminate="k3").relations[-1]
    (k3, (l*omega - m0)/(omega**2*(I1 - I3)))
    """
    return _tilted(E3.label, scene, OMEGA, eliminate)


def static_tilt(scene: System, eliminate: str | None = None) -> Equilibrium:
    """The body at rest at a tilt where U'(k3) = 0, for every l.

    Parameters
    ----------
    scene : System
        body of revolution in U(k3)
    eliminate : str or None
        as in inclined

    Returns
    -------
    Equilibrium
        a family in k3

    Raises
    ------
    ScopeError
        the body is not of revolution, or U is not U(k3)
    EquilibriumError
        the relation is not affine in the name

    Examples
    --------
    >>> import gyrostat as gs
    >>> gs.static_tilt(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())).point
    (0, 0, 0, sqrt(1 - k3**2), 0, k3)
    """
    return _tilted(E3_AT_REST.label, scene, S.Zero, eliminate)


def _tilted(label: str, scene: System, omega: Expr, eliminate: str | None) -> Equilibrium:
    require(scene, System, "the scene")
    body, potential = scene.body, scene.potential
    if potential is None or not potential.axial or not body.is_of_revolution():
        raise ScopeError(f"{label} is a family of bodies of revolution in U(k3); this scene has inertia "
                         f"{body.inertia}, l = "
                         f"{body.gyrostatic_momentum}, U = {potential and potential.expression}: use "
                         "equilibrium(scene, point)")
    (I1, _, I3), l, k1 = body.inertia, body.gyrostatic_momentum[2], sqrt(1 - K3**2)
    point = (I1 * omega * k1, S.Zero, I3 * omega * K3, k1, S.Zero, K3)
    slope = omega * l - omega**2 * K3 * (I1 - I3)
    given = potential.value(DU) if potential.given else DU
    if (relation := plain(slope - given)).is_number and relation != 0:
        unknown = " (not proved to be true or false)" if sign_of_constant(relation) is None else ""
        raise EquilibriumError(f"{label} does not exist in U = {potential.expression}: its relation is "
                               f"{relation} = 0{unknown}")
    name, solved, pivot = solved_for(relation, eliminate, potential.parameters, label)
    relations = (
        [(DU, slope)] if name == "dU" or solved is None else [(DU, slope), (symbol(str(name)), solved)]
    )
    domain = [1 - K3**2] + ([pivot**2] if pivot.free_symbols else [])
    return Equilibrium(label, scene, point, tuple(relations), tuple(domain), name)


def solved_tilt(eq: Equilibrium) -> Expr | None:
    """k3 of a tilted family in closed form, where its relation is affine in k3 and another name was
    eliminated.
    """
    potential = eq.system.potential
    slopes = [value for name, value in eq.relations if name == DU]
    if not slopes or not potential or not potential.given or eq.eliminated == "k3":
        return None
    solved = affine(slopes[0] - potential.value(DU), K3)
    return solved and solved[0]


@dataclass(frozen=True)
class Family:
    """What is known of a named family of equilibria.

    Parameters
    ----------
    label : str
        of its equilibria, Equilibrium.label
    name : str
        the word of the field
    title : str
        how it moves; "" where the label says so
    make : callable
        of a scene, and of what the family is made with
    made_with : str
        the argument that its maker takes besides: "spin", "eliminate", or "" for none
    pole : int
        1 where k points upwards, −1 downwards, 0 at a tilt, and of a free body
    free : bool
        of a free body
    asked_for : str
        what the command line and published files call it; "" if it is only found
    source : str
    """

    label: str
    name: str
    title: str
    make: Callable[..., Equilibrium]
    made_with: str = ""
    pole: int = 0
    free: bool = False
    asked_for: str = ""
    source: str = "Vera & Viguera 2003, §3"

    @property
    def tilted(self) -> bool:
        """Whether it lies at a tilt, with a relation that a name may be eliminated from."""
        return self.made_with == "eliminate"

    def of(self, scene: System, spin: str = "pi3_0", eliminate: str | None = None) -> Equilibrium:
        """The equilibrium of a scene, made with what its maker takes."""
        if self.made_with == "spin":
            return self.make(scene, spin)
        return self.make(scene, eliminate) if self.made_with == "eliminate" else self.make(scene)


E1 = Family("E1", "upright", "spinning about the upward vertical", upright, "spin", 1, asked_for="E1")
E2 = Family("E2", "hanging", "spinning about the downward vertical", hanging, "spin", -1, asked_for="E2")
E3 = Family("E3", "inclined", "precessing about the vertical, inclined", inclined, "eliminate",
            asked_for="E3")
E3_AT_REST = Family("E3 at rest", "at rest at a tilt", "tilted, without rotation", static_tilt, "eliminate")
PRINCIPAL = tuple(Family(f"rotation about axis {n}", "principal rotation", "",
                         partial(principal_rotation, axis=n), free=True, asked_for=f"axis {n}",
                         source="Hughes 1986, chapter 6") for n in (1, 2, 3))
POLES = {1: E1, -1: E2}
FAMILIES = {family.label: family for family in (E1, E2, E3, E3_AT_REST, *PRINCIPAL)}


def in_a_field() -> list[Family]:
    """The families that are asked for by their label, of a body in a field."""
    return [family for family in FAMILIES.values() if family.asked_for and not family.free]
