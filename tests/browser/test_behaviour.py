"""How the page behaves: hostile texts, no other host, keyboard, narrow screens."""
import os
from pathlib import Path
from urllib.parse import quote

import pytest
from browser.driving import picked, shown, typed
from fuzz_texts import drawn

WORST = ["(" * 2500, "k3^" * 1600 + "2", "9" * 4900, "2^(2^(2^(2^k3)))", "k3**10**10**10",
         "sqrt(" * 900 + "k3", "</textarea><script>alert(1)</script>", "\\href{javascript:alert(1)}{k3}",
         "k3\u202e\u0000", "𝛼*k3", "∫k3", "__import__('js').fetch('/')", "'; DROP TABLE k3; --", "k3;k3",
         ",,,", " "]
TEXTS = [*WORST, *(drawn(index, "browser")[0] for index in range(40 - len(WORST)))]
FIELDS = ("potential", "orbit", "gyrostatic_momentum", "made", "value-I1")
KEYS = ("potential", "orbit", "inertia", "gyrostatic_momentum", "equilibrium", "direction", "pointing",
        "spin", "set")


def test_hostile_texts_are_refused_and_the_page_goes_on(page, context):
    """In field, orbit, body, point, number: a sentence or an answer, and no error of the page."""
    errors = len(context.errors)
    for number, field in enumerate(FIELDS):
        page.check(f"input[value={'point' if field == 'made' else 'E1'}]")
        shown(page)
        before = page.input_value(f"#{field}")
        for text in TEXTS[number::len(FIELDS)]:
            assert "internal error" not in typed(page, field, text)[1], text
        assert typed(page, field, before) == ("Stable", "")
    assert shown(page) == ("Stable", "") and context.errors[errors:] == []


def test_hostile_links_go_through_the_same_gate(page, context):
    """Refused as if they were typed; nothing of them becomes a part of the page."""
    errors = len(context.errors)
    for text in TEXTS:
        _followed(page, text)
        assert "internal error" not in shown(page)[1], text
    assert page.evaluate("document.scripts.length") == 2 and context.errors[errors:] == []
    assert picked(page, 1)[1] == ""


def _followed(page, text):
    """The text as every part of a link."""
    page.evaluate("""hash => new Promise(done => {
        addEventListener("hashchange", () => done(), { once: true });
        location.hash = hash;
    })""", "&".join(f"{name}={quote(text, errors='surrogatepass')}" for name in KEYS))


def test_a_link_has_the_newest_numbers_however_fast_they_change(page):
    """Where a browser takes 100 addresses and then refuses: address and copied link have the last."""
    page.evaluate("""() => {
        let taken = 0;
        history.replaceState = function (...given) {
            if (++taken > 100) throw new Error("too many addresses");
            History.prototype.replaceState.apply(this, given);
        };
        const text = document.getElementById("value-I3");
        for (let n = 1; n <= 300; n++) {
            text.value = String(1 + n / 1000);
            text.dispatchEvent(new Event("input"));
        }
    }""")
    assert shown(page) == ("Unstable", "")
    page.click("[data-copy=link]")
    assert "set=I3%3D1.3&" in page.input_value("#copied")
    page.wait_for_url(page.input_value("#copied"))
    page.evaluate("delete history.replaceState")


def test_nothing_is_asked_of_another_host(started, context, address):
    """All that page and thread load comes from where it is served; the browser knows no other host."""
    host = address.removesuffix("try/index.html")
    asked = {url.split("?")[0] for url in context.asked if not url.startswith(("data:", "blob:"))}
    assert {f"{host}try/{name}" for name in ("app/worker.js", "runtime/pyodide.mjs", "files.json")} <= asked
    assert all(url.startswith(host) for url in asked), asked


def test_everything_has_a_name_and_is_reached_by_keys(page):
    """Every control has a label; Tab reaches each from the first to the last."""
    named = page.eval_on_selector_all("input, select, button, textarea", """all => all.map(one =>
        one.ariaLabel || [...one.labels].map(label => label.textContent).join("") || one.textContent)""")
    assert len(named) > 15 and all(name.strip() for name in named), named
    page.focus("#example")
    reached = set()
    for _ in range(40):
        reached.add(page.evaluate("document.activeElement.id || document.activeElement.textContent"))
        page.keyboard.press("Tab")
    assert {"potential", "inertia", "gyrostatic_momentum", "spin", "value-I1", "LaTeX"} <= reached


@pytest.mark.parametrize("theme", ["light", "dark"])
@pytest.mark.parametrize("width", [360, 800, 1440])
def test_no_page_is_wider_than_its_screen(page, width, theme):
    """Formulas that are too wide scroll by themselves; GYROSTAT_SHOTS has the pictures."""
    page.set_viewport_size({"width": width, "height": 900})
    page.emulate_media(color_scheme=theme)
    for number in (0, 2, 7, 10):
        picked(page, number)
        assert page.evaluate("document.documentElement.scrollWidth") <= width
        if "GYROSTAT_SHOTS" in os.environ:
            page.screenshot(path=Path(os.environ["GYROSTAT_SHOTS"]) / f"{width}-{theme}-{number}.png",
                            full_page=True)
    assert page.evaluate("getComputedStyle(document.body).backgroundColor") == (
        "rgb(20, 24, 30)" if theme == "dark" else "rgb(255, 255, 255)")
