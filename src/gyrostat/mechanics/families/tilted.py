"""Families at a tilt: precession about the vertical, inclined E3, and its limit at rest."""
from sympy import Expr, S, sqrt

from ...algebra.reals.exact import plain, sign_of_constant
from ...arguments import checked
from ...errors import EquilibriumError, ScopeError
from ...notation import symbol
from ..equilibrium.equilibrium import Equilibrium
from ..equilibrium.relations import solved_for
from ..scenes.coupled import in_one_direction
from ..scenes.kind import Kind
from ..scenes.system import System
from .named_families import E3, E3_AT_REST

K3, OMEGA, DU = symbol("k3"), symbol("omega"), symbol("dU")


@checked
def inclined(scene: System, eliminate: str | None = None) -> Equilibrium:
    """Return E3: precession at the rate omega about the vertical, tilted at 0 < θ < π; ω = omega·k.

    With k3 = cos θ it needs U'(k3) = ω l − ω² k3 (I1 − I3); by the spin symmetry the point shown has k2 = 0,
    k1 > 0.

    Parameters
    ----------
    scene : System
        body of revolution in U(k3)
    eliminate : str or None
        the name that the relation expresses by the others; it must enter affinely. Default: dU if U is
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
    Vera & Viguera (2003), §3; derived in docs/explanation/derivations/conditions.md, section 2.

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> gs.inclined(top, eliminate="k3").relations[-1]
    (k3, (l*omega - m0)/(omega**2*(I1 - I3)))
    """
    return _tilted(E3.label, scene, OMEGA, eliminate)


@checked
def static_tilt(scene: System, eliminate: str | None = None) -> Equilibrium:
    """Return the body at rest at a tilt where U'(k3) = 0, for every l.

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
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
    >>> gs.static_tilt(top).point
    (0, 0, 0, sqrt(1 - k3**2), 0, k3)
    """
    return _tilted(E3_AT_REST.label, scene, S.Zero, eliminate)


def _tilted(label: str, scene: System, omega: Expr, eliminate: str | None) -> Equilibrium:
    in_one_direction(scene.potential, label)
    body, potential = scene.body, scene.potential
    if potential is None or scene.kind is not Kind.REVOLUTION:
        raise ScopeError(f"{label} is a family of bodies of revolution in U(k3); this scene has inertia "
                         f"{body.moments}, l = "
                         f"{body.gyrostatic_momentum}, U = {potential and potential.expression}: use "
                         "equilibrium(scene, point)")
    (I1, _, I3), l, k1 = body.moments, body.gyrostatic_momentum[2], sqrt(1 - K3**2)
    point = (I1 * omega * k1, S.Zero, I3 * omega * K3, k1, S.Zero, K3)
    slope = omega * l - omega**2 * K3 * (I1 - I3)
    given = potential.value(DU) if potential.given else DU
    if (relation := plain(slope - given)).is_number and relation != 0:
        unknown = " (not proved to be true or false)" if sign_of_constant(relation) is None else ""
        raise EquilibriumError(f"{label} does not exist in U = {potential.expression}: its relation is "
                               f"{relation} = 0{unknown}; choose another field, or another family")
    name, solved, pivot = solved_for(relation, eliminate, potential.parameters, label)
    relations = (
        [(DU, slope)] if name == "dU" or solved is None else [(DU, slope), (symbol(str(name)), solved)]
    )
    domain = [1 - K3**2] + ([pivot**2] if pivot.free_symbols else [])
    return Equilibrium(label, scene, point, tuple(relations), tuple(domain), (name,) if name else ())
