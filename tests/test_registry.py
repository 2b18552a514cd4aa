"""The table of names decides where each may stand, and the reference prints it.

`python tests/test_registry.py` writes it there.
"""
import re
from pathlib import Path

import pytest

import gyrostat as gs
from gyrostat.errors import BodyError, GyrostatError
from gyrostat.notation import NOTATION, REGISTRY, Use
from gyrostat.registry import Letters, free_letters, refused, use_of

PAGE = Path(__file__).parents[1] / "docs" / "reference" / "names.md"
TABLE = re.compile(r"<!-- ([A-Z]+) -->\n(.*?)<!-- end -->", re.DOTALL)
HEADS = {Use.PRINTED: ("printed", "what it is", "in its place")}
FORMULAS = {                                               # in the meanings, as the page typesets them
    "π1": r"\pi_1", "π2": r"\pi_2", "π3": r"\pi_3", "U": "U", "k3": "k_3", "C1": "C_1", "C2": "C_2",
    "M": "M", "K": "K", "H": "H",
    "ω = omega·k": r"\omega k", "|k| = 1": r"\lvert k\rvert = 1", "k3 = cos(theta)": r"k_3 = \cos\theta",
    "m g z0": "m g z_0", "3 g / r, r": "3g/r$, $r", "M·k": r"M\cdot k", "C1 = M·k": r"C_1 = M\cdot k",
    "Iω + l": r"I\omega + l", "|M|²": r"\lvert M\rvert^2", "k·Ik": r"k\cdot Ik", "λ²": r"\lambda^2",
    "2 ω Ik + l": r"2\omega Ik + l", "I1 dk3/dt": "I_1\\,dk_3/dt", "g": "g", "D4": "D_4",
    **{f"∫ |x|^{n} P_{n}(x3/|x|) dm": rf"\int \lvert x\rvert^{n} P_{n}(x_3/\lvert x\rvert)\,dm"
       for n in range(3, 10)}}
LONGEST_FIRST = sorted(FORMULAS, key=len, reverse=True)
FORMULA = re.compile("|".join(rf"(?<!\w){re.escape(text)}(?!\w)" for text in LONGEST_FIRST))
k1, k3 = gs.symbol("k1"), gs.symbol("k3")


def table(use):
    """The rows of one use, in Markdown."""
    left, middle, right = HEADS.get(use, ("name", "what it is", "letters to write"))
    lines = [f"| {left} | {middle} | {right} |", "|---|---|---|"]
    for entry in REGISTRY:
        if entry.use is use:
            name = entry.name.replace("vector_", "vector ")
            name = f"{name[:-1]}1, {name[:-1]}2, …" if name[-1] == "_" else name
            name = f"{name[:-1]}, {name[:-1]}1, …" if name[-1] == "*" else name
            letters = ", ".join(f"`{letter}`" for letter in entry.instead.split())
            if entry.name.startswith("vector_"):
                letters = "bold, all vectors"
            meaning = FORMULA.sub(lambda found: f"${FORMULAS[found[0]]}$", entry.meaning)
            lines.append(f"| `{name}` | {meaning}{', positive' if entry.positive else ''} | {letters} |")
    return "\n".join(lines)


def test_formulas_in_the_table_are_typeset():
    """No Greek letter, index, power, bar or product stands outside of a formula."""
    for entry in REGISTRY:
        text = FORMULA.sub("", entry.meaning)
        assert not re.search(r"[α-ωΑ-Ω²·∫|^*]|\b[A-Za-z]\d", text), (entry.name, text)


def filled(page):
    """The page with its tables."""
    return TABLE.sub(lambda found: f"<!-- {found[1]} -->\n{table(Use[found[1]])}\n<!-- end -->", page)


def test_the_reference_prints_the_table():
    """Every use once, its rows and the sentence that says what it decides."""
    page = PAGE.read_text(encoding="utf-8")
    assert page == filled(page), "python tests/test_registry.py writes docs/reference/names.md"
    assert sorted(name for name, _ in TABLE.findall(page)) == sorted(use.name for use in Use)


