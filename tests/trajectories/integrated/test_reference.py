"""The integrators and the reference of the benchmark of motions."""
import ast
import sys
from dataclasses import replace
from fractions import Fraction
from math import log2
from pathlib import Path

import pytest
from mpmath import cos, floor, mpf, sin, workdps
from slow import slow

BENCHMARKS = Path(__file__).parents[3] / "benchmarks"
# M1 is the top of Simo & Wong, IJNME 31 (1991) 19-52, M2 the body of Hairer, Lubich & Wanner, Geometric
# Numerical Integration
KNOWN = {"M1": "-.153091997209136024 .143264870866601439 50.000000000000000 -.0288715630929733331 "
               ".0458625370775062699 .998530450480796716",
         "M2": ".450201146840795038 .0783373315292274935 .889484226882136907",
         "M3": "-.63263141376382492 1.3279608395136307 -2.30416111460101 -.42019155176267731 "
               ".78822852802552266 -.44959409185841302"}


@pytest.fixture(scope="module")
def modules():
    sys.path.insert(0, str(BENCHMARKS))
    try:
        import motion_integrators
        import motion_reference
    finally:
        sys.path.remove(str(BENCHMARKS))
    return motion_integrators, motion_reference


def exactly(function, x):
    """A value as a fraction, 40 digits of it."""
    with workdps(60):
        return Fraction(int(floor(function(mpf(x.numerator) / x.denominator) * 10**40)), 10**40)


def decimal(case):
    """M1, M2 and M3 with the numbers that their names say, not the nearest floats."""
    tilt, angle = Fraction(1, 20), Fraction(11, 10)
    exact = {"M1": {"state": (0, 0, 50, 0, exactly(sin, tilt), exactly(cos, tilt))},
             "M2": {"inertia": (2, 1, Fraction(2, 3)),
                    "state": (exactly(cos, angle), 0, exactly(sin, angle))},
             "M3": {name: tuple(Fraction(str(x)) for x in getattr(case, name))
                    for name in ("state", "rotor", "slope")}}
    return replace(case, **exact[case.name[:2]])


@pytest.mark.parametrize("name", ["M2", *slow(("M1",), ("M3",))])
def test_the_series_has_the_known_digits(modules, name):
    """The Taylor series in whole numbers reproduces motions known to 15 to 18 digits."""
    _, reference = modules
    case = decimal(next(c for c in reference.cases() if c.name.startswith(name)))
    state = reference.taylor(case, *case.times.values(), digits=25)
    with workdps(30):
        for x, known in zip(state, KNOWN[name].split(), strict=True):
            # a unit of its last digit or two
            assert abs(x - mpf(known)) < mpf(10) ** (1 - len(known.partition(".")[2])), known


def test_the_period_brings_the_tilt_back(modules):
    """After a period of the nutation k3 is what it was, with 25 digits."""
    _, reference = modules
    case = reference.cases(quick=True)[0]
    period = reference.nutation_period(case.inertia, case.rotor[2], case.slope[2], case.state)
    with workdps(40):
        mantissa = Fraction(int(floor(period * 10**35)), 10**35)
        assert abs(reference.taylor(case, mantissa, digits=30)[5] - mpf(case.state[5])) < mpf(10)**-25


@pytest.mark.slow
@pytest.mark.parametrize("place", range(3))
def test_splittings_have_their_order_and_keep_the_casimirs(modules, place):
    """Errors fall with the order 2, 4 or 8.

    abs(k)², (π + l)·k or abs(π)² change by round-off: 2000 steps and a few units each.
    """
    integrators, reference = modules
    case = reference.cases(quick=True)[place]
    (t,) = case.times.values()
    truth = reference.taylor(case, t, digits=20)
    for name, (order, _, _) in integrators.SPLITTINGS.items():
        few, more = {2: (200, 400), 4: (32, 64), 8: (10, 14)}[order]
        ends = [integrators.splitting_run(name, n)(case, t, None)() for n in (few, more)]
        seen = log2(reference.error(ends[0], truth) / reference.error(ends[1], truth)) / log2(more / few)
        assert abs(seen - order) < 0.3, (name, seen)
        assert max(max(case.drifts(x)[1:]) for x in ends) < 1e-13, name


def test_the_reference_is_independent():
    """Neither the series nor the other integrators use gyrostat."""
    for name in ("motion_reference", "motion_integrators"):
        tree = ast.parse((BENCHMARKS / f"{name}.py").read_text(encoding="utf-8"))
        imported = {n.module if isinstance(n, ast.ImportFrom) else a.name for n in ast.walk(tree)
                    if isinstance(n, (ast.Import, ast.ImportFrom)) for a in n.names}
        assert not any(module.startswith("gyrostat") for module in imported)
