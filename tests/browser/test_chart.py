"""The chart: the colours of its pixels against the library's verdicts, its point, its keys."""
import json
from collections import Counter
from fractions import Fraction
from math import isfinite
from pathlib import Path
from random import Random
from urllib.parse import urlencode

import pytest
import session
from browser.drawn_scenes import drawn_scene
from browser.driving import AGREE, at, cells, picked, pixels, shown, typed
from mpmath import mp, mpf

from gyrostat.questions.page.chosen import chosen

EXAMPLES = json.loads((Path(session.__file__).parent / "examples.json").read_text(encoding="utf-8"))
DRAWN = """places => {
    const key = [...document.querySelectorAll(".key span")].map(span => [
        getComputedStyle(span).backgroundColor.match(/\\d+/g).slice(0, 3).join(), span.className]);
    const ranges = ["across", "upwards"].map(id => document.getElementById(id).value).map(name => {
        const { low, high } = document.getElementById(`value-${name}`).closest(".value").dataset;
        return [name, low, high];
    });
    const values = Object.fromEntries([...document.querySelectorAll("#values input[id]")].map(
        input => [input.id.slice(6), input.value]));
    return { cells: cells(places), key, ranges, values };
}"""


BOUNDS = """async (questions) => {
    const { Rows } = await import("/sources/numerics/programs.js");
    return questions.map(([steps, numbers]) => {
        const rows = new Rows(steps, [], 1);
        rows.begin(numbers, 0);
        return [rows.values.at(-1)[0], rows.errors.at(-1)[0]].map(String);
    });
}"""
WITHIN = {"exp": (-30, 30), "log": (0, 9), "sin": (-9, 9), "cos": (-9, 9), "tan": (-9, 9), "asin": (-1, 1),
          "acos": (-1, 1), "atan": (-9, 9), "sinh": (-9, 9), "cosh": (-9, 9), "tanh": (-9, 9),
          "asinh": (-9, 9), "acosh": (1, 9), "atanh": (-1, 1), "power": (0, 9)}
BOUNDED = ("log", "power", "asin", "acos", "acosh", "atanh")         # what is undefined at one end, or both


def report_of(number):
    return chosen(EXAMPLES[number]["scene"]).report


def test_a_number_with_a_unit_is_one_of_its_name(page):
    """What the library said of a rate in rpm is nothing for a moment of inertia."""
    assert page.evaluate("""async () => {
        const { heard, number } = await import("/sources/app/numbers.js");
        heard({ omega: "3.5 rpm" }, { omega: 0.25 });
        return [["omega", "3.5 rpm"], ["I1", "3.5 rpm"], ["I1", "1/4"], ["I1", "0x10"]].map(
            ([name, text]) => String(number(name, text)));
    }""") == ["0.25", "NaN", "0.25", "NaN"]


@pytest.mark.parametrize("number, axes", [
    (0, ("m0", "omega3_0")), (0, ("omega3_0", "I1")), (2, ("k3", "d2U")), (3, ("k3", "omega")),
    (6, ("I2", "l")), (7, ("I2", "omega3_0"))])
def test_the_colour_of_each_pixel(page, number, axes):
    """Of random ones that nothing is drawn over: what the library says at that very double."""
    picked(page, number)
    page.select_option("#across", axes[0])
    page.select_option("#upwards", axes[1])
    shown(page)
    rng = Random(str(axes))
    places = [(rng.randrange(400), rng.randrange(400)) for _ in range(150)]
    drawn = drawn_at(page, places)
    assert [name for name, *_ in drawn["ranges"]] == list(axes)
    assert sum(pixels_agree(report_of(number), drawn).values()) > 60


def drawn_at(page, places):
    """The colours at some places, and what they are of."""
    cells(page)
    page.wait_for_selector("#picture[aria-busy=false]")
    return page.evaluate(DRAWN, places)


def pixels_agree(report, drawn):
    """How often each colour was seen, and the library says what it says."""
    seen = Counter()
    for word, verdict, values in pixels(report, drawn):
        assert verdict in AGREE[word], (word, verdict, values)
        seen[word] += 1
    return seen


