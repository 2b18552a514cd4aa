"""Matrices of expressions: made once, and applied to vectors without their zeros."""
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy import I, ImmutableMatrix, Rational, S, sqrt, symbols

import gyrostat as gs
from gyrostat.algebra.rings.matrices import applied, immutable, solved
from gyrostat.mechanics.equilibrium.derivation_ring import rows_at_point

ENTRIES = st.sampled_from([S.Zero, S.One, Rational(-2, 3), sqrt(2), *symbols("x y"), symbols("x") - 1, 2 * I])


@given(st.integers(1, 3).flatmap(lambda n: st.lists(st.lists(ENTRIES, min_size=n, max_size=n), min_size=1,
                                                    max_size=4)))
def test_a_matrix_is_the_one_that_sympy_makes(rows):
    """Equal, with the same hash and the same entries; and its product with its first row."""
    ours, theirs = immutable(rows, len(rows[0])), ImmutableMatrix(rows)
    assert ours == theirs and hash(ours) == hash(theirs) and ours.tolist() == theirs.tolist()
    product = theirs * ImmutableMatrix(rows[0])
    assert [(a - b).expand() for a, b in zip(applied(rows, rows[0]), product)] == [0] * len(rows)


def test_what_is_placed_at_one_equilibrium_is_not_taken_for_another():
    """The Hessian of the energy at E1, which has U'' at the upper pole, and at E3 with its relation."""
    top = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
    field = top.jet_jacobian
    first, tilted = (rows_at_point(eq, field) for eq in (gs.upright(top), gs.inclined(top)))
    for rows, eq in ((first, gs.upright(top)), (tilted, gs.inclined(top))):
        assert ImmutableMatrix(rows) == eq.at_point(field)
    assert first != tilted


@settings(max_examples=15, deadline=None)
@given(st.lists(st.fractions(-3, 3, max_denominator=5), min_size=6, max_size=6), st.booleans())
def test_a_system_of_three_rows_is_solved_in_lowest_terms(entries, of_names):
    """The x with Ax = v is found from v = Ax, though v is long; A has names on its diagonal, or numbers."""
    x, (a, b, c, d, e, f) = [symbols("x"), 1 / symbols("y"), sqrt(2)], map(Rational, entries)
    p, q, r = symbols("p q r") if of_names else map(Rational, (9, 10, 11))      # larger than the others
    rows = [[a + p, d, e], [d, b + q, f], [e, f, c + r]]
    assert solved(rows, [sum(m * n for m, n in zip(row, x)) for row in rows]) == x
