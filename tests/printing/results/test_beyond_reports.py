"""What is found beyond a report reads as a person would write it, in text and in LaTeX."""
from dataclasses import replace

import pytest
from sympy import Rational, oo

import gyrostat as gs
from gyrostat.equilibria.continuation.bifurcation_kinds import KINDS
from gyrostat.equilibria.continuation.meeting_equations import bifurcations
from gyrostat.equilibria.continuation.meeting_values import bifurcation_points
from gyrostat.equilibria.search import relative_equilibria
from gyrostat.mechanics.equilibrium.reduction import reduce
from gyrostat.parameters.sets import EXCLUDED, INCLUDED, Case, Interval, Solution, SolvedCondition
from gyrostat.parameters.stabilizing_set import stabilizing_set
from gyrostat.printing.formats.article import to_latex
from gyrostat.printing.formats.latex import display
from gyrostat.printing.formats.latex_names import Names
from gyrostat.printing.results.beyond_reports import result_blocks
from gyrostat.printing.results.decision import decision_blocks
from gyrostat.stability.decision import C1

BODY = gs.symmetric_gyrostat()
HEAVY = gs.assemble(BODY, gs.uniform_field())
l, m0, k3 = map(gs.symbol, ("l", "m0", "k3"))


def test_rumiantsev_solved_reads_as_three_cases():
    """Which l stabilises the upright heavy gyrostat."""
    solution = stabilizing_set(gs.analyze(gs.upright(HEAVY)), "l")
    assert str(solution) == ("Stable for m₀ < 0: every l.\nStable for m₀ = 0: l ≠ −π₃⁰.\n"
                             "Stable for m₀ > 0: l ≤ −π₃⁰ − 2 √(I₁ m₀) or l ≥ 2 √(I₁ m₀) − π₃⁰.")
    assert (
        r"\text{Stable for }m_0 > \text{0: }l \leq - \pi_3^0 - 2 \sqrt{I_1 m_0}\text{ or }l \geq 2"
        in to_latex(solution)
    )


@pytest.mark.parametrize(("intervals", "shown"), [
    ((), "no l"), ((Interval(-oo, oo),), "every l"), ((Interval(m0, m0, INCLUDED, INCLUDED),), "l = m₀"),
    ((Interval(m0, 2 * m0, INCLUDED, EXCLUDED),), "m₀ ≤ l < 2 m₀"), ((Interval(m0, oo, EXCLUDED),), "l > m₀"),
    ((Interval(m0, oo, (k3,)),), "l > m₀; l = m₀ too if k₃ > 0"),
    ((Interval(m0, oo, (k3, l)),), "l > m₀; l = m₀ too if k₃ > 0, or k₃ = 0 and l > 0"),
    ((Interval(m0, oo, (k3, m0 / m0)),), "l > m₀; l = m₀ too if k₃ > 0, or k₃ = 0"),
    ((Interval(m0, oo, (-k3**2,)),), "l > m₀"),
    ((Interval(m0, oo, (-k3**2, l)),), "l > m₀; l = m₀ too if k₃ = 0 and l > 0"),
    ((Interval(-oo, m0, EXCLUDED, (k3,)), Interval(2 * m0, oo, (k3,))),
     "l < m₀ or l > 2 m₀; the ends too if k₃ > 0"),
    ((Interval(-oo, m0, EXCLUDED, (k3,)), Interval(m0, oo, (k3,))), "l ≠ m₀; l = m₀ too if k₃ > 0"),
    ((Interval(m0, 2 * m0, INCLUDED, EXCLUDED, (Rational(1, 2), Rational(1))),),
     "m₀ ≤ l < 2 m₀ (k₃ from 1/2 to 1)")])
def test_sets_in_words(intervals, shown):
    """Ends, which of them belong, and on what it depends."""
    part = SolvedCondition("stable", l, (Case((), intervals),), k3)
    assert str(Solution("l", (part,))) == f"Stable: {shown}."


def test_where_something_is_left_open_it_is_said():
    """Between what is proved stable and what is proved unstable; not where the two are one."""
    proved, needed, stable = (SolvedCondition(meaning, l, (Case((), (Interval(m0, oo, EXCLUDED),)),), k3)
                              for meaning in ("sufficient", "necessary", "stable"))
    open_ = "Elsewhere these conditions do not decide; a verdict at given numbers may."
    assert str(Solution("l", (proved, needed))).splitlines()[-1] == open_
    assert open_ not in str(Solution("l", (stable,)))


def test_positive_names_start_at_zero():
    """A moment of inertia below a bound."""
    text = str(stabilizing_set(gs.analyze(gs.upright(HEAVY)), "I1"))
    assert "Stable for m₀ > 0 and π₃⁰ + l ≠ 0: I₁ ≤ (π₃⁰ + l)²/(4 m₀)." in text
    assert "m₀ = 0 and π₃⁰ + l ≠ 0: every I₁." in text


