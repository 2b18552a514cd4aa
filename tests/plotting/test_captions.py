"""Captions for a paper: LaTeX that compiles, with scene, numbers and what each look means."""
import re
import shutil
import subprocess

import matplotlib
import pytest
from drawn_pictures import BODY, FIELDS, of_revolution, of_three_moments, without_a_field
from matplotlib.figure import Figure
from matplotlib.mathtext import MathTextParser

import gyrostat as gs
from gyrostat import plotting
from gyrostat.errors import ArgumentError

SCENE = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(FIELDS["3"]))


def compiled(captions, folder):
    """With pdflatex if it is there, else each formula by the parser of Matplotlib, and text without what
    LaTeX does not take.
    """
    if shutil.which("pdflatex"):
        figures = "".join(f"\\begin{{figure}}\\caption{{{text}}}\\end{{figure}}\\clearpage\n"
                          for text in captions)
        (folder / "paper.tex").write_text("\\documentclass{article}\\usepackage{amsmath}\\begin{document}\n"
                                          f"{figures}\\end{{document}}\n", encoding="utf-8")
        said = subprocess.run(["pdflatex", "-halt-on-error", "-interaction=nonstopmode", "paper.tex"],
                              cwd=folder, capture_output=True, text=True, check=False)
        assert said.returncode == 0, said.stdout[-2000:]
        return
    for text in captions:
        parts = text.split("$")
        assert len(parts) % 2 and not re.search(r"[#%&_^\\~]|[^ -~]", " ".join(parts[::2])), text
        for formula in parts[1::2]:
            MathTextParser("path").parse(f"${formula}$")


@pytest.mark.slow
def test_captions_are_latex(tmp_path):
    """Of each function of the gallery."""
    every = [*of_revolution(FIELDS["4"]), *of_three_moments(1), *without_a_field()]
    captions = [plotting.caption(ax) for ax in every]
    compiled(captions, tmp_path)
    assert len(captions) > 16 and all(text.endswith(".") for text in captions)
    for ax, text in zip(every, captions):
        for name in ax.get_legend().get_texts() if ax.get_legend() else ():
            assert f": {name.get_text()}" in text


@pytest.mark.slow
def test_a_caption_says_what_the_picture_shows():
    """U, every number, and the look of each verdict and mark, as the artists have it."""
    ax = plotting.draw_bifurcation_diagram(SCENE, "omega", (-5, 5), BODY, Figure().subplots())
    text = plotting.caption(ax)
    for part in (r"$U = k_3^{3} - \frac{k_3}{2}$", "$l = 3/2$", "$I_1 = 2$", "$I_3 = 1$", r"$\omega$",
                 "solid blue lines: stable", "dashed dark lines: unstable",
                 "filled circles: fold on a level"):
        assert part.lower() in text.lower(), part
    (mark,) = [line for line in ax.lines if line.get_marker() == "o"]
    assert not matplotlib.colors.same_color(mark.get_markerfacecolor(), "white")


@pytest.mark.slow
def test_a_caption_does_not_need_the_title():
    """A paper leaves the title out; a colour that is given is named."""
    ax = plotting.draw_bifurcation_diagram(SCENE, "omega", (-5, 5), BODY, Figure().subplots(), color="green")
    before = plotting.caption(ax)
    ax.set_title("")
    assert plotting.caption(ax) == before and "solid green lines: stable" in before.lower()


def test_other_axes_have_no_caption():
    """They are refused."""
    with pytest.raises(ArgumentError, match="no draw_ function has drawn on these axes"):
        plotting.caption(Figure().subplots())
