"""Permanent rotations in any direction k1, k2, k3, in closed form: against matrices, and in doubles."""
import json
import random
from fractions import Fraction

import numpy as np
import pytest
from heavy_scenes import by_criteria, k1, k2, k3
from oracles.heavy import growth, squares
from rotation_families import LINEAR, NAMES, QUADRATIC, asked, claimed, drawn, family, parts
from slow import sampled
from sympy import Matrix, Rational, S, sqrt

import gyrostat as gs
from gyrostat.errors import ScopeError, ValuesError
from gyrostat.printing.formats.json_data import json_text, report_data


@pytest.fixture(scope="module")
def families():
    return {"linear": family(LINEAR), "quadratic": family(QUADRATIC), "unspecified": family()}


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["linear", "quadratic", "unspecified"])
def test_p_and_q_are_those_of_the_matrix_and_t_and_s_its_signs(families, kind, full):
    """λ⁴ + p λ² + q of the linearisation; the second variation is definite where t, s > 0. Exact, any k."""
    rng, seen = random.Random(f"closed {kind}"), set()
    for _ in range(sampled(300, full, 5)):
        numbers, Q = drawn(rng, kind != "linear")
        eq, report = claimed(numbers, Q), families[kind]
        decision = report.verdict(asked(numbers, kind, Q))
        found = {str(margin): value for margin, value in decision.margins}
        wanted = dict(zip("pq", gs.derivation.linearize(eq).coefficients))
        assert all(found.get(name, value) == value for name, value in wanted.items())
        matrix = gs.derivation.second_variation(eq).matrix
        definite = all(matrix[:n, :n].det() > 0 for n in range(1, 5))
        assert bool(found["t"] > 0 and found["s"] > 0) is definite
        if kind != "unspecified" or decision.verdict.name != "UNDECIDED":
            theirs = gs.analyze(eq)
            assert decision.verdict is theirs.verdict({}).verdict
            damped = report.verdict(asked(numbers, kind, Q), damped=True)
            there = theirs.verdict({}, damped=True)
            assert (damped.verdict, damped.growing) == (there.verdict, there.growing)
        seen.add(by_criteria(decision))
    assert seen == {"STABLE", "UNSTABLE", "UNDECIDED"} or not full


@pytest.mark.slow
def test_verdicts_against_eigenvalues_in_doubles(families, full):
    """Of the Euler-Poisson equations and of D²(h + ν·C): nothing is shared."""
    rng = random.Random("doubles")
    for _ in range(sampled(3000, full, 100)):
        numbers, Q = drawn(rng, True)
        inertia, rotor, c, k, omega = parts(numbers, Q)
        matrices = [np.array(x.tolist(), float) for x in (inertia, Q)]
        rotor, c, k = (np.array(list(x), float) for x in (rotor, c, k))
        data = matrices[0], rotor, c, matrices[1], float(omega), k
        rate, form = growth(*data), squares(*data)
        verdict = by_criteria(families["quadratic"].verdict(asked(numbers, "quadratic", Q)))
        if abs(form).min() > 1e-6 * abs(form).max():      # off the boundary
            assert (verdict == "STABLE") == (form.min() > 0 or form.max() < 0)
        if rate > 1e-4:                                   # a double zero is off by the root of the rounding
            assert verdict == "UNSTABLE"
        if verdict == "UNSTABLE":
            assert rate > 1e-9


@pytest.mark.few(4)
@pytest.mark.parametrize(("numbers", "p", "q"), [
    ((3, 5, 4, 0, 0, 0, "2/3", "1/3", "2/3", -1, -3), "2/3", "2/135"),
    ((4, 6, 3, 0, 0, 0, "-2/3", "1/3", "2/3", -1, -3), "209/324", "1/81"),
    ((6, 3, 4, 0, 0, 0, "1/3", "-2/3", "2/3", -1, -3), "209/324", "1/81"),
    ((6, 4, 3, 0, 0, 0, "1/3", "2/3", "2/3", 1, -3), "209/324", "1/81"),
    ((3, 4, 5, -1, 2, -1, "1/3", "2/3", "-2/3", -1, -2), "479/540", "52/405")])
def test_known_p_and_q(families, numbers, p, q):
    """Of five maxima of the amended potential that are known in fractions, one with a rotor."""
    decision = families["linear"].verdict(dict(zip(NAMES, numbers)))
    found = {str(margin): value for margin, value in decision.margins}
    assert (found["p"], found["q"]) == (Rational(p), Rational(q))
    assert found["s"] > 0 > found["t"] and by_criteria(decision) == "UNDECIDED"
    assert "gyroscopic forces stabilise it; D4 = " in decision.reason and decision.verdict.name == "STABLE"


