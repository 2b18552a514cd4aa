"""Verdicts of bodies of revolution that are not entered in the standard way, against the oracle of the
reduced motion.
"""
import random
from fractions import Fraction as F

import oracle
import pytest
from slow import sampled
from sympy import Rational, exp, pi, sqrt
from turns import OBLIQUE, TURNS, K, scene, turned

import gyrostat as gs
from gyrostat.charts.signs.verdict_arrays import verdicts
from gyrostat.printing.formats.article import to_latex
from gyrostat.stability.decision import Verdict
from gyrostat.trajectories import confirm

k1, k2, k3 = K
pi1, pi2, pi3 = (gs.symbol(f"pi{i}") for i in (1, 2, 3))


def drawn(draw, name):
    """A body, a field and a point of it in the standard axes, as often as not on the boundary.

    Whether it is stable, by the oracle.
    """
    number = lambda low=-6: F(draw.randint(low, 6), draw.randint(1, 3))  # noqa: E731
    I1, l, spin = number(1), number(), number()
    I3 = I1 if name in OBLIQUE else number(1)
    c = [number() for _ in range(draw.randint(2, 7))]
    kind = draw.choice(("E1", "E2", "E3"))

    def derivative(n, z):
        return sum(c[m - 1] * z ** (m - n) * falling(m, n) for m in range(n, len(c) + 1))

    if kind != "E3":
        s = 1 if kind == "E1" else -1
        if draw.random() < 0.7:
            c[0] += (spin + l) ** 2 / (4 * s * I1) - derivative(1, F(s))
            if draw.random() < 0.5:                    # 2 n U'' + U' = 0 too: the next rung decides
                c[1] -= (derivative(2, F(s)) + s * derivative(1, F(s))) / 4
                c[0] += (spin + l) ** 2 / (4 * s * I1) - derivative(1, F(s))
        x = (F(0), F(0), spin, F(0), F(0), F(s))
    else:
        k, z = draw.choice(((F(3, 5), F(4, 5)), (F(12, 13), F(-5, 13)), (F(1), F(0)), (F(4, 5), F(-3, 5))))
        c[0] += spin * l - spin**2 * z * (I1 - I3) - derivative(1, z)
        x = (I1 * spin * k, F(0), I3 * spin * z, k, F(0), z)
    U = [F(0), *c]
    e, v, P = oracle.axial_integrals(x, I1, l, U)
    sides = (1, -1) if kind == "E3" else (-x[5],)
    leaves = oracle.moves_away(oracle.reduced_motion(I1, e, v, P, U), x[5], sides)
    return I1, I3, l, c, x, Verdict.UNSTABLE if leaves else Verdict.STABLE


def falling(m, n):
    """m (m − 1) … (m − n + 1)."""
    return 1 if n == 0 else m * falling(m - 1, n - 1)


def checked(draw, name):
    """The verdict at a random point about an axis, with U spelled with abs(k)² = 1, is that of the reduced
    motion; so is the flow.
    """
    I1, I3, l, c, x, expected = drawn(draw, name)
    this = scene(name, I1, I3, l, c, [draw.randint(-2, 2) for _ in range(3)])
    decision = gs.analyze(gs.equilibrium(this, turned(name, x))).verdict({})
    assert decision.verdict is expected, (name, I1, I3, l, c, x, decision)
    if x[3]:
        (modulo,) = decision.modulo
        along = TURNS[name].row(2).dot([pi1, pi2, pi3])
        assert (modulo / along).simplify().is_number
    else:
        assert decision.modulo == ()
    return decision


@pytest.mark.slow
@pytest.mark.parametrize("name", ["axis 1", "(3, 4, 0)"])
def test_verdicts_about_every_axis(name):
    """Interior, boundary with one or more rungs, and tilts.

    Stable where no motion of the level leaves, modulo the spin about the axis.
    """
    draw = random.Random(f"13 {name}")
    for _ in range(2):
        checked(draw, name)


@pytest.mark.slow
@pytest.mark.parametrize("name", TURNS)
def test_many_verdicts_about_every_axis(name, full):
    """The same, 60 of each axis."""
    draw = random.Random(f"14 {name}")
    for _ in range(sampled(60, full, 8)):
        checked(draw, name)


