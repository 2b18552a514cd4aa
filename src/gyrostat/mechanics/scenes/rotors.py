"""Rotors of a gyrostat, from their data sheets: wheels along any axes, driven or free."""
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from sympy import Expr, ImmutableMatrix, Matrix, S, eye, sqrt

from ...algebra.reals.exact import proved_sign
from ...algebra.rings.matrices import leading_minors
from ...algebra.text.numbers import exact_expression, exact_number
from ...algebra.text.quantities import not_mixed
from ...arguments import checked
from ...errors import BodyError, brief
from ...notation import Use
from ...registry import check_names
from .body import Gyrostat
from .functions_on_sphere import lowest


@dataclass(frozen=True)
class Rotor:
    """An axially symmetric rotor whose axis is fixed in the body.

    If it is driven, its speed relative to the body is held, at rate; it turns with the body otherwise. If it
    is free, it runs without friction, and its axial momentum is constant, axial · (ω·a + rate).

    Parameters
    ----------
    axis : (a1, a2, a3)
        any vector along the axis, in the axes of the body; not 0
    axial : Expr, number or text
        moment of inertia about the axis [M L²]
    transverse : Expr, number or text, or None
        moment of inertia across it, about the centre of mass of the rotor [M L²]; needed if the tensor is
        that of the body without its rotors
    rate : Expr, number or text, or None
        of a driven rotor, relative to the body [1/T]; default, without a momentum either: it stands still
    momentum : Expr, number or text, or None
        of a free rotor, along the axis, in space [M L²/T]

    Raises
    ------
    BodyError
        the axis is no direction, the inertia is negative, or rate and momentum are both given

    Examples
    --------
    >>> import gyrostat as gs
    >>> wheel = gs.Rotor((0, 3, 4), axial="25 g m^2", rate="3000 rpm")
    >>> wheel.gyrostatic_momentum
    (0, 3*pi/2, 2*pi)
    """

    axis: Sequence[Any]
    axial: Any
    transverse: Any = None
    rate: Any = None
    momentum: Any = None

    def __post_init__(self) -> None:
        given = {name: getattr(self, name) for name in ("axial", "transverse", "rate", "momentum")}
        not_mixed((name, x) for name, x in given.items() if x is not None)
        for name, value in given.items():
            if value is not None:
                exact = exact_expression(value, name)
                check_names([exact], f"{name} = {exact}", BodyError, Use.ROTOR, Use.ANGLE)
                object.__setattr__(self, name, exact)
        for name in ("axial", "transverse"):
            value = getattr(self, name)
            if value is not None and not value.free_symbols and proved_sign(value) == -1:
                raise BodyError(f"{name} = {given[name]}, and no moment of inertia is negative: give a "
                                "positive one")
        if self.rate is not None and self.momentum is not None:
            raise BodyError("rate and momentum of a rotor are both given: rate is that of a driven rotor, "
                            "momentum that of a free one; leave out one of the two")
        object.__setattr__(self, "axis", _direction(self.axis))

    @property
    def gyrostatic_momentum(self) -> tuple[Expr, ...]:
        """The part of l that it gives: axial · rate along the axis; if it is free, its momentum."""
        if self.momentum is not None:
            return tuple(self.momentum * x for x in self.axis)
        return tuple(lowest(self.axial * (self.rate or S.Zero) * x) for x in self.axis)

    @property
    def along(self) -> ImmutableMatrix:
        """The matrix a aᵀ, shape (3, 3)."""
        a = Matrix(self.axis)
        return ImmutableMatrix(a * a.T)


