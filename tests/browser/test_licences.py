"""The licences of what the page ships, shipped with it."""
import json
import lzma
import os
import tomllib
from pathlib import Path

import licences

FOLDER = Path(os.environ["GYROSTAT_SITE"]) / "try"
SAYS = {"lgpl-3.0.txt": "GNU LESSER GENERAL PUBLIC LICENSE", "gpl-3.0.txt": "GNU GENERAL PUBLIC LICENSE",
        "mpl-2.0.txt": "Mozilla Public License", "python.txt": "PYTHON SOFTWARE FOUNDATION LICENSE",
        "sympy.txt": "SymPy Development Team", "mpmath.txt": "mpmath contributors",
        "katex.txt": "Khan Academy", "ofl-1.1.txt": "SIL OPEN FONT LICENSE", "gyrostat.txt": "MIT License",
        "python-flint.txt": "Fredrik Johansson", "xz-decompress.txt": "xz-embedded",
        "interpreter.txt": "musl"}


def test_a_link_leads_to_the_licence_of_everything(page, context, address):
    """Each text in full, and the version that is shipped."""
    page.locator("footer a").scroll_into_view_if_needed()
    table = context.new_page()
    table.goto(page.locator("footer a").evaluate("link => link.href"))
    text = table.inner_text("table")
    sources = tomllib.loads((licences.HERE.parent / "sources.toml").read_text(encoding="utf-8"))
    for part in licences.parts():
        assert part["name"] in text and licences.version(part, sources) in text
    links = table.eval_on_selector_all("td a", "all => all.map(link => link.getAttribute('href'))")
    assert {link for link in links if not link.startswith("https:")} >= SAYS.keys()
    for name, said in SAYS.items():
        assert said in (FOLDER / "licences" / name).read_text(encoding="utf-8")
    assert "leaves exports out" in table.inner_text("body")
    table.close()


def test_each_library_of_the_archive_is_a_part():
    """The table names the version of each as its wheel has it."""
    stream = lzma.decompress((FOLDER / "runtime" / "flint.xz").read_bytes())
    length = 4 + int.from_bytes(stream[:4], "little")
    shipped = {Path(name).name for name, _ in json.loads(stream[4:length])
               if name.startswith("python_flint.libs/")}
    assert shipped == {part["library"] for part in licences.parts() if "library" in part}