@pytest.mark.parametrize("name", WITHIN)
def test_each_function_has_a_bound_of_its_error(started, name):
    """Of a difference that loses digits, at numbers that are no doubles, near the ends of its domain too."""
    rng, (low, high) = Random(name), WITHIN[name]
    questions, exact = [], []
    for n in range(200):
        big = Fraction(rng.randint(1, 10**20), rng.randint(1, 10**20)) * 10**rng.choice([0, 0, 6])
        x = low + (high - low) * Fraction(rng.randint(1, 10**9), 10**9)
        if n % 4 == 0:
            x = rng.choice([low, high]) + (low + high - 2 * x) / 10**rng.randint(1, 16)
        power = Fraction(rng.choice(["1/2", "1/3", "-2/3", "5/2"]))
        steps = [["name", "a"], ["name", "b"], ["subtract", 0, 1],
                 [name, 2, float(power)] if name == "power" else [name, 2]]
        questions.append([steps, {"a": float(big + x), "b": float(big)}])
        with mp.workdps(60):
            x = mpf(x.numerator) / x.denominator
            inside = low < x and (high == 9 or x < high) or name not in BOUNDED
            exponent = mpf(power.numerator) / power.denominator
            value = x**exponent if name == "power" else getattr(mp, name)(x)
            exact.append(value if inside else None)
    known = 0
    for (value, error), truth in zip(started.evaluate(BOUNDS, questions), exact, strict=True):
        if not isfinite(bound := float(error.replace("Infinity", "inf"))):
            continue
        known += 1
        with mp.workdps(60):
            assert truth is not None and abs(mpf(value) - truth) <= bound, (value, error, truth)
    assert known > 120


@pytest.mark.parametrize("field", [
    "-4*tan(k3)^2 - asin(k3)/3", "4*acos(k3)*k3 - atan(2*k3)", "-3*cosh(2*k3) + acosh(k3 + 2)",
    "4*tanh(3*k3)^2 - asinh(k3)", "-3*sinh(k3)^2 - atanh(k3/2)", "m0/(2 - k3) - 9*k3^3"])
def test_fields_of_every_function_have_a_chart(page, field):
    """The colours of an inclined rotation are the library's verdicts, and most pixels have one."""
    picked(page, 3)
    assert typed(page, "potential", field)[1] == ""
    page.select_option("#across", "k3")
    page.select_option("#upwards", "omega")
    shown(page)
    rng = Random(field)
    places = [(rng.randrange(400), rng.randrange(400)) for _ in range(80)]
    drawn = drawn_at(page, places)
    scene = {**EXAMPLES[3]["scene"], "potential": field}
    agreed = pixels_agree(chosen(scene).report, drawn)
    assert sum(agreed.values()) > 50 and {"stable", "unstable"} <= set(agreed)


def test_a_click_sets_the_point_and_keys_move_it(page):
    """The numbers stand in their fields, the verdict is the library's, what is read aloud follows."""
    page.select_option("#across", "m0")
    page.select_option("#upwards", "omega3_0")
    shown(page)
    page.wait_for_selector("#chart[aria-label*='m0 across']")
    for x, y, verdict in ((3.75, 0, "Unstable"), (-3.75, 3.5, "Stable")):
        page.click("#chart", position=at(page, x, y))
        assert shown(page) == (verdict, "")
        found = float(page.input_value("#value-m0")), float(page.input_value("#value-omega3_0"))
        assert found == pytest.approx((x, y), abs=0.03)
    before = found[0]
    page.focus("#chart")
    for _ in range(3):
        page.keyboard.press("ArrowRight")
    shown(page)
    assert float(page.input_value("#value-m0")) == pytest.approx(before + 0.3, abs=1e-9)
    assert f"m0 = {page.input_value('#value-m0')}" in page.get_attribute("#chart", "aria-label")