@checked
def gyrostat_with_rotors(inertia: Sequence[Any] | str, rotors: Sequence[Rotor], *, lumped: bool,
                         products: str = "negative") -> Gyrostat:
    """Return the gyrostat that a body with rotors is.

    l is the sum of the momenta of the rotors. The tensor is that of the locked body, and without axial · a aᵀ
    of each free rotor, which does not turn with the body about its axis. That is the tensor of the kinetic
    energy: the gravity gradient in an orbit acts on the full one. A potential that is given by its formula is
    taken as it is given, and the moments that it names are those of the kinetic energy.

    Parameters
    ----------
    inertia : (I1, I2, I3), or matrix, shape (3, 3), or text
        principal moments or tensor, about the centre of mass of the whole body or its fixed point [M L²]
    rotors : sequence of Rotor
    lumped : bool
        whether the tensor includes the rotors; if not, they are added, their masses being in it already
    products : str
        the sign of the products of inertia, as of Gyrostat

    Returns
    -------
    Gyrostat

    Raises
    ------
    BodyError
        a rotor that is to be added has no transverse moment; or nothing of the body is left beside its
        rotors

    References
    ----------
    Hughes, Spacecraft Attitude Dynamics (1986), §3.5.

    Examples
    --------
    >>> import gyrostat as gs
    >>> wheel = gs.Rotor((0, 1, 0), axial="0.05 kg m^2", rate="3000 rpm")
    >>> moments = "120, 110, 80 kg m^2"
    >>> body = gs.gyrostat_with_rotors(moments, [wheel], lumped=True)
    >>> body.moments, body.gyrostatic_momentum
    ((120, 110, 80), (0, 5*pi, 0))
    """
    total, l = Matrix(Gyrostat(inertia, (0, 0, 0), products).tensor), [S.Zero] * 3
    for n, rotor in enumerate(rotors, 1):
        if not lumped and rotor.transverse is None:
            raise BodyError(f"rotor {n} has no transverse moment of inertia, and the tensor is without the "
                            "rotors: give it, or lumped=True if the tensor includes them")
        if not lumped:
            total += rotor.transverse * (eye(3) - rotor.along) + rotor.axial * rotor.along
        l = [x + y for x, y in zip(l, rotor.gyrostatic_momentum)]
    left = total
    for rotor in rotors:
        left = left - rotor.axial * rotor.along
    if not all(m.free_symbols or proved_sign(m) == 1 for m in leading_minors(left)):
        raise BodyError("the rotors have more inertia about their axes than the body with them: check their "
                        "units, or give lumped=False if the tensor is without them")
    momentum, free = [lowest(x) for x in l], Matrix.zeros(3)
    for rotor in rotors:
        free += rotor.axial * rotor.along if rotor.momentum is not None else Matrix.zeros(3)
    left = (total - free).applyfunc(lowest).tolist()
    if free.is_zero_matrix:
        return Gyrostat(left, momentum)
    return GyrostatWithFreeRotors(left, momentum, free=ImmutableMatrix(free.applyfunc(lowest)))


@dataclass(frozen=True)
class GyrostatWithFreeRotors(Gyrostat):
    """A gyrostat whose tensor is without the axial moments of its free rotors, free = Σ axial · a aᵀ."""

    free: ImmutableMatrix = ImmutableMatrix.zeros(3)

    @property
    def gravitating(self) -> ImmutableMatrix:
        """The tensor on which gravity acts, shape (3, 3): it has the axial moments of the free rotors too."""
        return ImmutableMatrix((self.tensor + self.free).applyfunc(lowest))

    def changed(self, change: Callable[[Expr], Expr]) -> Gyrostat:
        """Return the body with every entry changed, those of its free rotors too."""
        return self._with(super().changed(change), self.free.applyfunc(change))

    def _turned(self, R: ImmutableMatrix, moments: Sequence[Expr], rotor: Sequence[Expr]) -> Gyrostat:
        """Return the body in axes x' = R x, where its moments and its rotor are known."""
        return self._with(super()._turned(R, moments, rotor), R * self.free * R.T)

    @staticmethod
    def _with(body: Gyrostat, free: ImmutableMatrix) -> Gyrostat:
        return GyrostatWithFreeRotors(body.inertia, body.gyrostatic_momentum, free=free)


def _direction(axis: Sequence[Any]) -> tuple[Expr, ...]:
    """Return the unit vector along an axis."""
    if isinstance(axis, str | bytes) or not hasattr(axis, "__len__") or len(axis) != 3:
        raise BodyError(f"axis = {brief(axis)}: give three numbers, (0, 0, 1)")
    vector = [exact_number(x, "axis") for x in axis]
    length = lowest(sum((x**2 for x in vector), S.Zero))
    if proved_sign(length) != 1:
        raise BodyError(f"axis = {brief(axis)} is not a direction: give a vector that is not 0")
    return tuple(lowest(x / sqrt(length)) for x in vector)
