"""Sliders and scales: they fit a CubeSat as well as a ship, whatever is typed."""
import json
from pathlib import Path

import pytest
import session
from browser.driving import picked, slid, typed
from browser.test_hands import NUMBERS, ends, settled

CUBESAT = {"I1": "0.002", "I2": "0.0021", "I3": "0.0018", "l": "0", "omega0": "0.0011"}
EXAMPLES = json.loads((Path(session.__file__).parent / "examples.json").read_text(encoding="utf-8"))


def test_sliders_fit_a_cubesat(page):
    """Its moments, its rate, the momentum of its wheel; three digits, and an end that moves on."""
    picked(page, 9)
    for name, text in CUBESAT.items():
        typed(page, f"value-{name}", text)
        assert page.input_value(f"#value-{name}") == text
    assert ends(page, "I1") == [0.0001, 0.01] and ends(page, "omega0") == [0.00005, 0.005]
    for name, number in (("I1", 0.0051), ("omega0", 0.00006)):
        slid(page, name, number)
        text = page.input_value(f"#value-{name}")
        assert float(text) == pytest.approx(number, rel=0.006) and len(text) <= 7
        assert settled(page)[1] == "" and page.inner_text("#no-chart") == ""
    typed(page, "value-l", "1e-6")
    assert ends(page, "l") == [-5e-6, 5e-6]
    page.focus(".value:has(#value-I1) [type=range]")
    page.keyboard.press("End")
    assert page.input_value("#value-I1") == "0.01" and ends(page, "I1") == [0.0001, 0.05]


def test_a_link_with_a_wheel_at_rest_has_a_scale_of_its_dimension(page, context, address):
    """The momentum of a rotor is about a moment of inertia times a rate."""
    other = context.new_page()
    values = "".join(f"&set={name}%3D{text}" for name, text in CUBESAT.items())
    other.goto(f"{address}#potential=none&orbit=omega0&inertia=I1,I2,I3&gyrostatic_momentum=0,l,0"
               f"&equilibrium=earth-pointing&pointing=1,2,3{values}")
    other.wait_for_selector("body[aria-busy=false]:has(#early[hidden]) .badge")
    low, high = ends(other, "l")
    assert low == -high and 2.2e-6 <= high <= 2.2e-5
    other.close()


def test_numbers_with_units_have_scales(page):
    """The library says what they are; what is typed stays as it is typed."""
    picked(page, 6)
    given = {"I1": ("120 kg m^2", [5, 500]), "I2": ("2000 kg cm^2", [0.1, 10]), "I3": ("2 kg m^2", [0.1, 10]),
             "l": ("50 N m s", [-200, 200]), "omega3_0": ("3000 rpm", [-1000, 1000])}
    for name, (text, _) in given.items():
        typed(page, f"value-{name}", text)
    assert settled(page)[1] == "" and page.inner_text("#no-chart") == ""
    for name, (text, expected) in given.items():
        assert page.input_value(f"#value-{name}") == text and ends(page, name) == expected


def test_typing_never_moves_what_is_typed(page):
    """Key by key, over numbers that are none yet."""
    text = page.locator("#value-I1")
    text.fill("")
    for key in "0.0021":
        text.press(key)
    assert text.input_value() == "0.0021" and settled(page)[1] == ""
    assert ends(page, "I1") == [0.0001, 0.01] and page.evaluate("document.activeElement.id") == "value-I1"


@pytest.mark.parametrize("number", range(len(EXAMPLES)))
def test_every_number_of_an_example_is_on_its_slider(page, number):
    """With its number between the ends, and the slider nowhere near an end."""
    picked(page, number)
    for name, text in page.evaluate(NUMBERS).items():
        low, high = ends(page, name)
        value = page.evaluate("""async ([name, text]) => (
            await import("/sources/app/numbers.js")).number(name, text)""", [name, text])
        assert low < value < high
        share = page.eval_on_selector(f".value:has(#value-{name}) [type=range]",
                                      "slider => slider.value / slider.max")
        assert 0.05 < share < 0.95