def test_a_picture_follows_its_numbers_and_says_why_there_is_none(page):
    """Another number, another picture; two axes change places; no chart of what is bound."""
    places = [(350, y) for y in range(0, 400, 9)]
    first = drawn_at(page, places)["cells"]
    typed(page, "value-I1", "3")
    assert drawn_at(page, places)["cells"] != first
    names = page.input_value("#across"), page.input_value("#upwards")
    page.select_option("#across", names[1])
    shown(page)
    assert (page.input_value("#upwards"), page.input_value("#across")) == names
    picked(page, 8)
    page.wait_for_selector("#no-chart:has-text('bound to each other')")
    assert page.is_hidden("#chart")


def test_two_axes_differ(page, context):
    """After another scene has taken the name of one, and where a link names one twice."""
    picked(page, 9)
    for across, upwards in (("I3", "l"), ("l", "omega0"), ("omega0", "l"), ("omega0", "I1")):
        typed(page, "orbit", "omega0")
        page.select_option("#across", across)
        page.select_option("#upwards", upwards)
        assert typed(page, "orbit", "mu=398600.4418 km^3/s^2, radius=6778 km")[1] == ""
        page.wait_for_selector("#chart:visible")
        axes = [page.input_value("#across"), page.input_value("#upwards")]
        assert len({*axes, "omega0"}) == 3 and [axis for axis in (across, upwards) if axis in axes] == [
            axis for axis in (across, upwards) if axis != "omega0"]
        assert page.inner_text("#no-chart") == ""
    page.evaluate("location.hash = location.hash.replace(/axes=[^&]*/, 'axes=l,l')")
    shown(page)
    assert page.input_value("#across") != page.input_value("#upwards")


def test_a_chart_over_one_number_is_none(page):
    """It says which number alone a verdict needs, and offers no axes until there are two again."""
    picked(page, 5)
    assert page.is_visible("#across")
    typed(page, "inertia", "1, 2, 5/2")
    page.wait_for_selector("#no-chart:has-text('a verdict here needs omega2_0 alone')")
    assert page.is_hidden("#across") and page.is_hidden("#upwards")
    picked(page, 10)
    assert page.is_hidden("#across") and page.is_hidden("#upwards")
    picked(page, 0)
    assert page.is_visible("#across") and page.is_visible("#upwards")


def test_pictures_take_numbers_as_the_library_does(page):
    """Of what it refuses there is no picture."""
    for text in ("0x10", "0b11", "1_0", "Infinity", "-1", "0"):
        assert typed(page, "value-I1", text)[1] != ""
        assert page.inner_text("#no-chart") == "a picture needs numbers, and possible ones"
        assert page.inner_text("#no-motion") == "a motion needs numbers, and possible ones"
    assert typed(page, "value-I1", ".5e1")[1] == "" and page.inner_text("#no-chart") == ""


@pytest.mark.few(1)
@pytest.mark.parametrize("first", range(0, 360, 12))
def test_random_scenes_have_the_librarys_charts(page, first):
    """In random pixels of random bodies, fields and satellites its verdicts, most of them known."""
    seen, charts = Counter(), 0
    for n in range(first, first + 12):
        scene = drawn_scene(n)
        page.evaluate("""hash => new Promise((done) => {
            addEventListener("hashchange", () => done(), { once: true });
            location.hash = hash;
        })""", f"n={n}&{link_of(scene)}")
        shown(page)
        page.wait_for_selector("#picture[aria-busy=false]")
        if page.is_hidden("#chart"):
            assert page.inner_text("#no-chart")
            continue
        rng = Random(n)
        drawn = drawn_at(page, [(rng.randrange(400), rng.randrange(400)) for _ in range(30)])
        seen += pixels_agree(chosen(scene).report, drawn)
        charts += 1
    assert charts > 3 and sum(seen.values()) > 15 * charts, (charts, seen)


def link_of(scene):
    """As the page writes it."""
    texts = {name: ", ".join(value) if isinstance(value, list) else value for name, value in scene.items()
             if name != "values"}
    numbers = [("set", f"{name}={value}") for name, value in scene["values"].items()]
    return urlencode([*texts.items(), *numbers])
