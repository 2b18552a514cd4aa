"""The page in Firefox: it starts, answers, draws, and is used by mouse, finger and keys."""
import os

import pytest
from bench_page import served
from browser.firefox import firefox

SITE = os.environ["GYROSTAT_SITE"]
WIDTHS = (390, 768, 1280, 1920)
QUIET = "document.body.ariaBusy === 'false' && document.querySelector('.badge')"
WORD = "document.querySelector('.badge').textContent.trim().split(' ').at(-1)"
# the share of the pixels of a canvas that have each colour, of those that many have
COLOURS = """((canvas) => {
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    const count = new Map();
    for (let n = 0; n < data.length; n += 4) {
        const colour = `${[...data.slice(n, n + 3)]}/${data[n + 3]}`;
        count.set(colour, (count.get(colour) ?? 0) + 4 / data.length);
    }
    return Object.fromEntries([...count].filter(([, share]) => share > 0.001));
})(document.getElementById(%r))"""
SWATCH = """Object.fromEntries([...document.querySelectorAll(".key span")].map((span) =>
    [span.className, getComputedStyle(span).backgroundColor.match(/\\d+/g).slice(0, 3).join()]))"""


@pytest.fixture(scope="module")
def started(address):
    """Firefox with the page and its first verdict."""
    with firefox(**{"ui.systemUsesDarkTheme": 0}) as tab:
        tab.resize(1280, 900)
        tab.goto(address)
        tab.until(f"{QUIET} && document.getElementById('starting').hidden")
        yield tab


@pytest.fixture
def tab(started):
    """With the first example, from the top."""
    started.resize(1280, 900)
    for number in (1, 0):
        chosen(started, number)
    started.value("scrollTo(0, 0)")
    return started


def settled(tab):
    """The word of the verdict, when the page has answered."""
    tab.until(QUIET)
    return tab.value(WORD)


def chosen(tab, number):
    """An example."""
    tab.value(f"""((select) => {{ select.value = "{number}"; select.dispatchEvent(new Event("change")); }})(
        document.getElementById("example"))""")
    return settled(tab)


def typed(tab, field, text):
    """A text in a field, with the keys of a keyboard."""
    tab.value(f"""((field) => {{ field.focus(); field.select(); }})(document.getElementById("{field}"))""")
    tab.press(*text)
    return settled(tab)


def middle(tab, selector):
    """Where a part of the page is, in sight."""
    return tab.value(f"""((one) => {{
        one.scrollIntoView({{ block: "center" }});
        const {{ x, y, width, height }} = one.getBoundingClientRect();
        return [Math.round(x + width / 2), Math.round(y + height / 2)];
    }})(document.querySelector("{selector}"))""")


def test_examples_and_numbers_are_decided(tab):
    """The first example on both sides of Rumiantsev's condition; then every example."""
    assert settled(tab) == "Stable"
    assert typed(tab, "value-omega3_0", "1.2") == "Unstable"
    assert typed(tab, "value-omega3_0", "5/4") == "Stable"
    assert typed(tab, "value-l", "1/0") == "verdict"
    words = [chosen(tab, number) for number in range(tab.value("document.getElementById('example').length"))]
    assert {"Stable", "Unstable", "equilibria"} <= set(words) and "verdict" not in words


def test_chart_and_body_are_painted(tab):
    """The colours of the chart are those of its key; the body has several."""
    tab.until("!document.querySelector('[aria-busy=true]')")
    tab.until("['chart', 'motion'].every((id) => document.getElementById(id).checkVisibility())")
    tab.value("new Promise((done) => setTimeout(done, 500))")
    swatches, shares = tab.value(SWATCH), tab.value(COLOURS % "chart")
    known = {word: shares.get(f"{colour}/255", 0) for word, colour in swatches.items()}
    assert known["stable"] > 0.05 and known["unstable"] > 0.05, known
    shares = tab.value(COLOURS % "motion")
    assert len(shares) > 3 and shares.get("0,0,0/0", 0) < 0.95, shares


def test_keys_reach_the_chart_and_move_its_point(tab):
    """And each control comes once, the verdict's numbers before the chart."""
    tab.value("document.getElementById('example').focus()")
    seen = []
    for _ in range(60):
        tab.press("\ue004")                            # Tab
        seen.append(tab.value("document.activeElement.id || document.activeElement.textContent.slice(0, 40)"))
    assert seen.index("value-I1") < seen.index("chart") and "motion" in seen
    axes = """["across", "upwards"].map((id) => document.getElementById(id).value)
        .map((name) => document.getElementById(`value-${name}`).value)"""
    before = tab.value(axes)
    tab.until("!document.querySelector('[aria-busy=true]')")
    tab.value("document.getElementById('chart').focus()")
    tab.press("\ue014", "\ue013")                      # right, up
    settled(tab)
    assert all(float(now) > float(old) for now, old in zip(tab.value(axes), before, strict=True))


def test_a_slider_is_dragged_with_the_mouse(tab):
    """From its middle to the right."""
    x, y = middle(tab, ".value:has(#value-l) [type=range]")
    tab.act("pointer", {"type": "pointerMove", "x": x, "y": y}, {"type": "pointerDown", "button": 0},
            {"type": "pointerMove", "x": x + 40, "y": y, "duration": 200}, {"type": "pointerUp", "button": 0},
            pointerType="mouse")
    settled(tab)
    assert float(tab.value("document.getElementById('value-l').value")) > 0.2


@pytest.mark.parametrize("width", WIDTHS)
def test_no_page_is_wider_than_its_screen(tab, width):
    """At each example."""
    tab.resize(width, 844)
    for number in (0, 5, 8, 9):
        chosen(tab, number)
        assert tab.value("document.documentElement.scrollWidth") <= width


def test_it_is_dark_where_the_system_is(address):
    """And the chart has its colours then too."""
    with firefox(**{"ui.systemUsesDarkTheme": 1}) as tab:
        tab.goto(address)
        tab.until(QUIET)
        assert tab.value("getComputedStyle(document.body).backgroundColor") == "rgb(20, 24, 30)"
        tab.value("new Promise((done) => setTimeout(done, 1000))")
        swatches, shares = tab.value(SWATCH), tab.value(COLOURS % "chart")
        assert shares.get(f"{swatches['stable']}/255", 0) > 0.05


def test_the_second_visit_needs_no_network():
    """What has come once is kept: page, library and answers, without a server."""
    with firefox() as tab:
        with served(SITE) as place:
            address = place.replace("/index.html", "/try/index.html")
            tab.goto(address)
            tab.until(QUIET)
            tab.until("navigator.serviceWorker.ready.then(({ active }) => active.state === 'activated')")
        tab.goto("about:blank")
        tab.goto(address)
        assert settled(tab) == "Stable"
        assert typed(tab, "value-omega3_0", "1.2") == "Unstable"
