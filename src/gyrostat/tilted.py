"""E3, the inclined family of a body of revolution, its static limit, and the elimination of one parameter."""
from collections.abc import Sequence

from sympy import Expr, S, Symbol, sqrt

from .algebra import Ring
from .equilibria import Equilibrium
from .errors import EquilibriumError, ScopeError, require
from .notation import symbol
from .system import System

K3, OMEGA, DU = symbol("k3"), symbol("omega"), symbol("dU")


def inclined(scene: System, eliminate: str | None = None) -> Equilibrium:
    """E3: precession at the rate omega about the vertical, tilted at 0 < θ < π, k3 = cos θ; ω = omega·k.

    U'(k3) = ω l − ω² k3 (I1 − I3); by the spin symmetry the point shown has k2 = 0, k1 > 0.

    Parameters
    ----------
    scene : System           body of revolution in U(k3)
    eliminate : str or None  the name that the relation expresses by the others; it must enter affinely.
                             None: dU where U is unspecified; else l; else k3, or a parameter of U; else none,
                             and the relation is checked at every point asked for

    Raises
    ------
    ScopeError               the body is not of revolution, or U is not U(k3)
    EquilibriumError         the relation is not affine in the name

    Source
    ------
    Vera & Viguera (2003), §3.

    Examples
    --------
    >>> from gyrostat.body import symmetric_gyrostat
    >>> from gyrostat.potential import uniform_field
    >>> from gyrostat.system import assemble
    >>> inclined(assemble(symmetric_gyrostat(), uniform_field()), eliminate="k3").relations[-1]
    (k3, (l*omega - m0)/(omega**2*(I1 - I3)))
    """
    return _tilted("E3", scene, OMEGA, eliminate)


def static_tilt(scene: System, eliminate: str | None = None) -> Equilibrium:
    """The body at rest at a tilt where U'(k3) = 0, for every l; arguments as in inclined.

    Examples
    --------
    >>> from gyrostat.body import symmetric_gyrostat
    >>> from gyrostat.potential import axial_potential
    >>> from gyrostat.system import assemble
    >>> static_tilt(assemble(symmetric_gyrostat(), axial_potential())).point
    (0, 0, 0, sqrt(1 - k3**2), 0, k3)
    """
    return _tilted("E3 at rest", scene, S.Zero, eliminate)


def _tilted(label: str, scene: System, omega: Expr, eliminate: str | None) -> Equilibrium:
    require(scene, System, "the scene")
    body, potential = scene.body, scene.potential
    if potential is None or not potential.axial or not body.is_of_revolution():
        raise ScopeError(f"{label} is a family of bodies of revolution in U(k3); this scene has inertia {body.inertia}, l = "
                         f"{body.gyrostatic_momentum}, U = {potential and potential.expression}: use equilibrium(scene, point)")
    (I1, _, I3), l, k1 = body.inertia, body.gyrostatic_momentum[2], sqrt(1 - K3**2)
    point = (I1 * omega * k1, S.Zero, I3 * omega * K3, k1, S.Zero, K3)
    slope = omega * l - omega**2 * K3 * (I1 - I3)
    given = potential.value(DU) if potential.given else DU
    if (relation := slope - given).is_number and relation != 0:
        raise EquilibriumError(f"{label} does not exist in U = {potential.expression}: its relation is {relation} = 0")
    name, solved, pivot = _eliminate(relation, eliminate, potential.parameters, label)
    relations = [(DU, slope)] if name == "dU" or solved is None else [(DU, slope), (symbol(str(name)), solved)]
    domain = [1 - K3**2] + ([pivot**2] if pivot.free_symbols else [])
    return Equilibrium(label, scene, point, tuple(relations), tuple(domain), name)


def solved_tilt(eq: Equilibrium) -> Expr | None:
    """k3 of a tilted family in closed form, where its relation is affine in k3 and another name was eliminated."""
    potential = eq.system.potential
    slopes = [value for name, value in eq.relations if name == DU]
    if not slopes or not potential or not potential.given or eq.eliminated == "k3":
        return None
    solved = _affine(slopes[0] - potential.value(DU), K3)
    return solved and solved[0]


def _eliminate(relation: Expr, wanted: str | None, parameters: Sequence[Symbol], label: str) -> tuple[str | None, Expr | None, Expr]:
    """Name, value and leading coefficient of a parameter in which the relation is affine."""
    for name in [wanted] if wanted else ["dU", "l", "k3", *map(str, parameters)]:
        if solved := _affine(relation, symbol(name)):
            return name, *solved
    if wanted:
        raise EquilibriumError(f"{label}: the relation {relation} = 0 is not affine in {wanted}: eliminate another name, or none")
    return None, None, S.One


def _affine(relation: Expr, x: Symbol) -> tuple[Expr, Expr] | None:
    """Solution and leading coefficient of a x + b = 0, None if the relation has no such form."""
    ring = Ring([relation])
    top, _ = ring.fraction(relation)
    if x not in ring.gens or any(x in g.free_symbols for g in ring.generators if g != x):
        return None
    index = ring.generators.index(x)
    if top.degrees()[index] != 1:
        return None
    slope = top.derivative(index)
    rest = top - slope * ring.gens[x]
    return ring.quotient(-rest, slope), ring.expression(slope)
