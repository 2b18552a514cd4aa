"""Potentials are given as expressions or functions, matched by name, or refused."""
import pytest
import sympy
from sympy import CRootOf, Function, Symbol, exp

import gyrostat as gs
from gyrostat.errors import ExpressionError

k1, k3, m0 = map(gs.symbol, ("k1", "k3", "m0"))


def test_a_plain_symbol_is_matched_by_name():
    """A user's own Symbol("k3"), with any assumptions, gives the same potential and the same margins."""
    for theirs in (Symbol("k3"), Symbol("k3", positive=True)):
        potential = gs.axial_potential(Symbol("m0") * theirs)
        assert potential == gs.uniform_field()
        report = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), potential)))
        assert {s.name for s in report.sufficient.alternatives[0][0].margin.free_symbols} == {
            "I1",
            "l",
            "m0",
            "pi3_0",
        }


def test_callables_and_expressions_agree():
    """axial_potential(f) is axial_potential(f(k3)), general_potential takes three arguments."""
    assert gs.axial_potential(lambda z: exp(z) + m0) == gs.axial_potential(exp(k3) + m0)
    assert gs.general_potential(lambda *k: k[0] * k[2]).expression == k1 * k3


@pytest.mark.parametrize(("given", "why"), [
    (m0**2, "does not depend"), (m0 * k1, "k1"), (gs.symbol("omega") * k3, "omega"),
    (gs.symbol("pi3_0") * k3, "pi3_0"),
    (gs.symbol("dU") * k3, "dU"), ("m0*k3*k1", "k1"), ("m0*k3(2)", "cannot read"),
    (lambda k3: True, "not an expression"),
    (Function("V")(k3), "unspecified"),
    (sympy.I * 2, "finite real"), (sympy.oo, "finite real"),
    (sympy.Abs(k3), "smooth"), (sympy.Piecewise((k3, k3 > 0), (0, True)), "smooth")])
def test_what_is_no_potential_is_refused(given, why):
    """Parameters without k3, names of the motion, text, other functions, numbers that are not real."""
    with pytest.raises((TypeError, ValueError), match=why):
        gs.axial_potential(given)


def test_a_truth_value_is_no_potential():
    """Though Python counts with it."""
    with pytest.raises(TypeError, match="expression = True is a bool, not an Expr"):
        gs.axial_potential(True)


def test_texts_are_read_by_the_grammar():
    """As on the command line, in every place for an expression; nothing in them is executed."""
    k1, k2, e2, n1, l = map(gs.symbol, ("k1", "k2", "e2", "n1", "l"))
    assert gs.axial_potential("m₀·k3 + k3^2/2").expression == m0 * k3 + k3**2 / 2
    assert gs.general_potential("k1*k2 + k3").expression == k1 * k2 + k3
    assert not gs.axial_potential("U(k3)").given and not gs.general_potential("U(k1, k2, k3)").given
    assert gs.coupled_potential("-k1 - 2*e2").expression == -k1 - 2 * e2
    assert gs.coupled_potential("k1", ("k",), ("k1", "0", "-2*k2")).drift == (k1, 0, -2 * k2)
    field, beside = gs.circular_orbit(), gs.circular_orbit("omega0", potential="3*n1")
    assert beside.expression - field.expression == 3 * n1
    assert gs.Gyrostat(("I1", "I1", "I3 + 1"), ("0", "0", "2*l")).gyrostatic_momentum == (0, 0, 2 * l)
    scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)), gs.general_potential("k3"))
    assert gs.equilibrium(scene, ("0", "0", "3*w", "0", "0", "1")).point[2] == 3 * gs.symbol("w")
    top = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential("k3"))
    assert gs.mechanics.reduce(top).square("k3^2").has(k3**2)
    for slot in (gs.axial_potential, gs.general_potential, gs.coupled_potential,
                 lambda text: gs.circular_orbit(potential=text), lambda text: gs.Gyrostat((text, 1, 1))):
        with pytest.raises(ValueError, match="cannot read"):
            slot("__import__('os').system('true')")
    with pytest.raises(ValueError, match="a direction fixed in space"):
        gs.circular_orbit(potential="k3")


def test_floats_are_the_rationals_they_are():
    """0.5 k3 is k3/2, exactly."""
    assert gs.axial_potential(0.5 * k3) == gs.axial_potential(k3 / 2)


def test_a_constant_is_a_field_without_force():
    """U = 0 keeps the direction k but exerts no torque."""
    scene = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(0))
    assert scene.vector_field()[:3] == gs.assemble(gs.symmetric_gyrostat()).vector_field()[:3]


def test_roots_in_a_name_of_ours_are_refused():
    """A root of a polynomial in k3 inside U(k3) would be mistaken for a function of k3."""
    k3 = gs.symbol("k3")
    with pytest.raises(ExpressionError, match="write it in another symbol"):
        gs.axial_potential(CRootOf(k3**3 + 7 * k3 - 5, 0) * k3)
