"""System: a space, a Hamiltonian and the integrals found; its equations of motion; assemble."""
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

from sympy import Add, Expr, ImmutableMatrix, Mul, Symbol, diag

from ..algebra.exact import evaluate
from ..algebra.matrices import null_space
from ..algebra.polynomials import Ring, derivatives
from ..errors import ScopeError, StructureError, require
from ..kept import cached_property
from ..notation import Stored, jet, symbol
from ..shown import Shown
from .body import Gyrostat
from .liepoisson import LiePoisson, lie_poisson
from .potential import Potential


@dataclass(frozen=True, repr=False)
class System(Shown, Stored):
    """A scene: a body and, if there is a field, a potential.

    In the smallest Lie-Poisson space that holds them.

    Parameters
    ----------
    body : Gyrostat
    space : LiePoisson
    hamiltonian : Expr
        h = ½ Σ πᵢ²/Iᵢ + U [M L²/T²]
    integrals : tuple of Expr
        functions F with {F, h} = 0 that are no Casimirs, linear in π
    potential : Potential or None

    Raises
    ------
    StructureError
        an integral does not commute with the Hamiltonian

    Examples
    --------
    >>> import gyrostat as gs
    >>> scene = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> scene.hamiltonian, scene.integrals
    (k3*m0 + pi3**2/(2*I3) + pi1**2/(2*I1) + pi2**2/(2*I1), (pi3,))
    """

    body: Gyrostat
    space: LiePoisson
    hamiltonian: Expr
    integrals: tuple[Expr, ...]
    potential: Potential | None = None

    def __post_init__(self) -> None:
        for integral in self.integrals:
            if rate := self.space.bracket(integral, self.hamiltonian):
                raise StructureError(f"{integral} is not an integral: its bracket with the Hamiltonian is "
                                     f"{rate}, not 0")

    def vector_field(self) -> ImmutableMatrix:
        """ẋ = B ∇h, one component for each coordinate.

        Returns
        -------
        ImmutableMatrix, shape (n, 1)
            π̇ [M L²/T²], then k̇ [1/T]

        References
        ----------
        Vera & Viguera (2003), §2.

        Examples
        --------
        >>> import gyrostat as gs
        >>> gs.assemble(gs.symmetric_gyrostat()).vector_field()[2]
        0
        """
        if self.potential is None:
            return self.jet_field
        return ImmutableMatrix(_rates(self.potential, self.jet_field.flat()))

    @cached_property
    def energy_gradient(self) -> ImmutableMatrix:
        """∇h in the coordinates and the jet of U: ωᵢ = πᵢ/Iᵢ, then ∇U."""
        rates = self.body.inverse * ImmutableMatrix(self.space.coordinates[:3])
        return ImmutableMatrix([*rates, *(self.potential.gradient() if self.potential else ())])

    @cached_property
    def energy_hessian(self) -> ImmutableMatrix:
        """D²h in the coordinates and the jet of U."""
        kinetic = self.body.inverse
        if self.potential is None:
            return ImmutableMatrix(kinetic)
        rows = [self.potential.following(d) if isinstance(d, Symbol) else (0, 0, 0)
                for d in self.potential.gradient()]
        return ImmutableMatrix(diag(kinetic, ImmutableMatrix(rows)))

    @cached_property
    def jet_field(self) -> ImmutableMatrix:
        """B ∇h in the coordinates and the jet of U, one coefficient for each product of coordinates."""
        return _jet_field(self.space, tuple(self.energy_gradient.flat()))

    @cached_property
    def jet_jacobian(self) -> ImmutableMatrix:
        """Derivative of the field along the coordinates, dU differentiated to d2U."""
        slopes = self.potential.gradient() if self.potential else ()
        following = [(d, self.potential.following(d)) for d in slopes
                     if self.potential and isinstance(d, Symbol)]
        return _jet_jacobian(self.jet_field, self.space.coordinates, tuple(following))


def assemble(body: Gyrostat, potential: Potential | None = None) -> System:
    """The scene of a body: on so(3)* without a potential, on e(3)* with one.

    The moments and the gyrostatic momentum of the body are inserted into a potential that names them.

    Parameters
    ----------
    body : Gyrostat
    potential : Potential or None

    Returns
    -------
    System
        with the integrals linear in π that it has: π3 for a body of revolution in U(k3)

    Raises
    ------
    ScopeError
        the potential is written for a body of revolution, and this is none

    Examples
    --------
    >>> import gyrostat as gs
    >>> gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential()).integrals
    (pi3,)
    """
    require(body, Gyrostat, "the body")
    if potential is not None:
        require(potential, Potential, "the potential")
        potential = _of_body(potential, body)
    return system_of(body, potential)


