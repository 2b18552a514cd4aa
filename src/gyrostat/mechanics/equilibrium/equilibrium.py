"""Equilibria: points or families that are checked, when they are built, to satisfy their equations."""
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, TypeVar

from sympy import Expr, S, Symbol

from ..._cached import cached_property
from ..._display import Shown
from ...algebra.reals.exact import is_identically_zero, plain, sign
from ...errors import EquilibriumError, require
from ...notation import Stored, Use, jet
from ...registry import INTERNAL, use_of, why_refused
from ..scenes.coupled import CoupledPotential, Held
from ..scenes.equations import field_at, gradient_at
from ..scenes.potential import smooth_where_positive
from ..scenes.system import System
from .near_pole import NearPole, left_positive, near_pole, refuse_rough
from .relations import refuse_lengths, refuse_rate, replaced, residual_of

Relation = tuple[Symbol, Expr]
Derived = TypeVar("Derived")


@dataclass(frozen=True, repr=False)
class Equilibrium(Shown, Stored):
    """A point, or a family of points, where the field vanishes; that it does is checked here, once.

    Parameters
    ----------
    label : str
    system : System
    point : tuple of Expr, shape (n,)
        in the parameters of the family
    relations : tuple of (Symbol, Expr)
        inserted in this order; a derivative of U in them holds on the family
    domain : tuple of Expr
        positive on the family; the family is not claimed to exist elsewhere
    eliminated : tuple of str
        the names that relations express by the others; if they are given, they are checked

    Raises
    ------
    EquilibriumError
        a component of the field does not vanish; the message names it

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
    >>> gs.inclined(top).relations
    ((dU, -k3*omega**2*(I1 - I3) + l*omega),)
    """

    label: str
    system: System
    point: tuple[Expr, ...]
    relations: tuple[Relation, ...] = ()
    domain: tuple[Expr, ...] = ()
    eliminated: tuple[str, ...] = ()
    _carried = "_existence", "field_values", "constraints"

    def __post_init__(self) -> None:
        require(self.system, System, "the scene")
        if len(self.point) != (n := len(self.system.space.coordinates)):
            raise EquilibriumError(f"{self.label} has {len(self.point)} entries, the space has {n}: give "
                                   "one for each coordinate")
        moments = [*self.system.body.positive, *(value for name, value in self.relations if name.is_positive)]
        if impossible := [m for m in moments if not m.free_symbols and sign(m, {}) != 1]:
            raise EquilibriumError(f"a relation of {self.label} gives a moment or the like the value "
                                   f"{impossible[0]}: moments of inertia are positive; correct it")
        unknown = [m for m in (*moments, *self._inner_arguments()) if m.free_symbols and not m.is_positive
                   and m not in self.domain]
        object.__setattr__(self, "domain", (*self.domain, *dict.fromkeys(unknown)))
        names = {s.name for x in (*self.point, *dict(self.relations).values()) for s in x.free_symbols}
        if clash := sorted(name for name in names if name in INTERNAL or use_of(name) is Use.TIME):
            raise EquilibriumError(f"{self.label} depends on {why_refused(clash, names)}")
        object.__setattr__(self, "point", tuple(map(plain, self.point)))   # 0 and ±1, however they are spelt
        refuse_rate(self.label, field_at(self.system.space, self.energy_gradient, self.at_point), self.insert)
        if self.system.potential:
            self._check_direction()

    def _check_direction(self) -> None:
        """Check that k is a unit vector (the verbs refuse k = 0), the relations on U, that U is smooth."""
        if isinstance(self.system.potential, CoupledPotential):
            return self._check_held(self.system.potential.held)
        k, anywhere = self.point[3:], self.system.space.coordinates[3:]   # of names: checked at numbers
        length = sum((x**2 for x in k), S.NegativeOne)
        if any(k) and k != anywhere and (excess := residual_of(length, self.insert)):
            unknown = " (not proved to be 0)" if is_identically_zero(excess) is None else ""
            raise EquilibriumError(f"{self.label} has k = ({', '.join(map(str, k))}) with |k|² − 1 = {excess}"
                                   f"{unknown}: k is a direction, |k| = 1; divide it by its length")
        refuse_rough(self.label, self.system.potential, self.near_pole,
                     (*self.field_values, *self.constraints), self._inner_arguments())
        for residual in self.constraints:
            if not residual.free_symbols:
                what = "is not proved to be" if sign(residual, {}) is None else "is not"
                raise EquilibriumError(f"{self.label} {what} an equilibrium: a relation on the derivatives "
                                       f"of U is off by {residual}; correct the point, or U")

    def _check_held(self, held: Held) -> None:
        """Check that the directions have the lengths and the angle that the scene gives them."""
        refuse_lengths(self.label, ((c, value, self._placed(c)) for c, value in held), self.insert)

    def _inner_arguments(self) -> tuple[Expr, ...]:
        """Return what has to be positive for a given U to be smooth at the point: arguments of roots."""
        if not (potential := self.system.potential) or not potential.given:
            return ()
        found = map(self._placed, smooth_where_positive(potential.expression))
        return tuple(dict.fromkeys(map(self.insert, left_positive(self.near_pole, found))))

    @cached_property
    def energy_gradient(self) -> tuple[Expr, ...]:
        """The gradient ∇h at the point: ω, then ∇U."""
        scene = self.system
        return gradient_at(scene.energy_gradient.flat(), None if scene.coupled else scene.body, self.at_point)

    @cached_property
    def near_pole(self) -> NearPole | None:
        """U in powers of 1 ∓ k3, if k3 = ±1 and U(k3) has roots of what is 0 there; else None."""
        return near_pole(self.system.potential, plain(self.point[-1]))

    def _placed(self, expression: Expr) -> Expr:
        """Return an expression in k, at the point."""
        directions = self.system.space.coordinates[3:]
        return expression.xreplace(dict(zip(directions, self.point[3:])))

    @property
    def at(self) -> Expr:
        """The k3 at which the derivatives of an axial U are taken: 1, -1 or an expression."""
        return self.point[-1]

    def at_point(self, expression: Any) -> Any:
        """Return an expression or matrix in the coordinates and the jet of U, at the point of the family.

        Parameters
        ----------
        expression : Expr or ImmutableMatrix, any shape

        Returns
        -------
        Expr or ImmutableMatrix, of the same shape
        """
        return replaced(expression, self._found[0], self._place)

    def _place(self, name: Symbol) -> Expr:
        """Return a symbol at the point."""
        placed: Expr = name.xreplace(dict(zip(self.system.space.coordinates, self.point)))
        for derivative, value in self.relations:
            placed = placed.xreplace({derivative: value} if jet(derivative.name) else {})
        potential = self.system.potential
        return self.insert(placed) if potential and potential.given and not potential.axial else placed

    def insert(self, expression: Any) -> Any:
        """Return an expression with the values of a given U and of its derivatives at the point.

        After that the eliminated names are replaced by their values.

        Parameters
        ----------
        expression : Expr or ImmutableMatrix, any shape

        Returns
        -------
        Expr or ImmutableMatrix, of the same shape
        """
        return replaced(expression, self._found[1], self._value)

    def _value(self, name: Symbol) -> Expr:
        """Return a symbol with the values inserted."""
        value = self.insert_field(name)
        for eliminated, by_others in self.relations:
            if not jet(eliminated.name):
                value = value.xreplace({eliminated: by_others})
        return value

    def insert_field(self, expression: Any) -> Any:
        """Return an expression with the jet of a given U replaced by its values at the point.

        Parameters
        ----------
        expression : Expr or ImmutableMatrix, any shape

        Returns
        -------
        Expr or ImmutableMatrix, of the same shape
        """
        return replaced(expression, self._found[2], self._value_in_field)

    def _value_in_field(self, name: Symbol) -> Expr:
        """Return a symbol, or the derivative of a given U that it stands for."""
        potential = self.system.potential
        if not potential or not potential.given or not (order := jet(name.name)):
            return name
        near, value = self.near_pole, potential.value(name)
        return near.derivative(order[0]) if near else self._placed(value)

    @cached_property
    def _found(self) -> tuple[dict[Symbol, Expr], ...]:    # symbols at the point, inserted, of the field
        return {}, {}, {}

    def existence(self) -> tuple[Expr, ...]:
        """Return the domain in the parameters that are left: positive where the family exists."""
        return self._existence

    @cached_property
    def _existence(self) -> tuple[Expr, ...]:
        return tuple(map(self.insert, self.domain))

    @cached_property
    def field_values(self) -> tuple[Expr, ...]:
        """A given U, its slope and its curvature at the point; () if U is unspecified."""
        potential = self.system.potential
        if not potential or not potential.given:
            return ()
        if near := self.near_pole:                         # where nothing is asked of the curvature
            return self.insert(near.coefficient(0)), self.insert(near.derivative(1))
        first = [d for d in potential.gradient() if d]
        jets = [*first, *(d for s in first for d in potential.following(s) if d)]
        return tuple(self.insert(e) for e in (self._placed(potential.expression), *jets))

    @cached_property
    def constraints(self) -> tuple[Expr, ...]:
        """What has to vanish at given values: the relations that a given U does not satisfy by itself."""
        if not self.system.potential or not self.system.potential.given:
            return ()
        residuals = (residual_of(self.insert(name) - self.insert(value), self.insert)
                     for name, value in self.relations if jet(name.name))
        return tuple(residual for residual in residuals if residual is not None)

    def derived(self, verb: Callable[["Equilibrium"], Derived]) -> Derived:
        """Return what a verb derives from this equilibrium; it is derived when it is first asked for.

        Parameters
        ----------
        verb : callable
            of an equilibrium

        Returns
        -------
        Any
            what the verb returns
        """
        if verb not in self._derived:
            self._derived[verb] = verb(self)
        return self._derived[verb]

    @cached_property
    def _derived(self) -> dict[Callable[..., Any], Any]:
        return {}
