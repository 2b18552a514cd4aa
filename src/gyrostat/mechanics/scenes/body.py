"""The gyrostat: inertia, gyrostatic momentum, kinetic energy."""
from collections.abc import Callable, Sequence
from dataclasses import InitVar, dataclass, replace
from typing import Any

from sympy import Add, Expr, ImmutableMatrix, Rational, Symbol

from ..._cached import cached_property
from ..._display import Shown
from ...algebra.reals.exact import plain, rationalised, sign_of_constant
from ...algebra.rings.matrices import adjugate, diagonal, immutable, leading_minors
from ...algebra.text.numbers import exact_expression, shown
from ...algebra.text.quantities import not_mixed
from ...algebra.text.tensor_entries import as_first_written, entries_of, tensor_of
from ...arguments import checked, several
from ...errors import BodyError, ScopeError, brief
from ...notation import Stored, Use, components, symbol
from ...registry import check_names

PRODUCTS = ("negative", "positive")                    # of inertia: −∫ xy dm, ∫ xy dm


@dataclass(frozen=True)
class Gyrostat(Shown, Stored):
    """A rigid body with a rotor whose relative angular momentum l is constant, in axes fixed in the body.

    Each entry is a number (made exact) or a SymPy expression; the default is the general body, in symbols.
    Arrays are sequences too, and a diagonal matrix has its moments on the diagonal. With a full tensor
    everything is given, and answered, in its axes; what needs principal moments says so. Texts may have
    units, "120 kg m^2", then all of them; the body is in SI. One text may be all entries, with one unit:
    "62.1, 58, 30 kg m^2", "[[62.1, 1.3, -0.8], [1.3, 58, 0.2], [-0.8, 0.2, 30]] kg m^2".

    Parameters
    ----------
    inertia : (I1, I2, I3), or matrix, shape (3, 3), or text
        principal moments of the locked body, or its inertia tensor [M L²]; positive
    gyrostatic_momentum : (l1, l2, l3), or text
        angular momentum of the rotor relative to the body [M L²/T]
    products : str
        the sign of the products of inertia as they are given: "negative" if they are the entries of the
        tensor, I12 = −∫ x1 x2 dm; "positive" if they are the integrals ∫ x1 x2 dm, as CAD programs often
        print them (SolidWorks: positive tensor notation), which the tensor has with a minus

    Raises
    ------
    BodyError
        a moment is not positive, or there are not three of each; the tensor is not symmetric or not positive

    Examples
    --------
    >>> import gyrostat as gs
    >>> body = gs.Gyrostat(inertia=(2, 2, 1), gyrostatic_momentum=(0, 0, 0))
    >>> body.kinetic_energy((gs.symbol("pi1"), 0, gs.symbol("pi3")))
    pi1**2/4 + pi3**2/2
    >>> printed = "[[5, 1, 0], [1, 4, 0], [0, 0, 3]] kg m^2"
    >>> gs.Gyrostat(printed, "0, 0, 2 N m s", products="positive").tensor[0, 1]
    -1
    """

    inertia: Sequence[Any] = components("I")
    gyrostatic_momentum: Sequence[Any] = components("l")
    products: InitVar[str] = "negative"

    def __post_init__(self, products: str) -> None:
        if not isinstance(products, str) or products not in PRODUCTS:
            raise BodyError(f"products = {brief(products)}: give negative if the products of inertia are the "
                            "entries of the tensor, −∫ xy dm, or positive if they are the integrals ∫ xy dm")
        given = {field: entries_of(getattr(self, field), field)
                 for field in ("gyrostatic_momentum", "inertia")}
        not_mixed((field, x) for field, entries in given.items() for x in entries)
        rotor, inertia = ([rationalised(exact_expression(x, field)) for x in entries]
                          for field, entries in given.items())
        if products == "positive" and len(inertia) == 9:
            inertia = [x if n % 4 == 0 else -x for n, x in enumerate(inertia)]
        object.__setattr__(self, "gyrostatic_momentum", tuple(map(plain, rotor)))
        object.__setattr__(self, "inertia", tensor_of(inertia) if len(inertia) == 9
                           else as_first_written(inertia))
        check_names(self.entries, "the inertia", BodyError, Use.ANGLE)
        check_names(self.gyrostatic_momentum, "the rotor", BodyError, Use.ROTOR, Use.ANGLE)
        for value in self.positive:
            if not value.free_symbols and (sign := sign_of_constant(value)) != 1:
                what = "is not proved to be" if sign is None else "is not"
                if isinstance(self.inertia, ImmutableMatrix):
                    raise BodyError(f"inertia = {brief(self.inertia.tolist())}: a leading principal minor, "
                                    f"{shown(value, 12)}, {what} positive, but the tensor of a body is "
                                    "positive definite; check the signs of the products of inertia: its "
                                    "entries are −∫ xy dm, and products=\"positive\" takes ∫ xy dm")
                raise BodyError(f"inertia = ({', '.join(map(shown, self.inertia))}): {shown(value)} "
                                f"{what} positive, but a body has "
                                "mass off every axis; give three positive moments")

    @property
    def moments(self) -> tuple[Expr, ...]:
        """The principal moments (I1, I2, I3).

        Raises
        ------
        ScopeError
            the axes are not principal
        """
        if isinstance(self.inertia, ImmutableMatrix):
            raise ScopeError("this needs principal axes, and the inertia tensor has products of inertia: "
                             "in Python gyrostat.mechanics.principal_axes(body) turns the body; state "
                             "everything else in those axes")
        return tuple(self.inertia)

    @cached_property
    def tensor(self) -> ImmutableMatrix:
        """The inertia tensor, shape (3, 3)."""
        return self.inertia if isinstance(self.inertia, ImmutableMatrix) else diagonal(self.inertia)

    @property
    def gravitating(self) -> ImmutableMatrix:
        """The tensor on which gravity acts, shape (3, 3): of free rotors it has the axial moments too."""
        return self.tensor

    @cached_property
    def inverse(self) -> ImmutableMatrix:
        """The inverse I⁻¹ of the tensor, shape (3, 3): ω = I⁻¹ π."""
        if isinstance(self.inertia, ImmutableMatrix):
            whole = self.inertia.det(method="berkowitz")
            return immutable([[entry / whole for entry in row] for row in adjugate(self.inertia.tolist())], 3)
        return diagonal([1 / moment for moment in self.inertia])

    @property
    def entries(self) -> tuple[Expr, ...]:
        """The moments, or I11, I22, I33, I23, I31, I12 of a tensor."""
        if not isinstance(self.inertia, ImmutableMatrix):
            return tuple(self.inertia)
        return tuple(self.inertia[i, j] for i, j in ((0, 0), (1, 1), (2, 2), (1, 2), (2, 0), (0, 1)))

    @cached_property
    def positive(self) -> tuple[Expr, ...]:
        """What is positive for any body: the moments, or the leading principal minors of the tensor."""
        if not isinstance(self.inertia, ImmutableMatrix):
            return tuple(self.inertia)
        return leading_minors(self.inertia)

    @cached_property
    def symbols(self) -> frozenset[Symbol]:
        """The names that it depends on."""
        return frozenset(s for e in (*self.entries, *self.gyrostatic_momentum) for s in e.free_symbols)

    @checked
    def changed(self, change: Callable[[Expr], Expr]) -> "Gyrostat":
        """Return the body with every entry changed, for example by inserting numbers.

        Parameters
        ----------
        change : callable

        Returns
        -------
        Gyrostat
        """
        inertia = (self.inertia.applyfunc(change) if isinstance(self.inertia, ImmutableMatrix)
                   else [change(x) for x in self.inertia])
        return replace(self, inertia=inertia,
                       gyrostatic_momentum=[change(x) for x in self.gyrostatic_momentum])

    def _turned(self, R: ImmutableMatrix, moments: Sequence[Expr], rotor: Sequence[Expr]) -> "Gyrostat":
        """Return the body in axes x' = R x, where its moments and its rotor are known."""
        return replace(self, inertia=moments, gyrostatic_momentum=rotor)

    @checked
    def kinetic_energy(self, momentum: Sequence[Expr]) -> Expr:
        """Return T = ½ π·I⁻¹π, with the rotor locked.

        Parameters
        ----------
        momentum : sequence of Expr, shape (3,)
            π [M L²/T]

        Returns
        -------
        Expr
            [M L²/T²]
        """
        momentum = [exact_expression(p, "momentum") for p in several(momentum, "momentum", 3)]
        if isinstance(self.inertia, ImmutableMatrix):
            return Add(*(x * p * q / 2 for row, p in zip(self.inverse.tolist(), momentum)
                         for x, q in zip(row, momentum)))
        return Add(*(Rational(1, 2) * p**2 / moment for p, moment in zip(momentum, self.inertia)))

    def is_of_revolution(self) -> bool:
        """Tell whether I1 = I2 and l lies on axis 3."""
        if isinstance(self.inertia, ImmutableMatrix):
            return False
        return self.inertia[0] == self.inertia[1] and self.gyrostatic_momentum[:2] == (0, 0)


def symmetric_gyrostat() -> Gyrostat:
    """Return the gyrostat of revolution: I1 = I2, l = (0, 0, l).

    Returns
    -------
    Gyrostat

    Examples
    --------
    >>> import gyrostat as gs
    >>> gs.symmetric_gyrostat().inertia
    (I1, I1, I3)
    """
    return Gyrostat((symbol("I1"), symbol("I1"), symbol("I3")), (0, 0, symbol("l")))
