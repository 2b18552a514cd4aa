"""Satellites held by a rotor: any tensor with t·Ir = 0; free rotors; K and g as formulas have them."""
import pickle
from dataclasses import replace
from fractions import Fraction as F
from random import Random

import pytest
from satellites import exact
from slow import sampled
from sympy import Matrix, N, Rational

import gyrostat as gs
from gyrostat.mechanics.families.circular_orbit import by_gradient_alone
from gyrostat.mechanics.families.scene_tables import SceneTable
from gyrostat.mechanics.scenes.principal_axes import principal_axes
from gyrostat.stability.criteria.orientation_form import orientation_form


def tensor_of(rng):
    """A positive tensor in the axes (t, n, r) with I_tr = 0, as fractions."""
    def some():
        return F(rng.randint(-9, 9), rng.randint(3, 12))

    while True:
        tt, nn, rr = (F(rng.randint(5, 40), 10) for _ in range(3))
        tn, nr = some() / 2, some() / 2
        if tt * nn > tn**2 and tt * (nn * rr - nr**2) > tn**2 * rr:
            return [[tt, tn, F(0)], [tn, nn, nr], [F(0), nr, rr]]


@pytest.mark.slow
def test_the_rotor_that_holds_a_tensor(full):
    """K and g of the scene against the formulas in the entries of the tensor."""
    rng = Random(7)
    for _ in range(sampled(300, full, 40)):
        (tt, tn, _), (_, nn, nr), (_, _, rr) = tensor = tensor_of(rng)
        w, along = F(rng.randint(1, 9), rng.randint(1, 5)), F(rng.randint(-30, 30), 10)
        orbit = gs.circular_orbit(w)
        held = gs.earth_pointing_gyrostat(gs.Gyrostat(tensor, (5, along, 7)), orbit)
        assert list(held.gyrostatic_momentum) == exact([-w * tn, along, -4 * w * nr])
        K, g, _ = orientation_form(gs.earth_pointing(gs.assemble(held, orbit)))
        assert K == Matrix([exact(row) for row in (
            [4 * w**2 * (nn - rr) + w * along, -3 * w**2 * tn, F(0)],
            [-3 * w**2 * tn, 3 * w**2 * (tt - rr), 3 * w**2 * nr],
            [F(0), 3 * w**2 * nr, w**2 * (nn - tt) + w * along])])
        assert list(g) == exact([-w * tn, w * (tt + rr - nn) - along, 2 * w * nr])


def test_every_assignment_of_the_axes():
    """Roll, pitch and yaw along any axes, in either sense: held, with the momentum along pitch kept."""
    orbit, names = gs.circular_orbit(), [gs.symbol(f"a{i}") for i in range(5)]
    for axes in ((1, 2, 3), (3, -1, 2), (2, 3, -1)):
        t, n, r = (abs(x) - 1 for x in axes)
        tensor = [[0] * 3 for _ in range(3)]
        for (i, j), x in zip(((t, t), (n, n), (r, r), (t, n), (n, r)), names):
            tensor[i][j] = tensor[j][i] = x
        held = gs.earth_pointing_gyrostat(gs.Gyrostat(tensor), orbit, *axes)
        assert held.gyrostatic_momentum[n] == gs.symbol(f"l{n + 1}")
        assert held.gyrostatic_momentum[t].free_symbols == {gs.symbol("omega0"), gs.symbol("a3")}
        assert gs.earth_pointing(gs.assemble(held, orbit), *axes).label == "Earth-pointing"


def test_a_product_of_roll_and_yaw_is_held_by_no_rotor():
    """What it is, what turns the body, and by which angle it is turned: here cos φ = 4/5, sin φ = 3/5."""
    body = gs.Gyrostat([["34/25", 0, "-12/25"], [0, 2, 0], ["-12/25", 0, "41/25"]], (0, 0, 0))
    with pytest.raises(gs.errors.EquilibriumError, match=r"t·Ir = -12/25, .* no rotor balances it\. .*"
                       r"t towards r by φ, tan 2φ = .* = -24/25 over -7/25$"):
        gs.earth_pointing_gyrostat(body, gs.circular_orbit())
    turn = Matrix([[4, 0, 3], [0, 5, 0], [-3, 0, 4]]) / 5  # rows: the new t, n, r
    turned = gs.Gyrostat((turn * body.tensor * turn.T).tolist(), (0, 3, 0))
    assert gs.earth_pointing_gyrostat(turned, gs.circular_orbit()) == turned
    with pytest.raises(gs.errors.ScopeError, match="without another field and without a free rotor"):
        gs.earth_pointing_gyrostat(body, gs.circular_orbit(potential=gs.symbol("n1")))


def test_what_turns_a_body_that_is_not_held():
    """Each of the three that is not 0, in the axes of the orbit, and what to do; names may be 0."""
    tensor = [[410, 5, 5], [5, 580, 5], [5, 5, 250]]
    for rotor, why in (((0, 12, 0), "t·Ir = 5, l·t + ω0 t·In = 5, l·r + 4 ω0 r·In = 20, and"),
                       ((-5, 12, -20), "t·Ir = 5, and")):
        with pytest.raises(gs.errors.EquilibriumError) as error:
            gs.earth_pointing(gs.assemble(gs.Gyrostat(tensor, rotor), gs.circular_orbit(1)))
        assert f"of this body: {why} each must be 0: turn the body" in str(error.value)


