"""The attitude of a satellite that rests in its orbit, in doubles: rotation, quaternion, roll, pitch, yaw."""
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

from flint import arb
from sympy import Expr

from ..algebra.enclosures.balls import FARTHEST
from ..algebra.enclosures.precision import doubled, own_precision
from ..algebra.reals.exact import evaluate, proved_sign
from ..algebra.rings.matrices import cross
from ..algebra.solving.real_fields import balls
from ..mechanics.classical.quaternion import quaternion_products
from ..stability.form import PRECISION
from .doubles import rounded

Matrix = Sequence[Sequence[Any]]
Rows = Callable[[int], Matrix]


@dataclass(frozen=True)
class Attitude:
    """The rotation R from body axes to the axes t, n, r of the orbit, as engineers write it.

    t = n × r is along the velocity, n along the normal of the orbit, r along the vertical, away from the
    Earth. R = Rz(yaw) Ry(pitch) Rx(roll): from t, n, r the body is turned by yaw about r, then by pitch about
    its axis 2, then by roll about its axis 1. It is the convention of release and of roll_pitch_yaw. Against
    the frame with z to the Earth and y against n, the angles are roll + 180°, −pitch and −yaw.

    Each number is the double next to the exact one.

    Parameters
    ----------
    matrix : tuple, shape (3, 3)
        R; its rows are t, n and r in body axes
    scalar_first : tuple, shape (4,)
        the quaternion q of R as (w, x, y, z): x_orbit = q x_body q*; the first of its numbers that is not 0
        is positive
    roll : float or None
        in degrees, above −180 and at most 180; None if pitch is ±90°, where it is not determined
    pitch : float
        in degrees, from −90 to 90
    yaw : float or None
        as roll
    note : str
        what is determined if pitch is ±90°: yaw − roll or yaw + roll; else ""

    References
    ----------
    The 3-2-1 sequence: Hughes, Spacecraft Attitude Dynamics (1986), chapter 2. The quaternion: Shepperd,
    Journal of Guidance and Control 1 (1978) 223-224.

    Examples
    --------
    >>> import gyrostat as gs
    >>> body = gs.Gyrostat((60, 70, 35), (0, 30, 0))
    >>> scene = gs.assemble(body, gs.circular_orbit(1))
    >>> found = gs.relative_equilibria(scene, {})
    >>> print(found[3].attitude)
    roll 102.4°, pitch 0°, yaw 0°
    >>> found[3].attitude.scalar_last
    (0.7791937224739796, 0.0, 0.0, 0.6267831705280087)
    """

    NAMES: ClassVar = tuple(f"{axis}{n}" for axis in "tnr" for n in (1, 2, 3))
    matrix: tuple[tuple[float, ...], ...]
    scalar_first: tuple[float, ...]
    roll: float | None
    pitch: float
    yaw: float | None
    note: str

    @property
    def scalar_last(self) -> tuple[float, ...]:
        """The same quaternion as (x, y, z, w)."""
        return *self.scalar_first[1:], self.scalar_first[0]

    @property
    def columns(self) -> dict[str, Any]:
        """Its numbers by the names that they have in a table: angles, quaternion, rows of the rotation."""
        return {"roll_deg": self.roll, "pitch_deg": self.pitch, "yaw_deg": self.yaw,
                **dict(zip(("q_w", "q_x", "q_y", "q_z"), self.scalar_first)),
                **dict(zip(self.NAMES, (x for row in self.matrix for x in row))), "attitude_note": self.note}

    @property
    def data(self) -> dict[str, Any]:
        """Its numbers as data for JSON."""
        return {"roll_deg": self.roll, "pitch_deg": self.pitch, "yaw_deg": self.yaw, "note": self.note,
                "scalar_first": list(self.scalar_first), "scalar_last": list(self.scalar_last),
                "rotation": list(map(list, self.matrix))}

    def __str__(self) -> str:
        shown = (("roll", self.roll), ("pitch", self.pitch), ("yaw", self.yaw))
        angles = ", ".join(f"{name} {in_degrees(x)}" for name, x in shown if x is not None)
        return self.note or angles


def in_degrees(angle: float) -> str:
    """Write an angle to four digits, and four decimals at most, with its sign.

    Examples
    --------
    >>> in_degrees(-135.0), in_degrees(0.0123456), in_degrees(-1e-13)
    ('−135°', '0.0123°', '0°')
    """
    return f"{round(angle, 4) + 0.0:.4g}°".replace("-", "−")


def attitude_of(n: Sequence[Expr], r: Sequence[Expr]) -> Attitude:
    """Return the attitude by the normal of the orbit and the vertical in body axes, each shape (3,)."""
    def rows(precision: int) -> Matrix:
        normal, vertical = balls(n, precision), balls(r, precision)
        return [cross(normal, vertical), normal, vertical]

    near = rounded(lambda precision: [x for row in rows(precision) for x in row])
    matrix = near[:3], near[3:6], near[6:]
    return Attitude(matrix, _quaternion(rows, matrix), *_angles(rows, _is_singular(r)))


def _quaternion(rows: Rows, near: Matrix) -> tuple[float, ...]:
    """Return (w, x, y, z) by the largest of the four, so that nothing cancels."""
    largest = max(range(4), key=lambda n: quaternion_products(near)[n][n])

    def found(precision: int) -> list[arb]:
        products = quaternion_products(rows(precision))[largest]
        return [x / (2 * products[largest].sqrt()) for x in products]

    q = rounded(found)
    sign = next(1 if x > 0 else -1 for x in q if x)
    return tuple(sign * x + 0.0 for x in q)                # no −0


def _angles(rows: Rows, singular: bool) -> tuple[float | None, float, float | None, str]:
    """Return roll, pitch and yaw, and what is determined if the matrix is singular.

    R = Rz(yaw) Ry(pitch) Rx(roll) has the last row (−sin pitch, cos pitch sin roll, cos pitch cos roll), and
    its first column cos pitch (cos yaw, sin yaw) above. If cos pitch = 0, it is Rz(yaw ∓ roll) Ry(±90°).
    """
    if not singular:
        def found(precision: int) -> list[arb]:
            (a, _, _), (d, _, _), (g, h, i) = rows(precision)
            return [_degrees(h, i), _degrees(-g, (h * h + i * i).sqrt()), _degrees(d, a)]

        roll, pitch, yaw = rounded(found)
        return roll, pitch, yaw, ""
    up = rows(PRECISION)[2][0] < 0
    (turn,) = rounded(lambda precision: [_degrees(-rows(precision)[0][1], rows(precision)[1][1])])
    pitch = 90.0 if up else -90.0
    sign = "−" if up else "+"
    return None, pitch, None, (f"pitch {in_degrees(pitch)}, where only yaw {sign} roll = {in_degrees(turn)} "
                               "is determined")


def _degrees(y: arb, x: arb) -> arb:
    """Return the angle of (x, y), above −180° and at most 180°."""
    if x < 0 and y.contains(0):                            # there the ball would reach round to −180°
        return (arb.pi() + (y / x).atan()) * 180 / arb.pi()
    return arb.atan2(y, x) * 180 / arb.pi()


def _is_singular(r: Sequence[Expr]) -> bool:
    """Whether the vertical lies along the first axis of the body."""
    for precision in doubled(PRECISION, FARTHEST):
        with own_precision(precision):
            across = balls(r, precision)[1:]
            if any(not x.contains(0) for x in across):
                return False
            if all(x == 0 for x in across):
                return True
    return not any(proved_sign(evaluate(x, {})) for x in (r[1], r[2]))
