"""What is unusual about the numbers of a scene or a state is said."""
import pytest
from sympy import Rational, sqrt

import gyrostat as gs
from gyrostat.stability.criteria.number_notes import state_note
from gyrostat.trajectories import motion

STATE = (0, "1/10", 1, "3/5", 0, "4/5")
SATELLITE = (1, 2, Rational(5, 2))


def note(inertia, U, state=STATE):
    return state_note(gs.assemble(gs.Gyrostat(inertia, (0, 0, 0)), gs.general_potential(U)),
                      tuple(map(Rational, state)))


@pytest.mark.parametrize("U", [
    lambda x, y, z: Rational(3, 2) * (x**2 + 2 * y**2 + Rational(5, 2) * z**2),
    lambda x, y, z: 7 - sqrt(2) * (3 * x**2 + y**2),
    lambda x, y, z: (x**4 + 2 * y**4 + Rational(5, 2) * z**4 + 3 * x**2 * y**2 + Rational(7, 2) * x**2 * z**2
                     + Rational(9, 2) * y**2 * z**2)])
def test_the_gravity_gradient_in_any_spelling(U):
    """c k·Ik where abs(k) = 1, c > 0: k is fixed in space here, it is no vertical of an orbit."""
    assert "this is not the satellite in its orbit" in note(SATELLITE, U)


@pytest.mark.parametrize("U", [lambda x, y, z: -(x**2 + 2 * y**2 + Rational(5, 2) * z**2),
                               lambda x, y, z: x**2 + 2 * y**2 + 3 * z**2,
                               lambda x, y, z: x**2 + 2 * y**2 + Rational(5, 2) * z**2 + x / 100,
                               lambda x, y, z: x * y + z])
def test_other_fields_have_no_note(U):
    """Another sign, another form, a linear term."""
    assert note(SATELLITE, U) == ""


def test_a_verdict_has_the_note():
    """Numbers for names: at n = 0 there is no field and no note."""
    n = gs.symbol("n")
    field = gs.general_potential(lambda x, y, z: n * (x**2 + 2 * y**2 + 3 * z**2))
    report = gs.analyze(gs.equilibrium(gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)), field),
                                       (0, 0, 1, 0, 0, 1)))
    assert "gravity gradient" in report.verdict({"n": 2}).note
    assert report.verdict({"n": -2}).note == report.verdict({"n": 0}).note == ""


def test_a_direction_that_is_no_unit_vector():
    """Said of 1.08 and of 0.577 three times, not of a unit vector in doubles."""
    uniform = gs.assemble(gs.Gyrostat((1, 1, 1), (0, 0, 0)), gs.axial_potential(lambda z: z))
    assert "|k| = 1.08000000000, not 1" in motion(uniform, (0, 0, 1, 0, 0, "1.08")).note
    assert "not 1" in motion(uniform, (0, 0, 1, *["0.577"] * 3)).note
    assert (
        motion(uniform, (0, 0, 1, 0.6, 0.0, 0.8)).note
        == motion(uniform, (0, 0, 1, *[3**-0.5] * 3)).note
        == ""
    )


def test_an_inertia_that_no_body_has():
    """In a motion too, with a field and without, and where it prints."""
    free = motion(gs.assemble(gs.Gyrostat((1, 1, 3), (0, 0, 0))), (1, 0, 1))
    assert free.note.startswith("no rigid body has the moments 1, 1, 3")
    assert "note: no rigid body" in repr(free)
    top = motion(gs.assemble(gs.Gyrostat((1, 1, 3), (0, 0, 0)), gs.axial_potential(lambda z: z)), STATE)
    assert "no rigid body" in top.note


def test_a_motion_prints_what_is_known_of_it():
    """Route, period, precession, spin, limits and error, a line each."""
    top = motion(gs.assemble(gs.Gyrostat((1, 1, 1), (0, 0, 0)), gs.axial_potential(lambda z: z)), STATE)
    lines = repr(top).splitlines()
    assert lines[0] == "Motion: elliptic"
    assert [line.split()[0] for line in lines[1:]] == ["period", "precession", "spin", "k3", "error"]
    assert f"{top.period:.12g}" in lines[1] and str(top) == repr(top)


IMPOSSIBLE = "no rigid body has the moments 1, 2, 4"


@pytest.mark.parametrize("field, rotor, asked", [
    (None, (0, 0, 0), {"M": 1}), (None, (0, 0, 1), {"M": 0}),
    (gs.general_potential("k1 + 2*k2"), (0, 0, 1), {"omega": 1}),
    (gs.general_potential("k1 + k3"), (0, 0, 0), {"C1": 1}),
    (gs.general_potential("13/5*k3"), (0, 0, 1), {"k1": 0, "k2": "3/5", "k3": "4/5"}),
    (gs.circular_orbit(1), (0, 0, 0), {})])
def test_every_rotation_of_a_list_has_the_note(field, rotor, asked):
    """As a verdict about one has it, under damping too."""
    for inertia, said in (((1, 2, 4), IMPOSSIBLE), ((2, 3, 4), "")):
        for rotation in gs.relative_equilibria(gs.assemble(gs.Gyrostat(inertia, rotor), field), asked):
            for decision in (rotation.decision, rotation.damped):
                assert decision.note.startswith(said) and bool(decision.note) is bool(said)


@pytest.mark.slow
def test_pieces_of_arcs_have_the_note():
    for rotor in ((0, 0, 0), (0, 0, 1)):
        scene = gs.assemble(gs.Gyrostat((1, 2, 4), rotor), gs.general_potential("k1 + k2 + k3"))
        arcs = gs.staude_cone(scene).arcs({})
        assert all(piece.decision.note.startswith(IMPOSSIBLE) for arc in arcs for piece in arc.pieces)


def test_the_satellite_in_a_field_fixed_in_space():
    """U = k·Ik is noted on every rotation of a level."""
    scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)), gs.general_potential("k1^2 + 2*k2^2 + 3*k3^2"))
    assert all("gravity gradient" in r.decision.note for r in gs.relative_equilibria(scene, {"C1": 1}))
