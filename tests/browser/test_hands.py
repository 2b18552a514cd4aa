"""Hands on the page: one finger scrolls, taps, drags, two zoom; mouse, wheel, keys; sliders and scales."""

import pytest
from browser.conftest import OPTIONS
from browser.driving import at, picked, shown
from browser.test_chart import drawn_at, pixels_agree, report_of

WHERE = """() => {
    const { x, y, width } = document.getElementById("chart").getBoundingClientRect();
    return [x, y, width, scrollY, visualViewport.scale];
}"""
NUMBERS = """() => Object.fromEntries([...document.querySelectorAll("#values input[id]")].map(
    (input) => [input.id.slice(6), input.value]))"""


def settled(page):
    """The page has answered, and its chart is drawn."""
    found = shown(page)
    page.wait_for_selector("#picture[aria-busy=false]")
    return found


def ends(page, name):
    """The ends of a slider, as numbers."""
    return page.eval_on_selector(f".value:has(#value-{name})",
                                 "row => [row.dataset.low, row.dataset.high].map(Number)")


def chosen(page, number, across, upwards):
    """An example with two axes, its chart on the screen."""
    picked(page, number)
    page.select_option("#across", across)
    page.select_option("#upwards", upwards)
    page.eval_on_selector("#chart", "chart => chart.scrollIntoView({ block: 'center' })")
    settled(page)


@pytest.fixture(scope="module")
def phone(playwright, address):
    """The page on a phone."""
    with playwright.chromium.launch(**OPTIONS) as browser:
        context = browser.new_context(viewport={"width": 390, "height": 844}, device_scale_factor=2,
                                      has_touch=True, is_mobile=True)
        page = context.new_page()
        page.set_default_timeout(60_000)
        page.goto(address)
        shown(page)
        page.fingers = context.new_cdp_session(page)
        yield page


def touch(page, kind, *places):
    """Fingers at some places of the window; those that were there and are not have gone."""
    page.fingers.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": [
        {"x": x, "y": y, "id": n} for n, (x, y) in enumerate(places)]})


def stroke(page, *paths):
    """Fingers go along paths of the same length, then up."""
    touch(page, "touchStart", *(path[0] for path in paths))
    for places in list(zip(*paths))[1:]:
        touch(page, "touchMove", *places)
        page.wait_for_timeout(20)
    touch(page, "touchEnd")
    page.wait_for_timeout(300)


def along(start, end, steps=12):
    """A straight path."""
    return [tuple(a + (b - a) * n / steps for a, b in zip(start, end)) for n in range(steps + 1)]


def on_window(page, across, upwards):
    """Where numbers of the axes are in the window."""
    x, y, *_ = page.evaluate(WHERE)
    place = at(page, across, upwards)
    return x + place["x"], y + place["y"]


def test_a_finger_that_scrolls_over_the_chart_changes_nothing(phone):
    """The page scrolls under it, both ways."""
    chosen(phone, 0, "m0", "omega3_0")
    for down, (across, upwards) in ((-150, (-4, -2)), (150, (3, 3.5))):
        before, scrolled = phone.evaluate(NUMBERS), phone.evaluate(WHERE)[3]
        x, y = on_window(phone, across, upwards)
        stroke(phone, along((x, y), (x, y + down)))
        assert phone.evaluate(NUMBERS) == before
        moved = phone.evaluate(WHERE)[3] - scrolled
        assert moved * -down > 0 and abs(moved) > 80, moved


def test_a_tap_sets_the_point(phone):
    """And the verdict is that of its numbers."""
    chosen(phone, 0, "m0", "omega3_0")
    for across, upwards, verdict in ((3, 1, "Unstable"), (-2, 3, "Stable")):
        stroke(phone, [on_window(phone, across, upwards)] * 2)
        assert settled(phone) == (verdict, "")
        found = phone.evaluate(NUMBERS)
        assert (float(found["m0"]), float(found["omega3_0"])) == pytest.approx((across, upwards), abs=0.05)


def test_a_finger_on_the_ring_drags_the_point(phone):
    """The page does not scroll; the finger may be some pixels beside it."""
    chosen(phone, 0, "m0", "omega3_0")
    scrolled = phone.evaluate(WHERE)[3]
    (x, y), (u, v) = on_window(phone, 1, 1.5), on_window(phone, 3, -3.5)
    stroke(phone, along((x + 12, y + 9), (u + 12, v + 9)))
    assert settled(phone) == ("Stable", "")
    found = phone.evaluate(NUMBERS)
    assert (float(found["m0"]), float(found["omega3_0"])) == pytest.approx((3, -3.5), abs=0.05)
    assert phone.evaluate(WHERE)[3] == scrolled