def test_a_rotation_of_staude(families):
    """I = (1, 2, 3), U = c·k, c = (1, 1, 1)/√3, k = (−1, −3, 3)/√19: stable; p, q, s, t to 12 digits."""
    k = [x / sqrt(19) for x in (-1, -3, 3)]
    rate = sqrt(sqrt(19) / sqrt(3) * Rational(2, 3))      # omega² (Ik)_1 k_2 − … : two equations of the cone
    sigma = 1 / (sqrt(3) * k[0]) - rate**2
    for n in (1, 2):
        assert (rate**2 * (n + 1) * k[n] + sigma * k[n] - 1 / sqrt(3)).simplify() == 0
    decision = families["linear"].verdict(dict(zip(NAMES, (1, 2, 3, 0, 0, 0, *k, rate, sigma))))
    named = families["linear"].closed.at(decision_point(1, 2, 3, 0, 0, 0, *k, rate, sigma))
    assert decision.verdict.name == "STABLE"
    known = {"t": 3.35164274701, "s": 1.70209339775, "p": 2.28113905939, "q": 0.686809616634}
    assert {str(name): float(value) for name, value in named.items()} == pytest.approx(known, rel=1e-11)


def decision_point(*numbers):
    from gyrostat.algebra.reals.exact import Point
    return Point({gs.symbol(name): S(x) for name, x in zip(NAMES, numbers)})


@pytest.mark.slow
def test_a_tensor_and_a_claimed_family():
    """A body turned out of its principal axes, and one at rest in a family that is claimed."""
    turn = Matrix([[2, -1, 2], [2, 2, -1], [-1, 2, 2]]) / 3
    inertia, k = turn * Matrix.diag(3, 5, 4) * turn.T, Matrix([2, 3, 6]) / 7
    rotor = Matrix([1, Rational(1, 2), -1])
    report = family(LINEAR, inertia=inertia.tolist(), gyrostatic_momentum=tuple(rotor))
    for omega, sigma in ((2, -3), (-1, -9), (3, -20), (0, -1)):
        place = dict(zip(NAMES[6:], (*k, omega, sigma)))
        c = omega**2 * inertia * k + omega * rotor + sigma * k
        U = sum(x * y for x, y in zip(c, (k1, k2, k3)))
        eq = gs.equilibrium(gs.assemble(report.equilibrium.system.body, gs.general_potential(U)),
                            (*(omega * inertia * k), *k))
        decision = report.verdict(place)
        assert decision.verdict is gs.analyze(eq).verdict({}).verdict
        found = {str(margin): value for margin, value in decision.margins}
        coefficients = gs.derivation.linearize(eq).coefficients
        assert all(found.get(x, value) == value for x, value in zip("pq", coefficients))
    relations = [(f"c{n}", gs.symbol("sigma") * x) for n, x in enumerate((k1, k2, k3), 1)]
    rest = gs.analyze(gs.equilibrium(report.equilibrium.system, (0, 0, 0, k1, k2, k3), relations=relations))
    assert rest.verdict({"k1": k[0], "k2": k[1], "k3": k[2], "sigma": -1}).margins == decision.margins


def test_along_an_axis_it_is_the_upright_rotation():
    """k = (0, 0, 1), l and c along it: the conditions are those of E1 with dU = c3."""
    body = gs.Gyrostat(gyrostatic_momentum=(0, 0, gs.symbol("l")))
    scene = gs.assemble(body, gs.general_potential(LINEAR))
    ours = gs.analyze(gs.permanent_rotation(scene, (0, 0, 1)))
    upright = gs.analyze(gs.upright(gs.assemble(body, gs.uniform_field()), spin="omega3_0"))
    omega, sigma, l, I3 = map(gs.symbol, ("omega", "sigma", "l", "I3"))
    placed = {gs.symbol("omega3_0"): omega, gs.symbol("m0"): omega**2 * I3 + omega * l + sigma}
    for mine, other in ((ours.sufficient, upright.sufficient), (ours.necessary, upright.necessary)):
        assert {c.margin.expand() for c in mine.alternatives[0]} == {
            c.margin.xreplace(placed).expand() for c in other.alternatives[0]}


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["linear", "unspecified"])
def test_the_definitions_in_json_are_the_conditions(families, kind):
    """Evaluated in turn in fractions, as they are written."""
    data = json.loads(json_text(report_data(families[kind])))
    assert data["eliminated"] == (["c1", "c2", "c3"] if kind == "linear" else ["dU_1", "dU_2", "dU_3"])
    (conditions,) = (a["all_of"] for a in data["sufficient"]["any_of"])
    assert [c["margin"] for c in conditions] == ["t", "s"]
    rng = random.Random("json")
    for _ in range(5):
        numbers, Q = drawn(rng, kind != "linear")
        place = {n: Fraction(str(x)) for n, x in asked(numbers, kind, Q).items()}
        for name, text in data["definitions"].items():
            place[name] = eval(text, {}, place)
        wanted = gs.derivation.linearize(claimed(numbers, Q)).coefficients
        assert tuple(Rational(place[name]) for name in "pq") == wanted


