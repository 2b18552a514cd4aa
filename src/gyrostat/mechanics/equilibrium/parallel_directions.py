"""Makes one direction of two that are parallel: the scene of the motions in which they stay so."""
from sympy import Expr, ImmutableMatrix, S

from ...algebra.rings.polynomials import lowest_terms
from ...arguments import checked
from ...errors import ScopeError
from ..scenes.coupled import CoupledPotential
from ..scenes.potential import DIRECTIONS, Potential
from ..scenes.system import system_of
from .derived_once import once
from .equilibrium import Equilibrium
from .relations import residual_of


@checked
def parallel_directions(eq: Equilibrium) -> Equilibrium:
    """Return the same equilibrium in the scene of one direction, if its two directions are parallel.

    They are carried along by one rotation: parallel once, they stay so, b = c a with a constant c. These
    motions are those of a body in the one direction a. What is unstable among them is unstable; what is
    stable need not be so against other motions, in which the angle of the directions is small and not 0.

    Parameters
    ----------
    eq : Equilibrium
        in two directions, parallel at the point: a vehicle that rises or sinks, two fields that pull together

    Returns
    -------
    Equilibrium
        of U(k) if there is no coupling and k is a unit vector, else in the direction of the scene

    Raises
    ------
    ScopeError
        the directions are not two, or not parallel

    References
    ----------
    Leonard & Marsden, Physica D 105 (1997) 130-162, for the singular orbits.

    Examples
    --------
    >>> import gyrostat as gs
    >>> vehicle = gs.underwater_vehicle(weight=(0, 0, gs.symbol("m0")))
    >>> rising = gs.steady_motion(vehicle, (0, 0, gs.symbol("p0")), (0, 0, 1))
    >>> gs.parallel_directions(rising).system.space.casimirs
    (k1*pi1 + k2*pi2 + k3*pi3, k1**2 + k2**2 + k3**2)
    """
    found = parallel(eq)
    if found is None:
        raise ScopeError(f"{eq.label} has no two directions that are parallel: analyze(eq) decides it in its "
                         "own scene")
    return found


@once
def parallel(eq: Equilibrium) -> Equilibrium | None:
    """Return the same equilibrium in one direction; None if there are no two directions that are parallel."""
    potential = eq.system.potential
    if not isinstance(potential, CoupledPotential) or len(eq.point) != 9:
        return None
    vectors = [ImmutableMatrix(eq.point[i:i + 3]) for i in (3, 6)]
    a, b = vectors
    if not any(vectors[0]) and not any(vectors[1]) or any(residual_of(x, eq.insert) for x in a.cross(b)):
        return None
    squares = [lowest_terms(eq.insert(v.dot(v))) if any(v) else S.Zero for v in vectors]
    n = 0 if squares[0] == 1 or squares[0] and squares[1] != 1 else 1     # of length 1 if one is
    own, other = (potential.variables[3 * i:3 * i + 3] for i in (n, 1 - n))
    ratio = lowest_terms(a.dot(b) / squares[n]) if any(vectors[1 - n]) else S.Zero
    unit = squares[n] == 1
    names = DIRECTIONS if unit and not any(potential.drift) else own
    change = {**dict(zip(other, (ratio * x for x in names))), **dict(zip(own, names))}

    def along(entry: Expr) -> Expr:
        return entry.xreplace(change).expand()

    U, drift = along(potential.expression), tuple(map(along, potential.drift))
    held = tuple((c.xreplace(change), value) for c, value in potential.held
                 if c.free_symbols <= {*own})
    field = (Potential(names, U) if names is DIRECTIONS
             else CoupledPotential(own, U, False, drift, held))
    place = eq.point[:3] + tuple(vectors[n])
    return Equilibrium(eq.label, system_of(eq.system.body, field), place, eq.relations, eq.domain,
                       eq.eliminated)
