"""The page as a visitor finds it: the first verdict, every example, sliders, copies, links."""
import json
from pathlib import Path

import pytest
import session
from browser.driving import latex, picked, shown, slid, typed

from gyrostat.questions import WANTED

EXAMPLES = json.loads((Path(session.__file__).parent / "examples.json").read_text(encoding="utf-8"))


def test_the_first_verdict_stands_below_rumiantsevs_condition(page):
    """Typeset, with its reason; what loads is said no more."""
    assert shown(page) == ("Stable", "")
    assert r"\left(I_3 \omega_3^0 + l\right)^{2} > 4 I_1 m_0" in latex(page, "conditions")
    assert "the second variation is definite" in page.inner_text("#reasons")
    assert "Rumiantsev 1961" in page.inner_text("#source")
    assert typed(page, "value-omega3_0", "1.25") == ("Stable", "")
    reasons = page.inner_text("#reasons")
    assert "on the boundary" in reasons and "2 growing modes" in reasons
    assert page.is_hidden("#starting") and page.is_hidden("#notice")


@pytest.mark.parametrize("number", range(len(EXAMPLES)))
def test_every_example_has_a_verdict(page, number):
    """That which the library gives here, at the values of the example."""
    scene = EXAMPLES[number]["scene"]
    decided = json.loads(session.answer(json.dumps({"want": "decided", "scene": scene})))
    verdict = decided["verdict"].capitalize() if "verdict" in decided else "equilibria"
    assert picked(page, number) == (verdict, "")
    assert page.input_value("#potential") == scene["potential"]
    assert page.locator("#values .value").count() == len(
        json.loads(session.answer(json.dumps({"want": "analysed", "scene": scene})))["names"])


def test_every_equilibrium_can_be_chosen(page):
    """Each has conditions of its own, and a verdict."""
    seen = set()
    for name in ("E1", "E2", "E3"):
        page.check(f"input[value={name}]")
        verdict, refused = shown(page)
        assert verdict in ("Stable", "Unstable", "Undecided") and not refused
        seen.add(tuple(latex(page, "conditions") + latex(page, "point")))
    assert len(seen) == 3


def test_a_slider_changes_the_verdict_and_its_reason(page):
    """By the mouse's events, and by keys; the text beside it follows."""
    slider = page.locator(".value:has(#value-omega3_0) input[type=range]")
    assert slid(page, "omega3_0", 1.2)[0] == "Unstable"
    assert "positive real part" in page.inner_text("#reasons")
    assert page.input_value("#value-omega3_0") == "1.2"
    slider.focus()
    for _ in range(6):
        page.keyboard.press("ArrowRight")
    assert shown(page)[0] == "Stable" and page.input_value("#value-omega3_0") == "1.26"
    assert typed(page, "value-omega3_0", "5/4") == ("Stable", "")
    assert slider.get_attribute("aria-valuetext") == "1.25"


def test_a_number_that_is_no_fraction_has_its_place(page):
    """Slider, chart and motion follow roots and pi; on the boundary too."""
    for text, place in (("sqrt(2)", "1.414"), ("pi", "3.142"), ("sqrt(25/16)", "1.25"), ("5/2/2", "1.25")):
        assert typed(page, "value-omega3_0", text) == ("Stable", "")
        slider = page.locator(".value:has(#value-omega3_0) input[type=range]")
        assert slider.get_attribute("aria-valuetext") == place
        page.wait_for_selector(f"#chart[aria-label*='omega3_0 = {place[:3]}']")
        assert page.inner_text("#no-chart") == page.inner_text("#no-motion") == ""
        assert page.inner_text("#here").endswith(f"omega3_0 = {text}: stable")


def test_another_way_to_give_the_spin_keeps_it(page):
    """π3 = I3 ω3, as it is written; there and back."""
    assert typed(page, "value-omega3_0", "1.2") == ("Unstable", "")
    for spin, name, text in (("pi3_0", "pi3_0", "1.2*1.6"), ("omega3_0", "omega3_0", "1.2")):
        page.select_option("#spin", spin)
        assert shown(page) == ("Unstable", "") and page.input_value(f"#value-{name}") == text
    typed(page, "value-I3", "2")
    page.select_option("#spin", "pi3_0")
    shown(page)
    assert page.input_value("#value-pi3_0") == "1.2*2"


def test_a_field_of_ones_own(page):
    """Its conditions, and what the library says of one that is none."""
    assert typed(page, "potential", "k3^4 - c*k3^2/2")[1] == ""
    assert any("c" in formula for formula in latex(page, "conditions"))
    assert "not part of the grammar" in typed(page, "potential", "alert('k3')")[1]
    assert typed(page, "potential", "m0*k3") == ("Stable", "")


def test_a_number_that_is_none_is_refused_beside_it(page):
    """And the next one is decided."""
    assert "1,5" in typed(page, "value-I1", "1,5")[1]
    assert "I1" in typed(page, "value-I1", "-1")[1]
    assert typed(page, "value-I1", "1") == ("Stable", "")


def test_the_whole_derivation_is_shown_where_it_is_opened(page):
    """Bracket, equations of motion, linearisation; the symbols in a table."""
    page.evaluate("document.getElementById('derivation').open = true")
    page.wait_for_selector("#blocks table")
    text = page.inner_text("#blocks")
    assert "Poisson tensor" in text and "characteristic polynomial" in text
    page.evaluate("document.getElementById('derivation').open = false")


@pytest.mark.parametrize("kind", ["latex", "python", "scene"])
def test_what_is_copied_is_what_the_library_gives(page, kind):
    """Character by character, at the numbers that are shown."""
    typed(page, "value-l", "1/3")
    page.click(f"[data-copy={kind}]")
    shown(page)
    scene = {**EXAMPLES[0]["scene"], "values": {**EXAMPLES[0]["scene"]["values"], "l": "1/3"}}
    copied = json.loads(session.answer(json.dumps({"want": "copied", "scene": scene})))[kind]
    found = page.input_value("#copied")
    assert sorted(found.splitlines()) == sorted(copied.splitlines())


def test_a_link_restores_what_is_on_the_page(page, context):
    """In another tab: scene, equilibrium, numbers as they were typed, verdict."""
    picked(page, 3)
    typed(page, "value-omega", "sqrt(2)/3")
    page.select_option("#across", "I1")
    page.select_option("#upwards", "k3")
    shown(page)
    page.click("[data-copy=link]")
    verdict = shown(page)
    other = context.new_page()
    other.goto(page.input_value("#copied"))
    other.wait_for_selector("body[aria-busy=false]:has(#early[hidden]) .badge")
    assert shown(other) == verdict
    for field in ("potential", "inertia", "gyrostatic_momentum", "value-omega", "value-k3", "example",
                  "across", "upwards"):
        assert other.input_value(f"#{field}") == page.input_value(f"#{field}")
    assert latex(other, "conditions") == latex(page, "conditions") and other.is_checked("input[value=E3]")
    other.close()


def test_the_library_answers_there_as_it_does_here(page):
    """Every question about every example, character by character."""
    for example in EXAMPLES:
        for want in WANTED:
            found = page.evaluate("""async ([want, scene]) => {
                const { Analyser } = await import("/sources/app/analyser.js");
                if (!window.other) (window.other = new Analyser(() => {})).start();
                return window.other.ask(want, scene);
            }""", [want, example["scene"]])
            assert found == json.loads(session.answer(json.dumps({"want": want, "scene": example["scene"]})))
