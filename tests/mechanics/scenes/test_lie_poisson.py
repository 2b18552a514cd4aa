"""The bracket: against its definition, Jacobi, Leibniz, Casimirs; and that wrong tensors do not exist."""
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy import ImmutableMatrix, Matrix, cos, exp, expand, simplify, sin

import gyrostat as gs
from gyrostat.errors import ScopeError, StructureError
from gyrostat.mechanics.scenes.lie_poisson import LiePoisson

E3 = gs.lie_poisson(("k",))
SO3 = gs.lie_poisson(())
PI, K, L = (
    Matrix(E3.coordinates[:3]),
    Matrix(E3.coordinates[3:]),
    Matrix([gs.symbol(f"l{i}") for i in (1, 2, 3)]),
)


def polynomials(space):
    """Random polynomials of degree ≤ 2 in the coordinates, and l1 as a parameter."""
    x = st.sampled_from((*space.coordinates, gs.symbol("l1")))
    term = st.builds(lambda c, a, b: c * a * b, st.integers(-3, 3), x, st.one_of(x, st.just(1)))
    return st.lists(term, min_size=1, max_size=3).map(sum)


def defined(f, g):
    """{F, G} = −M·(∂πF × ∂πG) − k·(∂πF × ∂kG + ∂kF × ∂πG), VV2003 §2, with SymPy's cross product."""
    fp, fk, gp, gk = (Matrix([h.diff(x) for x in v]) for h in (f, g) for v in (PI, K))
    return expand(-(PI + L).dot(fp.cross(gp)) - K.dot(fp.cross(gk) + fk.cross(gp)))


@given(polynomials(E3), polynomials(E3))
def test_bracket_is_its_definition(f, g):
    """∇F · B ∇G is the printed formula."""
    f, g = f + 0 * PI[0], g + 0 * PI[0]
    assert E3.bracket(f, g) == defined(*map(gs.algebra.text.numbers.exact_expression, (f, g)))


def test_bracket_of_smooth_functions():
    """Nothing is special about polynomials."""
    f, g = exp(K[2]) * PI[0], sin(PI[1]) + cos(K[0] * PI[2])
    assert simplify(E3.bracket(f, g) - defined(f, g)) == 0


@pytest.mark.few(1)
@pytest.mark.parametrize("space", [E3, SO3])
@given(data=st.data())
@settings(max_examples=10)
def test_jacobi_and_leibniz(space, data):
    """{F, {G, H}} + cyclic = 0 and {F, G H} = G {F, H} + {F, G} H, for random polynomials."""
    f, g, h = (data.draw(polynomials(space)) for _ in range(3))
    cyclic = sum(space.bracket(a, space.bracket(b, c)) for a, b, c in ((f, g, h), (g, h, f), (h, f, g)))
    assert expand(cyclic) == 0
    assert expand(space.bracket(f, g * h) - g * space.bracket(f, h) - space.bracket(f, g) * h) == 0


@pytest.mark.few(1)
@pytest.mark.parametrize("space", [E3, SO3])
@given(data=st.data())
def test_casimirs_commute_with_everything(space, data):
    """{C, F} = 0."""
    f = data.draw(polynomials(space))
    assert all(space.bracket(c, f) == 0 for c in space.casimirs)


def test_spaces_are_the_smallest():
    """3 coordinates and one Casimir without a field, 6 and two with one."""
    assert (len(SO3.coordinates), len(SO3.casimirs)) == (3, 1)
    assert (len(E3.coordinates), len(E3.casimirs)) == (6, 2)
    assert {
        E3.tensor.subs(dict.fromkeys(E3.coordinates, 0), simultaneous=True).subs(dict.fromkeys(L, 1)).rank()
    } == {2}


def test_the_shift_by_l():
    """The gyrostatic structure is the old one after π → π + l."""
    plain = gs.lie_poisson(("k",), (0, 0, 0))
    assert plain.tensor.xreplace({p: p + l for p, l in zip(PI, L)}) == E3.tensor


def test_a_wrong_tensor_does_not_exist():
    """Antisymmetry, Jacobi and the Casimirs are checked when the space is built, and the message says what
    fails.
    """
    wrong = E3.tensor.as_mutable()
    wrong[0, 4], wrong[4, 0] = -wrong[0, 4], -wrong[4, 0]
    with pytest.raises(StructureError, match="jacobiator of pi1, pi2"):
        LiePoisson(E3.coordinates, ImmutableMatrix(wrong), ())
    wrong[4, 0] *= -1
    with pytest.raises(StructureError, match="antisymmetric"):
        LiePoisson(E3.coordinates, ImmutableMatrix(wrong), ())
    with pytest.raises(StructureError, match="not a Casimir"):
        LiePoisson(E3.coordinates, E3.tensor, (E3.casimirs[0] + PI[0],))
    with pytest.raises(StructureError, match="polynomial"):
        LiePoisson(SO3.coordinates, ImmutableMatrix(SO3.tensor.applyfunc(lambda e: e * exp(PI[0]))), ())


def test_other_spaces_are_refused():
    """Of three directions one is a combination of the others; names that mean something else are refused."""
    for directions in (("k", "e", "n"), ("k", "k"), ("pi",), ("1",)):
        with pytest.raises(ScopeError, match="directions"):
            gs.lie_poisson(directions)
