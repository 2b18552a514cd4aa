"""The page in a lecture: large letters, one scene, keys."""
import pytest
from axe_playwright_python.sync_playwright import Axe
from browser.driving import shown
from browser.test_sharing import FITS, LOOK, NUMBERS, copied, drawn


@pytest.fixture
def lecture(page):
    """The page in a lecture, and left again."""
    page.click("#lecture")
    yield page
    page.evaluate("() => document.getElementById('leave').click()")
    assert page.evaluate(LOOK)[0] == "header > p"


@pytest.mark.parametrize("size, theme", [((1280, 720), "light"), ((1920, 1080), "dark")])
def test_a_lecture_has_large_letters_and_one_scene(lecture, size, theme):
    """Body, verdict, sliders on the whole screen; the verdict has 6 % of its height; axe finds nothing."""
    lecture.set_viewport_size({"width": size[0], "height": size[1]})
    lecture.emulate_media(color_scheme=theme)
    for number in (0, 4, 8, 9, 10):
        lecture.eval_on_selector("#example", "(one, n) => { one.value = n; one.onchange(); }", number)
        drawn(lecture)
        assert lecture.evaluate(FITS), number
        listed = number == 10
        assert lecture.evaluate(LOOK) == ["#because" if listed else "#nearby canvas", "#verdict", "#values"]
        letters = lecture.eval_on_selector(".badge", "one => parseFloat(getComputedStyle(one).fontSize)")
        assert letters >= 0.06 * size[1]
        assert lecture.inner_text("#titled") == lecture.evaluate(
            "document.querySelector('#example option:checked').textContent")
        found = Axe().run(lecture)
        assert found.violations_count == 0, found.generate_report()
    lecture.emulate_media(color_scheme="light")


def test_keys_of_a_lecture(lecture):
    """Arrows move the slider, n, p, PageDown and PageUp go from example to example, Escape leaves."""
    before = lecture.evaluate(NUMBERS)
    lecture.keyboard.press("ArrowRight")
    assert shown(lecture)[1] == "" and lecture.evaluate(NUMBERS) != before
    titles = []
    for key in ("n", "PageDown", "p", "PageUp", "p"):
        lecture.keyboard.press(key)
        shown(lecture)
        titles.append(lecture.inner_text("#titled"))
    names = lecture.eval_on_selector_all("#example option", "all => all.map(one => one.textContent)")
    assert titles == [names[n] for n in (1, 2, 1, 0, 0)]
    lecture.keyboard.press("Escape")
    lecture.wait_for_selector("#take:visible")
    assert lecture.evaluate("[document.activeElement.id, document.fullscreenElement]") == ["lecture", None]


def test_a_link_opens_a_lecture(page, context):
    """The address of a lecture; what it copies then is the whole page's."""
    page.click("#lecture")
    page.wait_for_url("**&show=lecture")
    tab = context.new_page()
    tab.goto(page.url)
    shown(tab)
    assert tab.is_visible("#leave") and tab.is_hidden("#take")
    tab.keyboard.press("Escape")
    assert "show=" not in copied(tab, "link")
    tab.close()
    page.click("#leave")