def test_the_boundary_theorem_speaks_about_another_axis():
    """P² = 4 I1 U'(k1): one sentence says what was recognised, and no component has a name that is not the
    user's.
    """
    report = gs.analyze(gs.equilibrium(scene("axis 1", 1, 3, 0, (1,)), (2, 0, 0, 1, 0, 0)))
    decision = report.verdict({})
    assert decision.verdict is Verdict.STABLE
    assert decision.reason.startswith("recognised as a body of revolution about axis 1: on the boundary")
    assert "x stays small" in decision.reason
    assert "k3" not in decision.reason
    assert report.boundary.rung(3).condition.margin == 1
    oblique = gs.analyze(gs.equilibrium(scene("(3, 4, 0)", 1, 1, 0, (-1,)),
                                        (-F(6, 5), -F(8, 5), 0, -F(3, 5), -F(4, 5), 0))).verdict({})
    assert oblique.verdict is Verdict.STABLE
    assert "the axis c along (3, 4, 0)" in oblique.reason
    assert "x stays small" in oblique.reason


def general():
    """A gyrostat in symbols, the field U = a k1 + b k2² + e k1 k2 in the direction of axis 1, spinning about
    it.
    """
    U = gs.general_potential(gs.symbol("a") * k1 + gs.symbol("e") * k2 * k3)
    return gs.assemble(gs.Gyrostat(gyrostatic_momentum=(gs.symbol("l1"), 0, 0)), U)


def test_equality_at_the_numbers_given_is_enough():
    """I2 = I3 and e = 0 at the numbers only.

    Beyond, on and below P² = 4 I2 a, in the interior too where only gyroscopic forces hold it.
    """
    report = gs.analyze(gs.equilibrium(general(), (gs.symbol("pi1_0"), 0, 0, 1, 0, 0)))
    numbers = {"I1": 1, "I2": "3/2", "I3": "3/2", "l1": 1, "a": "3/2", "e": 0}
    decisions = [report.verdict(numbers | {"pi1_0": p}) for p in ("1.9", 2, "2.1")]
    assert [d.verdict.name for d in decisions] == ["UNSTABLE", "STABLE", "STABLE"]
    assert decisions[1].reason.startswith("at these numbers recognised as a body of revolution about axis "
                                          "1: on the boundary")
    assert list(verdicts(report, numbers, pi1_0=[1.5, 2.0, 2.5])) == [-1, 1, 1]
    near = report.verdict(numbers | {"pi1_0": 2, "I3": Rational(3, 2) + Rational(1, 10**30)})
    assert "recognised" not in near.reason


def test_unspecified_field_at_equal_moments_asks_for_its_derivatives():
    """U(k3) unspecified and I1 = I2 at the numbers: the boundary asks for d2U, and with it decides."""
    scene = gs.assemble(gs.Gyrostat(gyrostatic_momentum=(0, 0, gs.symbol("l"))), gs.axial_potential())
    report, on = gs.analyze(gs.upright(scene)), {"I1": 1, "I2": 1, "I3": 2, "l": 0, "pi3_0": 2, "dU": 1}
    assert "give d2U" in report.verdict(on).reason and report.verdict(on).verdict is Verdict.UNDECIDED
    assert [report.verdict(on | {"d2U": d}).verdict.name for d in (1, -2)] == ["STABLE", "UNSTABLE"]


def test_tilted_family_in_symbols_is_modulo_the_spin_about_its_axis():
    """Axis 1, U = k1: the criterion, the drift of the point itself, and the same decision as of E3 in the
    standard axes.
    """
    I1, I3, c, omega = (gs.symbol(n) for n in ("I1", "I3", "c", "omega"))
    this = gs.assemble(gs.Gyrostat((I3, I1, I1), (gs.symbol("l1"), 0, 0)), gs.general_potential(k1))
    point = (I3 * omega * c, 0, I1 * omega * sqrt(1 - c**2), c, 0, sqrt(1 - c**2))
    report = gs.analyze(gs.equilibrium(this, point, relations=(("l1", 1 / omega + omega * c * (I1 - I3)),),
                                       domain=(1 - c**2, omega**2)))
    values = {"I1": 2, "I3": 1, "omega": 1, "c": "1/2"}
    standard = gs.analyze(gs.inclined(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(k3))))
    theirs = standard.itself({"I1": 2, "I3": 1, "omega": 1, "k3": "1/2"})
    ours = report.itself(values)
    assert report.verdict(values).modulo == (pi1,) and ours.verdict is theirs.verdict is Verdict.UNSTABLE
    assert ours.reason.endswith(theirs.reason.replace("∂k3", "∂k1"))
    assert [x for _, x in ours.margins] == [x for _, x in theirs.margins]
    assert "recognised as a body of revolution about axis 1" in to_latex(report)


