"""Gyrostat: principal moments of inertia, gyrostatic momentum, kinetic energy."""
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from sympy import Add, Expr, Rational, radsimp

from ..algebra.exact import plain, sign_of_constant
from ..algebra.numbers import exact_expression, shown
from ..errors import ArgumentError, BodyError, article, brief
from ..notation import Stored, of_the_motion, symbol
from ..shown import Shown

_INERTIA = tuple(symbol(f"I{i}") for i in (1, 2, 3))
_ROTOR = tuple(symbol(f"l{i}") for i in (1, 2, 3))


@dataclass(frozen=True)
class Gyrostat(Shown, Stored):
    """Rigid body with a rotor whose relative angular momentum l is constant, in principal axes.

    Each entry is a number (made exact) or a SymPy expression; the default is the general body, in symbols.
    Arrays are sequences too, and a diagonal matrix has its moments on the diagonal.

    Parameters
    ----------
    inertia : (I1, I2, I3)
        principal moments of the locked body [M L²], positive
    gyrostatic_momentum : (l1, l2, l3)
        angular momentum of the rotor relative to the body [M L²/T]

    Raises
    ------
    BodyError
        a moment is not positive, or there are not three of each

    Examples
    --------
    >>> import gyrostat as gs
    >>> body = gs.Gyrostat(inertia=(2, 2, 1), gyrostatic_momentum=(0, 0, 0))
    >>> body.kinetic_energy((gs.symbol("pi1"), 0, gs.symbol("pi3")))
    pi1**2/4 + pi3**2/2
    """

    inertia: Sequence[Any] = _INERTIA
    gyrostatic_momentum: Sequence[Any] = _ROTOR

    def __post_init__(self) -> None:
        for field in ("inertia", "gyrostatic_momentum"):
            given = _entries(getattr(self, field), field)
            object.__setattr__(self, field, tuple(_without_surds_below(exact_expression(value, field))
                                                  for value in given))
        if taken := of_the_motion(s for e in (*self.inertia, *self.gyrostatic_momentum)
                                  for s in e.free_symbols):
            raise BodyError(f"the body depends on {', '.join(taken)}, a name of the motion: rename it")
        object.__setattr__(self, "inertia", _as_first_written(self.inertia))
        object.__setattr__(self, "gyrostatic_momentum", tuple(map(plain, self.gyrostatic_momentum)))
        for moment in self.inertia:
            if not moment.free_symbols and (sign := sign_of_constant(moment)) != 1:
                what = "is not proved to be" if sign is None else "is not"
                raise BodyError(f"inertia = ({', '.join(map(shown, self.inertia))}): {shown(moment)} "
                                f"{what} positive, but a body has "
                                "mass off every axis; give three positive moments")

    def kinetic_energy(self, momentum: Sequence[Expr]) -> Expr:
        """T = ½ Σ πᵢ²/Iᵢ, with the rotor locked.

        Parameters
        ----------
        momentum : sequence of Expr, shape (3,)
            π [M L²/T]

        Returns
        -------
        Expr
            [M L²/T²]
        """
        return Add(*(Rational(1, 2) * p**2 / moment for p, moment in zip(momentum, self.inertia)))

    def is_of_revolution(self) -> bool:
        """Whether I1 = I2 and l lies on axis 3."""
        return self.inertia[0] == self.inertia[1] and self.gyrostatic_momentum[:2] == (0, 0)


def symmetric_gyrostat() -> Gyrostat:
    """Gyrostat of revolution: I1 = I2, l = (0, 0, l).

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


def _as_first_written(values: Sequence[Expr]) -> tuple[Expr, ...]:
    """Constants that are equal in one spelling, so that a body of revolution is one."""
    known: list[Expr] = []
    for value in values:
        same = (x for x in known if not (apart := x - value).free_symbols and sign_of_constant(apart) == 0)
        known.append(next(same, value))
    return tuple(known)


def _entries(given: Any, field: str) -> tuple[Any, ...]:
    """Three entries, of a sequence or an array; of a diagonal matrix those on the diagonal."""
    rows = given.tolist() if hasattr(given, "tolist") else given
    if isinstance(rows, str | bytes) or not isinstance(rows, Sequence):
        raise ArgumentError(f"{field} = {brief(given)} is {article(type(given))}, not a sequence: give "
                            "three numbers, "
                            f"{field}=({'2, 2, 1' if field == 'inertia' else '0, 0, 1'})")
    entries = tuple(rows)
    if len(entries) == 3 and all(isinstance(row, Sequence) and not isinstance(row, str) and len(row) == 3
                                 for row in entries):
        if field != "inertia":
            raise BodyError(f"{field} is a matrix: give three numbers, one for each principal axis")
        if any(exact_expression(row[j], field) != 0 for i, row in enumerate(entries)
               for j in range(3) if i != j):
            raise BodyError("inertia is a matrix with products of inertia: give the three principal "
                            "moments, its eigenvalues, and state "
                            "everything else in the principal axes, its eigenvectors")
        entries = tuple(row[i] for i, row in enumerate(entries))
    # a matrix of one row, or of one column
    if len(entries) == 1 and isinstance(entries[0], Sequence):
        entries = tuple(entries[0])
    if hasattr(given, "tolist") and all(isinstance(row, Sequence) and len(row) == 1 for row in entries):
        entries = tuple(row[0] for row in entries)
    if len(entries) != 3:
        raise BodyError(f"{field} has {len(entries)} entries: give three, one for each principal axis")
    return entries


def _without_surds_below(value: Expr) -> Expr:
    """A number with its denominator rational, as polynomial algebra wants it."""
    return value if value.free_symbols or value.is_Rational else radsimp(value)
