"""The motion nearby, against the library's motions."""
import json
from fractions import Fraction
from itertools import islice
from math import cos, sin
from pathlib import Path
from random import Random

import pytest
import session
from browser.driving import picked, typed

import gyrostat as gs
from gyrostat.mechanics.scenes.system import names_of_scene
from gyrostat.questions.page.chosen import chosen
from gyrostat.questions.page.programs import steps_to

EXAMPLES = json.loads((Path(session.__file__).parent / "examples.json").read_text(encoding="utf-8"))
FIELDS = ["m0*k3", "k3^4 - k3^2/2", "m0*k3 + m1*k3^2", "exp(k3)*m0", "c1*k1 + c3*k3", "m0*k3 + m1*k1*k2",
          "none", "sin(k3) + sqrt(k3 + 2)", "log(k3 + 3)/(k1 + 4)"]
TIMES = [0.5, 2.5, 10]
FOLLOW = """async (given) => {
    const { compiled } = await import("/sources/numerics/compiled.js");
    const { Motion } = await import("/sources/numerics/integrator.js");
    return given.map(({ rates, coordinates, numbers, state }) => {
        const run = compiled(rates);
        const motion = new Motion(x => run({ ...numbers, ...Object.fromEntries(coordinates.map((name, i) =>
            [name, x[i]])) }), state);
        return [0.5, 2.5, 10].map(time => motion.at(time));
    });
}"""


def scenes(count):
    """Bodies, fields of every kind of function, states that are not near anything."""
    rng = Random("motions")

    def number(low, high):
        return Fraction(rng.randint(20 * low, 20 * high), 20)

    for n in range(count):
        field, (a, b, c) = FIELDS[n % len(FIELDS)], (number(1, 2) for _ in range(3))
        values = {name: str(number(-1, 1)) for name in ("m0", "m1", "c1", "c3") if name in field}
        table = {"potential": field, "inertia": [str(a), str(b if n % 3 else a), str(c)],
                 "gyrostatic_momentum": ["0", "0", str(number(-1, 1))]}
        k = rng.choice([(3, 0, 4, 5), (2, -1, 2, 3), (2, 3, 6, 7)])
        state = [number(-1, 1), number(-1, 1), number(-2, 2), *(Fraction(x, k[3]) for x in k[:3])]
        yield table, values, state[:3 if field == "none" else 6]


@pytest.mark.few(1)
@pytest.mark.parametrize("first", range(0, 200, 50))
def test_motions_are_those_of_the_library(page, first):
    """To 1e-9."""
    given, expected = [], []
    for table, values, state in islice(scenes(first + 50), first, None):
        scene = chosen(table).scene
        given.append({"rates": steps_to(scene.vector_field()), "state": [float(x) for x in state],
                      "coordinates": [x.name for x in scene.space.coordinates],
                      "numbers": {name: float(Fraction(text)) for name, text in values.items()}})
        expected.append(gs.trajectories.motion(scene, [float(x) for x in state], values)(TIMES).tolist())
    for there, here in zip(page.evaluate(FOLLOW, given), expected, strict=True):
        for state, same in zip(there, here, strict=True):
            assert state == pytest.approx(same, rel=0, abs=1e-9)


@pytest.mark.parametrize("number, state", [
    (0, (0, 0, 2.4, 0, -sin(0.1), cos(0.1))),            # upright, k turned about axis 1
    (5, (0, 2 * cos(0.1), 2 * sin(0.1)))])               # free, π turned about axis 1
def test_what_is_read_is_on_the_path(page, number, state):
    """The vector that is shown is that of the library at the time that is shown."""
    picked(page, number)
    page.locator("#motion").scroll_into_view_if_needed()
    page.evaluate("""() => { const push = document.getElementById("push");
        push.value = 0.1; push.dispatchEvent(new Event("input")); }""")
    page.wait_for_timeout(1500)
    time, vector = page.inner_text("#state").removeprefix("t = ").split(": ")
    scene, values = chosen(EXAMPLES[number]["scene"]).scene, EXAMPLES[number]["scene"]["values"]
    known = {str(name) for name in names_of_scene(scene)}
    motion = gs.trajectories.motion(scene, state, {name: values[name] for name in values if name in known})
    there = [float(x) for x in vector.split("= (")[1].rstrip(")").split(", ")]
    assert float(time) > 0.1 and there == pytest.approx(motion([float(time)])[0][-3:].tolist(), abs=1e-5)


def test_a_motion_that_there_is_not_is_said(page):
    """A field that is not given; a number that is none."""
    picked(page, 1)
    page.wait_for_selector("#no-motion:has-text('needs a field that is given')")
    assert page.is_visible("#motion") and page.inner_text("#state") == ""     # the body is drawn at rest
    picked(page, 0)
    page.wait_for_selector("#motion:visible")
    assert "number" in typed(page, "value-I1", "two")[1]
    assert "a motion needs numbers" in page.inner_text("#no-motion") and page.is_hidden("#motion")