def test_branches_bifurcations_and_the_rest():
    """Each has a text and a formula; derivatives of U are taken where they are meant."""
    found = relative_equilibria(HEAVY, {"I1": 2, "I3": 1, "l": 1, "m0": 1, "omega": 2})
    assert list(map(str, found)) == ["E1 at k₃ = 1, ω = 2, σ = 0: stable",
                                     "E3 at k₃ = 1/4, ω = 2, σ = 0: stable",
                                     "E2 at k₃ = −1, ω = 2, σ = 0: stable"]
    every = relative_equilibria(HEAVY, {"I1": 2, "I3": 2, "l": 1, "m0": 1, "omega": 1})
    assert str(every[1]) == "E3 at ω = 1, σ = 0, every k₃: stable"
    scene = gs.assemble(BODY, gs.axial_potential())
    equations = {b.kind: str(b) for b in bifurcations(scene)}
    assert equations.keys() < KINDS.keys() and "ω² (I₁ − I₃) − ω l + U′(1) = 0" in equations["E3 leaves E1"]
    assert "p_ψ" in equations["fold on a level"] and r"p_{\psi}" in to_latex(bifurcations(scene)[-1])
    points = bifurcation_points(HEAVY, "l", {"I1": 2, "I3": 1, "m0": 3, "omega": 1})
    assert [str(p) for p in points] == ["E3 leaves E2 at l = 2, k₃ = −1", "E3 leaves E1 at l = 4, k₃ = 1"]
    report = gs.analyze(gs.inclined(scene))
    assert "D = " in str(report.drift) and "∂σ/∂k₃" in str(report.drift)
    assert str(gs.analyze(gs.upright(scene)).boundary).splitlines()[0] == "−c₃ ∝ U′(1) + U″(1)"
    assert "k̇₃² = 2 I₁" in str(reduce(scene))
    for thing in (*found, *points, *bifurcations(scene), report.drift, report.boundary, reduce(scene)):
        assert to_latex(thing).startswith(r"\begin{aligned}") and thing._repr_latex_().startswith("$")
    with pytest.raises(TypeError, match="no result"):
        result_blocks(3)


def test_an_equilibrium_in_orbit_says_where_it_is():
    """The normal and the vertical in body axes, and the verdict; typeset too."""
    scene = gs.assemble(gs.Gyrostat((1, "5/4", "8/5"), (0, 0, 0)), gs.circular_orbit(1))
    found = relative_equilibria(scene, {})
    assert str(found[0]) == ("equilibrium in orbit at n = (1, 0, 0), r = (0, 0, 1), roll 0°, pitch 0°, "
                             "yaw 90°: unstable")
    assert r"r = \text{(}1" in found[5]._repr_latex_()


def test_roots_of_polynomials_are_shown_as_decimals():
    """Twelve digits and an ellipsis; JSON has the exact root."""
    report = gs.analyze(gs.inclined(gs.assemble(BODY, gs.axial_potential(lambda z: z**5 - z**2 + z))))
    text = str(stabilizing_set(report, "l", {"I1": 2, "I3": 1, "omega": 1}))
    assert "0.723697… ≤ l < 7 (k₃ from 0.368403… to −1)" in text


def test_what_is_long_under_a_root_has_a_name():
    """E3 in the Newtonian field solved for ω: R1, R2, … and what they stand for."""
    report = gs.analyze(gs.inclined(gs.assemble(BODY, gs.newtonian_field(2))))
    text = " ".join(str(stabilizing_set(report, "omega")).split())
    assert "ω < −√R₄ or −√R₅ < ω < √R₅ or ω > √R₄" in text and "There: R₁ = " in text and "√R₃/(2 I₁)" in text


@pytest.mark.parametrize("spin, said", [
    ("1.5", "stable; a sufficient condition for stability is proved to hold"),
    ("1.25", "stable; the two conditions do not decide, a theorem does"),
    ("1.2", "unstable; a necessary condition for stability is proved to fail")])
def test_a_verdict_says_whether_a_condition_proves_it(spin, said):
    """Not on the boundary, where the sufficient one fails and the necessary one holds."""
    report = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field()), spin="omega3_0"))
    decision = report.verdict({"I1": 1, "I3": "1.6", "l": 0, "m0": 1, "omega3_0": spin})
    assert said in "".join(map(str, decision_blocks(decision, report.equilibrium.at)[0].parts))


def test_a_verdict_says_on_what_it_holds_and_what_is_rounded():
    """On its level of C1 only; a margin that is no short fraction is about its decimal."""
    report = gs.analyze(gs.upright(HEAVY))
    decision = report.verdict({"I1": 1, "l": 0, "m0": "sqrt(2)", "pi3_0": 3})
    first, margin, *_ = decision_blocks(replace(decision, level=(C1,)), report.equilibrium.at)
    assert "".join(map(str, first.parts)).startswith("Verdict: Lyapunov stable on its level of C1; ")
    assert r"\approx 3.343" in display(margin, Names())
    exact = report.verdict({"I1": 1, "l": 0, "m0": 1, "pi3_0": "1e-3"})
    assert [block.relation for block in decision_blocks(exact, None) if hasattr(block, "relation")] == ["="]
