"""Derives what a formula may name about permanent rotations in a field."""
from collections.abc import Mapping
from typing import Any

from sympy import Expr, Matrix, S, eye

from ..._cached import cached_property
from ...algebra.rings.polynomials import lowest_terms
from ...equilibria.curves.amended_potential import amended_potential
from ...equilibria.curves.staude import staude_cone
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.scenes.potential import DIRECTIONS
from ...mechanics.scenes.system import System
from ...notation import symbol
from ...stability.criteria.amended_form import adjugate, dot
from .kinematics import Later


def cone_names(system: System) -> Mapping[str, Any]:
    """Return Staude's cone, 0 in the directions of rotations, and omega² along it; with a rotor, omega."""
    return {"staude_cone": Later(lambda: staude_cone(system).polynomial),
            "staude_rate": Later(lambda: staude_cone(system).rate)}


def amended_names(eq: Equilibrium) -> Mapping[str, Any]:
    """Return trace and determinant of the amended potential's second variation, on the plane across k."""
    curved = _Curved(eq)
    return {"amended_trace": Later(lambda: curved.trace),
            "amended_determinant": Later(lambda: curved.determinant)}


class _Curved:
    """The form D²U_c − (k·∇U_c) on the sphere abs(k) = 1, at an equilibrium."""

    def __init__(self, eq: Equilibrium):
        self.eq, self.k = eq, Matrix(eq.point[3:])

    @cached_property
    def matrix(self) -> Matrix:
        """Its matrix: the part of U by its jet, the rest of U_c by derivatives at constant C1."""
        system = self.eq.system
        assert system.potential is not None
        twist = amended_potential(system).expression - system.potential.expression
        slopes = Matrix([U + twist.diff(x) for U, x in zip(system.potential.gradient(), DIRECTIONS)])
        bent = Matrix([[(system.potential.following(d)[j] if d else S.Zero) + twist.diff(x, y)
                        for j, y in enumerate(DIRECTIONS)]
                       for d, x in zip(system.potential.gradient(), DIRECTIONS)])
        level = (Matrix(self.eq.point[:3]) + Matrix(system.body.gyrostatic_momentum)).dot(self.k)

        def here(value: Expr) -> Expr:
            return self.eq.at_point(value).xreplace({symbol("C1"): level})

        radial = self.k.dot(slopes.applyfunc(here))
        return (bent.applyfunc(here) - radial * eye(3)).applyfunc(lowest_terms)

    @cached_property
    def trace(self) -> Expr:
        """The trace on the plane across k."""
        return lowest_terms(self.matrix.trace() - self.k.dot(self.matrix * self.k))

    @cached_property
    def determinant(self) -> Expr:
        """The determinant on the plane across k."""
        return lowest_terms(dot(self.k, [dot(row, self.k) for row in adjugate(self.matrix.tolist())]))
