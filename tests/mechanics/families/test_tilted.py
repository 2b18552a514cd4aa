"""E3 and its static limit: the relation, the eliminated name, existence, the closed form of the tilt."""
import pytest
from sympy import Rational, cos, exp, simplify

import gyrostat as gs
from gyrostat.errors import EquilibriumError, ScopeError
from gyrostat.printing.results.document import solved_tilt

m0, m1, l, omega, k3, I1, I3 = map(gs.symbol, ("m0", "m1", "l", "omega", "k3", "I1", "I3"))


def inclined(U, body=None, **options):
    return gs.inclined(gs.assemble(body or gs.symmetric_gyrostat(), U), **options)


def test_the_relation_of_the_source(scene):
    """U'(k3) + ω² k3 (I1 − I3) − ω l = 0 and abs(k3) < 1, VV2003 §3."""
    eq = gs.inclined(scene)
    (name, value), = eq.relations
    assert name == gs.symbol("dU") and simplify(value + omega**2 * k3 * (I1 - I3) - omega * l) == 0
    assert eq.eliminated == ("dU",) and eq.domain == (1 - k3**2,)


@pytest.mark.parametrize(("potential", "tilt"), [
    (gs.uniform_field(), (omega * l - m0) / (omega**2 * (I1 - I3))),
    (gs.newtonian_field(2), (omega * l - m0) / ((omega**2 - m1) * (I1 - I3)))])
def test_closed_form_of_the_tilt(potential, tilt):
    """k3 for U linear and quadratic, as printed in VV2003 §3, with its existence inequality."""
    eq = inclined(potential, eliminate="k3")
    assert eq.relations[-1][0] == k3 and simplify(eq.relations[-1][1] - tilt) == 0
    assert simplify(eq.existence()[0] - (1 - tilt**2)) == 0
    assert simplify(solved_tilt(inclined(potential)) - tilt) == 0


@pytest.mark.parametrize(("U", "body", "name"), [
    (gs.axial_potential(), None, "dU"), (gs.uniform_field(), None, "l"),
    (gs.axial_potential(exp(k3)), None, "l"),
    (gs.axial_potential(k3**5 / 3 - k3), None, "l"),
    (gs.uniform_field(), gs.Gyrostat((2, 2, 1), (0, 0, 1)), "k3"),
    (gs.axial_potential(m0 * k3**3), gs.Gyrostat((2, 2, 1), (0, 0, 1)), "m0"),
    (gs.axial_potential(k3**3), gs.Gyrostat((2, 2, 1), (0, 0, 1)), None)])
def test_what_is_eliminated(U, body, name):
    """dU where U is unspecified; else l; else k3; else a parameter of U.

    Else nothing, and the relation is a constraint.
    """
    eq = inclined(U, body)
    assert eq.eliminated == ((name,) if name else ())
    assert (eq.constraints == ()) == (name is not None)


@pytest.mark.parametrize("name", ["l", "k3", "m0", "m1"])
def test_every_elimination_solves_the_relation(name):
    """Inserted, the eliminated value satisfies U' = ω l − ω² k3 (I1 − I3)."""
    U = gs.newtonian_field(2)
    value = dict(inclined(U, eliminate=name).relations)[gs.symbol(name)]
    relation = U.expression.diff(k3) - omega * l + omega**2 * k3 * (I1 - I3)
    assert simplify(relation.subs(gs.symbol(name), value)) == 0


def test_margins_agree_whichever_name_is_eliminated():
    """The same condition in other coordinates: their margins have the same sign at a common point."""
    U, point = gs.newtonian_field(2), {"I1": 2, "I3": 1, "m0": "1/3", "m1": "1/5", "omega": "3/2",
                                       "k3": "2/7"}
    values = {gs.symbol(n): gs.algebra.text.numbers.exact_number(v) for n, v in point.items()}
    point["l"] = dict(inclined(U, eliminate="l").relations)[l].subs(values)
    seen = set()
    for name in ("l", "k3", "m0", "m1"):
        report = gs.analyze(inclined(U, eliminate=name))
        assert gs.symbol(name) not in report.necessary.alternatives[0][0].margin.free_symbols
        seen.add(report.verdict(point).verdict)
    assert len(seen) == 1


def test_what_cannot_be_eliminated_is_refused():
    """A name that does not enter affinely, or not at all."""
    for name in ("omega", "I2", "k3"):
        with pytest.raises(EquilibriumError, match=f"not affine in {name}"):
            inclined(gs.axial_potential(cos(k3)), eliminate=name)


def test_inclined_needs_a_body_of_revolution(free):
    """Other bodies, other fields: ScopeError, with the way out."""
    for scene in (free, gs.assemble(gs.Gyrostat(), gs.axial_potential()),
                  gs.assemble(gs.symmetric_gyrostat(), gs.general_potential())):
        with pytest.raises(ScopeError, match="equilibrium"):
            gs.inclined(scene)


def test_static_family(at_rest):
    """At rest U' = 0, for every l: l² + I1 (1 − k3²) U'' decides (theory: p at ω = 0)."""
    eq = at_rest.equilibrium
    assert eq.relations == ((gs.symbol("dU"), 0),) and eq.point[:3] == (0, 0, 0)
    margin = at_rest.sufficient.alternatives[0][0].margin
    assert simplify(margin - l**2 - I1 * (1 - k3**2) * gs.symbol("d2U")) == 0


def test_static_family_of_given_fields():
    """In U⁽²⁾ the tilt at rest is m0 / (m1 (I1 − I3)); in U = k3 there is none.

    In U = k3³/3 − k3/4 it is checked.
    """
    eq = gs.static_tilt(gs.assemble(gs.symmetric_gyrostat(), gs.newtonian_field(2)))
    assert simplify(eq.relations[-1][1] - m0 / (m1 * (I1 - I3))) == 0
    with pytest.raises(EquilibriumError, match="does not exist"):
        gs.static_tilt(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(k3)))
    cubic = gs.analyze(gs.static_tilt(gs.assemble(gs.symmetric_gyrostat(),
                                                  gs.axial_potential(k3**3 / 3 - k3 / 4))))
    assert cubic.verdict({"I1": 1, "l": 0, "k3": Rational(1, 2)}).verdict is gs.Verdict.STABLE
    assert cubic.verdict({"I1": 1, "l": 0, "k3": Rational(-1, 2)}).verdict is gs.Verdict.UNSTABLE
    with pytest.raises(ValueError, match="not on E3 at rest"):
        cubic.verdict({"I1": 1, "l": 0, "k3": Rational(1, 3)})