@pytest.mark.slow
def test_freeing_a_rotor_adds_to_the_stiffness(full):
    """K_free = K_servo + ω0² J (n × a)(n × a)ᵀ at the same momentum, gravity on the full tensor."""
    rng = Random(8)
    for _ in range(sampled(300, full, 40)):
        tensor, w, J = tensor_of(rng), F(rng.randint(1, 9), rng.randint(1, 5)), F(rng.randint(1, 9), 40)
        axis = [F(x, 7) for x in rng.choice([(2, -3, 6), (6, 2, 3), (0, 7, 0), (7, 0, 0)])]
        orbit = gs.circular_orbit(w)
        servo = gs.earth_pointing_gyrostat(gs.Gyrostat(tensor, (0, F(rng.randint(-30, 30), 10), 0)), orbit)
        # a second rotor at h holds beside it: the free one has the axial momentum J (ω·a + Ω) = h
        h = F(rng.randint(-20, 20), 10)
        wheel = gs.Rotor(axis, axial=J, momentum=h)
        a, moment, speed = Matrix(exact(axis)), *exact([J, w * axis[1]])
        left = Matrix(servo.gyrostatic_momentum) + (moment * speed - exact([h])[0]) * a
        free = gs.gyrostat_with_rotors(tensor, [wheel], lumped=True)
        free = replace(free, gyrostatic_momentum=Matrix(free.gyrostatic_momentum) + left)
        scene = gs.assemble(free, gs.circular_orbit(w))
        K, _, inertia = orientation_form(gs.earth_pointing(scene))
        held, *_ = orientation_form(gs.earth_pointing(gs.assemble(servo, orbit)))
        across = Matrix(exact([axis[2], F(0), -axis[0]]))  # n × a
        assert K == held + exact([w])[0]**2 * moment * across * across.T
        assert inertia == Matrix([exact(row) for row in tensor]) - moment * a * a.T


def test_a_free_pitch_wheel():
    """K stays; pitch librates with the moment of the body alone, I2 − J."""
    wheel = gs.Rotor((0, 1, 0), axial="1/10", momentum="1/2")
    whole = gs.gyrostat_with_rotors((60, 70, 35), [wheel], lumped=True)
    assert whole.moments == (60, Rational(699, 10), 35)
    pointing = gs.earth_pointing(gs.assemble(whole, gs.circular_orbit(1)))
    driven = gs.Gyrostat((60, 70, 35), (0, Rational(1, 2) - Rational(1, 10), 0))
    K, *_ = orientation_form(gs.earth_pointing(gs.assemble(driven, gs.circular_orbit(1))))
    assert orientation_form(pointing).stiffness == K
    pitch = gs.derivation.linearize(pointing).factors()[0][0]
    assert pitch == 233 * gs.symbol("lamda")**2 + 250      # 699/10 and 75


def test_driven_rotors_are_in_the_tensor():
    """A body with driven rotors alone is that of its numbers; gravity acts on its tensor."""
    driven = gs.Rotor((0, 1, 0), axial=1, rate=5)
    body = gs.gyrostat_with_rotors((60, 70, 35), [driven], lumped=True)
    assert body == gs.Gyrostat((60, 70, 35), (0, 5, 0)) and body.gravitating == body.tensor


def test_gravity_acts_on_free_rotors_in_any_axes():
    """The energy of the gravity gradient is that of the locked tensor, in its principal axes too."""
    rng = Random("free rotors")
    for _ in range(5):
        tensor = tensor_of(rng)
        axis, J = Matrix([rng.randint(1, 4) for _ in range(3)]), F(1, 50)
        body = gs.gyrostat_with_rotors(tensor, [gs.Rotor(axis, axial=J, momentum=1)], lumped=True)
        r = Matrix(gs.notation.components("r"))
        for this, R in ((body, Matrix.eye(3)), principal_axes(body)):
            scene = gs.assemble(this, gs.circular_orbit(1))
            locked = R * Matrix([exact(row) for row in tensor]) * R.T
            at = dict(zip(r, exact([F(1, 3), F(2, 3), F(-2, 3)])))
            energy = scene.potential.expression.xreplace(dict.fromkeys(gs.notation.components("n"), 0))
            there = r.xreplace(at)
            assert N(energy.xreplace(at) - (Rational(3, 2) * there.T * locked * there)[0], 30, chop=True) == 0
            assert not by_gradient_alone(scene) and this.gravitating != this.tensor


def test_a_body_with_free_rotors_keeps_them():
    """In a pickle, at numbers, and where two bodies are compared."""
    J = gs.symbol("J")
    free, fixed = (gs.gyrostat_with_rotors((60, 70, 35), [gs.Rotor((0, 1, 0), axial=5, **how)], lumped=True)
                   for how in ({"momentum": 1}, {"rate": "1/5"}))
    assert pickle.loads(pickle.dumps(free)).gravitating == free.gravitating == fixed.tensor
    assert free != gs.Gyrostat(free.inertia, free.gyrostatic_momentum)
    named = gs.gyrostat_with_rotors((60, 70, 35), [gs.Rotor((0, 1, 0), axial=J, momentum=1)], lumped=True)
    assert named.changed(lambda x: x.xreplace({J: 5})) == free


def test_a_scene_file_with_a_free_wheel():
    """Its gravity gradient is that of the whole satellite."""
    table = {"inertia": [60, 70, 35], "lumped": True, "orbit": "1", "equilibrium": "earth-pointing",
             "rotors": [{"axis": [0, 0, 1], "axial": "5", "momentum": "0"}]}
    scene = SceneTable(table).system
    assert scene.body.moments == (60, 70, 30)
    K, *_ = orientation_form(gs.earth_pointing(scene))
    assert K.is_diagonal() and K[1, 1] == 3 * (60 - 35)
