"""A condition solved for one parameter: free and asymmetric bodies, and sets that the boundary decides."""
import random
from fractions import Fraction
from functools import partial

import oracle
import pytest
from parameters.solved import BODY, truth
from sympy import oo, pi

import gyrostat as gs
from gyrostat.algebra.text.numbers import exact_number
from gyrostat.parameters.sets import INCLUDED
from gyrostat.parameters.solve import solve_condition
from gyrostat.parameters.stabilizing_set import stabilizing_set
from gyrostat.printing.formats.text import text
from gyrostat.printing.results.beyond_reports import result_blocks


@pytest.mark.slow
@pytest.mark.parametrize("name", ["l", "I2", "omega3_0"])
def test_a_free_body_in_closed_form(name):
    """Rotation about axis 3 with l along it.

    The set is that of the verdicts, ends included as the fourth order says.
    """
    report = gs.analyze(
        gs.principal_rotation(gs.assemble(gs.Gyrostat(gyrostatic_momentum=(0, 0, gs.symbol("l")))), 3)
    )
    solution, draw = stabilizing_set(report, name), random.Random(name)
    for n in range(60):
        values = {s: Fraction(draw.randint(1, 4)) for s in ("I1", "I2", "I3")}
        values |= {s: Fraction(draw.randint(-3, 3)) for s in ("l", "omega3_0")}
        if n % 2:
            values["l"] = (values[("I1", "I2")[n % 4 // 2]] - values["I3"]) * values["omega3_0"]
        assert solution.contains(values) is truth(report, values), values


@pytest.mark.slow
def test_where_the_margin_is_zero_all_along():
    """U = k3 + a (k3 − 1)², P² = 4 I1: on the boundary for every a, stable for a ≥ −1/2.

    I2 of a free body with f1 = 0 likewise.
    """
    report = gs.analyze(
        gs.upright(gs.assemble(BODY, gs.axial_potential(lambda z: z + gs.symbol("a") * (z - 1) ** 2)))
    )
    free = gs.analyze(
        gs.principal_rotation(gs.assemble(gs.Gyrostat(gyrostatic_momentum=(0, 0, gs.symbol("l")))), 3)
    )
    for r, name, values, expected in ((report, "a", {"I1": 1, "l": 0, "pi3_0": 2}, Fraction(-1, 2)),
                                      (free, "I2", {"I1": 1, "I3": 3, "l": -2, "omega3_0": 1}, 1)):
        numeric, symbolic = stabilizing_set(r, name, values), stabilizing_set(r, name)
        (interval,) = numeric.parts[0].cases[0].intervals
        assert (interval.low, interval.low_if, interval.high) == (expected, INCLUDED, oo)
        for x in (Fraction(1, 3), Fraction(-3, 5), Fraction(2), Fraction(expected)):
            if x > 0 or name == "a":
                assert (
                    numeric.contains({name: x})
                    is symbolic.contains(values | {name: x})
                    is truth(r, values | {name: x})
                )


def test_a_claimed_point_that_is_on_the_boundary_for_every_value():
    """E1 of numbers, P² = 4 I1 U' exactly: no margin is left, and the ladder decides: a ≥ −1/2."""
    scene = gs.assemble(gs.Gyrostat((1, 1, 1), (0, 0, 2)),
                        gs.axial_potential(lambda z: z + gs.symbol("a") * (z - 1) ** 2))
    report = gs.analyze(gs.equilibrium(scene, (0, 0, 0, 0, 0, 1)))
    (interval,) = stabilizing_set(report, "a").parts[0].cases[0].intervals
    assert (interval.low, interval.low_if, interval.high) == (Fraction(-1, 2), INCLUDED, oo)
    assert [report.verdict({"a": a}).verdict.name for a in (-1, "-1/2", 0)] == [
        "UNSTABLE",
        "STABLE",
        "STABLE",
    ]


def test_ends_of_an_unspecified_field():
    """The ends of E1 belong to the set where U' + U'' > 0; three rungs of the ladder are kept."""
    report = gs.analyze(gs.upright(gs.assemble(BODY, gs.axial_potential())))
    part = solve_condition(report.sufficient.alternatives[0][0], "l", report.boundary)
    above = part.cases[2].intervals[0]
    dU, d2U, d3U, d4U = map(gs.symbol, ("dU", "d2U", "d3U", "d4U"))
    assert above.high_if == (d2U + dU, -3 * d2U - 2 * d3U, 2 * d3U + d4U)


ASYMMETRIC = [((2, 1, 3), "omega3_0", {"m0": 1, "l": 0}), ((2, 3, 1), "l", {"m0": 1, "omega3_0": 4}),
              ((2, 3, 1), "omega3_0", {"m0": 1, "l": 1}),
              ((1, 2, "5/2"), "m0", {"omega3_0": "3/2", "l": -1}),
              ((3, 4, 2), "l", {"m0": -2, "omega3_0": 1})]


@pytest.mark.slow
@pytest.mark.parametrize("wholly", [True, pytest.param(False, marks=pytest.mark.slow)])
@pytest.mark.parametrize(("inertia", "name", "values"),
                         [ASYMMETRIC[1], *(pytest.param(*case, marks=pytest.mark.slow) for case in (
    ASYMMETRIC[:1] + ASYMMETRIC[2:]))])
def test_an_asymmetric_body_as_far_as_it_is_proved(inertia, name, values, wholly):
    """Unstable iff Euler and Poisson's equations have a growing mode.

    Stable where (I3 − Ii) ω² + l ω − m0 > 0 for both; and by D4 wherever else no mode grows.

    With numbers for all other names, and with none: then what is claimed is true, and what is sufficient is
    found, of the rest nothing is proved.
    """
    body = gs.Gyrostat(tuple(map(exact_number, inertia)), (0, 0, gs.symbol("l")))
    report = gs.analyze(gs.upright(gs.assemble(body, gs.axial_potential(lambda z: gs.symbol("m0") * z)),
                                   "omega3_0"))
    solution, kinds = stabilizing_set(report, name, values if wholly else None), set()
    I1, I2, I3 = map(Fraction, inertia)
    for n in range(-40, 41, 2):
        v = {s: Fraction(x) for s, x in values.items()} | {name: Fraction(n, 4)}
        omega, l, m0 = v["omega3_0"], v["l"], v["m0"]
        x, moments, rotor = oracle.exact([0, 0, I3 * omega, 0, 0,
                                          1]), oracle.exact([I1, I2, I3]), oracle.exact([0, 0, l])
        unstable = oracle.growth(partial(oracle.field, inertia=moments, rotor=rotor,
                                         slope=oracle.axial_slope(m0, Fraction(0), 1)), x)
        rises = [(I3 - i) * omega**2 + l * omega - m0 for i in (I1, I2)]
        lowest = min(rises)
        stable = lowest > 0
        answer = solution.contains({name: v[name]} if wholly else v)
        kinds.add(answer)
        if lowest == 0 and not unstable:                   # the fourth order may prove it stable
            assert answer is not False
            continue
        if max(rises) == 0 and not unstable:               # terms of higher degree decide
            continue
        assert (
            answer is (stable or not unstable)
            or not wholly
            and answer is None
            and not stable
        ), v
    shown = text(result_blocks(solution))
    assert len(kinds) > 1 and shown.count("\n") >= len(solution.parts) and shown.count("Stable:") <= 1
    left = "Nothing is proved for" if wholly else "a verdict at given numbers may"
    assert None not in kinds or left in shown


@pytest.mark.slow
def test_a_rate_in_rpm_is_that_in_radians():
    """The ends of the set are 30/π times the others; π stands in every coefficient of the sextic."""
    def ends(unit):
        tensor = [[45, "0.9", 0], ["0.9", 52, "1.1"], [0, "1.1", 31]]
        wheel = gs.Rotor((0, 1, 0), axial="1/50", rate=gs.symbol("s") * unit)
        orbit = gs.circular_orbit("0.0011")
        body = gs.earth_pointing_gyrostat(gs.gyrostat_with_rotors(tensor, [wheel], lumped=True), orbit)
        report = gs.analyze(gs.earth_pointing(gs.assemble(body, orbit)))
        return [float(end) for part in stabilizing_set(report, "s").parts for case in part.cases
                for interval in case.intervals for end in (interval.low, interval.high) if abs(end) != oo]

    radians = ends(1)
    assert len(radians) > 4
    assert ends(pi / 30) == pytest.approx([x * float(30 / pi) for x in radians], rel=1e-13)  # doubles
