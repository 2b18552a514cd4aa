"""What follows from what: reduction of conjunctions, elimination, merging of alternatives."""
from sympy import expand

import gyrostat as gs
from gyrostat.algebra.rings.polynomials import Ring
from gyrostat.algebra.solving.margins import Signs
from gyrostat.stability.criteria.implication import Item, eliminate, merge, reduced

I1 = gs.symbol("I1")


def items(*conditions):
    """Items of one ring from (margin, degenerate, strict)."""
    ring = Ring([e for margin, degenerate, _ in conditions for e in (margin, *degenerate)] + [I1])
    polynomial = lambda e: ring.fraction(e)[0]  # noqa: E731
    return Signs(ring), [Item(polynomial(m), tuple(map(polynomial, d)), strict, "")
                         for m, d, strict in conditions]


def test_squares_are_not_forgotten():
    """x² y ≥ 0 alone does not give y ≥ 0; with x² + y ≥ 0 it does; strictly, x ≠ 0 stays."""
    x, y = gs.symbol("x"), gs.symbol("y")
    signs, alone = items((y, (x,), False))
    assert reduced(alone, signs) == alone
    signs, both = items((x**2 + y, (), False), (y, (x,), False))
    (left,) = reduced(both, signs)
    assert left.degenerate == () and left.margin == both[1].margin
    signs, strict = items((x**2 + y, (), True), (y, (x,), True))
    (left,) = reduced(strict, signs)
    assert len(left.degenerate) == 1
    signs, other = items((x**2 + y, (), False), (y, (gs.symbol("z"),), False))
    assert len(reduced(other, signs)) == 2


def test_what_does_not_follow_is_kept():
    """x² − y ≥ 0 does not follow from y ≥ 0; x y ≥ 0 beside x ≥ 0 is not y ≥ 0.

    An even factor survives the reduction.
    """
    x, y = gs.symbol("x"), gs.symbol("y")
    for conditions in (((x**2 - y, (), False), (y, (), False)), ((x, (), False), (x * y, (), False)),
                       ((x, (), True), (y, (x - y,), True))):
        signs, given = items(*conditions)
        assert reduced(given, signs) == given
    signs, given = items((x, (), True), (x * y, (), True))
    assert [signs.ring.expression(i.margin) for i in reduced(given, signs)] == [x, y]


def test_a_sum_of_two_others_adds_nothing():
    """I2 > I3 beside I1 > I3 and I2 > I1; not where one of the two is missing, or not strict."""
    x, y, z = (gs.symbol(f"I{n}") for n in (1, 2, 3))
    signs, all_three = items((y - z, (), True), (x - z, (), True), (y - x, (), True))
    left = reduced(all_three, signs)
    assert [item.margin for item in left] == [item.margin for item in all_three[1:]]
    (proof,) = [proof for item in left for proof in item.implies]
    assert proof.margin == proof.square + proof.factor * proof.by
    for some in (all_three[:2], all_three[1:]):
        assert len(reduced(some, signs)) == 2
    signs, weak = items((y - z, (), True), (x - z, (), False), (y - x, (), True))
    assert len(reduced(weak, signs)) == 3
    signs, opposite = items((y - z, (), True), (z - x, (), True), (y - x, (), True))
    assert len(reduced(opposite, signs)) == 2              # y > x follows from the others


def test_impossible_and_trivial_conjunctions():
    """A margin that is never positive kills its conjunction; one that always is leaves it."""
    x = gs.symbol("x")
    signs, never = items((-I1, (), True), (x, (), True))
    assert reduced(never, signs) is None
    signs, always = items((I1, (), True), (x, (), True))
    assert reduced(always, signs) == always[1:]
    signs, square = items((I1, (x,), True))
    assert reduced(square, signs) == square            # x² I1 > 0 still asks for x ≠ 0


def test_elimination_of_a_multiplier():
    """∃ν: a ν² + b ν + c > 0 iff a > 0 or b² > 4ac."""
    nu, b, c = gs.symbol("nu1"), gs.symbol("b"), gs.symbol("c")
    for a, expected in ((-I1, [b**2 + 4 * I1 * c]), (I1, None),
                        (gs.symbol("a"), [gs.symbol("a"), b**2 - 4 * gs.symbol("a") * c])):
        signs, given = items((a * nu**2 + b * nu + c, (), True))
        left = [reduced(alternative, signs) for alternative in eliminate(given, nu, signs)]
        left = [alternative for alternative in left if alternative is not None]
        if expected is None:
            assert [] in left
        else:
            assert [
                signs.ring.expression(item.margin) for alternative in left for item in alternative
            ] == list(map(expand, expected))


def test_opposite_signs_merge_only_where_zero_is_excluded():
    """(x > 0 and x y > 0) or (x < 0 and x y > 0) is x y > 0; x > 0 or x < 0 alone is not always true."""
    x, y = gs.symbol("x"), gs.symbol("y")
    signs, (plus, minus, product) = items((x, (), True), (-x, (), True), (x * y, (), True))
    assert merge([[plus, product], [minus, product]], signs) == [[product]]
    assert len(merge([[plus], [minus]], signs)) == 2
    ring = Ring([x, y])
    signs = Signs(ring, (x**2,))
    plus, minus = (Item(*signs.split(*ring.fraction(e)), True, "") for e in (x, -x * (y - 1) ** 2))
    assert len(merge([[plus], [minus]], signs)) == 2    # the second does not hold at y = 1


def test_where_q_is_0_the_discriminant_is_the_square_of_p(e3):
    """At a tilt, along the spin: it vanishes where p does."""
    p, q, discriminant = gs.derivation.spectral_criterion(e3.linearization).alternatives[0]
    assert q.margin == 0
    assert (discriminant.margin, discriminant.degenerate) == (1, (p.margin,))
