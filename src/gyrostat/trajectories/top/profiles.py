"""Encloses g on a level of the integrals: its values, derivatives, and quotients by a root at a pole."""
from functools import lru_cache

from flint import arb, ctx
from sympy import Expr

from ...algebra.enclosures.balls import ball
from .level import K3, Level, enclosed, expression


class Profile:
    """g(z) = T (r² − z²) − w² on a level, T = abs(p)² + 2 I1 (U(k3) − U(z)), w = v − P z, in balls.

    It is at the precision of the moment at which it is made.

    Parameters
    ----------
    level : Level

    Attributes
    ----------
    radius : arb
        r = abs(k)
    """

    def __init__(self, level: Level):
        self._field = derivatives(level.potential)
        self._inertia, self._height, self._axial = map(enclosed, (level.inertia, level.height, level.axial))
        self._across, self._twist = enclosed(level.across), enclosed(level.twist)
        self._square = enclosed(level.square_radius)
        self._start = ball(level.potential.xreplace({K3: expression(level.height)}), ctx.prec)
        self.radius = self._square.sqrt()

    def kinetic(self, z: arb) -> arb:
        """Return T = abs(p)²."""
        return self._across + 2 * self._inertia * (self._start - self._potential(z, 0))

    def __call__(self, z: arb, order: int = 0) -> arb:
        """Return g, g′ or g″."""
        w = self._twist + self._axial * (self._height - z)
        if order == 0:
            return self.kinetic(z) * (self._square - z * z) - w * w
        if order == 1:
            return self._fall(z, 1) * (self._square - z * z) - 2 * z * self.kinetic(z) + 2 * self._axial * w
        return (self._fall(z, 2) * (self._square - z * z) - 4 * z * self._fall(z, 1) - 2 * self.kinetic(z)
                - 2 * self._axial * self._axial)

    def divided(self, z: arb, side: int, order: int = 0) -> arb:
        """Return g/(r − side z) or its derivative, if the pole side · r is a root.

        Then w = P (side r − z).
        """
        square = self._axial * self._axial
        if order == 0:
            return self.kinetic(z) * (self.radius + side * z) - square * (self.radius - side * z)
        return self._fall(z, 1) * (self.radius + side * z) + side * (self.kinetic(z) + square)

    def _potential(self, z: arb, order: int) -> arb:
        return ball(self._field[order], ctx.prec, {K3: z})

    def _fall(self, z: arb, order: int) -> arb:
        """Return a derivative of T."""
        return -2 * self._inertia * self._potential(z, order)


@lru_cache(maxsize=64)
def derivatives(U: Expr) -> tuple[Expr, Expr, Expr]:
    """Return U, U′ and U″ as functions of k3."""
    return U, U.diff(K3), U.diff(K3, 2)
