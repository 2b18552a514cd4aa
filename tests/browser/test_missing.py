"""Whatever fails, a file, the network, a computation: the page says so in a sentence, and how to go on."""
import json
import os
import shutil
from pathlib import Path

import pytest
from browser.driving import SLOW, shown, typed
from page_starts import served

FOLDER = Path(os.environ["GYROSTAT_SITE"]) / "try"
FILES = ["files.json", *json.loads((FOLDER / "files.json").read_text(encoding="utf-8"))]
FONTS = [name for name in FILES if name.endswith(".woff2")]
# without these the page is as it is meant to be, but later, or with less beside it
NESTED = "app/unpacker.js"
SPARE = ("licences/", "prepared/", "pictures/", "sw.js", "index.html", NESTED)
FILES = [name for name in FILES if name not in FONTS and not name.startswith(SPARE)]
TOGETHER = 8                                           # pages that are open at once
OF_PYTHON = ("runtime/", "app/worker.js", "files.json")  # missed before Python runs
SAID = {"katex/katex.min.js": "katex.min.js could not be loaded", "try.css": "try.css could not be loaded",
        "katex/katex.min.css": "katex.min.css could not be loaded",
        "examples.json": "examples.json could not be loaded", "modes.css": "modes.css could not be loaded",
        "numerics/chart-worker.js": "The chart failed"}


def without(context, address, name, mode):
    """A page to which a file does not come, and which has not kept it."""
    page = context.browser.new_context(service_workers="block").new_page()
    if not name.startswith(OF_PYTHON):
        page.route("**/worker.js", lambda route: None)
    page.route(lambda url: url.partition("?")[0].endswith(f"/{name}"), lambda route: (
        route.abort("internetdisconnected") if mode == "lost" else route.fulfill(status=404, body="none")))
    page.goto(address)
    return page


def leads_on(page, said):
    """The sentence is there, and a way on with it."""
    line = page.locator("#unstarted, #notice").filter(has_text=said)
    line.wait_for()
    return "load the page again" in line.inner_text() or line.locator("button").count() > 0


@pytest.mark.parametrize("mode", ["404", "lost"])
def test_each_file_that_does_not_come_is_said(stranger, address, mode):
    """In turn: the page's own script, those of its threads, KaTeX, Python."""
    for first in range(0, len(FILES), TOGETHER):
        pages = {name: without(stranger, address, name, mode) for name in FILES[first:first + TOGETHER]}
        for name, page in pages.items():
            library = "The library could not be started" if name.startswith(OF_PYTHON) else ""
            assert leads_on(page, SAID.get(name, library or "This page has not started yet")), name
            page.context.close()


def test_a_thread_of_a_thread_that_does_not_come_is_said(stranger, tmp_path):
    """Its file is missing on the server, for what a thread asks for is not routed here."""
    shutil.copytree(FOLDER, tmp_path / "try")
    (tmp_path / "try" / NESTED).unlink()
    with served(tmp_path) as place:
        page = stranger.new_page()
        page.goto(place.replace("index.html", "try/index.html"))
        assert leads_on(page, "The library could not be started")


@pytest.mark.parametrize("name", FONTS)
@pytest.mark.few(1)
def test_a_font_that_does_not_come_is_said(stranger, address, name):
    """If a formula needs it."""
    for mode in ("404", "lost"):
        page = without(stranger, address, name, mode)
        page.evaluate("Promise.allSettled([...document.fonts].map((face) => face.load()))")
        assert leads_on(page, "A font could not be loaded")


def test_without_scripts_the_page_says_what_it_needs(stranger, address):
    """And nothing that is not true then."""
    page = stranger.browser.new_context(java_script_enabled=False).new_page()
    page.goto(address)
    assert "needs JavaScript" in page.locator("noscript").inner_text()
    assert page.is_hidden("#unstarted") and page.is_hidden("#starting")


def test_a_computation_that_fails_or_lasts_is_said_and_the_library_starts_again(stranger, address):
    """With the network, and without; in a browser without OffscreenCanvas."""
    page = stranger.new_page()
    page.add_init_script("delete window.OffscreenCanvas")
    page.clock.install()
    page.goto(address)
    page.wait_for_selector("#starting", state="hidden")
    page.wait_for_selector("#early", state="hidden")
    page.wait_for_timeout(1000)                            # all that was asked is answered
    page.wait_for_selector("#chart[aria-label*='The ring']")
    assert shown(page) == ("Stable", "")

    worker = next(worker for worker in page.workers if worker.url.endswith("/worker.js"))
    worker.evaluate("() => { self.onmessage = () => { throw new Error('out of memory'); }; }")
    verdict, wrong = typed(page, "value-l", "1/7")
    assert verdict == "verdict" and "out of memory" in wrong and "more simply" in wrong
    assert typed(page, "value-l", "0") == ("Stable", "")

    page.click("#asked > summary")
    ended(page)
    assert typed(page, "potential", "m0*k3") == ("Stable", "") and page.is_hidden("#notice")

    stranger.set_offline(True)
    outlast(page)                                          # what it says then gives way to the next sentence
    assert leads_on(page, "The library could not be started")
    assert "not running" in typed(page, "potential", "m0*k3")[1]
    stranger.set_offline(False)
    page.wait_for_selector("#notice", state="hidden")
    assert shown(page) == ("Stable", "")


def outlast(page):
    """Type a field whose conditions take longer than the page waits."""
    page.fill("#potential", SLOW)
    page.clock.fast_forward(1000)
    page.clock.fast_forward(11_000)


def ended(page):
    """That the computation was ended is said, and nothing else is shown."""
    outlast(page)
    verdict, refused = shown(page)
    assert verdict == "verdict" and "longer than 10 s" in refused and "your own machine" in refused
    assert page.inner_text("#no-chart") == "no chart: the scene has no answer"
    assert page.inner_text("#no-motion") == "no motion: the scene has no answer"
    assert page.is_hidden("#chart") and page.is_hidden("#motion") and page.inner_text("#conditions") == ""
