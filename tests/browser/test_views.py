"""What is seen of the page: by everybody, at every width, without one part over another."""
import pytest
from axe_playwright_python.sync_playwright import Axe
from browser.driving import picked, shown, typed

WIDTHS = (390, 768, 1280, 1920)
EVERY, OPEN = 8, 7                                     # of examples.json: a list; gyroscopic stabilization
DRAWN = "() => !document.querySelector('[aria-busy=true]')"
# pairs of things of which one lies over the other by more than a pixel, and neither holds the other
OVERLAPPING = """() => {
    const all = [...document.querySelectorAll("h1, h2, h3, canvas, button, select, input, textarea, summary, \
        main section, .badge, table")].filter((one) => one.checkVisibility({ visibilityProperty: true })
            && one.getBoundingClientRect().width);
    const name = (one) => one.id || one.textContent.trim().slice(0, 20) || one.tagName;
    const boxes = all.map((one) => one.getBoundingClientRect()), found = [];
    for (let i = 0; i < all.length; i++) {
        for (let j = i + 1; j < all.length; j++) {
            if (all[i].contains(all[j]) || all[j].contains(all[i])) continue;
            const [a, b] = [boxes[i], boxes[j]];
            const wide = Math.min(a.right, b.right) - Math.max(a.left, b.left);
            const high = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
            if (wide > 1 && high > 1) found.push(`${name(all[i])} / ${name(all[j])}`);
        }
    }
    return found;
}"""
# what begins within its section and ends outside of it
OUTSIDE = """() => [...document.querySelectorAll("main section *")].filter((one) => {
    if (!one.checkVisibility() || one.closest(".katex, details:not([open])")) return false;
    const place = one.getBoundingClientRect(), card = one.closest("section").getBoundingClientRect();
    return place.width && (place.right > card.right + 1 || place.left < card.left - 1)
        && !one.closest(".display, .reasons, textarea");
}).map((one) => one.id || one.className || one.textContent.slice(0, 20))"""
SEEN = """(places) => Object.fromEntries(places.map((place) => {
    const { top, bottom } = document.querySelector(place).getBoundingClientRect();
    return [place, [Math.round(top), Math.round(bottom)]];
}))"""


def drawn(page):
    """The page when everything has come, and what was pale is no longer so."""
    shown(page)
    page.wait_for_function(DRAWN)
    page.wait_for_timeout(500)


def first(page):
    """The first example."""


def refused(page):
    """A field that is none."""
    assert typed(page, "potential", "m0*")[1]


def derivation(page):
    """The form and the whole derivation, open."""
    page.evaluate("document.getElementById('derivation').open = true")
    page.wait_for_selector("#blocks table")


def between(page):
    """What lies between the conditions."""
    picked(page, OPEN)
    page.evaluate("document.getElementById('opened').open = true")
    page.wait_for_selector("#between .katex")


def every(page):
    """A list of equilibria."""
    picked(page, EVERY)


VIEWS = {
    "light": (first, 1280, "light"), "dark": (first, 1280, "dark"), "phone": (first, 390, "light"),
    "dark phone": (first, 390, "dark"), "every equilibrium": (every, 1280, "light"),
    "refused": (refused, 390, "dark"),
    "derivation": (derivation, 1280, "dark"), "between": (between, 768, "light"),
    "lecture": ("lecture", 1280, "dark"),
    "embed": ("embed", 768, "light")}


@pytest.fixture
def opened(page):
    """The page with its form open, as it is found and left."""
    page.evaluate("document.getElementById('asked').open = true")
    yield page
    page.evaluate("for (const id of ['derivation', 'opened']) document.getElementById(id).open = false")
    page.set_viewport_size({"width": 1280, "height": 900})
    typed(page, "potential", "m0*k3")


@pytest.mark.parametrize("name", VIEWS)
def test_everybody_can_use_each_view(opened, context, address, name):
    """axe-core finds nothing in ten views."""
    what, width, scheme = VIEWS[name]
    page = opened if callable(what) else context.new_page()
    page.set_viewport_size({"width": width, "height": 844})
    page.emulate_media(color_scheme=scheme)
    if callable(what):
        what(page)
    else:
        page.goto(f"{address}#potential=m0*k3&show={what}")
        page.wait_for_selector("body[aria-busy=false]:has(#early[hidden]) .badge")
    drawn(page)
    page.wait_for_timeout(500)                             # what was pale takes a quarter to be dark
    said = [f"{each['help']}: {node['html'][:200]}" for each in Axe().run(page).response["violations"]
            for node in each["nodes"]]
    if page is not opened:
        page.close()
    assert not said, "\n".join(said)


@pytest.mark.parametrize("width", WIDTHS)
def test_nothing_is_wider_than_the_screen_or_over_another(page, width):
    """Of each kind of scene, with the form folded and open."""
    page.set_viewport_size({"width": width, "height": 900})
    for number in (0, 2, OPEN, EVERY, 10):
        picked(page, number)
        for folded in (True, False):
            page.evaluate("folded => { document.getElementById('asked').open = !folded; }", folded)
            drawn(page)
            assert page.evaluate("document.documentElement.scrollWidth") <= width
            assert not (found := page.evaluate(OVERLAPPING)), (number, found)
            assert not (found := page.evaluate(OUTSIDE)), (number, found)


def test_what_moves_with_a_slider_is_in_sight_with_it(page):
    """On a desk of 1280 by 800 verdict, chart, body and the sliders; on a phone verdict and body."""
    for width, height, places in ((1280, 800, [".badge", "#chart", "#motion", "#values .value:nth-child(2)"]),
                                  (390, 844, [".badge", "#motion"])):
        page.set_viewport_size({"width": width, "height": height})
        page.evaluate("document.getElementById('asked').open = false")
        drawn(page)
        page.evaluate("scrollTo(0, 0)")
        places = page.evaluate(SEEN, places)
        assert all(0 <= top < bottom <= height for top, bottom in places.values()), (width, places)


@pytest.mark.parametrize("width", [390, 1280])
def test_verdict_and_numbers_come_before_chart_and_body(page, width):
    """In the order of the document, and so in that of Tab."""
    page.set_viewport_size({"width": width, "height": 844})
    page.focus("#example")
    reached = []
    for _ in range(60):
        page.keyboard.press("Tab")
        reached.append(page.evaluate("document.activeElement.id || document.activeElement.textContent"))
    order = [reached.index(name) for name in ("value-I1", "value-omega3_0", "chart", "motion", "LaTeX")]
    assert order == sorted(order), reached
    assert page.evaluate("""() => Boolean(document.getElementById("verdict").compareDocumentPosition(
        document.getElementById("values")) & Node.DOCUMENT_POSITION_FOLLOWING)""")