def test_rotation_that_is_stable_in_no_field_is_not_said_to_leave():
    """Three equal moments, l = 0, U constant: ω ∥ k is stable at any tilt, where x² of g is negative.

    At rest k drifts.
    """
    free = gs.assemble(gs.Gyrostat((1, 1, 1), (0, 0, 0)), gs.axial_potential(0))
    assert gs.analyze(gs.equilibrium(free, (1, 0, 0, 1, 0, 0))).verdict({}).verdict is Verdict.STABLE
    assert gs.analyze(gs.upright(free)).verdict({"pi3_0": 0}).verdict is Verdict.UNSTABLE


def test_moments_equal_in_two_spellings():
    """√(4 + 2√3) = 1 + √3: recognised, as is the body that has the first of them twice, entered in the
    standard way or not.
    """
    nested, plain = sqrt(4 + 2 * sqrt(3)), 1 + sqrt(3)
    for inertia, field in (((nested, plain, 1), gs.general_potential(k3)),
                           ((nested, nested, 1), gs.axial_potential(k3))):
        this = gs.assemble(gs.Gyrostat(inertia, (0, 0, 0)), field)
        report = gs.analyze(gs.equilibrium(this, (0, 0, 2 * sqrt(plain), 0, 0, 1)))
        assert report.verdict({}).verdict is Verdict.STABLE


@pytest.mark.parametrize(("inertia", "rotor", "U", "point"), [
    ((1, 1, 3), (0, 0, 0), k1, (2, 0, 0, 1, 0, 0)), ((2, 2, 2), (1, 1, 0), k1, (1, 1, 0, 1, 0, 0)),
    ((2, 2, 2), (0, 0, 0), k1 + k2**2 / 10, (4, 0, 0, 1, 0, 0))])
def test_what_is_not_of_revolution_keeps_its_own_criteria(inertia, rotor, U, point):
    """A body of revolution in a field that is none, a rotor or a field off the axis.

    No sentence, no ladder.
    """
    this = gs.assemble(gs.Gyrostat(inertia, rotor), gs.general_potential(U))
    if rotor == (1, 1, 0):
        with pytest.raises(gs.errors.EquilibriumError):
            gs.equilibrium(this, point)
        return
    report = gs.analyze(gs.equilibrium(this, point))
    assert report.recognised is None
    assert report.boundary is None
    assert "recognised" not in report.verdict({}).reason


def test_transcendental_field_about_an_oblique_axis():
    """U = exp(c·k) on a sphere, c = (1, 1, 1)/√3.

    On the boundary of E1 the ladder decides, off it the criterion.
    """
    this = gs.assemble(gs.Gyrostat((1, 1, 1), (0, 0, 0)), gs.general_potential(exp((k1 + k2 + k3) / sqrt(3))))
    for factor, expected in ((1, Verdict.STABLE), (Rational(99, 100), Verdict.UNSTABLE),
                             (Rational(101, 100), Verdict.STABLE)):
        spin = 2 * exp(Rational(1, 2)) * factor / sqrt(3)
        report = gs.analyze(gs.equilibrium(this, (spin, spin, spin, 1 / sqrt(3), 1 / sqrt(3), 1 / sqrt(3))))
        assert report.verdict({}).verdict is expected, report.verdict({})


@pytest.mark.slow
@pytest.mark.parametrize("second", [2 ** Rational(1, 3), pi, sqrt(2)])
def test_axes_of_other_numbers(second):
    """c along (1, ∛2, 0), (1, π, 0), (1, √2, 0): P² = 4 I1 U', U = c·k."""
    length = sqrt(1 + second**2)
    this = gs.assemble(gs.Gyrostat((1, 1, 1), (0, 0, 0)), gs.general_potential((k1 + second * k2) / length))
    for spin, expected in ((2, Verdict.STABLE), (Rational(21, 10), Verdict.STABLE),
                           (Rational(19, 10), Verdict.UNSTABLE)):
        point = (spin / length, spin * second / length, 0, 1 / length, second / length, 0)
        decision = gs.analyze(gs.equilibrium(this, point)).verdict({})
        assert decision.verdict is expected and ("on the boundary" in decision.reason) == (spin == 2)


@pytest.mark.slow
@pytest.mark.parametrize("point", [(2, 0, 0, 1, 0, 0), (3, 0, 0, 1, 0, 0), (1, 0, 0, 1, 0, 0)])
def test_motions_agree(point):
    """confirm on, above and below the boundary about axis 1, and where the moments are equal at the numbers
    only.
    """
    assert confirm(gs.analyze(gs.equilibrium(scene("axis 1", 1, 3, 0, (1,)), point)), {}).agrees
    report = gs.analyze(gs.equilibrium(general(), (gs.symbol("pi1_0"), 0, 0, 1, 0, 0)))
    assert confirm(report, {"I1": 1, "I2": 1, "I3": 1, "l1": 0, "a": 1, "e": 0, "pi1_0": point[0]}).agrees
