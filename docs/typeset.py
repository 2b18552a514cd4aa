"""Typeset the formulas in the prose of docstrings on the site; a terminal shows them in Unicode."""
from collections.abc import Iterator

from docutils import nodes
from formulas import formulas
from sphinx import addnodes
from sphinx.application import Sphinx

AS_WRITTEN = (nodes.literal, nodes.literal_block, nodes.doctest_block, nodes.math, nodes.math_block,
              nodes.raw, nodes.title, nodes.term, nodes.classifier, nodes.strong, nodes.reference,
              addnodes.desc_signature, addnodes.pending_xref)


def typeset(app: Sphinx, doctree: nodes.document) -> None:
    """Replace what is a formula in the pages that are made from docstrings."""
    if not app.env.docname.startswith("reference/api"):
        return
    for text in [*doctree.findall(nodes.Text)]:
        if any(isinstance(above, AS_WRITTEN) for above in above_of(text)):
            continue
        parts, place = [], 0
        for begin, end, latex in formulas(text.astext()):
            parts += [nodes.Text(text.astext()[place:begin]), nodes.math(latex, latex)]
            place = end
        if parts:
            text.parent.replace(text, [*parts, nodes.Text(text.astext()[place:])])


def above_of(node: nodes.Node) -> Iterator[nodes.Node]:
    """The nodes that contain one, from the inside."""
    while node := node.parent:
        yield node


def setup(app: Sphinx) -> None:
    """Called when the pages are read."""
    app.connect("doctree-read", typeset)
