"""Branches against a parameter: complete, exact verdicts, ends at bifurcations."""
from fractions import Fraction
from itertools import product

import numpy as np
import oracle
import pytest
from matplotlib.figure import Figure
from sympy import Rational, exp, sqrt

import gyrostat as gs
from gyrostat.equilibria.continuation.continuation import continuation
from gyrostat.equilibria.search import relative_equilibria
from gyrostat.errors import ScopeError, ValuesError
from gyrostat.plotting import draw_bifurcation_diagram

TOP = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
QUARTIC = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(lambda k3: k3**4 - k3**2 / 2))
CUBIC = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(lambda k3: k3**3 - k3 / 2))
CASES = [(TOP, {"I1": 2, "I3": 1, "l": 0, "m0": -1}, "omega", (-4, 4), [0, -1]),
         (QUARTIC, {"I1": 2, "I3": 1, "l": "1/10"}, "omega", (0, 2), [0, 0, -0.5, 0, 1]),
         (TOP, {"I1": 2, "I3": 1, "omega": 1, "l": 1}, "m0", ("1/10", 3), None),
         (CUBIC, {"I1": 2, "I3": 1, "l": "1/2"}, "omega", (-2, 2), [0, -0.5, 0, 1])]


@pytest.fixture(scope="module", params=CASES, ids=["heavy", "quartic", "m0", "cubic"])
def followed(request):
    scene, values, name, ends, _ = request.param
    found = continuation(scene, name, ends, values)
    return *request.param, found.pieces, found.marks


def at(pieces, x):
    """Every branch at a value of the parameter, (k3, verdict), from above."""
    found = {}
    for piece in pieces:
        order = np.argsort(piece.parameter)
        if piece.parameter.min() <= x <= piece.parameter.max():
            found[round(float(np.interp(x, piece.parameter[order], piece.k3[order])), 4)] = piece.verdict
    return sorted(found.items(), key=lambda pair: -pair[0])


@pytest.mark.few(1)
def test_every_branch_is_there_with_its_verdict(followed):
    """At values between the nodes: those of relative_equilibria, which are complete and exact."""
    scene, values, name, ends, _, pieces, _ = followed
    low, high = (float(Fraction(end)) for end in ends)
    for x in low + (high - low) * np.array([0.07, 0.31, 0.62, 0.83]):
        exact = relative_equilibria(scene, {**values, name: float(x)})
        ours = at(pieces, x)
        # a chord between two nodes
        np.testing.assert_allclose([k3 for k3, _ in ours], [float(b.place["k3"]) for b in exact], atol=2e-3)
        assert [verdict for _, verdict in ours] == [b.decision.verdict for b in exact]


@pytest.mark.slow
def test_points_satisfy_the_relation_of_e3(followed):
    """U' = ω l − ω² k3 (I1 − I3) at every point of a branch, written out independently."""
    scene, values, name, _, U, pieces, _ = followed
    for piece in pieces:
        if piece.label == "E3":
            inner = slice(2, -2)
            given = {**{n: float(Fraction(x)) for n, x in values.items()}, name: piece.parameter[inner]}
            coefficients = oracle.slope(U) if U else [given["m0"]]
            residual = oracle.polynomial(coefficients, piece.k3[inner]) - given["omega"] * given["l"] + (
                given["omega"] ** 2 * piece.k3[inner] * (given["I1"] - given["I3"]))
            # roots of a polynomial near a double one
            np.testing.assert_allclose(residual, 0, atol=1e-6)


@pytest.mark.slow
def test_branches_end_at_bifurcations(followed):
    """A branch of E3 that ends inside the range does so at a point of bifurcation_points, exactly."""
    _, _, _, _, _, pieces, points = followed
    assert points
    marks = {(float(point.value), float(point.k3))
             for point in points if not point.kind.startswith("precessions")}
    tips = [(x, k) for p in pieces if p.label == "E3" for x, k in zip(p.parameter[[0, -1]], p.k3[[0, -1]])]
    for mark in marks:
        assert mark in tips


