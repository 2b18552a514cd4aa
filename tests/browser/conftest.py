"""The site, and the page that runs the library, in headless Chromium.

Collected if GYROSTAT_SITE names the folder in which .ci/site built the site; the page is its folder try.
"""
import os
from pathlib import Path

SITE = os.environ.get("GYROSTAT_SITE")
if not SITE:
    collect_ignore_glob = ["*"]
else:
    import build
    import pytest
    from bench_page import CHROMIUM, NO_OTHER_HOST, profile, served
    from playwright.sync_api import sync_playwright

    @pytest.fixture(scope="session")
    def site(tmp_path_factory):
        """The site as it was built, and beside it the sources of the page, for tests of one script."""
        folder = tmp_path_factory.mktemp("site")
        for path in Path(SITE).resolve().iterdir():
            (folder / path.name).symlink_to(path)
        (folder / "sources").symlink_to(Path(build.__file__).resolve().parent)
        with served(folder) as place:
            yield place.removesuffix("/index.html")

    @pytest.fixture(scope="session")
    def address(site):
        return f"{site}/try/index.html"

    @pytest.fixture(scope="session")
    def playwright():
        with sync_playwright() as found:
            yield found

    OPTIONS = {"executable_path": CHROMIUM, "args": ["--no-sandbox", NO_OTHER_HOST]}

    @pytest.fixture(scope="module")
    def browser(playwright):
        """For pages of the site: nothing of it is asked for by the page that runs the library."""
        with playwright.chromium.launch(**OPTIONS) as browser:
            yield browser

    @pytest.fixture
    def stranger(playwright):
        """A browser of its own, which keeps nothing and whose network may be lost."""
        with playwright.chromium.launch(**OPTIONS) as browser:
            yield browser.new_context(service_workers="block")

    @pytest.fixture(scope="session")
    def context(playwright):
        """A browser, with the addresses that it asked for and the errors of its pages."""
        with profile(playwright) as browser:
            browser.asked, browser.errors = [], []
            browser.set_default_timeout(60_000)
            browser.on("request", lambda request: browser.asked.append(request.url))
            browser.on("weberror", lambda error: browser.errors.append(str(error.error)))
            browser.on("console", lambda message: browser.errors.append(message.text)
                       if message.type == "error" else None)
            yield browser

    @pytest.fixture(scope="session")
    def started(context, address):
        """The page with its first verdict."""
        page = context.new_page()
        page.goto(address)
        page.wait_for_selector("#starting", state="hidden")
        page.wait_for_selector("#early", state="hidden")
        page.wait_for_selector("body[aria-busy=false]:has(#early[hidden]) .badge")
        page.click("#asked > summary")                 # the form is folded
        return page

    @pytest.fixture
    def page(started):
        """The page with the first example."""
        started.set_viewport_size({"width": 1280, "height": 900})
        # whatever another test has left
        started.emulate_media(color_scheme="light", reduced_motion="no-preference")
        started.select_option("#example", "1")
        started.select_option("#example", "0")
        started.wait_for_selector("body[aria-busy=false]:has(#early[hidden])")
        return started