def test_every_name_is_there_once_and_has_a_use():
    """Those of the notation too; a letter of the print may be a name of the motion besides."""
    names = [entry.name for entry in REGISTRY if entry.use is not Use.PRINTED]
    printed = [entry.name for entry in REGISTRY if entry.use is Use.PRINTED]
    assert len(set(names)) == len(names) and len(set(printed)) == len(printed) and set(NOTATION) <= set(names)
    for use, some in ((Use.TIME, "t"), (Use.ROTOR, "l l2"), (Use.MOTION, "omega3_0 d2U_13 k1_dot sigma"),
                      (Use.ANGLE, "theta"), (Use.BODY, "I2"), (Use.FIELD, "m0 r"), (Use.LEVEL, "C1"),
                      (None, "h C p")):
        assert {use_of(name) for name in some.split()} == {use}


@pytest.mark.few(10)
@pytest.mark.parametrize("entry", [e for e in REGISTRY if e.use is not Use.PRINTED], ids=lambda e: e.name)
def test_the_table_decides_where_a_name_may_stand(entry):
    """In a potential, a tensor, a rotor, a drift and a rate."""
    s, refuses = gs.symbol(entry.name), (Use.TIME, Use.MOTION)
    places = {
        "potential": (lambda: gs.general_potential(s * k1), (*refuses, Use.ROTOR, Use.ANGLE)),
        "tensor": (lambda: gs.Gyrostat((s, 1, 1), (0, 0, 0)), (*refuses, Use.ROTOR)),
        "rotor": (lambda: gs.Gyrostat((1, 1, 1), (0, 0, s)), refuses),
        "wheel": (lambda: gs.Rotor((0, 0, 1), axial=1, rate=s), refuses),
        "rate": (lambda: gs.circular_orbit(s), (*refuses, Use.ROTOR, Use.ANGLE)),
        "drift": (lambda: gs.coupled_potential(0, ("e",), (s * gs.symbol("e1"), 0, 0)),
                  (*refuses, Use.ROTOR, Use.ANGLE)),
        "vehicle": (lambda: gs.underwater_vehicle((1, 1, 1), (1, 1, 1), weight=(0, 0, s)),
                    (*refuses, Use.ROTOR, Use.ANGLE)),
        "space": (lambda: gs.lie_poisson((), (0, 0, s)), refuses)}
    for place, (make, uses) in places.items():
        if entry.use not in uses or place == "potential" and entry.name in ("k1", "k2", "k3"):
            make()
            continue
        with pytest.raises(GyrostatError) as error:
            make()
        assert entry.name in str(error.value) and len(str(error.value)) <= 300, place


def test_a_free_letter_is_free():
    """Of the table first, then others; two names never get one."""
    assert free_letters(["l"], {"M", "g"}) == {"l": "L"} and free_letters(["l"], {"L", "a"}) == {"l": "b"}
    assert free_letters(["omega", "omega3_0"], ()) == {"omega": "Omega", "omega3_0": "w"}
    assert refused(map(gs.symbol, ("sigma", "h", "time", "J3"))) == ["time", "sigma"]


def test_a_letter_of_the_print_gives_way():
    """One that neither the scene nor the print has; vectors all together; looks alike, not names alike."""
    letters = Letters(["h", "C_1", "lambda", "K11", "Delta"], ["k"])
    assert [letters.of(name) for name in ("h", "C1", "C2", "C", "lamda", "K", "Delta2", "g")] == [
        "E", "Z1", "Z2", "C", "Lambda", "Y", "d2", "g"]
    assert letters.of("vector_k") == "vector_k" and Letters(["k"], ["k"]).of("vector_M") == "bold_M"
    assert Letters(["k"]).of("vector_M") == "vector_M" and Letters(["h", "E", "W"]).of("h") not in "hEW"
    assert Letters(["l", "pi3_0", "I1"]).text("⟨vector_l⟩ ⟨h⟩") == "l h"


def test_components_of_a_direction_are_no_letters_of_the_body():
    """In orbit n1 and r3, in a field k1: they would be taken for each other."""
    body = gs.Gyrostat((gs.symbol("r3"), 2, 3), (0, 0, 0))
    assert gs.assemble(body).body == body
    with pytest.raises(BodyError, match="r3, a component of a direction of this scene: write another letter"):
        gs.assemble(body, gs.circular_orbit())


if __name__ == "__main__":
    PAGE.write_text(filled(PAGE.read_text(encoding="utf-8")), encoding="utf-8")
