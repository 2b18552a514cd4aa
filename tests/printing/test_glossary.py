"""The glossary: every term once, in two sentences, on its page; reports end with the terms they use.

`python tests/printing/test_glossary.py` writes the page.
"""
import re
from pathlib import Path

import pytest
from commands import run

import gyrostat as gs
from gyrostat.printing.blocks import prose
from gyrostat.printing.formats.prose import words
from gyrostat.printing.formats.references import cited
from gyrostat.printing.glossary import WHERE, glossary, term_blocks

PAGE = Path(__file__).parents[2] / WHERE
LINE = 72                                              # characters of a meaning that stands in one line
TERMS = [term for terms in glossary().values() for term in terms]
TITLES = {"stability": "Stability, and what decides", "motion": "The body, its equilibria and their curves"}
TOP = """# Glossary

This page says what the words of reports, messages and pages mean. Each term has two sentences, its formula
and its source. Signs and symbols are in [conventions](../explanation/conventions.md), the names of
parameters in [names](names.md).
"""


# what stands in meanings, which reports print as text, and as a formula on the page
SYMBOLS = {"π = Iω": r"\pi = I\omega", "J₁, J₂": "J_1, J_2", "C₁": "C_1", "k₃": "k_3", "σ": r"\sigma",
           "ω": r"\omega", "τ": r"\tau", "ρ": r"\rho", "D4": "D_4", r"\bk\b": "k", r"\bF\b": "F"}


def anchor(name):
    """What stands after # in the address of a term, by the rule of the site."""
    return re.sub(r"[^\w -]", "", name.lower()).replace(" ", "-")


def part(term):
    """A term as a part of the page."""
    source = "A word of this library" if term.source == "own" else f"Source: {term.source}"
    name = term.name[0].upper() + term.name[1:] if term.name.isascii() else term.name
    meaning = re.sub("|".join(SYMBOLS), lambda found: f"${SYMBOLS.get(found[0], found[0])}$", term.meaning)
    return (f"### {name}\n\n{meaning} {' '.join(term.more.split())}\n\n"
            f"$$\n{term.formula}\n$$\n\n{' '.join(source.split())}.\n")


def page():
    """The glossary page, in Markdown."""
    names = sorted((term.name for term in TERMS), key=str.lower)
    links = " ·\n".join(f"[{name}](#{anchor(name)})" for name in names)
    works = "\n".join(f"- {work}" for work in cited([" ".join(term.source.split()) for term in TERMS]))
    parts = [f"## {TITLES[key]}\n\n" + "\n".join(map(part, terms)) for key, terms in glossary().items()]
    return "\n".join((TOP, f"{links}\n", *parts, f"## Sources\n\n{works}\n"))


def listed(text):
    """The terms at the end of a text, with their meanings."""
    block = text.partition("\n  Terms\n")[2].partition("\n  The glossary")[0]
    return dict(re.split(r" {3,}", line.strip()) for line in block.splitlines())


def test_the_page_is_that_of_the_table():
    """One home: the page is written from the table."""
    assert PAGE.read_text(encoding="utf-8") == page(), f"python {Path(__file__).name} writes {WHERE}"


@pytest.mark.parametrize("term", TERMS, ids=lambda term: anchor(term.name))
def test_a_term_has_two_sentences_a_formula_and_a_source(term):
    """The first fits a line of a report; both end with a full stop; LaTeX of the page can be in prose."""
    assert term.meaning.endswith(".") and len(term.meaning) <= LINE and "$" not in term.meaning
    assert term.more.endswith(".") and term.more.count("$") % 2 == 0
    assert term.formula and term.source and term.formula.count("{") == term.formula.count("}")
    assert words(term.meaning).isascii()
    assert [anchor(t.name) for t in TERMS].count(anchor(term.name)) == 1


def test_the_page_has_an_anchor_for_each_term():
    """Each link at its top leads to a heading, by the rule of the site."""
    text = PAGE.read_text(encoding="utf-8")
    headings = set(map(anchor, re.findall("^### (.*)$", text, re.MULTILINE)))
    assert set(re.findall(r"\]\(#(.*?)\)", text)) == headings and len(headings) == len(TERMS)


@pytest.mark.parametrize(("said", "term"), [
    ("Lyapunov stable modulo the flow of π₃", "modulo the flow of F"),
    ("Necessary (spectral):", "spectral stability"),
    ("in a field there are windows", "window"), ("2 growing modes", "growing mode"),
    ("D4 = 1/2", "Arnold's determinant D4"), ("the second variation is definite", "second variation")])
def test_a_term_is_listed_where_it_is_used(said, term):
    """By its words, and not by parts of other words."""
    (rows, where) = term_blocks([prose(said)])
    assert ((term,),) in [row[:1] for row in rows.rows] and WHERE in where.parts[0]
    assert term_blocks([prose("An informal level playing field, aspectral.")]) == []


@pytest.mark.parametrize(("verb", "has", "has_not"), [
    ("report", {"spectral stability", "formal stability", "secular stability", "symplectic slice"},
     {"window"}),
    ("conditions", {"modulo the flow of F", "internal damping"}, {"spectral stability", "symplectic slice"})])
def test_what_is_printed_ends_with_its_terms(capsys, verb, has, has_not):
    """Those that occur, in one line each, with the meanings of the table."""
    _, out, _ = run(capsys, "--equilibrium", "E3", "--potential", "m0*k3", verb=verb)
    found = listed(out)
    assert has <= found.keys() and not has_not & found.keys()
    meanings = {term.name: term.meaning for term in TERMS}
    assert all(found[name] == meanings[name] for name in found)
    assert out.rstrip().endswith(f"{WHERE}.")


def test_details_of_decide_end_with_their_terms(capsys):
    """With --full; the table explains its own words."""
    asked = ["--potential", "m0*k3", "--set", "I1=2", "I3=1", "l=1", "m0=1/2", "omega=1"]
    _, out, _ = run(capsys, *asked, "--full", verb="decide")
    assert {"Lyapunov stability", "second variation", "internal damping"} <= listed(out).keys()
    _, out, _ = run(capsys, *asked, verb="decide")
    assert listed(out) == {}


def test_latex_has_the_terms_too():
    """As a table with a caption."""
    document = gs.to_latex([gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())))])
    assert r"\caption{Terms}" in document and "spectral stability & No eigenvalue" in document


if __name__ == "__main__":
    PAGE.write_text(page(), encoding="utf-8")
