"""The site: sphinx-build -W -b html docs build/site, with the extra docs."""
import json
import re
import sys
from pathlib import Path
from shutil import copy, copytree, ignore_patterns

from sphinx.application import Sphinx

import gyrostat as gs

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE))                          # command_line and typeset

project = "gyrostat"
author = "The gyrostat developers"
version = release = gs.__version__

extensions = [
    "command_line",
    "myst_nb",
    "numpydoc",
    "sphinx.ext.autodoc",
    "sphinx.ext.autosummary",
    "sphinx.ext.mathjax",
    "sphinx-mathjax-offline",
    "sphinx_copybutton",
    "sphinx_design",
    "typeset",
]
nitpicky = True
smartquotes = False                                    # U'' and --set are written so
templates_path = ["_templates"]

autosummary_filename_map = {                           # spectrum and Spectrum are one file on some disks
    f"gyrostat.{name}": f"gyrostat.{name}-class" for name in gs.__all__
    if name != name.lower() and name.lower() in gs.__all__}
autodoc_member_order = "bysource"
autodoc_typehints = "none"                             # the types are in the docstrings
numpydoc_show_class_members = False                    # autodoc shows them

nb_execution_mode = "off"                              # their outputs are stored; CI runs them
nb_render_markdown_format = "myst"                     # sentences that code writes have formulas too
myst_enable_extensions = ["amsmath", "colon_fence", "dollarmath", "html_image"]
myst_dmath_double_inline = True                        # $$ within a paragraph, as notebooks have it
myst_heading_anchors = 4
mathjax3_config = {"chtml": {"scale": 0.9}}           # else they look larger than the text

html_theme = "pydata_sphinx_theme"
html_title = f"gyrostat {release}"
html_favicon = "_static/favicon.svg"
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_js_files = [("site.js", {"defer": "defer"})]
html_copy_source = False
html_sidebars = {"install": [], "faq": [], "gallery/index": []}       # no pages below these
html_theme_options = {
    "header_links_before_dropdown": 6,
    "show_toc_level": 2,
    "footer_start": ["copyright"],
    "footer_end": [],
}
copybutton_prompt_text = r">>> |\.\.\. |\$ "
copybutton_prompt_is_regexp = True


def pages_from_elsewhere() -> None:
    """The notebooks and what the benchmarks measured are pages too, with links that hold in the site."""
    for pattern, folder in (("notebooks/*.ipynb", "notebooks"), ("benchmarks/*.md", "measured"),
                            ("benchmarks/*.png", "measured")):
        (HERE / folder).mkdir(exist_ok=True)
        for file in HERE.parent.glob(pattern):
            page = HERE / folder / file.name
            content = file.read_bytes().replace(b"](../docs/", b"](../")
            content = content.replace(b"](../benchmarks/", b"](../measured/")
            if folder == "notebooks":
                content = with_download(content, file.name)
            if not page.exists() or page.read_bytes() != content:      # what is unchanged is not built again
                page.write_bytes(content)


def with_download(content: bytes, name: str) -> bytes:
    """Return a notebook as a page: below its first cell a link downloads the file."""
    notebook = json.loads(content)
    link = f'<a href="{name}" download>Download this notebook</a> (.ipynb) to run it with other numbers.'
    notebook["cells"].insert(1, {"cell_type": "markdown", "id": "download", "metadata": {}, "source": [link]})
    return json.dumps(notebook).encode()


def notebooks_beside_their_pages(app: Sphinx, error: Exception | None) -> None:
    """Copy each notebook as it is in the source, without the link."""
    if error is None:
        for file in HERE.parent.glob("notebooks/*.ipynb"):
            copy(file, Path(app.outdir) / "notebooks")


def schemas_beside_their_page(app: Sphinx, error: Exception | None) -> None:
    """A schema has an address that stays."""
    if error is None:
        copytree(HERE / "reference" / "schema", Path(app.outdir) / "reference" / "schema", dirs_exist_ok=True)


def page_to_try(app: Sphinx, error: Exception | None) -> None:
    """The page that runs the library in a browser; what it loads is added by docs/try/build.py."""
    if error is None:
        copytree(HERE / "try", Path(app.outdir) / "try", dirs_exist_ok=True,
                 ignore=ignore_patterns("*.py", "*.mjs", "*.toml", "__pycache__"))


def links_to_pages(app: Sphinx, what: str, name: str, value: object, options: object,
                   lines: list[str]) -> None:
    """A page that a docstring names by its file is a link on the site."""
    lines[:] = [re.sub(r"docs/([\w/-]+)\.md", r":doc:`/\1`", line) for line in lines]


def setup(app: Sphinx) -> None:
    """What is done before and after the build."""
    pages_from_elsewhere()
    app.connect("autodoc-process-docstring", links_to_pages)
    app.connect("build-finished", notebooks_beside_their_pages)
    app.connect("build-finished", schemas_beside_their_page)
    app.connect("build-finished", page_to_try)
