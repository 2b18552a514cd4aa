"""Satellites, points, every equilibrium, windows; and that the answers are the library's, scene by scene."""
import json

import pytest
import session
from browser.drawn_scenes import drawn_scene
from browser.driving import latex, picked, shown, typed

TITLES = {"satellite": "Satellite in a circular orbit, Earth-pointing", "every": "Free gyrostat, every",
          "point": "A point of one's own", "asymmetric": "Heavy asymmetric body, upright"}


def example(page, start):
    """The example whose title begins so."""
    titles = page.eval_on_selector_all("#example option", "all => all.map(one => one.textContent)")
    return picked(page, next(n for n, title in enumerate(titles) if title.startswith(start)))


def test_a_satellite_is_earth_pointing_and_turned(page):
    """Its conditions; with its axes exchanged another verdict, and the list of all its attitudes."""
    assert example(page, TITLES["satellite"]) == ("Stable", "") and page.is_visible("#made-row")
    conditions = latex(page, "conditions")
    assert any(r"\omega_0" in formula for formula in conditions)
    assert typed(page, "made", "3, 2, 1")[0] == "Unstable" and latex(page, "conditions") != conditions
    assert "the body axes along roll, pitch and yaw" in typed(page, "made", "1, 1, 3")[1]
    assert typed(page, "made", "1, 2, 3") == ("Stable", "")
    page.check("input[value=every]")
    assert shown(page) == ("equilibria", "") and page.inner_text(".badge") == "24 equilibria"
    assert page.inner_text("#reasons").count("equilibrium in orbit at") == 24


def test_what_is_typed_is_no_example_any_more(page):
    """An empty potential is none; the example can be picked again."""
    assert page.input_value("#example") == "0"
    assert typed(page, "potential", "")[1] == "" and page.is_visible("input[value='axis 1']")
    assert page.inner_text("#example option:checked") == "Your scene"
    assert picked(page, 0) == ("Stable", "") and page.input_value("#potential") == "m0*k3"


def test_a_point_begins_where_the_last_equilibrium_was(page):
    """And what is none is refused by its derivatives."""
    page.check("input[value=point]")
    assert shown(page) == ("Stable", "") and page.input_value("#made") == "0, 0, I3*omega3_0, 0, 0, 1"
    assert "is not an equilibrium" in typed(page, "made", "1, 0, w, 0, 0, 1")[1]
    assert typed(page, "made", "0, 0, I3*w, 0, 0, 1")[1] == "" and page.is_visible("#value-w")


def test_every_rotation_follows_the_sliders(page):
    """Six on a large sphere of the momentum, two on a small one."""
    assert example(page, TITLES["every"])[1] == "" and page.inner_text(".badge") == "6 equilibria"
    assert typed(page, "value-M", "1/100")[1] == "" and page.inner_text(".badge") == "2 equilibria"
    assert page.is_hidden("#place") and page.is_hidden("#opened")


def test_what_lies_between_the_conditions(page):
    """The normal form and D4; nothing is offered where nothing is open."""
    assert page.is_hidden("#opened")
    example(page, TITLES["asymmetric"])
    page.click("#opened summary")
    page.wait_for_selector("#between .katex")
    shown(page)
    assert "Arnold" in page.inner_text("#between") and "h_{0}" in latex(page, "between")[1]
    page.click("#opened summary")


def test_links_keep_what_an_equilibrium_is_made_with(page, context):
    """Orbit and axes."""
    example(page, TITLES["satellite"])
    typed(page, "made", "3, 2, 1")
    verdict, conditions = shown(page), latex(page, "conditions")
    other = context.new_page()
    page.click("[data-copy=link]")
    other.goto(page.input_value("#copied"))
    other.wait_for_selector("body[aria-busy=false]:has(#early[hidden]) .badge")
    assert shown(other) == verdict and latex(other, "conditions") == conditions
    assert other.input_value("#orbit") == "omega0" and other.input_value("#made") == "3, 2, 1"
    other.close()


@pytest.mark.few(1)
@pytest.mark.parametrize("first", range(0, 600, 60))
def test_random_scenes_have_the_librarys_answers(page, first):
    """Character by character; most of them are answers, not refusals."""
    questions = [{"want": want, "scene": drawn_scene(n)} for n in range(first, first + 60)
                 for want in ("analysed", "decided")]
    found = page.evaluate("""async (questions) => {
        const { Analyser } = await import("/sources/app/analyser.js");
        if (!window.other) (window.other = new Analyser(() => {})).start();
        const answers = [];
        for (const { want, scene } of questions) answers.push(await window.other.ask(want, scene));
        return answers.map((answer) => JSON.stringify(answer));
    }""", questions)
    expected = [json.loads(session.answer(json.dumps(question))) for question in questions]
    for question, here, there in zip(questions, expected, found):
        assert json.loads(there) == here, question
    assert sum("error" in answer for answer in expected) < len(expected) / 4


