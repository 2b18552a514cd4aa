"""Statements in the letters of their paper, which are letters of the library too."""
import math

import pytest
from published.written_sources import CLAIM, status, written

import gyrostat as gs
from gyrostat.errors import PublishedError
from gyrostat.published import check

MOMENTS = ["A C", "A B", "I1 I3", "I J", "J C", "Ix Iz", "J1 J3", "P Q", "B C", "I C", "K C", "h C", "T U",
           "p q", "A C1", "F G", "M N", "state field", "cross dot"]
TOP = """inertia = ["{0}", "{0}", "{1}"]
potential = "m0*k3 + mu/2*({1} - {0})*k3**2"
equilibrium = "E1"
spin = "omega3_0"
"""
BODIES = ["A B C", "I J K", "C B h", "h T B", "p q r", "F G H", "C1 C2 C3", "U V W", "cross rank state",
          "F1 G1 J11"]
WEIGHT = 'potential = "P*(x0*k1 + y0*k2 + z0*k3)"\n'


def source(tmp_path, scene, *claims):
    """The findings of some claims (quantity, printed, kind, let)."""
    text = f'[source]\nname = "mine"\ntitle = "t"\n[scene.s]\n{scene}\n'
    for n, (quantity, printed, kind, let) in enumerate(claims):
        text += CLAIM.format(key=f"c{n}", quantity=quantity, printed=printed, kind=kind) + f"let = {let}\n"
    return check([written(tmp_path, text)])


@pytest.mark.few(2)
@pytest.mark.parametrize("moments", MOMENTS)
def test_one_false_formula_in_many_letterings(tmp_path, moments):
    """4A(m0 + μ(A − C)) is false, 4A(m0 + μ(C − A)) is true, whatever A and C are called.

    At the numbers shown the printed side holds, and (C ω)² < 4A(m0 + μ(C − A)).
    """
    across, along = moments.split()
    wrong, right = (f"({along}*omega3_0)**2 > 4*{across}*(m0 + mu*({one} - {other}))"
                    for one, other in ((across, along), (along, across)))
    claim = "sufficient for stability"
    found, true = source(tmp_path, TOP.format(across, along), (claim, wrong, "condition", "{}"),
                         (claim, right, "condition", "{}"))
    assert (found.status, true.status) == ("misprint", "confirmed")
    values = {name: float(value) for name, value in found.outcome.counterexample.values}
    A, C, m0, mu = (values[name] for name in (across, along, "m0", "mu"))
    spin = (C * values["omega3_0"]) ** 2
    assert spin > 4 * A * (m0 + mu * (A - C)) and spin < 4 * A * (m0 + mu * (C - A))


@pytest.mark.few(2)
@pytest.mark.parametrize("field", ["", WEIGHT])
@pytest.mark.parametrize("moments", BODIES)
def test_eulers_equations_in_many_letterings(tmp_path, moments, field):
    """A false equation is a misprint with numbers, and what stands before and behind it is checked too."""
    A, B, C = moments.split()
    torque = " + P*(z0*k2 - y0*k3)" if field else ""
    weight = " + P*(x0*k1 + y0*k2 + z0*k3)" if field else ""
    name = "derived_h" if "h" in (A, B, C) else "h"
    energy = f"({A}*omega1**2 + {B}*omega2**2 + {C}*omega3**2)/2{weight}"
    right, wrong = (f"({B} - {C})*pi2*pi3/({moment}*{C}){torque}" for moment in (B, A))
    let, scene = f'{{ E = "{name}" }}', f'inertia = ["{A}", "{B}", "{C}"]\n{field}'
    found = source(tmp_path, scene, ("dt(pi1)", right, "identity", "{}"),
                   ("dt(pi1)", wrong, "identity", "{}"), ("E", energy, "identity", let),
                   ("E", f"2*({energy})", "identity", let))
    assert [each.status for each in found] == ["confirmed", "misprint", "confirmed", "misprint"]
    example = found[1].outcome.counterexample
    at = {key: float(value) for key, value in example.values}
    turning = (at[B] - at[C]) * at["pi2"] * at["pi3"] / at[C]
    pull = at["P"] * (at["z0"] * at["k2"] - at["y0"] * at["k3"]) if field else 0
    for shown, moment in ((example.derived, B), (example.printed, A)):
        assert math.isclose(float(shown), turning / at[moment] + pull, abs_tol=1e-12)


def test_a_quantity_asks_which_is_meant(tmp_path):
    """h is a height and the energy; what is printed is in the paper's letters without a word."""
    scene = 'inertia = ["A", "A", "C"]\npotential = "M*g*h*k3"\n'
    energy = "(A*omega1**2 + A*omega2**2 + C*omega3**2)/2 + M*g*h*k3"
    with pytest.raises(PublishedError, match='c0: quantity has h, .* let = { h = "derived_h" }'):
        source(tmp_path, scene, ("h", energy, "identity", "{}"))
    (found,) = source(tmp_path, scene, ("derived_h", energy, "identity", "{}"))
    assert found.status == "confirmed"
    whole, height = source(tmp_path, scene, ("h", energy.replace("*h*", "*H*"), "identity",
                                             '{ H = "h", h = "derived_h" }'),
                           ("h", "h", "identity", '{ h = "h" }'))
    assert (whole.status, height.status) == ("confirmed", "confirmed")
    assert height.outcome.derived == gs.symbol("h")


@pytest.mark.slow
@pytest.mark.parametrize(("claim", "sign"), [("necessary", ">="), ("sufficient", ">")])
def test_the_misprint_of_2003_entered_with_its_own_potential(tmp_path, claim, sign):
    """l⁴ + m0² I1² − U''(0) l² I1 is refuted at k3 = 0, where ω = m0/l.

    I1 = l = m0 = 1, U1 = 3 does so by hand; the same with l = m0/ω in it.
    """
    scene = ('inertia = ["I1", "I1", "I3"]\ngyrostatic_momentum = ["0", "0", "l"]\n'
             'potential = "m0*k3 + U1*k3**2/2"\nequilibrium = "E3"\n')
    for given, left, slope in (('{ k3 = "0", omega = "m0/l" }', "l**4 + m0**2*I1**2", "U1*l**2*I1"),
                               ('{ k3 = "0", l = "m0/omega" }', "m0**2 + I1**2*omega**4", "U1*omega**2*I1")):
        for term, found in (("-", "misprint"), ("+", "confirmed")):
            printed = f"{left} {term} {slope} {sign} 0"
            assert status(tmp_path, scene, f"{claim} for stability", printed, at=given) == found
