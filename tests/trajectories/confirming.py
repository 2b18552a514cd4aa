"""Sizes and directions of perturbations that are enough for every verdict here."""
from fractions import Fraction

from gyrostat.trajectories import confirmation

LARGE = [Fraction(1, 10**d) for d in (2, 3, 4)]        # where nothing becomes small


def one_direction(monkeypatch):
    """One of the directions and its negative; the example of confirm has them all."""
    monkeypatch.setattr(confirmation, "TURNS", confirmation.TURNS[:1])
