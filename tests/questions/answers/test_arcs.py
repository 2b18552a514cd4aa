"""gyrostat decide of a body in a field without numbers of its motion: every arc of permanent rotations."""
import json
import re

import pytest
from commands import decide
from sympy import Matrix, Rational, diag, simplify, zeros

import gyrostat as gs
from gyrostat.algebra.text.grammar import parse

AXIS = ["--potential", "k3", "--set", "I1=1", "I2=2", "I3=3", "l=1/2"]


@pytest.mark.slow
def test_arcs_as_text(capsys):
    status, out, err = decide(capsys, *AXIS)
    assert (status, err) == (0, "") and out.count("permanent rotations, arc") == 10
    assert "to k = (0, 0, 1), where ω =" in out and "every ω: stable" in out


@pytest.mark.slow
@pytest.mark.parametrize("field", ["k3", "2*k1 - k3",
                                   pytest.param("-k1 + k2 - 3*k3", marks=pytest.mark.slow)])
def test_what_is_not_proved_of_single_rates_is_said(capsys, field):
    """In the order of the pieces, of those that D4 decides and of no others."""
    asked = ["--potential", field, "--inertia", "2,1,6/5", "--gyrostatic-momentum=0,3/8,-1"]
    _, out, _ = decide(capsys, *asked)
    _, data, _ = decide(capsys, *asked, "--format", "json")
    said = re.findall(r": (?:un)?(?:stable|decided)(, except at single rates with D₄ = 0)?\n", out)
    by_d4 = [piece["decision"]["rung"] == "D4" for arc in json.loads(data)["arcs"] for piece in arc["pieces"]]
    assert [*map(bool, said)] == by_d4 and any(by_d4) and not all(by_d4)


@pytest.mark.slow
def test_it_is_said_where_an_arc_is_split(capsys):
    """With a rotor at resonances only, without one at the zeros of D4 too; the words used are explained."""
    for rotor, split in (("0,3/8,-1", "the two frequencies. The pieces"),
                         ("0,0,0", "the two frequencies, and where D₄ = 0. The pieces")):
        _, out, _ = decide(capsys, "--potential", "k1 + k2 + k3", "--inertia", "1,2,3",
                           f"--gyrostatic-momentum={rotor}")
        said = " ".join(out.split())
        assert f"an arc is split at the resonances 1:2 and 1:3 of {split}" in said
        assert "Arnold's determinant D4" in out.split("\n  Terms\n")[1]


@pytest.mark.slow
@pytest.mark.parametrize("rotor", ["l=1/2", "l=0"])
def test_arcs_as_data(capsys, rotor):
    """Those of the library, exact and as decimals."""
    status, out, _ = decide(capsys, *AXIS[:-1], rotor, "--format", "json")
    found = json.loads(out)["arcs"]
    body = gs.Gyrostat((1, 2, 3), (0, 0, rotor[2:]))
    arcs = gs.staude_cone(gs.assemble(body, gs.general_potential(lambda k1, k2, k3: k3))).arcs({})
    assert status == 0 and len(found) == len(arcs)
    for data, arc in zip(found, arcs):
        assert data["parameter"] == str(arc.parameter)
        texts = [(data[end]["exact"], str(getattr(arc, end))) for end in ("low", "high")]
        texts += [(end["omega"]["exact"], str(given.omega)) for end, given in zip(data["ends"], arc.ends)]
        assert all(said == whole if len(whole) <= 60 else len(said) <= 24 for said, whole in texts)
        assert [[x["decimal"] for x in end["k"]] for end in data["ends"]] == [
            [float(x) for x in end.k] for end in arc.ends]
        assert [piece["decision"]["verdict"] for piece in data["pieces"]] == [
            piece.decision.verdict.name for piece in arc.pieces]
    assert found[0]["low"]["decimal"] is None                          # JSON has no infinity


def test_other_fields_and_other_questions_are_answered_as_before(capsys):
    _, out, _ = decide(capsys, *AXIS, "omega=2", "--full")
    assert "arc 1" not in out and out.count("ω = 2") == 6
    status, _, err = decide(capsys, "--potential", "k1^2 + k2 + k3", *AXIS[2:])
    assert status == 2 and "decide finds those of a rate omega" in err


def test_the_direction_in_the_data_is_that_of_the_rotation(capsys):
    """k in a piece is a unit vector, and with omega_squared solves ∇U × k = omega² Ik × k (Staude 1894)."""
    _, out, _ = decide(capsys, "--potential", "k1", *AXIS[2:-1], "l=0", "--format", "json")
    arcs = json.loads(out)["arcs"]
    assert arcs
    for arc in arcs:
        for piece in arc["pieces"]:
            low, high = (piece[end]["decimal"] for end in ("low", "high"))
            at = {gs.symbol(arc["parameter"]): Rational(str((max(-9, low or -9) + min(9, high or 9)) / 2))}
            k = Matrix([parse(x).subs(at) for x in arc["k"]])
            rate = parse(arc["omega_squared"]).subs(at)
            assert simplify(k.dot(k)) == 1 and rate > 0
            assert simplify((Matrix([1, 0, 0]) - rate * diag(1, 2, 3) * k).cross(k)) == zeros(3, 1)


@pytest.mark.parametrize("stray", ["foo", "I4", "M"])
def test_a_name_that_is_none_is_refused(capsys, stray):
    """Beside the numbers of arcs; those of the motion ask for something else."""
    asked = ["--potential", "k1+k2+k3", "--inertia", "1,2,3", "--gyrostatic-momentum", "0,0,0", "--set"]
    status, _, err = decide(capsys, *asked, f"{stray}=1")
    assert status == 2 and f"the scene has no parameter {stray}: its parameters are" in err
    assert decide(capsys, *asked, "omega=2")[0] == 0
