"""Inserts the moments and the rotor of a body into what is written in I1, I2, I3, l or l1, l2, l3."""
from collections.abc import Mapping
from types import MappingProxyType

from sympy import Expr, Symbol

from ...errors import ScopeError
from ...notation import components, symbol
from .body import Gyrostat
from .potential import Potential

_MOMENTS = components("I")


def in_names_of(body: Gyrostat, expression: Expr, tensor: Mapping[Symbol, Expr] = MappingProxyType({})
                ) -> Expr:
    """Return the expression with the moments and the gyrostatic momentum of the body for their names.

    They are inserted at once with those of a tensor, since what is inserted has names too. If the rotor has
    the name l along another axis, l is that.
    """
    # asked for only if they occur: a full tensor has no principal moments
    names = dict(zip(_MOMENTS, body.moments)) if expression.free_symbols & {*_MOMENTS} else {}
    names |= zip(components("l"), body.gyrostatic_momentum)
    if symbol("l") not in body.symbols:
        names |= {symbol("l"): body.gyrostatic_momentum[2]}
    names |= tensor
    return expression.xreplace({name: value for name, value in names.items() if name != value})


def potential_of_body(potential: Potential, body: Gyrostat) -> Potential:
    """Return the potential with this body's moments and gyrostatic momentum inserted."""
    if potential.revolution and body.moments[0] != body.moments[1]:
        raise ScopeError(f"U = {potential.expression} is written for I1 = I2, the body has inertia = "
                         f"{body.moments}: "
                         "give its own U(k1, k2, k3) with general_potential")
    if potential.coupled:                                  # I11, I12, … too, in any axes
        gravitating = body.gravitating
        tensor = {symbol(f"I{i}{j}"): gravitating[i - 1, j - 1] for i in (1, 2, 3) for j in (1, 2, 3)}
        potential = potential.changed(lambda e: in_names_of(body, e, tensor))
        return potential if gravitating == body.tensor else potential.with_free_rotors()
    if in_names_of(body, potential.expression) == potential.expression:
        return potential
    return potential.changed(lambda e: in_names_of(body, e))