# when what has changed is painted, with the next frame
PIXELS = """async () => { await new Promise(requestAnimationFrame);
    return document.getElementById("motion").toDataURL(); }"""
COUNTED = """colour => { const canvas = document.getElementById("motion");
    const data = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
    let count = 0;
    for (let n = 0; n < data.length; n += 4) {
        if (data[n] === colour[0] && data[n + 1] === colour[1] && data[n + 2] === colour[2]) count += 1;
    }
    return count; }"""


def standing(page):
    """The page with a body that stands, its picture whole."""
    picked(page, 0)
    page.locator("#motion").scroll_into_view_if_needed()
    page.wait_for_selector("#state:not(:has-text('t = 0.0'))")
    page.click("#nearby button:has-text('Pause')")
    page.wait_for_timeout(300)
    return page.evaluate(PIXELS)


def test_keys_and_the_mouse_turn_the_view(page):
    """Both ways; the key 0 and a double click bring it back, and nothing else has changed."""
    first = standing(page)
    box = page.locator("#motion").bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    seen = [first]
    for across, up in ((60, 0), (0, 40)):
        page.mouse.move(x, y)
        page.mouse.down()
        page.mouse.move(x + across, y + up)
        page.mouse.up()
        seen.append(page.evaluate(PIXELS))
        page.mouse.dblclick(x, y)
        assert page.evaluate(PIXELS) == first
    for key in ("ArrowLeft", "ArrowDown"):
        page.press("#motion", key)
        seen.append(page.evaluate(PIXELS))
        page.press("#motion", "0")
        assert page.evaluate(PIXELS) == first
    assert len(set(seen)) == 5
    page.click("#nearby button:has-text('Go on')")


def test_the_path_is_in_the_colour_of_the_verdict(page):
    """Green or red, also once a number has changed the verdict."""
    def count(colour):
        return page.evaluate(COUNTED, list(colour))

    def seen(colour):                                      # the path has some pixels that nothing else covers
        page.wait_for_function(f"colour => ({COUNTED})(colour) > 3", arg=list(colour), polling=200)

    stable, unstable = (11, 107, 58), (168, 32, 26)
    picked(page, 0)
    page.locator("#motion").scroll_into_view_if_needed()
    page.evaluate("""() => { const push = document.getElementById("push");
        push.value = "0.5"; push.dispatchEvent(new Event("input")); }""")
    seen(stable)
    assert not count(unstable)
    typed(page, "value-m0", "3")
    page.wait_for_selector(".badge:has-text('Unstable')")
    seen(unstable)
    assert not count(stable)
    page.evaluate("""() => { const push = document.getElementById("push");
        push.value = "0.05"; push.dispatchEvent(new Event("input")); }""")


def test_who_wants_no_motion_has_a_picture_that_stands(page):
    """At the time 0, with what is to come of the path; it goes on if one asks."""
    page.emulate_media(reduced_motion="reduce")
    picked(page, 5)
    page.locator("#motion").scroll_into_view_if_needed()
    page.wait_for_timeout(500)
    assert page.inner_text("#state").startswith("t = 0.000000")
    before = page.evaluate(PIXELS)
    page.wait_for_timeout(300)
    assert page.evaluate(PIXELS) == before
    page.click("#nearby button:has-text('Go on')")
    page.wait_for_selector("#state:not(:has-text('t = 0.000000'))")


def test_the_picture_is_as_sharp_as_the_screen(page):
    """A pixel of the canvas is one of the screen, whatever the width of the page."""
    picked(page, 0)
    for width in (390, 1280):
        page.set_viewport_size({"width": width, "height": 900})
        page.wait_for_function("() => (c => c.width == Math.round(c.clientWidth * devicePixelRatio))"
                               "(document.getElementById('motion'))")


def test_a_finger_scrolls_over_the_body_and_turns_it(page):
    """Up and down the page moves, across the view does."""
    page.set_viewport_size({"width": 390, "height": 700})
    first = standing(page)
    touch = page.context.new_cdp_session(page)

    def drawn(across, down):
        box = page.locator("#motion").bounding_box()
        x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
        touch.send("Input.dispatchTouchEvent", {"type": "touchStart", "touchPoints": [{"x": x, "y": y}]})
        for n in range(1, 11):
            touch.send("Input.dispatchTouchEvent", {"type": "touchMove", "touchPoints": [
                {"x": x + across * n / 10, "y": y + down * n / 10}]})
        touch.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})

    before = page.evaluate("scrollY")
    drawn(0, -120)
    page.wait_for_function("before => scrollY > before + 50", arg=before)
    page.wait_for_timeout(300)
    assert page.evaluate(PIXELS) == first
    before = page.evaluate("scrollY")
    drawn(100, 0)
    page.wait_for_function(f"async before => await ({PIXELS})() != before", arg=first, polling=200)
    assert page.evaluate("scrollY") == before
    page.press("#motion", "0")
    page.click("#nearby button:has-text('Go on')")
