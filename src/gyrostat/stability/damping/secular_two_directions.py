"""Decides a body in the frame of two directions under internal damping, by its stiffness K.

The theorem is that of Kelvin, Tait and Chetaev; the exceptions, in which damping does not reach every motion,
are derived.
"""
from collections.abc import Mapping
from dataclasses import replace

from sympy import Expr, ImmutableMatrix, S, Symbol

from ..._cached import cached_property
from ...algebra.rings.polynomials import lowest_terms
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.families.circular_orbit import orbital_rate
from ...mechanics.scenes.kind import Kind
from ...mechanics.scenes.lie_poisson import hat
from ..criteria.orientation_form import orientation_form, rests_in_frame
from ..decision import Decision, undecided
from ..notion import Notion
from ..theorems.two_directions import on_curve
from .secular import Secular

DEGENERATE = "the second variation is degenerate, and terms of higher degree decide"


class SecularInFrame(Secular):
    """The second variation under internal damping, with two directions: K beside a form of the momenta.

    The form of the momenta is positive. Damping by the three components of the absolute rate ω reaches every
    motion of a body in a frame that does not turn. In an orbit it does unless the body, turned by a little as
    the normal turns, asks for no torque; in the gravity gradient that is so if t·In = 0 and n·In = r·Ir. With
    one direction a and a coupling it does unless a, carried along by the undisturbed rate, asks for no torque
    in any direction across it.

    References
    ----------
    As Secular; the exceptions are derived in docs/explanation/derivations/damping.md, section 5.
    """

    @cached_property
    def _torques(self) -> tuple[Expr, ...]:
        """What vanishes if the damping does not reach every motion."""
        eq = self.equilibrium
        if not rests_in_frame(eq):
            # () counts as an exception: whether it reaches all of a tilted body of revolution is not known
            return () if self.variation.modulo else _torques_across(eq)
        return _torques_in_orbit(eq) if eq.system.kind is Kind.ORBIT else (S.One,)

    @property
    def _rest(self) -> Expr:
        return S.One

    def _degenerate(self, numbers: Mapping[Symbol, Expr], reached: bool) -> Decision:
        found = on_curve(self.equilibrium, numbers)
        return undecided(DEGENERATE) if found is None else replace(found, notion=Notion.SECULAR, growing=0)


def _torques_in_orbit(eq: Equilibrium) -> tuple[Expr, ...]:
    """Return what is left of I θ̈ + g × θ̇ + K θ if the body turns as the normal does.

    Then ω stays, and θ̇ = θ × ω0 n.
    """
    form, turn = orientation_form(eq), orbital_rate(eq.system) * hat(eq.point[3:6])
    left = (form.inertia * turn**2 - hat(form.gyroscopic) * turn + form.stiffness) * turn
    return tuple(e for x in left.flat() if x != 0 and (e := lowest_terms(eq.insert(x))) != 0)


def _torques_across(eq: Equilibrium) -> tuple[Expr, ...]:
    """Return what is left of π̇ if a turns by a little across itself and ω stays.

    Then δπ = −IB δa, with the coupling B, and δȧ = δa × ω.
    """
    def placed(rows: list[list[Expr]]) -> ImmutableMatrix:
        return ImmutableMatrix([[eq.at_point(x) for x in row] for row in rows])

    energy, a = eq.system.energy_hessian.tolist(), ImmutableMatrix(eq.point[3:])
    rate = placed(eq.system.energy_gradient.tolist())
    drift, curved = (placed([row[3:] for row in part]) for part in (energy[:3], energy[3:]))
    momentum = -eq.system.body.tensor * drift              # δπ for δa
    turn, torque = hat(rate[:3, 0]), hat(rate[3:, 0])
    left = momentum * turn - turn * momentum - torque + hat(a) * (curved + drift.T * momentum)
    return tuple(e for x in (left * hat(a)).flat() if x != 0 and (e := lowest_terms(eq.insert(x))) != 0)