def test_what_is_refused_has_no_verdict(page):
    """Nothing of what was there before is shown as if it were of the new numbers, or of the new scene."""
    assert "divides by zero" in typed(page, "value-l", "1/0")[1]
    assert page.inner_text(".badge") == "No verdict" and page.inner_text("#reasons") == ""
    assert page.get_attribute("#value-l", "aria-invalid") == "true"
    assert typed(page, "value-l", "0") == ("Stable", "") and page.inner_text("#reasons") != ""
    assert page.get_attribute("#value-l", "aria-invalid") == "false"
    assert "cannot be analysed" in typed(page, "potential", "exp(-1/(1-k3))")[1]
    assert page.inner_text(".badge") == "No verdict" and page.get_attribute("#derived", "inert") is not None
    assert typed(page, "potential", "m0*k3") == ("Stable", "")


def test_a_name_of_javascripts_own_objects_is_a_name(page, context):
    """With a number of its own, a slider, and a place in a link."""
    errors = len(context.errors)
    for name in ("toString", "valueOf", "hasOwnProperty", "constructor"):
        assert typed(page, "potential", f"{name}*k3") == ("Stable", "")
        assert page.input_value(f"#value-{name}") == "1"
        assert typed(page, f"value-{name}", "2") == ("Unstable", "")
    page.click("[data-copy=link]")
    other = context.new_page()
    other.goto(page.input_value("#copied"))
    other.wait_for_selector("body[aria-busy=false]:has(#early[hidden]) .badge")
    assert shown(other) == ("Unstable", "") and other.input_value("#value-constructor") == "2"
    other.close()
    assert context.errors[errors:] == []


def test_numbers_that_a_link_gives_to_no_name_harm_nothing(page, context):
    """Not the prototype of an object either."""
    errors = len(context.errors)
    page.click("[data-copy=link]")
    with page.expect_event("framenavigated"):
        page.evaluate("""location.hash = new URL(document.getElementById("copied").value).hash
            + "&set=__proto__%3D1&set=constructor%3D2&set=l%3D1/3" """)
    assert shown(page) == ("Stable", "") and page.input_value("#value-l") == "1/3"
    assert context.errors[errors:] == []


def test_capitals_count_and_the_page_says_so(page):
    """M0 is another name than m0, which a phone's keyboard makes of it; its keyboards are asked not to."""
    assert typed(page, "potential", "M0*k3")[1] == ""
    assert "not m0: capitals count" in page.inner_text(".value:has(#value-M0)")
    assert page.evaluate("""[...document.querySelectorAll("input:not([type=range], [type=radio])")].every(
        (input) => input.autocapitalize === "none")""")


def test_what_was_copied_goes_with_its_scene(page):
    """Its text does not stand beside another one."""
    page.click("[data-copy=python]")
    shown(page)
    assert "gs.axial_potential(k3*m0)" in page.input_value("#copied")
    for field, text in (("value-l", "1/2"), ("potential", "m0*k3^2")):
        page.fill(f"#{field}", text)
        assert page.is_hidden("#copied") and page.input_value("#copied") == ""
        shown(page)
        page.click("[data-copy=python]")
        assert page.is_visible("#copied") or shown(page)


def test_a_refused_field_ends_chart_and_motion(page):
    """They say why there is none, and come back with the next field."""
    page.wait_for_selector("#motion:visible")
    for refused in ("m0*", "m0"):
        assert typed(page, "potential", refused)[1] != ""
        assert page.is_hidden("#chart") and page.is_hidden("#motion")
        assert "no answer" in page.inner_text("#no-chart") and "no answer" in page.inner_text("#no-motion")
    assert typed(page, "potential", "m0*k3") == ("Stable", "")
    page.wait_for_selector("#chart:visible")
    page.wait_for_selector("#motion:visible")


def test_arrows_go_through_the_equilibria(page):
    """The one that is chosen keeps the focus."""
    page.focus("input[value=E1]")
    for name in ("E2", "E3"):
        page.keyboard.press("ArrowDown")
        shown(page)
        assert page.is_checked(f"input[value={name}]")


def test_a_point_after_a_list_can_be_typed(page):
    """No coordinates are known there; the field for them is."""
    example(page, TITLES["every"])
    page.check("input[value=point]")
    shown(page)
    assert page.is_visible("#made")
    assert "M" not in typed(page, "made", "0, 0, w")[1]


def test_another_equilibrium_is_not_shown_in_place_of_the_chosen_one(page):
    """Where a field has none of the old ones the first is chosen, and stays so in the next field."""
    picked(page, 6)
    for field, text in (("potential", "m0*k3"), ("inertia", "I1, I1, I3")):
        assert typed(page, field, text)[1] == ""
    assert page.is_checked("input[value=E1]")
    assert "E1 cannot be analysed" in typed(page, "potential", "sqrt(1 - k3)")[1]


def test_a_spin_that_is_changed_there_and_back_has_its_number_in_its_field(page):
    """Before the library has answered; a rate that is no plain number gives way to the momentum."""
    page.select_option("#spin", "pi3_0")
    shown(page)
    assert typed(page, "value-pi3_0", "1")[1] == ""
    page.select_option("#spin", "omega3_0")
    shown(page)
    typed(page, "value-omega3_0", "3 rpm")
    page.evaluate("""() => {
        for (const name of ["pi3_0", "omega3_0"]) {
            document.getElementById("spin").value = name;
            document.getElementById("spin").dispatchEvent(new Event("change"));
        }
    }""")
    assert shown(page)[1] == "" and page.input_value("#value-omega3_0") == "1/1.6"