def system_of(body: Gyrostat, potential: Potential | None) -> System:
    """The scene of a body in a potential whose names are those of the scene: nothing is inserted."""
    space = lie_poisson(("k",) if potential else (), body.gyrostatic_momentum)
    hamiltonian = body.kinetic_energy(space.coordinates[:3]) + (potential.expression if potential else 0)
    free = System(body, space, hamiltonian, (), potential)
    rates = free.jet_field.flat()[:3]
    given = _rates(potential, rates) if potential else rates
    return replace(free, integrals=_linear_integrals(space.coordinates, tuple(given)))


def at_numbers(scene: System, known: Mapping[Symbol, Expr]) -> System:
    """The scene with numbers, or other expressions, in place of its names."""
    potential = scene.potential
    field = potential and replace(potential, expression=potential.expression.xreplace(dict(known)))
    return system_of(scene.body.changed(lambda x: evaluate(x, known)), field)


def names_of_scene(scene: System) -> set[Symbol]:
    """The symbols of the body and of U."""
    return scene.body.symbols.union(scene.potential.parameters if scene.potential else ())


def _of_body(potential: Potential, body: Gyrostat) -> Potential:
    """The potential with this body's moments and gyrostatic momentum inserted."""
    if potential.revolution and body.moments[0] != body.moments[1]:
        raise ScopeError(f"U = {potential.expression} is written for I1 = I2, the body has inertia = "
                         f"{body.moments}: "
                         "give its own U(k1, k2, k3) with general_potential")
    own = [symbol(f"I{i}") for i in (1, 2, 3)]
    # a tensor has none
    names = dict(zip(own, body.moments)) if potential.expression.free_symbols & {*own} else {}
    names |= {symbol(f"l{i}"): rotor for i, rotor in zip((1, 2, 3), body.gyrostatic_momentum)}
    names |= {symbol("l"): body.gyrostatic_momentum[2]}
    inserted = {name: value for name, value in names.items() if name != value
                and name in potential.expression.free_symbols}
    return (
        Potential(potential.variables, potential.expression.xreplace(inserted), potential.revolution)
        if inserted
        else potential
    )


@lru_cache(maxsize=64)
def _linear_integrals(coordinates: tuple[Symbol, ...], rates: tuple[Expr, ...]) -> tuple[Expr, ...]:
    """Every combination c·π, c constant, whose rate c·π̇ vanishes identically."""
    ring = Ring([*rates, *coordinates])
    (row,), _ = ring.matrix([list(rates)])
    equations: dict[tuple[int, ...], list[Any]] = {}
    for column, rate in enumerate(row):
        for kind, coefficient in ring.coefficients(rate, set(coordinates)).items():
            equations.setdefault(kind, [ring.zero] * 3)[column] = coefficient
    basis = null_space(ring, list(equations.values()),
                       lambda j, entry: (not entry.is_constant(), len(entry)), 3)
    return tuple(Add(*(Mul(ring.expression(c), p) for c, p in zip(vector, coordinates)))
                 for _, vector in basis)


def _rates(potential: Potential, rates: Sequence[Expr]) -> list[Expr]:
    """Rates in the jet of U, with what its symbols stand for."""
    values = {d: potential.value(d) for d in set().union(*(r.free_symbols for r in rates)) if jet(d.name)}
    return [rate.xreplace(values) for rate in rates]


# the jet is the same of every U: what it leaves open is derived once for a body
@lru_cache(maxsize=64)
def _jet_field(space: LiePoisson, energy_gradient: tuple[Expr, ...]) -> ImmutableMatrix:
    return ImmutableMatrix([_collected(component, space.coordinates)
                            for component in (space.tensor * ImmutableMatrix(energy_gradient)).flat()])


@lru_cache(maxsize=64)
def _jet_jacobian(field: ImmutableMatrix, coordinates: tuple[Symbol, ...],
                  following: tuple[tuple[Symbol, tuple[Expr, ...]], ...]) -> ImmutableMatrix:
    rows = []
    for rate in field.flat():
        row = derivatives(rate, (*coordinates, *(d for d, _ in following)))
        for (_, inner), outer in zip(following, row[len(coordinates):]):
            row[3:6] = [entry + outer * slope for entry, slope in zip(row[3:6], inner)]
        rows.append(row[:len(coordinates)])
    return ImmutableMatrix(rows)


def _collected(component: Expr, coordinates: tuple[Symbol, ...]) -> Expr:
    """The component with one coefficient for each product of coordinates, as in (I1 − I3)/(I1 I3) π2 π3."""
    ring = Ring([component])
    top, bottom = ring.fraction(component)
    return Add(*(Mul(ring.quotient(coefficient, bottom), ring.monomial(kind))
                 for kind, coefficient in ring.coefficients(top, set(coordinates)).items()))
