"""Fields in which equilibria meet, and how many there are by Sturm."""
from fractions import Fraction

import gyrostat as gs
from gyrostat.equilibria.search import relative_equilibria

k3, omega = gs.symbol("k3"), gs.symbol("omega")
TERMS = [gs.symbol(f"a{n}") for n in range(1, 6)]
FIELD = sum(a * k3**n for n, a in enumerate(TERMS, 1))
BODY = {"I1": Fraction(2), "I3": Fraction(3), "l": Fraction(1, 2)}
FIELDS = {"cubic": (Fraction(1, 2), -3, Fraction(2, 7), 0, 0),
          "quartic": (Fraction(1, 3), 2, Fraction(-5, 2), -3, 0),
          "quintic": (-1, Fraction(3, 2), 4, Fraction(-1, 2), -3),
          "oblate": (Fraction(3, 4), Fraction(-9, 2), 1, 2, Fraction(1, 5))}


def numbers_of(field):
    """The body and the field, by name."""
    return BODY | {f"a{n}": Fraction(a) for n, a in enumerate(FIELDS[field], 1)}


def near(number):
    """A fraction within 10⁻³⁰."""
    return Fraction(int((number.evalf(60) * 10**30).round()), 10**30)


def tilts(scene, values):
    """The branches between the poles, from above down."""
    return [b for b in relative_equilibria(scene, values) if b.label not in ("E1", "E2")]


STEP = {"E3 leaves E1": 1, "E3 leaves E2": 1, "fold at fixed rate": 2, "fold on a level": 2}
