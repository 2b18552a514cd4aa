"""Every computation has its own precision of python-flint, which has one for the whole process."""
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from flint import ctx
from sympy import Rational, exp, sqrt

import gyrostat as gs
from gyrostat._cached import cached_property
from gyrostat.algebra.text.numbers import exact_number
from gyrostat.charts.signs.verdict_arrays import verdicts
from gyrostat.trajectories import motion

HALF = Rational(1, 2)


def of_revolution(U):
    return gs.assemble(gs.Gyrostat((1, 1, HALF), (0, 0, HALF)), gs.axial_potential(U))


def states(scene, *start):
    """At three times, with the period, in doubles and to 25 digits."""
    def found():
        doubles, digits = motion(scene, start), motion(scene, start, precision=25)
        return [doubles([0.0, 1.5, 1e4]).tolist(), doubles.period, doubles.attitude(2.5).tolist(),
                str(digits([0, "7/3"])),
                str(digits.period)]
    return found


def verdict():
    """On the boundary, with roots, and close to it, with an exponential function."""
    top = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(),
                                            gs.axial_potential(lambda z: exp(z) / 2 + z))))
    critical = {"I1": 1, "I3": 1, "l": 0, "pi3_0": exact_number("sqrt(4+2*exp(1))", "pi3_0")
                + Rational(1, 10**30)}
    heavy = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())))
    at = heavy.verdict({"I1": sqrt(2), "m0": sqrt(2), "l": sqrt(3), "pi3_0": 2 * sqrt(2) - sqrt(3)})
    spins = np.linspace(2.0, 2.6, 30)
    return top.verdict(critical).verdict, at.verdict, verdicts(top, I1=1, I3=1, l=0, pi3_0=spins).tolist()


COMPUTATIONS = {
    "elliptic": states(of_revolution(lambda z: z), HALF, Rational(1, 5), 1, Rational(3, 5), 0,
                       Rational(4, 5)),
    "quadrature": states(of_revolution(exp), HALF, Rational(1, 5), 1, Rational(3, 5), 0, Rational(4, 5)),
    "separatrix": states(of_revolution(lambda z: 5 * z), 1, 1, Rational(5, 2), Rational(3, 5), 0,
                         Rational(4, 5)),
    "steady": states(of_revolution(exp), 0, 0, 1, 0, 0, 1),
    "free body": states(gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0))), 1, HALF, sqrt(2)),
    "free gyrostat": states(gs.assemble(gs.Gyrostat((1, 2, 3), (HALF, 0, 1))), 1, HALF, sqrt(2)),
    "verdict": verdict}


@pytest.fixture(scope="module")
def expected():
    return {name: compute() for name, compute in COMPUTATIONS.items()}


@pytest.mark.slow
@pytest.mark.parametrize("name", COMPUTATIONS)
@pytest.mark.parametrize("bits", [2, 1000])
def test_nothing_depends_on_the_precision_outside(expected, name, bits):
    """Whatever flint.ctx.prec is around a computation.

    The same results to the last bit, and it is left as it was.
    """
    with ctx.workprec(bits):
        assert COMPUTATIONS[name]() == expected[name]
        assert ctx.prec == bits


@pytest.mark.slow
def test_threads_do_not_change_each_others_precision(expected):
    """Motions and verdicts in eight threads at once: the same results as one after the other."""
    names = [*COMPUTATIONS] * 2
    before = ctx.prec
    with ThreadPoolExecutor(8) as pool:
        assert all(found == expected[name]
                   for name, found in zip(names, pool.map(lambda name: COMPUTATIONS[name](), names)))
    assert ctx.prec == before


class Answer:
    """Asked for once."""

    def __init__(self, ask):
        self.ask = ask

    @cached_property
    def kept(self):
        return self.ask()


def test_a_property_waits_for_none_of_another_object():
    """One thread is in a property of an object, one asks for that of another, as with enclosures."""
    with ThreadPoolExecutor(1) as pool:
        other = Answer(lambda: 2)
        first = Answer(lambda: pool.submit(lambda: other.kept).result(timeout=10))
        assert first.kept == other.kept == 2 and isinstance(Answer.kept, cached_property)
