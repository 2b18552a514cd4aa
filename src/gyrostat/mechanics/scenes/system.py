"""A scene as a Lie-Poisson system: space, Hamiltonian, integrals and equations of motion; assembles it."""
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from sympy import Add, Expr, ImmutableMatrix, S, Symbol

from ..._cached import cached_property
from ..._display import Shown
from ...algebra.reals.exact import evaluate, sign
from ...algebra.rings.matrices import applied, immutable
from ...arguments import checked
from ...errors import BodyError
from ...notation import Stored
from .body import Gyrostat
from .body_names import in_names_of, potential_of_body
from .coupled import CoupledPotential
from .equations import inserted, jet_field, jet_jacobian
from .integrals import check_independent, everywhere, in_coordinates, linear_integrals, texts_or_expressions
from .kind import Kind
from .lie_poisson import LiePoisson, lie_poisson
from .potential import Potential


@dataclass(frozen=True, repr=False)
class System(Shown, Stored):
    """A scene: a body and, if there is a field, a potential, in the smallest Lie-Poisson space for them.

    Parameters
    ----------
    body : Gyrostat
    space : LiePoisson
    hamiltonian : Expr
        h = ½ Σ πᵢ²/Iᵢ + U [M L²/T²]
    integrals : tuple of Expr
        functions F with {F, h} = 0 that are no Casimirs: those linear in π, then those given
    potential : Potential or None

    Raises
    ------
    StructureError
        an integral does not commute with the Hamiltonian, on abs(k) = 1, or on its level C1 = 0

    Examples
    --------
    >>> import gyrostat as gs
    >>> scene = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> scene.hamiltonian
    k3*m0 + pi3**2/(2*I3) + pi1**2/(2*I1) + pi2**2/(2*I1)
    >>> scene.integrals
    (pi3,)
    """

    body: Gyrostat
    space: LiePoisson
    hamiltonian: Expr
    integrals: tuple[Expr, ...]
    potential: Potential | None = None

    def __post_init__(self) -> None:
        if self.integrals:                                 # to refuse what is no integral
            _ = self.level_only

    @cached_property
    def kind(self) -> Kind:
        """What the scene is: a free body, a body of revolution in U(k3), …; found once."""
        if self.potential is None:
            return Kind.FREE
        if self.potential.axial and self.body.is_of_revolution():
            return Kind.REVOLUTION
        return self.potential.kind

    @property
    def coupled(self) -> bool:
        """Whether it has two directions, or a term of the energy that is linear in π: a CoupledPotential."""
        return self.potential is not None and self.potential.coupled

    @property
    def unspecified(self) -> bool:
        """Whether U is an unspecified function, of which only derivatives at a point are known."""
        return self.potential is not None and not self.potential.given

    @cached_property
    def level_only(self) -> tuple[Expr, ...]:
        """The integrals that are conserved only where C1 = M·k = 0."""
        return tuple(F for F in self.integrals
                     if not everywhere(F, self.space, self.hamiltonian, self.coupled))

    @cached_property
    def linear_integrals(self) -> tuple[Expr, ...]:
        """The integrals linear in π, whose flow is a symmetry; every one of them is found."""
        return tuple(F for F in self.integrals if not any(self.space.hessian(F)))

    @property
    def given_integrals(self) -> tuple[Expr, ...]:
        """The integrals that were given."""
        return self.integrals[len(self.linear_integrals):]

    @checked
    def integrals_at(self, state: Sequence[Expr]) -> tuple[Expr, ...]:
        """Return the integrals that are conserved on the level of the Casimirs of a state.

        Parameters
        ----------
        state : sequence of Expr, shape (n,)
            exact numbers

        Returns
        -------
        tuple of Expr
        """
        if self.level_only and sign(self.space.casimirs[0], dict(zip(self.space.coordinates, state))) != 0:
            return tuple(F for F in self.integrals if F not in self.level_only)
        return self.integrals

    def vector_field(self) -> ImmutableMatrix:
        """Return ẋ = B ∇h, one component for each coordinate.

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
        return ImmutableMatrix(inserted(self.potential, self.jet_field.flat()))

    @cached_property
    def energy_gradient(self) -> ImmutableMatrix:
        """The gradient ∇h in the coordinates and the jet of U: ωᵢ = πᵢ/Iᵢ, then ∇U."""
        if self.coupled:
            return self.space.gradient(self.hamiltonian)
        rates = applied(self.body.inverse.tolist(), self.space.coordinates[:3])
        slopes = self.potential.gradient() if self.potential else ()
        return immutable([[entry] for entry in (*rates, *slopes)], 1)

    @cached_property
    def energy_hessian(self) -> ImmutableMatrix:
        """The Hessian D²h in the coordinates and the jet of U."""
        if self.coupled:
            return self.space.hessian(self.hamiltonian)
        if self.potential is None:
            return self.body.inverse
        none = (S.Zero,) * 3
        rows = [self.potential.following(d) if isinstance(d, Symbol) else none
                for d in self.potential.gradient()]
        return immutable([*((*row, *none) for row in self.body.inverse.tolist()),
                          *((*none, *row) for row in rows)], 6)

    @cached_property
    def jet_field(self) -> ImmutableMatrix:
        """The field B ∇h in coordinates and jet of U, one coefficient for each product of coordinates."""
        return jet_field(self.space, tuple(self.energy_gradient.flat()))

    @cached_property
    def jet_jacobian(self) -> ImmutableMatrix:
        """The derivative of the field along the coordinates, dU differentiated to d2U."""
        if self.coupled:
            return jet_jacobian(self.jet_field, self.space.coordinates, ())
        slopes = self.potential.gradient() if self.potential else ()
        following = [(d, self.potential.following(d)) for d in slopes
                     if self.potential and isinstance(d, Symbol)]
        return jet_jacobian(self.jet_field, self.space.coordinates, tuple(following))


@checked
def assemble(body: Gyrostat, potential: Potential | None = None,
             integrals: Sequence[Expr | str] = ()) -> System:
    """Return the scene of a body: on so(3)* without a potential, on e(3)* with one.

    The moments and the gyrostatic momentum of the body are inserted into a potential that names them.

    Parameters
    ----------
    body : Gyrostat
    potential : Potential or None
    integrals : sequence of Expr or str
        functions F of pi1, pi2, pi3 (or M1, M2, M3), k1, k2, k3 and the parameters of the scene with
        {F, h} = 0, which is proved, on abs(k) = 1, or where C1 = 0 only; polynomials in π, no Casimirs

    Returns
    -------
    System
        with the integrals linear in π that it has, π3 for a body of revolution in U(k3), and those given

    Raises
    ------
    ScopeError
        the potential is written for a body of revolution, and this is none
    StructureError
        an integral is none, is constant or has other names, or follows from what is known

    Examples
    --------
    >>> import gyrostat as gs
    >>> gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential()).integrals
    (pi3,)
    >>> body, field = gs.Gyrostat((1, 2, 3), (0, 0, 0)), gs.general_potential(0)
    >>> gs.assemble(body, field, integrals=["M1^2 + M2^2 + M3^2"]).integrals
    (pi1**2 + pi2**2 + pi3**2,)
    """
    if potential is not None:
        potential = potential_of_body(potential, body)
    scene = system_of(body, potential)
    for given in texts_or_expressions(integrals):
        F = in_coordinates(in_names_of(body, given), scene.space, body.gyrostatic_momentum,
                           names_of_scene(scene))
        check_independent(F, scene.space, (scene.hamiltonian, *scene.space.casimirs, *scene.integrals))
        scene = replace(scene, integrals=(*scene.integrals, F))
    return scene


def system_of(body: Gyrostat, potential: Potential | None, given: Sequence[Expr] = ()) -> System:
    """Return the scene of a body in a potential that has the names of the scene: nothing is inserted."""
    space = lie_poisson(potential.directions if potential else (), body.gyrostatic_momentum)
    if taken := sorted(map(str, body.symbols & set(space.coordinates))):
        raise BodyError(f"the body depends on {', '.join(taken)}, a component of a direction of this scene: "
                        "write another letter for a number of your own, such as a1")
    hamiltonian = body.kinetic_energy(space.coordinates[:3]) + (potential.expression if potential else 0)
    if isinstance(potential, CoupledPotential):
        hamiltonian += Add(*(b * p for b, p in zip(potential.drift, space.coordinates)))
    free = System(body, space, hamiltonian, (), potential)
    rates = free.jet_field.flat()[:3]
    rates = inserted(potential, rates) if potential else rates
    return replace(free, integrals=(*linear_integrals(space.coordinates, tuple(rates)), *given))


def at_numbers(scene: System, known: Mapping[Symbol, Expr]) -> System:
    """Return the scene with numbers, or other expressions, in place of its names."""
    potential = scene.potential
    field = potential and potential.changed(lambda e: e.xreplace(dict(known)))
    given = [F.xreplace(dict(known)) for F in scene.given_integrals]
    return system_of(scene.body.changed(lambda x: evaluate(x, known)), field,
                     [F for F in given if any(scene.space.hessian(F))])


def names_of_scene(scene: System) -> frozenset[Symbol]:
    """Return the symbols of the body and of U."""
    return scene.body.symbols.union(scene.potential.parameters if scene.potential else ())
