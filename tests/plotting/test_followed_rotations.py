"""Permanent rotations along a name: complete, with their verdicts, and the picture of them."""
import matplotlib.colors
import numpy as np
import pytest
from matplotlib.figure import Figure
from sympy import Matrix, Rational

import gyrostat as gs
from gyrostat.errors import ValuesError
from gyrostat.plotting import draw_bifurcation_diagram
from gyrostat.plotting.looks import BLUE

L3 = gs.symbol("l3")
TURNED = [[Rational(n, 27) for n in row] for row in ((49, -8, 10), (-8, 40, 4), (10, 4, 73))]
CASES = {
    "along an axis": (gs.Gyrostat((1, 2, 3), (0, 0, L3)), "l3", (-3, 3), {"M": 1}),
    "in a plane": (gs.Gyrostat((1, 2, 3), (0, "1/10", L3)), "l3", (-1, "5/2"), {"M": 1}),
    "general": (gs.Gyrostat((1, 2, 3), ("1/20", "1/10", "1/2")), "M", ("1/10", 2), {}),
    "a moment": (gs.Gyrostat((1, 2, gs.symbol("I3")), ("1/20", "1/10", "1/2")), "I3", ("1/2", 3), {"M": 1}),
    "of revolution": (gs.Gyrostat((1, 1, 2), (0, 0, L3)), "l3", (-2, 2), {"M": 1}),
    "circle broken": (gs.Gyrostat((1, 1, 2), (L3, 0, "1/5")), "l3", (-1, 1), {"M": 1}),
    "tensor": (gs.Gyrostat(TURNED, ("1/3", L3, 0)), "l3", (-1, 1), {"M": 1})}
DEFAULT = ("along an axis", "general", "circle broken")


@pytest.mark.slow
@pytest.mark.parametrize("case", [case if case in DEFAULT else pytest.param(case, marks=pytest.mark.slow)
                                  for case in CASES])
def test_every_rotation_is_there_with_its_verdict(case):
    """At values between the nodes: those of relative_equilibria, which are complete and exact."""
    body, name, ends, values = CASES[case]
    scene = gs.assemble(body)
    followed = gs.continuation(scene, name, ends, values)
    low, high = (float(Rational(end)) for end in ends)
    for x in low + (high - low) * np.array([0.07, 0.31, 0.62, 0.83]):
        exact = gs.relative_equilibria(scene, {**values, name: float(x)})
        ours = [piece for piece in followed.pieces if piece.parameter[0] < x < piece.parameter[-1]]
        assert len(ours) == len(exact)
        for rotation in exact:
            M = np.array([float(m) for m in rotation.momentum])
            near = min(ours, key=lambda piece: apart(piece, x, rotation, M))
            assert apart(near, x, rotation, M) < 5e-3 and near.verdict is rotation.decision.verdict


def apart(piece, x, rotation, M):
    """From a chord between two nodes; of a circle in ν alone."""
    at = [np.interp(x, piece.parameter, values) for values in (piece.nu, *piece.momentum.T)]
    gaps = np.abs(np.array(at) - [float(rotation.form.nu), *M])
    return gaps[0] if rotation.locus else gaps.max()


@pytest.mark.slow
@pytest.mark.parametrize("case", [*DEFAULT, pytest.param("tensor", marks=pytest.mark.slow)])
def test_every_sample_is_a_rotation(case):
    """(1 − ν I) M = l on abs(M) = 1 or the parameter, written out; pieces go from one mark on to the next."""
    body, name, _, values = CASES[case]
    followed = gs.continuation(gs.assemble(body), name, *CASES[case][2:])
    x = gs.symbol(name)
    for piece in followed.pieces:
        for t, nu, M in list(zip(piece.parameter, piece.nu, piece.momentum))[1:-1]:
            l, I = (np.array(m.xreplace({x: Rational(float(t))}).tolist(), float)
                    for m in (Matrix(body.gyrostatic_momentum).T, body.tensor))
            np.testing.assert_allclose(M - nu * I @ M, l[0], atol=1e-9)
            assert np.linalg.norm(M) == pytest.approx(t if name == "M" else values["M"], rel=1e-7)
    ends = {round(float(end), 6) for piece in followed.pieces for end in piece.parameter[[0, -1]]}
    assert {round(float(mark.value), 6) for mark in followed.marks} <= ends


@pytest.mark.slow
def test_the_picture_shows_what_was_followed():
    """Lines of M3 against l3, solid where stable; open marks at the pitchforks; what the legend says."""
    body, name, ends, values = CASES["along an axis"]
    ax = draw_bifurcation_diagram(gs.assemble(body), name, ends, values, Figure().subplots())
    dimension = r"$[\mathrm{M\,L^{2}\,T^{-1}}]$"
    assert (ax.get_xlabel(), ax.get_ylabel()) == (f"$l_3$ {dimension}", f"$M_{{3}}$ {dimension}")
    assert ax.get_title() == "$I_1 = 1$, $I_2 = 2$, $I_3 = 3$, $|M| = 1$"
    assert [text.get_text() for text in ax.get_legend().get_texts()] == ["stable", "unstable"]
    assert [text.get_text() for text in ax.texts] == ["pitchfork"]
    (marks,) = [line for line in ax.lines if line.get_marker() == "P"]
    assert sorted(zip(*map(list, marks.get_data()))) == [(-2, 1), (-0.5, 1), (0.5, -1), (2, -1)]
    lines = [line for line in ax.lines if line.get_marker() == "None"]
    stable = [line for line in lines if matplotlib.colors.same_color(line.get_color(), BLUE)]
    at_one = sorted(round(float(np.interp(1, *line.get_data())), 6) for line in stable
                    if line.get_xdata()[0] < 1 < line.get_xdata()[-1])
    assert at_one == [-0.5, -0.5, 1.0] and all(line.get_linestyle() == "-" for line in stable)


@pytest.mark.slow
def test_against_another_name_it_is_the_rate():
    """ν against M; the fold at its value."""
    body, name, ends, values = CASES["general"]
    ax = draw_bifurcation_diagram(gs.assemble(body), name, ends, values, Figure().subplots())
    assert (ax.get_xlabel(), ax.get_ylabel()) == (
        r"$|M|$ $[\mathrm{M\,L^{2}\,T^{-1}}]$", r"$\nu$ $[\mathrm{T^{-1}}]$")
    assert "|M|" not in ax.get_title()
    (marks,) = [line for line in ax.lines if line.get_marker() == "D"]
    assert len(marks.get_xdata()) == 2


@pytest.mark.parametrize(("case", "ends", "words"), [
    ("general", (0, 1), "a range in which it is positive"), ("general", (2, 1), "the lower one first"),
    ("a moment", (-1, 1), "has to be positive")])
def test_what_is_refused(case, ends, words):
    """A length that is none, a range that is empty, a moment that is not positive."""
    body, name, _, values = CASES[case]
    with pytest.raises(ValuesError, match=words):
        gs.continuation(gs.assemble(body), name, ends, values)
