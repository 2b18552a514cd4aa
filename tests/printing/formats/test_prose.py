"""Prose in LaTeX."""
import ast
import json
import re
from pathlib import Path

import pytest
import session

import gyrostat
from gyrostat.printing.formats.prose import words

SRC = Path(gyrostat.__file__).parent
LIST = {"potential": "c1*k1 + c3*k3", "inertia": ["I1", "I2", "I3"], "gyrostatic_momentum": ["0", "0", "l"],
        "equilibrium": "every omega",
        "values": {"I1": "1", "I2": "1.2", "I3": "1.6", "l": "0", "c1": "0.5", "c3": "1", "omega": "2"}}
LEVEL = {"potential": "m0*k3", "inertia": ["I1", "I1", "I3"], "gyrostatic_momentum": ["0", "0", "l"],
         "equilibrium": "every pi3_0 C1",
         "values": {"I1": "1", "I3": "1.6", "l": "0", "m0": "1", "pi3_0": "2", "C1": "1"}}


def prose():
    """The texts of the library, but for docstrings."""
    for path in SRC.rglob("*.py"):
        tree = ast.parse(path.read_text(encoding="utf-8"))
        documented = {id(node.body[0].value) for node in ast.walk(tree)
                      if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef)
                      and node.body and isinstance(node.body[0], ast.Expr)}
        for node in ast.walk(tree):
            if isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in documented:
                yield node.value


@pytest.mark.slow
def test_every_text_of_the_library_has_its_latex():
    """In ASCII, dollar signs in pairs, and no sign by its name in sentences, which have blanks."""
    texts = [text for text in prose() if not text.isascii() and re.search(r"[a-z]{2,} [a-z]{2,}", text)]
    assert len(texts) > 40
    for text in texts:
        latex = words(text)
        assert latex.isascii() and len(re.findall(r"(?<!\\)\$", latex)) % 2 == 0
        assert not re.search(r"\((latin|greek|combining|superscript|subscript|modifier)", latex), text


@pytest.mark.parametrize("text, latex", [
    ("the frequencies are 2.00153, −0.0238721", "the frequencies are 2.00153, $-$0.0238721"),
    ("ω turns in the body", r"$\omega$ turns in the body"),
    ("ψ̇ = ω₃⁰ × M⁻¹", r"$\dot{\psi}$ = $\omega_{3}^{0}$ $\times$ M$^{-1}$"),
    ("Poincaré, Cárdenas, Müller, Ó, ñ, ç", r"Poincar{\'e}, C{\'a}rdenas, M{\"u}ller, {\'O}, {\~n}, {\c c}"),
    ("a_1 & 5 % of {x}", r"a\_1 \& 5 \% of \{x\}"), ("a < b | c", "a $<$ b $|$ c"),
    ("к", "(cyrillic small letter ka)")])
def test_signs_and_letters_are_commands(text, latex):
    """What LaTeX would refuse, or set as another sign."""
    assert words(text) == latex


@pytest.mark.parametrize("scene, said", [(LIST, r"are 2.00153, $-$0.0238721"), (LEVEL, r"$\omega$ turns in")],
                         ids=["rate", "level"])
def test_a_list_that_is_copied_is_ascii(scene, said):
    """Every equilibrium, with its reasons."""
    copied = json.loads(session.answer(json.dumps({"want": "copied", "scene": scene})))["latex"]
    assert said in copied and copied.isascii()