@pytest.mark.slow
def test_stability_of_e3_changes_where_the_oracle_says():
    """Where a branch goes from stable to unstable, −g''/2 is 0."""
    pieces, changes = continuation(QUARTIC, "omega", (0, 2), {"I1": 2, "I3": 1, "l": "1/10"}).pieces, 0
    tilted = [p for p in pieces if p.label == "E3"]
    for first, second in product(tilted, tilted):
        if first.verdict is not second.verdict and (first.parameter[-1], first.k3[-1]) == (
            second.parameter[0],
            second.k3[0],
        ):
            places = [(first.parameter[-9], first.k3[-9]), (first.parameter[-1], first.k3[-1]),
                      (second.parameter[8], second.k3[8])]
            margins = [oracle.verdict_inclined_margin(2, 1, Fraction(1, 10), x, z, 12 * z * z - 1)
                       for x, z in ((Fraction(x), Fraction(z)) for x, z in places)]
            assert margins[0] * margins[2] < 0 and abs(margins[1]) < 1e-12      # the exact one, rounded
            changes += 1
    # at the other the branch has turned back: both pieces begin there
    assert changes == 1


def test_stability_changes_where_the_oracle_says():
    """E1 of the heavy top, l = 0: stable from I3² ω² = 4 I1 m0 on."""
    pieces = continuation(TOP, "omega", (0, 2), {"I1": 1, "I3": "8/5", "l": 0, "m0": 1}).pieces
    first, second = [p for p in pieces if p.label == "E1"]
    assert (first.verdict, second.verdict) == (gs.Verdict.UNSTABLE, gs.Verdict.STABLE)
    assert first.parameter[-1] == second.parameter[0] == 1.25


@pytest.mark.slow
def test_the_picture():
    """Solid where stable, dashed where unstable; every kind of bifurcation has its mark.

    A change of stability is full, a meeting without one open; E1 and E2 are named.
    """
    scene, values, name, ends, _ = CASES[1]
    ax = draw_bifurcation_diagram(scene, name, ends, values, Figure().subplots(), linewidth=0.7)
    found = continuation(scene, name, ends, values)
    lines = [line for line in ax.lines if line.get_marker() == "None"]
    assert len(lines) == len(found.pieces) and {line.get_linewidth() for line in lines} == {0.7}
    for line, piece in zip(lines, found.pieces):
        assert (line.get_linestyle() == "-") == (piece.verdict is gs.Verdict.STABLE)
        np.testing.assert_array_equal(line.get_xydata().T, [piece.parameter, piece.k3])
    for kind, shape in (("fold at fixed rate", "D"), ("fold on a level", "o")):
        (mark,) = [line for line in ax.lines if line.get_marker() == shape]
        np.testing.assert_array_equal(mark.get_xydata(),
                                      [[float(p.value), float(p.k3)] for p in found.marks if p.kind == kind])
        (name,) = [text for text in ax.texts if text.get_text() == kind]
        assert name.xy in [tuple(place) for place in mark.get_xydata()]
        assert (mark.get_markerfacecolor() == "white") == (kind == "fold at fixed rate")
    assert {"E1", "E2", "E3"} <= {text.get_text() for text in ax.texts}
    assert (ax.get_xlabel(), ax.get_ylabel(), ax.get_xlim()) == (
        r"$\omega$ $[\mathrm{T^{-1}}]$", "$k_3$", (0, 2))


