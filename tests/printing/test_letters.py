"""A letter in a document has one meaning: where the scene has one of ours, ours is another."""
import re
import string
from functools import cache
from itertools import chain
from unicodedata import normalize

import pytest
from sympy import Basic, MatrixBase, S

import gyrostat as gs
from gyrostat.errors import ScopeError
from gyrostat.printing.blocks import Display, Rows, Sentence, Word
from gyrostat.printing.formats.latex import tex
from gyrostat.printing.formats.latex_names import Names
from gyrostat.printing.formats.unicode import unicode
from gyrostat.printing.results.beyond_reports import result_blocks
from gyrostat.printing.results.document import report_blocks, whole_blocks
from gyrostat.typesetting import GREEK, typeset

NEUTRAL = "Xi"                                             # a letter that nothing of ours has
# the time, names of the rotor and of the motion, and words that stand for numbers
TAKEN = {"l", "t", "k", "theta", "phi", "psi", "omega", "sigma", "pi", NEUTRAL, "Sigma"}
NUMBERED = ["C1", "C2", "C3", "D4", "J1", "K11", "A11", "v1", "R1", "f1", "F1", "c3", "c4", "e3", "Delta1",
            "C_1"]
LETTERS = sorted({*string.ascii_letters, *GREEK} - TAKEN) + NUMBERED
k1, k2, k3 = (gs.symbol(f"k{n}") for n in (1, 2, 3))
MOMENT = gs.symbol("Sigma")                             # another one


def heavy(name):
    """A body of revolution in U(k3), its moment across and its slope by two letters."""
    U = gs.axial_potential(gs.symbol(name) * k3 + MOMENT * k3**2)
    scene = gs.assemble(gs.symmetric_gyrostat(), U)
    reports = [gs.analyze(family(scene)) for family in (gs.upright, gs.inclined)]
    yield from whole_blocks(scene, list(chain(*map(report_blocks, reports))))
    yield from result_blocks(gs.mechanics.reduce(scene))


def by_its_body(name):
    """The same, the letter a moment of the body."""
    body = gs.Gyrostat((gs.symbol(name), gs.symbol(name), MOMENT), (0, 0, 0))
    scene = gs.assemble(body, gs.uniform_field())
    yield from whole_blocks(scene, report_blocks(gs.analyze(gs.upright(scene))))


def free(name):
    """A free gyrostat."""
    scene = gs.assemble(gs.Gyrostat((1, gs.symbol(name), 3), (0, 0, MOMENT)))
    yield from whole_blocks(scene, report_blocks(gs.analyze(gs.principal_rotation(scene, 3))))


def satellite(name):
    """In orbit, the letter a moment."""
    scene = gs.assemble(gs.Gyrostat((gs.symbol(name), 2, 3), (0, MOMENT, 0)), gs.circular_orbit())
    yield from whole_blocks(scene, report_blocks(gs.analyze(gs.earth_pointing(scene))))


def any_direction(name):
    """Permanent rotations in any direction, the conditions by definitions."""
    scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)),
                        gs.general_potential(gs.symbol(name) * k1 + MOMENT * k2))
    yield from whole_blocks(scene, report_blocks(gs.analyze(gs.permanent_rotation(scene))))


def amended(name):
    """The potential on a level of C1; a scene with a parameter of that name has none."""
    field = gs.general_potential(gs.symbol(name) * k1 + MOMENT * k2)
    yield from result_blocks(gs.amended_potential(gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)), field)))


def window(name):
    """Where gyroscopic forces hold a maximum, D4 in the letter."""
    field = gs.general_potential(-gs.symbol(name) * k1**2 - 2 * k2**2)
    scene = gs.assemble(gs.Gyrostat((1, "6/5", 2), (0, 0, 0)), field)
    report = gs.analyze(gs.upright(scene, spin="omega3_0"))
    yield from result_blocks(report.window({"omega3_0": 5}))


SCENES = [heavy, by_its_body, free, satellite, any_direction, amended, window]


def formulas(blocks):
    """Each formula of a document with the place of its derivatives of U; prose has none of our letters."""
    for block in blocks:
        if isinstance(block, Sentence):
            yield from ((part, block.at) for part in block.parts if not isinstance(part, str))
        elif isinstance(block, Display):
            yield from ((block.name, block.at), (block.value, block.at))
        elif isinstance(block, Rows):
            yield from ((part, None) for left, right in block.rows for part in (*left, *right)
                        if not isinstance(part, str))


def letters(shown):
    """The letters of a formula in Unicode, each with what stands below it."""
    return re.findall("energy|[^\\W\\d_][\u0307\u0308]*[₀-₉ₙ]*(?:_[^\\W\\d]\\w*)?", normalize("NFD", shown))


def in_text(blocks):
    """All letters of the document."""
    for part, at in formulas(blocks):
        entries = part.flat() if isinstance(part, MatrixBase) else [part]
        for entry in entries:
            yield from letters(entry.text if isinstance(entry, Word) else unicode(S(entry), at))


@cache
def neutral(scene):
    """Of the document with the neutral letter: how often it stands in text and in LaTeX, and alone."""
    plain = list(scene(NEUTRAL))
    return (list(in_text(plain)).count("Ξ"), in_latex(plain).count(r"\Xi"),
            sum(part == gs.symbol(NEUTRAL) for part, _ in formulas(plain)))


def in_latex(blocks):
    """All of them in LaTeX, without what is a rate, bold or no formula."""
    shown = " ".join(tex(part, Names(), at) for part, at in formulas(blocks)
                     if isinstance(part, Word | Basic | MatrixBase))
    bare = re.sub(r"\\(?:begin|end|text|boldsymbol|mathrm)\{[^{}]*\}|\[3pt\]", " ", shown)
    bare = re.sub(r"\\dot\{[^{}]*(?:\{[^{}]*\})?\}(?:_\w)?", " ", bare)
    return re.findall(r"(?:\\[A-Za-z]+|[A-Za-z])(?:_(?:\{[^{}]*\}|\\?\w+))?", bare)


@pytest.mark.few(2)
@pytest.mark.parametrize("scene", SCENES)
@pytest.mark.parametrize("name", LETTERS)
def test_a_letter_of_the_scene_is_no_letter_of_the_print(scene, name):
    """It stands exactly where a letter does that nothing else has, in text and in LaTeX."""
    if (scene, name) == (amended, "C1"):
        with pytest.raises(ScopeError, match="has a parameter C1, .* write another letter for the parameter"):
            list(amended(name))
        return
    own = list(scene(name))
    wanted, in_formulas, alone = neutral(scene)
    known = alone if name == "r" else 0                    # a positive one need not be said to be so
    look, latex = normalize("NFD", typeset(name, style="text")), typeset(name)
    assert wanted - known <= list(in_text(own)).count(look) <= wanted, look
    assert in_formulas - known <= in_latex(own).count(latex) <= in_formulas, latex
