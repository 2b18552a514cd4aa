"""The chart: the colours of its pixels against the library's verdicts, its point, its keys."""
import json
from fractions import Fraction
from pathlib import Path
from random import Random

import pytest
import session
from driving import picked, shown, typed

import gyrostat as gs

EXAMPLES = json.loads((Path(session.__file__).parent / "examples.json").read_text(encoding="utf-8"))
DRAWN = """places => new Promise(done => setTimeout(() => {
    const { data } = document.getElementById("chart").getContext("2d").getImageData(0, 0, 400, 400);
    const key = [...document.querySelectorAll(".key span")].map(span => [
        getComputedStyle(span).backgroundColor.match(/\\d+/g).slice(0, 3).join(), span.className]);
    const ranges = ["across", "upwards"].map(id => document.getElementById(id).value).map(name => {
        const row = document.getElementById(`value-${name}`).parentElement;
        const { min, max } = row.querySelector("[type=range]");
        return [name, min, max];
    });
    const values = Object.fromEntries([...document.querySelectorAll("#values input[id]")].map(
        input => [input.id.slice(6), input.value]));
    const colours = places.map(([x, y]) => data.slice(4 * (400 * y + x), 4 * (400 * y + x) + 3).join());
    done({ colours, key, ranges, values });
}, 300))"""
AGREE = {"stable": {"STABLE"}, "unstable": {"UNSTABLE"}, "open": {"STABLE", "UNSTABLE", "UNDECIDED"}}


def report_of(number):
    table = {name: value for name, value in EXAMPLES[number]["scene"].items() if name != "values"}
    return session.chosen(json.dumps(table)).report


@pytest.mark.parametrize("number, axes", [
    (0, ("m0", "omega3_0")), (0, ("omega3_0", "I1")), (2, ("k3", "d2U")), (3, ("k3", "omega")),
    (6, ("I2", "l")), (7, ("I2", "omega3_0"))])
def test_the_colour_of_each_pixel(page, number, axes):
    """Of random ones that nothing is drawn over: what the library says at that very double."""
    picked(page, number)
    page.select_option("#across", axes[0])
    page.select_option("#upwards", axes[1])
    shown(page)
    rng, seen = Random(str(axes)), set()
    places = [(rng.randrange(400), rng.randrange(400)) for _ in range(150)]
    drawn = page.evaluate(DRAWN, places)
    assert [name for name, *_ in drawn["ranges"]] == list(axes)
    words, report = dict(drawn["key"]), report_of(number)
    for place, colour in zip(places, drawn["colours"], strict=True):
        word = words.get(colour, "unknown")              # else the cross, or a dot
        if word == "unknown":
            continue
        shares = (place[0] + 0.5) / 400, (399 - place[1] + 0.5) / 400
        values = {name: text for name, text in drawn["values"].items() if name in report.required}
        for (name, low, high), share in zip(drawn["ranges"], shares, strict=True):
            values[name] = str(Fraction(float(low) + (float(high) - float(low)) * share))
        try:
            verdict = report.verdict(values).verdict.name
        except gs.GyrostatError:
            assert word == "nowhere", values
        else:
            assert verdict in AGREE[word], (word, verdict, values)
        seen.add(word)
    assert seen


def test_a_click_sets_the_point_and_keys_move_it(page):
    """The numbers stand in their fields, the verdict is the library's, what is read aloud follows."""
    page.select_option("#across", "m0")
    page.select_option("#upwards", "omega3_0")
    shown(page)
    page.wait_for_selector("#chart[aria-label*='m0 across']")
    for x, y, verdict in ((350, 200, "Unstable"), (50, 60, "Stable")):
        page.click("#chart", position={"x": x, "y": y})
        assert shown(page) == (verdict, "")
        found = float(page.input_value("#value-m0")), float(page.input_value("#value-omega3_0"))
        assert found == pytest.approx((-5 + x / 40, 5 - y / 40), abs=0.03)
    before = found[0]
    page.focus("#chart")
    for _ in range(3):
        page.keyboard.press("ArrowRight")
    shown(page)
    assert float(page.input_value("#value-m0")) == pytest.approx(before + 0.3, abs=1e-9)
    assert f"m0 = {page.input_value('#value-m0')}" in page.get_attribute("#chart", "aria-label")


def test_a_picture_follows_its_numbers_and_says_why_there_is_none(page):
    """Another number, another picture; one that is no fraction; two equal axes; no chart of what is bound."""
    places = [(350, y) for y in range(0, 400, 10)]
    first = page.evaluate(DRAWN, places)["colours"]
    typed(page, "value-I1", "3")
    assert page.evaluate(DRAWN, places)["colours"] != first
    typed(page, "value-I1", "sqrt(2)")
    assert "decimals or fractions" in page.inner_text("#no-chart")
    typed(page, "value-I1", "1")
    page.select_option("#across", page.input_value("#upwards"))
    page.wait_for_selector("#no-chart:has-text('two different names')")
    picked(page, 8)
    page.wait_for_selector("#no-chart:has-text('bound to each other')")
    assert page.is_hidden("#chart")
