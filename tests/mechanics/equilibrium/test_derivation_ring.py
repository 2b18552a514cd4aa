"""One ring for what is derived at an equilibrium; what is proved of a space is proved once."""
from sympy import exp, sqrt

import gyrostat as gs
from gyrostat.algebra.rings.polynomials import Ring
from gyrostat.mechanics.equilibrium.derivation_ring import rows_at_point, signs_over

TOP = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())


def test_everything_at_an_equilibrium_is_in_one_ring() -> None:
    for eq in (gs.upright(TOP), gs.hanging(TOP), gs.inclined(TOP)):
        entries = [e for row in rows_at_point(eq, TOP.jet_jacobian) for e in row]
        values = gs.derivation.linearize(eq).coefficients
        assert signs_over(eq, entries) is signs_over(eq, values) is signs_over(eq, [gs.symbol("nu1")])


def test_what_the_ring_does_not_hold_has_its_own() -> None:
    eq = gs.upright(TOP)
    shared = signs_over(eq, [gs.symbol("I1")])
    for foreign in (gs.symbol("a"), sqrt(2), exp(gs.symbol("pi3_0")), gs.symbol("I1") ** gs.symbol("l")):
        own = signs_over(eq, [foreign, gs.symbol("I1")])
        assert own is not shared and own.ring.holds([foreign]) and not shared.ring.holds([foreign])


def test_two_roots_are_ordered_by_the_ring_of_each_step() -> None:
    body = gs.Gyrostat(inertia=(sqrt(2), sqrt(2), 1), gyrostatic_momentum=(0, 0, 0))
    eq = gs.inclined(gs.assemble(body, gs.axial_potential()))
    assert signs_over(eq, [sqrt(2)]) is not signs_over(eq, [sqrt(2)])


def test_a_ring_reads_what_it_has_written() -> None:
    x, y = map(gs.symbol, ("x", "y"))
    ring = Ring([x, y])
    top, bottom = ring.fraction((x**2 - y) / (3 * x * (x + y)))
    written = ring.quotient(top, bottom)
    read = ring.fraction(written)
    assert read is ring.fraction(written) and read[0] * bottom == top * read[1]
    fresh = Ring([x, y]).fraction(written)
    assert fresh[0] * read[1] == read[0] * fresh[1]


def test_a_root_of_a_fraction_is_read_with_its_scale() -> None:
    x = gs.symbol("x")
    root = sqrt(1 + 1 / x**2)
    ring = Ring([root])
    top, bottom = ring.fraction(root)
    assert ring.quotient(top, bottom) == root and ring.fraction(ring.expression(top))[1] == bottom


def test_a_space_is_proved_once_for_a_rotor() -> None:
    assert gs.lie_poisson(("k",), (0, 0, 1)) is gs.lie_poisson(["k"], [0, 0, 1])
    assert gs.lie_poisson((), (0, 0, 1)) is not gs.lie_poisson(("k",), (0, 0, 1))


def test_the_field_in_the_jet_is_that_of_every_potential() -> None:
    given = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    assert given.jet_field is TOP.jet_field and given.jet_jacobian is TOP.jet_jacobian
    assert given.vector_field() != TOP.vector_field()
