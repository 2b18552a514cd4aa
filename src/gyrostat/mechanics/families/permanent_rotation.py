"""The family of all permanent rotations of a body in a field, from which ∇U is eliminated."""
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from sympy import Expr, Matrix, Symbol

from ...algebra.text.numbers import exact_expression
from ...arguments import checked
from ...errors import EquilibriumError, ScopeError
from ...notation import Use, jet, symbol
from ...registry import check_names
from ..equilibrium.equilibrium import Equilibrium, Relation
from ..equilibrium.relations import affine
from ..scenes.coupled import in_one_direction
from ..scenes.potential import DIRECTIONS, Potential
from ..scenes.system import System, names_of_scene, system_of
from .named_families import PERMANENT

OMEGA, SIGMA = symbol("omega"), symbol("sigma")
SLOPES = ("dU_1", "dU_2", "dU_3")


@checked
def permanent_rotation(scene: System, direction: Sequence[Any] | None = None) -> Equilibrium:
    """Return every permanent rotation of a body in U(k1, k2, k3): ω = omega k, k fixed in body and space.

    The body turns so if and only if ∇U(k) = omega² Ik + omega l + sigma k. There omega and sigma stay, ∇U
    goes: if U is unspecified, these are dU_1, dU_2, dU_3; for a given U they are a parameter for each
    equation that is affine in one, as c1, c2, c3 of U = c1 k1 + c2 k2 + c3 k3. An equation without such a
    parameter is checked at every point asked for.

    Parameters
    ----------
    scene : System
        in U(k1, k2, k3)
    direction : sequence, shape (3,), or None
        k in numbers or parameters, a unit vector identically: (sin(a), 0, cos(a)), or stereographic();
        default: any, k1, k2, k3 are names of the family, and at numbers abs(k) = 1 is checked

    Returns
    -------
    Equilibrium
        a family in omega [1/T], sigma [M L²/T²], and the parameters of the direction

    Raises
    ------
    ScopeError
        the scene has no field, one in k3 alone, or an integral, and k is any direction
    EquilibriumError
        k is no unit vector, a name is that of a parameter of the scene, or U has no parameter to eliminate

    References
    ----------
    Staude, J. reine angew. Math. 113 (1894) 318-334; with a rotor derived in
    docs/explanation/derivations/amended-potential.md, section 2.

    Examples
    --------
    >>> import gyrostat as gs
    >>> body = gs.Gyrostat(gyrostatic_momentum=(0, 0, 0))
    >>> scene = gs.assemble(body, gs.general_potential())
    >>> rotation = gs.permanent_rotation(scene, ("1/3", "2/3", "2/3"))
    >>> for name, value in rotation.relations:
    ...     print(name, "=", value)
    dU_1 = I1*omega**2/3 + sigma/3
    dU_2 = 2*I2*omega**2/3 + 2*sigma/3
    dU_3 = 2*I3*omega**2/3 + 2*sigma/3
    """
    in_one_direction(scene.potential, "permanent_rotation")
    U = scene.potential
    if U is not None and U.axial and U.given and not scene.integrals:
        U = replace(U, variables=DIRECTIONS)               # for an asymmetric body a U like any other
        scene = system_of(scene.body, U)
    if U is None or U.axial:
        given = "none" if U is None else f"U = {U.expression}"
        instead = "principal_rotation" if U is None else "U(k1, k2, k3), general_potential, or inclined"
        raise ScopeError("permanent_rotation is for a body in a field U(k1, k2, k3), this scene has "
                         f"{given}: use {instead}")
    if scene.integrals and direction is None:
        raise ScopeError(f"the scene has the integral {scene.integrals[0]}, whose flow carries "
                         "each rotation into others: give a direction, or use inclined")
    k = scene.space.coordinates[3:] if direction is None else _given(direction)
    _names_apart(scene, k)
    along, rotor = scene.body.tensor * Matrix(k), scene.body.gyrostatic_momentum
    slopes = [OMEGA**2 * a + OMEGA * l + SIGMA * x for a, l, x in zip(along, rotor, k)]
    relations, domain = list(zip(map(symbol, SLOPES), slopes)), list[Expr]()
    if U.given:
        relations, domain = _solved(U, scene, k, relations)
    eliminated = tuple(name.name for name, _ in relations if not (U.given and jet(name.name)))
    if not eliminated:
        raise EquilibriumError(f"U = {U.expression} has no parameter that ∇U(k) determines: there is no "
                               "family; relative_equilibria finds the rotations at given numbers")
    return Equilibrium(PERMANENT.label, scene, (*(OMEGA * a for a in along), *k), tuple(relations),
                       tuple(domain), eliminated)


def _given(direction: Sequence[Any]) -> tuple[Expr, ...]:
    """Return a direction in numbers or parameters."""
    if len(direction) != 3:
        raise EquilibriumError(f"direction has {len(direction)} entries: give the three components of k")
    k = tuple(exact_expression(x, "direction") for x in direction)
    check_names(k, "direction", EquilibriumError, Use.ANGLE)
    return k


def _names_apart(scene: System, k: Sequence[Expr]) -> None:
    """Refuse a direction with a name that the scene has, too."""
    own, inside = names_of_scene(scene), set[Symbol]().union(*(x.free_symbols for x in k))
    if clash := sorted(map(str, own & inside)):
        raise EquilibriumError(f"{', '.join(clash)} is a name of the scene and one of the direction: write "
                               "another letter in one of the two, such as a1")


def _solved(U: Potential, scene: System, k: Sequence[Expr],
            slopes: Sequence[Relation]) -> tuple[list[Relation], list[Expr]]:
    """Solve each equation for a parameter of U, if there is one; return what is positive for that, too."""
    own = [s for s in U.parameters if s not in scene.body.symbols]
    found, domain = list[Relation](), list[Expr]()
    for name, slope in slopes:
        relation = (U.value(name).xreplace(dict(zip(U.variables, k))) - slope).xreplace(dict(found))
        inside = relation.free_symbols
        ways = [(s, way[0], relation.diff(s)) for s in own if s in inside and (way := affine(relation, s))]
        if not ways:
            found.append((name, slope))
            continue
        s, value, pivot = min(ways, key=lambda way: not way[2].is_number)
        found.append((s, value))
        if not pivot.is_number:
            domain.append(pivot**2)
    return found, list(dict.fromkeys(domain))
