"""The pages of the site: what is seen of them, by whom, how much is sent, and what the search finds."""
import os
from collections import Counter
from pathlib import Path
from urllib.parse import urlsplit

import pytest
from axe_playwright_python.sync_playwright import Axe
from bench_page import compressed
from browser.boxes import measured, opened

SITE = Path(os.environ["GYROSTAT_SITE"])
PAGES = sorted(str(path.relative_to(SITE)) for path in SITE.rglob("*.html")
               if path.relative_to(SITE).parts[0] not in ("try", "_static"))
HELD = ("index.html", "install.html", "tutorials/first-verdict.html", "how-to/satellites.html", "faq.html",
       "explanation/stability.html", "reference/command-line.html", "gallery/index.html",
       "reference/api/names/gyrostat.analyze.html", "search.html?q=top", "try/index.html")
FOUND = {"reaction wheel": "how-to/data-sheet.html", "gravity gradient": "how-to/satellites.html",
         "Excel": "how-to/tables.html", "MATLAB": "how-to/tables.html", "install": "install.html",
         "exercise": "tutorials/first-verdict.html", "Lagrange top": "tutorials/first-verdict.html"}
# what may be wider than its place: at 1280 pixels how many, at 390 how many of a hundred; these only fall
WIDE = {(1280, "code"): 0, (1280, "formula"): 0, (1280, "table"): 0, (1280, "page"): 0,
        (390, "code"): 5, (390, "formula"): 5, (390, "table"): 5, (390, "page"): 0}


@pytest.fixture(scope="module")
def boxes(site, browser):
    """(width, kind) -> (page, whether it is too wide, text) of everything on the site that has a width.

    Each page is opened as on a telephone, and then widened.
    """
    found, tab = {case: [] for case in WIDE}, browser.new_page()
    for name in PAGES:
        opened(tab, f"{site}/{name}", 390)
        for width in (390, 1280):
            tab.set_viewport_size({"width": width, "height": 900})
            for kind, wide, text in measured(tab):
                if kind != "table" or not name.startswith("measured/"):  # records scroll in themselves
                    found[width, kind].append((name, wide, text))
    tab.close()
    return found


@pytest.mark.parametrize("case", WIDE)
def test_what_is_shown_fits_its_place(boxes, case):
    """Code and outputs, formulas, tables and whole pages on a desk and on a telephone."""
    wide = [f"{name}: {max(text.splitlines() or [''], key=len)}" for name, wide, text in boxes[case] if wide]
    assert len(boxes[case]) > 50
    most = WIDE[case] if case[0] == 1280 else WIDE[case] / 100 * len(boxes[case])
    assert len(wide) <= most, "\n".join([f"{len(wide)} of {len(boxes[case])}:", *wide])


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_pages_can_be_used_by_everybody(site, browser, scheme):
    """axe-core finds nothing."""
    tab, said = browser.new_page(color_scheme=scheme), []
    tab.set_default_timeout(60_000)
    for name in HELD:
        opened(tab, f"{site}/{name}", 1280)
        tab.wait_for_load_state("networkidle")
        if name.startswith("try/"):
            tab.wait_for_selector("body:not(:has([aria-busy=true])):has(.badge) #state:not(:empty)")
            tab.wait_for_timeout(500)                      # what was pale takes a quarter to be dark
        said += [f"{name}: {each['help']}: {node['html'][:200]}"
                 for each in Axe().run(tab).response["violations"] for node in each["nodes"]]
    tab.close()
    assert not said, "\n".join(said)


def test_the_home_page_is_small(site, browser):
    """With everything that it loads it is at most a megabyte as a server sends it that compresses."""
    asked, tab = set(), browser.new_page()
    tab.on("request", lambda request: asked.add(urlsplit(request.url).path.lstrip("/")))
    opened(tab, f"{site}/index.html", 1280)
    tab.evaluate("scrollTo(0, document.body.scrollHeight)")
    tab.wait_for_load_state("networkidle")
    tab.close()
    sizes = Counter({name: compressed(SITE / name) for name in asked})
    assert {"index.html", "searchindex.js", "_static/site.css"} <= asked
    assert sum(sizes.values()) <= 1_000_000, sizes.most_common(5)


def test_each_notebook_can_be_downloaded(site, browser):
    """As it stands in the source, by a link on its page."""
    tab = browser.new_page()
    for notebook in sorted((Path(__file__).parents[2] / "notebooks").glob("*.ipynb")):
        tab.goto(f"{site}/notebooks/{notebook.stem}.html")
        with tab.expect_download() as download:
            tab.click("text=Download this notebook")
        assert Path(download.value.path()).read_bytes() == notebook.read_bytes()
    tab.close()


@pytest.mark.parametrize("words", FOUND)
def test_the_search_finds_the_page_on(site, browser, words):
    """Among its first six."""
    tab = browser.new_page()
    tab.goto(f"{site}/search.html?q={words.replace(' ', '+')}")
    tab.wait_for_function("document.querySelector('.search-summary')?.textContent.includes('matching')")
    found = tab.eval_on_selector_all("ul.search li > a", "all => all.map(link => link.getAttribute('href'))")
    tab.close()
    assert FOUND[words] in [urlsplit(address).path for address in found[:6]]