def test_directions_that_are_no_unit_vectors(families):
    numbers = dict(zip(NAMES, (1, 2, 3, 0, 0, 0, "3/5", 0, "4/5", 1, 2)))
    with pytest.raises(ValuesError, match=r"k = \(1/2, 0, 4/5\) has \|k\|² − 1 = -11/100: k is a direction"):
        families["linear"].verdict(numbers | {"k1": "1/2"})
    with pytest.raises(ValuesError, match="needs .*k2"):
        families["linear"].verdict({n: x for n, x in numbers.items() if n != "k2"})
    with pytest.raises(ValuesError, match="needs c1 = 9/5, given was 2"):
        families["linear"].verdict(numbers | {"c1": 2})
    assert families["linear"].verdict(numbers | {"c1": "9/5"}).verdict.name == "UNSTABLE"
    root = dict(zip(NAMES, (1, 2, 3, 0, 0, 0, "sqrt(2)/2", 0, "-sqrt(2)/2", 2, -20)))
    assert families["linear"].verdict(root).verdict.name == "STABLE"


@pytest.mark.few(6)
@pytest.mark.parametrize("moments", [(1, 2, 3), (3, 2, 1), (2, 3, 1), (1, 3, 2), (2, 2, 1), (1, 1, 2)])
@pytest.mark.parametrize(("weight", "rotor"), [(0, 0), (1, 0), (-5, 0), (0, 1), (0, -2)])
def test_along_an_axis_it_is_asked_at_numbers(families, moments, weight, rotor):
    """Where M × k = 0 the damping may not reach every motion; without a weight the body is free, M may be 0.
    """
    rotor *= moments[2]
    numbers = dict(zip(NAMES, (*moments, 0, 0, rotor, 0, 0, 1, 2, weight - moments[2] * 4 - 2 * rotor)))
    scene = gs.assemble(gs.Gyrostat(moments, (0, 0, rotor)), gs.general_potential(S(weight) * k3))
    there = gs.analyze(gs.equilibrium(scene, (0, 0, 2 * moments[2], 0, 0, 1)))
    ours, theirs = families["linear"].verdict(numbers), there.verdict({})
    assert ours.verdict is theirs.verdict
    ours, theirs = families["linear"].verdict(numbers, damped=True), there.verdict({}, damped=True)
    assert (ours.verdict, ours.growing) == (theirs.verdict, theirs.growing)
    assert theirs.reason.endswith(ours.reason)            # a body of revolution is recognised first


def test_what_takes_ranges_asks_for_stereographic_coordinates(families):
    report = families["linear"]
    for ask in (lambda: gs.charts.verdicts(report, {"k1": [0, 1]}),
                lambda: gs.charts.certify_box(report, {"k1": (0, 1)}),
                lambda: gs.stabilizing_set(report, "sigma", {}),
                lambda: gs.spectrum(report.equilibrium, "k1", [0, 1], {}), lambda: report.linearization,
                lambda: report.second_variation):
        with pytest.raises(ScopeError, match=r"permanent_rotation\(scene, stereographic\(\)\)"):
            ask()


def test_a_parameter_with_the_name_of_a_definition():
    """It is the user's: the definitions take other names, and nothing else changes."""
    plain = family(gs.symbol("b1") * k1 + gs.symbol("b2") * k2).closed.definitions
    for first, second in ("qp", "sG", "JK", "vA"):
        report = family(gs.symbol(first) * k1 + gs.symbol(second) * k2)
        names = [name.name for name, _ in report.closed.definitions]
        assert not {first, second} & set(names) and len(set(names)) == len(plain)
        assert {first, second}.isdisjoint(str(report.necessary) + str(report.sufficient))


def test_bodies_of_revolution_are_recognised_at_numbers(families):
    """Along its axis a maximum of the amended potential is a sleeping top, here fast enough: stable."""
    numbers = dict(zip(NAMES, (1, 1, "3/2", 0, 0, 0, 0, 0, 1, 4, "-31/2")))
    decision = families["linear"].verdict(numbers)
    assert decision.verdict.name == "STABLE" and dict(decision.margins)[gs.symbol("t")] == -1
    assert decision.reason == "at these numbers the second variation is definite on the symplectic slice"
    along = dict(zip(NAMES, ("3/2", 1, 1, 0, 0, 0, 1, 0, 0, 4, "-31/2")))
    assert families["linear"].verdict(along).verdict.name == "STABLE"
    axial = gs.assemble(gs.symmetric_gyrostat(), gs.general_potential(k3**2))
    with pytest.raises(ScopeError, match="has the integral pi3, whose flow carries"):
        gs.permanent_rotation(axial)
