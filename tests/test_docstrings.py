"""Sentences of docstrings that begin with a symbol."""
import ast
import re
from pathlib import Path

import pytest
from test_layout import parsed, statements

SOURCE = Path(__file__).parents[1] / "src" / "gyrostat"
# a capital, other than that of a sum, that begins a paragraph below the first, and what comes after it
FIRST = re.compile(r"(?<=\n\n)([A-ZΑ-ΡΤ-Ω]̇?)(?![\w)])(.*)")
SECTION = re.compile(r"\n(?:Parameters|Returns|Raises|Notes|References|Examples)\n-+\n")


def misspelt(docstring):
    """Paragraphs that begin with a capital letter for a symbol that is a small letter."""
    text = SECTION.split(docstring)[0]
    for place in FIRST.finditer(text):
        letter, rest = place.groups()
        elsewhere = text[:place.start()] + rest
        article = letter == "A" and re.match(r" [`a-z]{2}", rest)
        formula = " = " in rest and not re.search("[a-z]{2}", rest.partition(" = ")[0])
        if not (article or formula or re.search(rf"(?<!\w){letter}(?!\w)", elsewhere)):
            yield place[0]


@pytest.mark.few(4)
@pytest.mark.parametrize("package", sorted(path.name for path in SOURCE.iterdir() if path.suffix != ".typed"))
def test_a_symbol_keeps_its_case_where_a_sentence_begins(package):
    """ω and Ω, k and K, h and H are different things."""
    folder = SOURCE / package
    for path in folder.rglob("*.py") if folder.is_dir() else [folder]:
        tree = parsed(path)
        for node in (tree, *(statement for statement, _ in statements(tree.body))):
            if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef):
                wrong = list(misspelt(ast.get_docstring(node) or ""))
                assert not wrong, (path.name, getattr(node, "name", ""))