def test_two_fingers_zoom_the_chart_and_not_the_page(phone):
    """What was between them stays there; the numbers stay; the sliders have the ends of the chart."""
    chosen(phone, 0, "m0", "omega3_0")
    before, (*_, scrolled, scale) = phone.evaluate(NUMBERS), phone.evaluate(WHERE)
    x, y = on_window(phone, -2, -1)
    stroke(phone, along((x - 20, y), (x - 60, y)), along((x + 20, y), (x + 60, y)))
    settled(phone)
    assert phone.evaluate(NUMBERS) == before
    low, high = ends(phone, "m0")
    assert high - low == pytest.approx(10 / 3, rel=0.1)
    assert on_window(phone, -2, -1) == pytest.approx((x, y), abs=2)
    assert phone.evaluate(WHERE)[3:] == [scrolled, scale]
    stroke(phone, along((x - 20, y), (x + 40, y + 30)), along((x + 20, y), (x + 80, y + 30)))
    assert on_window(phone, -2, -1) == pytest.approx((x + 60, y + 30), abs=4)
    assert ends(phone, "m0")[1] - ends(phone, "m0")[0] == pytest.approx(high - low, rel=0.05)
    phone.tap("#whole")
    settled(phone)
    assert ends(phone, "m0") == [-5, 5] and phone.is_hidden("#whole")


def test_a_finger_after_two_sets_nothing(phone):
    """The one that is lifted last."""
    chosen(phone, 0, "m0", "omega3_0")
    before = phone.evaluate(NUMBERS)
    x, y = on_window(phone, -2, -1)
    touch(phone, "touchStart", (x, y))
    touch(phone, "touchStart", (x, y), (x + 60, y))
    touch(phone, "touchEnd", (x, y))
    touch(phone, "touchEnd")
    phone.wait_for_timeout(200)
    assert phone.evaluate(NUMBERS) == before


def test_a_mouse_drags_the_point(page):
    """From where it is pressed, and from outside too; beside the chart it sets nothing."""
    chosen(page, 0, "m0", "omega3_0")
    x, y = on_window(page, -3, 2)
    page.mouse.move(x, y)
    page.mouse.down()
    assert float(page.input_value("#value-m0")) == pytest.approx(-3, abs=0.05)
    page.mouse.move(*on_window(page, 2, 0), steps=5)
    assert float(page.input_value("#value-m0")) == pytest.approx(2, abs=0.05)
    page.mouse.move(x + 900, y, steps=3)
    page.mouse.up()
    page.mouse.move(x, y)
    assert settled(page) == ("Unstable", "") or page.input_value("#value-omega3_0") == "2"
    assert float(page.input_value("#value-m0")) == 5
    before = page.evaluate(NUMBERS)
    page.mouse.click(*on_window(page, -5.8, 2))
    assert page.evaluate(NUMBERS) == before


def test_a_wheel_zooms_about_the_pointer(page):
    """Not while it scrolls the page; with the shift key the mouse moves what is seen."""
    chosen(page, 0, "m0", "omega3_0")
    x, y = on_window(page, 2, -3)
    page.mouse.move(x, y)
    scrolled = page.evaluate("scrollY")
    page.mouse.wheel(0, -300)
    settled(page)
    low, high = ends(page, "m0")
    assert high - low < 7 and on_window(page, 2, -3) == pytest.approx((x, y), abs=1)
    assert page.evaluate("scrollY") == scrolled and page.is_visible("#whole")
    page.keyboard.down("Shift")
    page.mouse.down()
    page.mouse.move(x + 50, y - 30, steps=3)
    page.mouse.up()
    page.keyboard.up("Shift")
    settled(page)
    assert on_window(page, 2, -3) == pytest.approx((x + 50, y - 30), abs=1)
    assert page.input_value("#value-m0") == "1"
    page.click("#whole")
    settled(page)
    assert ends(page, "m0") == ends(page, "omega3_0") == [-5, 5]


def test_keys_zoom_about_the_point(page):
    """Arrows move it by a hundredth of what is seen."""
    chosen(page, 0, "m0", "omega3_0")
    page.focus("#chart")
    before = on_window(page, 1, 1.5)
    for _ in range(5):
        page.keyboard.press("+")
        settled(page)
    low, high = ends(page, "m0")
    assert high - low == pytest.approx(10 / 1.25**5, rel=1e-3)
    assert on_window(page, 1, 1.5) == pytest.approx(before, abs=1)
    page.keyboard.press("ArrowRight")
    settled(page)
    assert float(page.input_value("#value-m0")) == pytest.approx(1 + (high - low) / 100, abs=0.006)
    for _ in range(7):
        page.keyboard.press("-")
    settled(page)
    assert ends(page, "m0")[1] - ends(page, "m0")[0] > 10


def test_a_zoomed_chart_is_the_librarys(page):
    """Each end is exact: its pixels are what the library says there."""
    chosen(page, 0, "m0", "omega3_0")
    page.mouse.move(*on_window(page, 1.1, 1.3))
    for _ in range(6):
        page.mouse.wheel(0, -400)
        settled(page)
    low, high = ends(page, "m0")
    assert high - low < 0.1 and low < 1.1 < high
    places = [(x, y) for x in range(9, 400, 40) for y in range(7, 400, 40)]
    agreed = pixels_agree(report_of(0), drawn_at(page, places))
    assert {"stable", "unstable"} <= set(agreed) and sum(agreed.values()) > 60
    page.click("#whole")
