"""Every family that a published file may name has the other route to its point."""
import pytest
from sympy import Matrix, Rational

from gyrostat.errors import PublishedError
from gyrostat.mechanics.families.named_families import PERMANENT, known_families
from gyrostat.mechanics.scenes.kind import Kind
from gyrostat.published.independent.frame_equations import model_of
from gyrostat.published.scenes import Scene

TOP = {"inertia": ["I1", "I1", "I3"], "gyrostatic_momentum": ["0", "0", "l"]}
TILTS = {"k3": Rational(3, 5), "n3": Rational(3, 5)}       # the other component is 4/5


def asked(family):
    """A scene of its kind in which it is asked for."""
    if Kind.FREE in family.kinds:
        table = {"potential": "none"}
    elif Kind.ORBIT in family.kinds:
        table = {"orbit": {"rate": "omega0"}} | ({} if family.made_with == "pointing" else TOP)
    else:
        table = {"potential": "U(k3)"} | TOP
    return Scene(table | {"equilibrium": family.asked_for})


def numbers(scene):
    """A number for each name, but for those that the family expresses by the others."""
    eq = scene.equilibrium
    bound = {name for name, _ in eq.relations}
    names = set().union(*(x.free_symbols for x in eq.point), *(x.free_symbols for _, x in eq.relations))
    free = sorted((names | scene.parameters) - bound, key=str)
    values = {s: TILTS.get(s.name, Rational(n + 7, n + 5)) for n, s in enumerate(free)}
    return values | {s: x.subs(values) for s, x in eq.relations}


@pytest.mark.parametrize("family", [each for each in known_families() if each is not PERMANENT],
                         ids=lambda family: family.label)
def test_newton_and_euler_have_its_point(family):
    """The point is that of the library, and the equations of motion vanish there."""
    scene = asked(family)
    values = numbers(scene)
    model = model_of(scene, values)                        # refuses a point that is no equilibrium
    assert scene.equilibrium.label == family.label
    assert Matrix(model.point) == Matrix(scene.equilibrium.point).subs(values)


def test_a_formula_about_permanent_rotations_names_a_point():
    """Therefore they need no other route: the file has their point."""
    with pytest.raises(PublishedError, match="a formula is about one direction"):
        assert Scene({"potential": "U(k1, k2, k3)", "equilibrium": PERMANENT.asked_for}).equilibrium