def test_what_cannot_be_drawn_is_refused():
    """An empty range, no rate, a field that is not rational."""
    values = {"I1": 2, "I3": 1, "l": 0, "m0": 1}
    with pytest.raises(ValuesError,
                       match="the range of omega is 2 to 1: give two numbers, the lower one first"):
        draw_bifurcation_diagram(TOP, "omega", (2, 1), values)
    with pytest.raises(ValuesError, match="given were I1, I3, m0, and l is free: give omega too"):
        draw_bifurcation_diagram(TOP, "l", (0, 1), {"I1": 2, "I3": 1, "m0": 1})
    for name, ends in (("I1", (-2, 2)), ("I3", (0, 1)), ("I1", ("-1", "-1/2"))):
        rest = {n: x for n, x in {**values, "omega": 1}.items() if n != name}
        with pytest.raises(ValuesError,
                           match=f"{name} has to be positive: give a range in which it is"):
            draw_bifurcation_diagram(TOP, name, ends, rest)
    with pytest.raises(ValuesError, match="speed is free"):
        draw_bifurcation_diagram(TOP, "speed", (0, 1), {**values, "omega": 1})
    with pytest.raises(ScopeError, match="give a field that is rational in k3"):
        transcendental = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(lambda k3: exp(k3)))
        draw_bifurcation_diagram(transcendental, "omega", (0, 1), {"I1": 2, "I3": 1, "l": 0})
    with pytest.raises(ScopeError, match="give a field of lower degree"):
        high = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(lambda k3: k3**60 - k3**2 + k3))
        draw_bifurcation_diagram(high, "omega", (0, 1), {"I1": 2, "I3": 1, "l": 1})
    with pytest.raises(ScopeError, match="U.k3. is unspecified"):
        draw_bifurcation_diagram(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential()),
                                 "omega", (0, 1), {"I1": 2, "I3": 1, "l": 0})


@pytest.mark.slow
def test_the_pitchfork_of_the_double_well():
    """U = k3⁴ − k3²/2, l = 0, I1 = 2, I3 = 1: stability of k3 = 0 changes at ω² = 1/2.

    At ω² = 1 three branches meet, and it does not.
    """
    found = continuation(QUARTIC, "omega", (-2, 2), {"I1": 2, "I3": 1, "l": 0})
    assert [(m.kind, m.value, m.k3, m.changes) for m in found.marks] == [
        ("pitchfork at fixed rate", -1, 0, False), ("fold on a level", -sqrt(2) / 2, 0, True),
        ("fold on a level", sqrt(2) / 2, 0, True), ("pitchfork at fixed rate", 1, 0, False)]
    ax = draw_bifurcation_diagram(QUARTIC, "omega", (-2, 2), {"I1": 2, "I3": 1, "l": 0}, Figure().subplots())
    names = [text.get_text() for text in (*ax.get_legend().get_texts(), *ax.texts)]
    assert names[:2] == ["stable (E3: modulo the spin)", "unstable"]
    assert names.count("pitchfork at fixed rate") == names.count("fold on a level") == 1


@pytest.mark.slow
def test_what_is_drawn_besides_branches():
    """An E3 at one rate alone, a rate at which every tilt is E3, branches that cross, and those that end
    where U is infinite.
    """
    k3, a = gs.symbol("k3"), gs.symbol("a")

    def along(U, values, name, ends):
        found = continuation(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(U)), name, ends, values)
        return found, [(m.kind, m.value, m.k3) for m in found.marks]

    body = {"I1": 2, "I3": 1, "l": 0}
    found, marks = along((2 * k3 - 1) ** 3, body, "omega", (-1, 1))
    assert [
        (p.parameter.tolist(), p.k3.tolist(), p.verdict.name) for p in found.pieces if p.label == "E3"
    ] == [([0], [0.5], "UNSTABLE")]
    assert marks == [("isolated at fixed rate", 0, Rational(1, 2))]
    found, _ = along(a * k3, {"I1": 1, "I3": 1, "l": 2, "omega": 1}, "a", (0, 3))
    assert [(p.parameter.tolist(), p.k3.tolist()) for p in found.pieces if p.label == "E3"] == [
        ([2, 2], [-1, 1])
    ]
    _, marks = along(k3**3 / 3 - a * k3**2 / 2, {"I1": 1, "I3": 1, "l": 0, "omega": 1}, "a", (-2, 2))
    assert ("crossing at fixed rate", 0, 0) in marks and ("fold on a level", 1, 0) in marks
    _, marks = along(a / (2 * k3 - 1) + k3**2, body | {"l": 1, "omega": 1}, "a", (-1, 1))
    assert ("U is infinite", 0, Rational(1, 2)) in marks
    with pytest.raises(ScopeError, match="everything is an equilibrium"):
        along(0 * k3, {"I1": 1, "I3": 1, "l": 0}, "omega", (-1, 1))
