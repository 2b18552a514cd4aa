"""The page starts without the network, and keeps one version whole."""
import os
import shutil
from pathlib import Path

import pytest
from bench_page import profile, served
from browser.driving import SLOW, shown, typed
from build import listed

FOLDER = Path(os.environ["GYROSTAT_SITE"]) / "try"
CONTROLLED = """async () => {
    await navigator.serviceWorker.ready;
    return Boolean(navigator.serviceWorker.controller);
}"""
UPDATED = """async () => {
    const registration = await navigator.serviceWorker.ready;
    await registration.update().catch(() => {});
    const worker = registration.installing ?? registration.waiting;
    while (worker?.state === "installing") await new Promise((next) => setTimeout(next, 50));
    return worker?.state ?? "none";
}"""
KEYS = """async () => (await (await caches.open("gyrostat")).keys()).map(({ url }) => url)"""
OLD, NEW = "Try gyrostat", "Another version"


@pytest.fixture
def folder(tmp_path):
    """A copy of the page, of which a test may make another version."""
    shutil.copytree(FOLDER, tmp_path / "try")
    listed(tmp_path / "try")
    return tmp_path / "try"


@pytest.fixture
def visitor(playwright):
    """A browser that keeps what a page lets it keep."""
    with profile(playwright) as browser:
        browser.set_default_timeout(60_000)
        yield browser


def visited(visitor, address):
    """A page of its own, with its first verdict from the library."""
    page = visitor.new_page()
    page.goto(address)
    page.wait_for_selector("#starting", state="hidden")
    return page


def kept(visitor, address):
    """The first visit: it ends when the page is kept."""
    page = visited(visitor, address)
    page.wait_for_function(CONTROLLED)
    return page


def renewed(folder):
    """Another version of two files that need each other, in the place of the first one."""
    page = folder / "index.html"
    page.write_text(page.read_text(encoding="utf-8").replace(OLD, NEW), encoding="utf-8")
    script = folder / "app" / "main.js"
    script.write_text(script.read_text(encoding="utf-8") + "globalThis.renewed = true;\n", encoding="utf-8")
    listed(folder)


def version(page):
    """Its title, and whether its script is the new one too."""
    return page.title(), page.evaluate("Boolean(globalThis.renewed)")


def test_the_second_visit_needs_no_network(folder, visitor):
    """No server is there; a computation that was ended starts again; a folder and a query lead here."""
    with served(folder) as address:
        kept(visitor, address).close()
    for way in (address, address.replace("index.html", ""), f"{address}?from=mail"):
        visited(visitor, way).close()
    page = visited(visitor, address)
    assert shown(page) == ("Stable", "")
    page.click("#asked > summary")
    page.fill("#potential", SLOW)
    page.wait_for_function("() => document.getElementById('error').innerText.includes('longer than 10 s')")
    assert typed(page, "potential", "m0*k3") == ("Stable", "")
    page.goto(f"{address.replace('index.html', '')}licences/index.html")
    assert "free software" in page.inner_text("body")


def test_a_page_that_is_open_survives_the_loss_of_the_network_at_the_first_visit(folder, visitor):
    """Its worker comes from what is kept."""
    with served(folder) as address:
        page = kept(visitor, address)
    worker = next(worker for worker in page.workers if worker.url.endswith("/worker.js"))
    worker.evaluate("() => { self.onmessage = () => { throw new Error('out of memory'); }; }")
    page.click("#asked > summary")
    assert "out of memory" in typed(page, "value-l", "1/7")[1]
    assert typed(page, "value-l", "0") == ("Stable", "")


def test_a_new_version_is_taken_whole_at_the_next_visit(folder, visitor):
    """A page that is open stays with its own, and so does one that is opened beside it."""
    with served(folder) as address:
        page = kept(visitor, address)
        before = set(page.evaluate(KEYS))
        renewed(folder)
        assert page.evaluate(UPDATED) == "installed"
        beside = visited(visitor, address)
        assert version(page) == version(beside) == (OLD, False)
        page.reload()
        page.wait_for_selector("#starting", state="hidden")
        assert version(page) == (OLD, False)
        page.close()
        beside.goto("about:blank")
        beside.wait_for_timeout(1000)
        page = visited(visitor, address)
        assert version(page) == (NEW, True)
        page.wait_for_function("async (before) => !(await (await caches.open('gyrostat')).keys())"
                               ".some(({ url }) => url === before)", arg=only(before, "main.js"))
        after = set(page.evaluate(KEYS))
    assert len(after) == len(before)
    assert only(after, "packages.xz") == only(before, "packages.xz")


def only(keys, name):
    """The one address of a file in what is kept."""
    found, = (key for key in keys if key.partition("?")[0].endswith(f"/{name}"))
    return found


def test_a_version_that_does_not_come_whole_is_not_taken(folder, visitor):
    """The one before goes on."""
    with served(folder) as address:
        page = kept(visitor, address)
        renewed(folder)
        (folder / "app" / "main.js").unlink()
        assert page.evaluate(UPDATED) != "installed"
        page.close()
        page = visited(visitor, address)
        assert version(page) == (OLD, False)
        assert page.locator("#notice").is_hidden()
