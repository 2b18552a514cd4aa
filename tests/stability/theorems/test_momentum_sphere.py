"""A free body about a principal axis where the two criteria are silent.

The energy on the momentum sphere, at exact points of it.
"""
from fractions import Fraction
from itertools import product

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import gyrostat as gs
from gyrostat.stability.decision import Verdict

sizes = st.fractions(min_value=Fraction(1, 4), max_value=4, max_denominator=6)
rates = st.fractions(min_value=-3, max_value=3, max_denominator=6).filter(bool)


def strict_extremum(inertia, rotor, rate, axis, step):
    """Whether the energy has one strict sign at rational points of the sphere around the rotation.

    None where it is constant.
    """
    b, c = (n for n in range(3) if n != axis)
    R = inertia[axis] * rate + rotor

    def energy(s, t):
        # stereographic: a rational point of the sphere |M| = |R|
        size = 1 + s * s + t * t
        M = [Fraction(0)] * 3
        M[b], M[c], M[axis] = 2 * s * R / size, 2 * t * R / size, (1 - s * s - t * t) * R / size
        return sum((m - (rotor if n == axis else 0)) ** 2 / (2 * inertia[n]) for n, m in enumerate(M))

    around = [(step * x, step * y) for x, y in product(range(-2, 3), repeat=2) if (x, y) != (0, 0)]
    # the valley of the energy bends away from the axis: its bottom is looked for along each direction
    changes = [energy(s, t) - energy(Fraction(0), Fraction(0)) for s, t in around]
    if not any(changes):
        return None
    return min(changes) > 0 or max(changes) < 0


@pytest.mark.slow
@pytest.mark.parametrize("axis", [1, 2, 3])
@given(I=st.tuples(sizes, sizes, sizes), rate=rates, which=st.integers(0, 1),
       equal=st.sampled_from(["", "own", "others", "all"]))
@settings(max_examples=12)
def test_verdicts_where_a_coefficient_vanishes(axis, I, rate, which, equal):
    """f_b f_c = 0 exactly: stable where the energy has a strict extremum on the sphere, or is constant.

    Never undecided.
    """
    a = axis - 1
    b, c = ([n for n in range(3) if n != a])[::1 if which else -1]
    I = list(I)
    if equal in ("own", "all"):
        I[b] = I[a]
    if equal in ("others", "all"):
        I[c] = I[b]
    rotor = (I[b] - I[a]) * rate                           # R = I_b ω: f_b = 0
    if I[a] * rate + rotor == 0:
        return
    body = gs.Gyrostat(tuple(I), tuple(rotor if n == a else 0 for n in range(3)))
    report = gs.analyze(gs.principal_rotation(gs.assemble(body), axis))
    decision = report.verdict({f"omega{axis}_0": rate})
    assert decision.verdict is not Verdict.UNDECIDED
    if not decision.modulo:
        found = strict_extremum(I, rotor, rate, a, Fraction(1, 10**4))
        expected = found is None or found
        if (I[b] - I[a]) * (I[b] - I[c]) != 0:             # theory: f_b = 0 ≠ f_c
            assert (decision.verdict is Verdict.STABLE) == ((I[b] - I[a]) * (I[b] - I[c]) > 0)
        assert (decision.verdict is Verdict.STABLE) == expected


def test_the_generic_case_in_symbols():
    """One report in symbols: I = (1, 2, 3), l = −2 ω about axis 3 has f1 = 0; I = (2, 1, 3), l = −ω.

    And with three equal moments.
    """
    free = gs.assemble(gs.Gyrostat(gyrostatic_momentum=(0, 0, gs.symbol("l"))))
    report = gs.analyze(gs.principal_rotation(free, 3))
    for inertia, l, expected in (((1, 2, 3), -2, "STABLE"), ((2, 1, 3), -1, "UNSTABLE"),
                                 ((2, 2, 3), -1, "STABLE"),
                                 ((2, 2, 2), 0, "STABLE"), ((3, 2, 3), 0, "UNSTABLE"),
                                 ((2, 1, "1/2"), "3/2", "STABLE")):
        values = dict(zip(("I1", "I2", "I3"), inertia)) | {"l": l, "omega3_0": 1}
        assert report.verdict(values).verdict.name == expected, inertia
