"""Fields in one or two directions with a term linear in π: h = T + β(a)·π + U(a)."""
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any, ClassVar

from sympy import Add, Expr, S, Symbol

from ...algebra.text.numbers import exact_expression
from ...arguments import checked, several
from ...errors import PotentialError, ScopeError
from ...notation import Use, components
from ...registry import check_names
from .kind import Kind
from .lie_poisson import lie_poisson
from .potential import Potential, derivative_along, expression_of

Held = tuple[tuple[Expr, Expr], ...]


@dataclass(frozen=True)
class CoupledPotential(Potential):
    """U as a function of one or two directions, always given, and β, linear in them: h = T + β·π + U.

    The rate of the body against the frame of the directions is Aπ + β, with A the inverse of its tensor. In
    the frame of an orbit, which turns at the rate ω0 about n, β = −ω0 n (circular_orbit). If the body is in a
    fluid, β comes from the mass that it moves, and the frame does not turn: internal damping
    takes the frame of every β that is not that of an orbit as one that does not turn.

    Parameters
    ----------
    variables : tuple of Symbol, shape (3,) or (6,)
        the components of the directions
    expression : Expr
        U [M L²/T²]
    revolution : bool
        False: of any body
    drift : tuple of Expr, shape (3,)
        β [1/T]
    held : tuple of (Expr, Expr)
        Casimirs and their values, such as n·n = 1

    Examples
    --------
    >>> import gyrostat as gs
    >>> orbit = gs.circular_orbit()
    >>> orbit.directions, orbit.drift
    (('n', 'r'), (-n1*omega0, -n2*omega0, -n3*omega0))
    """

    drift: tuple[Expr, Expr, Expr] = (S.Zero, S.Zero, S.Zero)
    held: Held = ()
    kind: ClassVar[Kind] = Kind.COUPLED

    def _check_names(self) -> None:
        """Refuse names that are no parameters; an orbit has the rotor in it, which assemble inserts."""
        check_names(self.parameters, "the potential", PotentialError, Use.ROTOR)

    @property
    def parameters(self) -> tuple[Symbol, ...]:
        """The symbols of U and β other than the directions, by name."""
        names = self.expression.free_symbols.union(*(b.free_symbols for b in self.drift))
        return tuple(sorted(names - set(self.variables), key=str))

    @checked
    def changed(self, change: Callable[[Expr], Expr]) -> "CoupledPotential":
        """Return the potential with every expression changed, for example by inserting numbers.

        Parameters
        ----------
        change : callable

        Returns
        -------
        CoupledPotential
        """
        first, second, third = map(change, self.drift)
        return replace(self, expression=change(self.expression), drift=(first, second, third))

    def gradient(self) -> tuple[Expr, ...]:
        """Return ∇U, one entry for each component of the directions."""
        return self.following(self.expression)

    @checked
    def following(self, derivative: Expr) -> tuple[Expr, ...]:
        """Return the derivatives of an entry of ∇U along the components of the directions.

        Parameters
        ----------
        derivative : Expr

        Returns
        -------
        tuple of Expr
        """
        return tuple(derivative_along(derivative, x) for x in self.variables)


@checked
def coupled_potential(expression: Any, directions: Sequence[str] = ("k", "e"),
                      drift: Sequence[Any] = (0, 0, 0),
                      held: Sequence[tuple[Any, Any]] = ()) -> CoupledPotential:
    """Return a potential in one or two directions, with a term β·π of the energy.

    Parameters
    ----------
    expression : Expr, str, number or callable
        U in the components, k1, k2, k3, e1, e2, e3, and real parameters [M L²/T²], or a text of it; or a
        function of them
    directions : sequence of str
        one or two names
    drift : sequence, shape (3,)
        β, linear in the directions [1/T]
    held : pairs (Casimir, value)
        what is known of a·a, a·b, b·b: (k1² + k2² + k3², 1) if k is a unit vector

    Returns
    -------
    CoupledPotential

    Raises
    ------
    PotentialError
        U or β depends on other coordinates, or β is not linear in the directions
    ScopeError
        three directions, or one whose components have another meaning

    References
    ----------
    Derived; two constant fields: Bogoyavlensky, Comm. Math. Phys. 95 (1984) 307-315.

    Examples
    --------
    >>> import gyrostat as gs
    >>> k1, e2 = gs.symbol("k1"), gs.symbol("e2")
    >>> body = gs.Gyrostat(gyrostatic_momentum=(0, 0, 0))
    >>> scene = gs.assemble(body, gs.coupled_potential(-k1 - 2 * e2))
    >>> scene.vector_field()[3:6]
    [k2*pi3/I3 - k3*pi2/I2, -k1*pi3/I3 + k3*pi1/I1, k1*pi2/I2 - k2*pi1/I1]
    """
    variables = lie_poisson(directions).coordinates[3:]
    if not variables:
        raise PotentialError("a coupled potential needs one or two directions: give directions=('k', 'e')")
    U = exact_expression(expression_of(expression, variables), "U")
    first, second, third = (exact_expression(b, "drift") for b in several(drift, "drift", 3))
    for entry in (first, second, third):
        slopes = [entry.diff(x) for x in variables]
        left = entry - Add(*(x * slope for x, slope in zip(variables, slopes)))
        if left.expand() != 0 or any(slope.free_symbols & {*variables} for slope in slopes):
            raise PotentialError(f"drift = ({first}, {second}, {third}): {entry} is not linear in "
                                 f"{', '.join(map(str, variables))}: β is a matrix times a "
                                 "direction; give it so")
    check_names({s for e in (U, first, second, third) for s in e.free_symbols} - {*variables},
                f"U = {U}", PotentialError)
    pairs = tuple((exact_expression(c, "a Casimir"), exact_expression(v, "its value")) for c, v in held)
    return CoupledPotential(variables, U, False, (first, second, third), pairs)


def in_one_direction(potential: Potential | None, what: str) -> None:
    """Refuse two directions, and a term β·π, for what is asked of a field U(k) that is fixed in space."""
    if isinstance(potential, CoupledPotential):
        has = (f"the directions {' and '.join(potential.directions)}" if len(potential.directions) > 1
               else f"a coupling β = ({', '.join(map(str, potential.drift))})")
        raise ScopeError(f"{what} is for a body in a field of one direction without coupling, and the scene "
                         f"has {has}: use its equilibria with analyze, spectrum, stabilizing_set and charts, "
                         "and its motion")


def unit_and_orthogonal(directions: Sequence[str]) -> Held:
    """Return the Casimirs that make each direction a unit vector, two of them at right angles."""
    vectors = list(map(components, directions))
    return tuple((Add(*(x * y for x, y in zip(a, b))), S.One if a is b else S.Zero)
                 for n, a in enumerate(vectors) for b in vectors[n:])
