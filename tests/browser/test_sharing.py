"""What is taken from the page, and what Back leads to: links, frames, a lecture, pictures, paper."""
import base64
import io
import re
from html.parser import HTMLParser
from unicodedata import normalize
from xml.etree import ElementTree

import pytest
from axe_playwright_python.sync_playwright import Axe
from browser.driving import picked, shown, typed
from pypdf import PdfReader

NUMBERS = """() => Object.fromEntries([...document.querySelectorAll("#values input[id]")].map(
    (input) => [input.id.slice(6), input.value]))"""
SCENE = f"""() => ({{ numbers: ({NUMBERS})(), verdict: document.querySelector(".badge").textContent,
    scene: ["potential", "orbit", "inertia", "gyrostatic_momentum"].map(
        (id) => document.getElementById(id).value),
    equilibrium: document.querySelector("#equilibria :checked").value }})"""
CHART = """() => ["across", "upwards"].map((id) => document.getElementById(id).value).concat(
    document.getElementById("chart").ariaLabel, document.getElementById("ends").textContent)"""
LOOK = """() => ["header > p", "#ask", "#derived", "#take", "#because", "footer", "#charted",
    "#nearby canvas", "#verdict", "#values"].filter(
    place => document.querySelector(place)?.checkVisibility())"""
FITS = """() => {
    const { scrollWidth, scrollHeight, clientWidth, clientHeight } = document.documentElement;
    return scrollWidth <= clientWidth && scrollHeight <= clientHeight;
}"""
COLOURS = """async (data) => {
    const image = new Image();
    image.src = data;
    await image.decode();
    const canvas = new OffscreenCanvas(image.width, image.height), context = canvas.getContext("2d");
    context.drawImage(image, 0, 0);
    const found = {}, pixels = context.getImageData(0, 0, image.width, image.height).data;
    for (let n = 0; n < pixels.length; n += 4) {
        const name = pixels.slice(n, n + 3).join();
        found[name] = (found[name] ?? 0) + 1;
    }
    return found;
}"""
TEXTS = ["</text><script>alert(1)</script>", "k3\u202e\u0000", "&amp;\"'<", "\U0001d6fc*k3", ""]
LIGHT = {"stable": "154,215,197", "unstable": "246,201,168"}


def drawn(page):
    """The page when its pictures have come too."""
    shown(page)
    page.wait_for_function("() => !document.querySelector('[aria-busy=true]')")


def copied(page, kind):
    """What a button copies."""
    page.click(f"[data-copy={kind}]")
    return page.input_value("#copied")


def saved(page, kind):
    """The name of the picture that a button saves, and its bytes."""
    with page.expect_download() as download:
        page.click(f"[data-copy={kind}]")
    return download.value.suggested_filename, download.value.path().read_bytes()


def test_a_link_restores_all_that_is_seen(page, context):
    """In another tab: scene, equilibrium, numbers as they are typed, axes and their ends, verdict."""
    picked(page, 4)
    page.select_option("#across", "m1")
    page.select_option("#upwards", "l")
    assert typed(page, "value-m1", "sqrt(2)/3")[1] == ""
    drawn(page)
    link = re.sub(r"ends=m1%3D[^&]*", "ends=m1%3D-1.5%2C2.5", copied(page, "link"))
    tab = context.new_page()
    tab.goto(link)
    drawn(tab)
    assert tab.evaluate(SCENE) == page.evaluate(SCENE)
    assert tab.input_value("#value-m1") == "sqrt(2)/3"
    axes = tab.evaluate(CHART)
    assert axes[:2] == ["m1", "l"] and axes[3].startswith("m1 from -1.5 to 2.5 across")
    assert copied(tab, "link") == link
    tab.close()


class Frame(HTMLParser):
    """The attributes of the element that is given."""

    def handle_starttag(self, tag, attrs):
        self.tag, self.attributes = tag, dict(attrs)


@pytest.mark.parametrize("width, height", [(720, 420), (480, 640)])
@pytest.mark.parametrize("number", [0, 8])
def test_another_page_shows_a_scene(page, context, number, width, height):
    """Its title with a link to the page, body, verdict, sliders, chart; no form, and no scrolling."""
    picked(page, number)
    title = page.inner_text("#example option:checked")
    given = Frame()
    given.feed(copied(page, "embed"))
    assert given.tag == "iframe" and given.attributes["title"] == f"{title} (gyrostat)"
    assert given.attributes["loading"] == "lazy" and given.attributes["src"].endswith("&show=embed")
    tab = context.new_page()
    tab.set_content('<!DOCTYPE html><html lang="en"><title>A course</title><main><h1>A course</h1>'
                    + page.input_value("#copied") + "</main>")
    tab.eval_on_selector("iframe", "(one, [width, height]) => Object.assign(one, { width, height })",
                         [width, height])
    frame = tab.wait_for_selector("iframe").content_frame()
    frame.wait_for_selector("body[aria-busy=false]:has(#early[hidden]) .badge")
    frame.wait_for_function("() => !document.querySelector('[aria-busy=true]')")
    assert frame.evaluate(LOOK) == ["#charted", "#nearby canvas", "#verdict", "#values"]
    assert frame.evaluate(FITS)
    assert frame.inner_text(".badge") == page.inner_text(".badge")
    assert frame.evaluate(NUMBERS) == page.evaluate(NUMBERS)
    assert frame.get_attribute("#titled", "href") == copied(page, "link")
    assert frame.inner_text("#titled") == title
    assert Axe().run(tab).violations_count == 0
    tab.close()


@pytest.mark.parametrize("theme", ["light", "dark"])
def test_a_picture_is_what_is_seen(page, theme):
    """As SVG: the scene, its verdict, numbers, key and chart; its colours are those of paper always."""
    page.emulate_media(color_scheme=theme)
    picked(page, 0)
    drawn(page)
    name, data = saved(page, "svg")
    assert name == "gyrostat-rumiantsev-s-condition-heavy-gyrostat-upright-sleeping-top.svg"
    root = ElementTree.fromstring(data)
    texts = [one.text for one in root.iter("{http://www.w3.org/2000/svg}text")]
    assert {page.inner_text("#example option:checked"), "✓ Stable", "stable", "unstable"} <= set(texts)
    assert "I1 = 1, I3 = 1.6, l = 0, m0 = 1, omega3_0 = 1.5" in [text.replace("\xa0", " ") for text in texts]
    image = [one.get("href") for one in root.iter("{http://www.w3.org/2000/svg}image")][-1]
    assert base64.b64decode(image.removeprefix("data:image/png;base64,")).startswith(b"\x89PNG")
    inside = page.evaluate(COLOURS, image)
    assert {LIGHT["stable"], LIGHT["unstable"]} <= set(sorted(inside, key=inside.get)[-4:])
    _, data = saved(page, "png")
    found = page.evaluate(COLOURS, f"data:image/png;base64,{base64.b64encode(data).decode()}")
    assert 200_000 > found[LIGHT["unstable"]] > 50_000 and found[LIGHT["stable"]] > 150_000
    assert sorted(found, key=found.get)[-1] == "255,255,255"


def test_a_picture_waits_for_its_answer(page):
    """Asked for together with another number: it shows that one's verdict; a refused scene has none."""
    for text, word in (("0", "✗ Unstable"), ("3", "✓ Stable")):
        with page.expect_download() as download:
            page.evaluate("""text => {
                const input = document.getElementById("value-omega3_0");
                input.value = text;
                input.dispatchEvent(new Event("input"));
                document.querySelector("[data-copy=svg]").click();
            }""", text)
        texts = download.value.path().read_text(encoding="utf-8")
        assert f">{word}</text>" in texts and f"omega3_0\xa0=\xa0{text}<" in texts
    typed(page, "value-I1", "-1")
    page.click("[data-copy=svg]")
    page.wait_for_selector("#said:has-text('no picture')")


@pytest.mark.parametrize("text", TEXTS)
def test_a_picture_of_hostile_texts_is_xml(started, text):
    """What is typed stands in it as a text."""
    root = ElementTree.fromstring(started.evaluate("""async text => {
        const { svg } = await import("/sources/views/picture.js");
        return svg({ title: text, line: text, verdict: { text, colour: text, more: text }, views: [],
            numbers: [text], key: [{ text, colour: text }],
            inks: { ink: text, quiet: text, line: text, paper: text } });
    }""", text))
    assert {one.tag.split("}")[1] for one in root.iter()} == {"svg", "title", "rect", "text"}


@pytest.mark.parametrize("number", [0, 4, 8, 9])
def test_paper(page, number):
    """One or two pages with scene, verdict, numbers, conditions and colours; no buttons, no fields."""
    picked(page, number)
    drawn(page)
    pdf = PdfReader(io.BytesIO(page.pdf(prefer_css_page_size=True)))
    assert len(pdf.pages) <= 2
    text = normalize("NFKC", re.sub(r"\s+", " ", " ".join(one.extract_text() for one in pdf.pages)))
    numbers = ", ".join(f"{name} = {value}" for name, value in page.evaluate(NUMBERS).items())
    title, verdict = page.inner_text("#example option:checked"), page.inner_text(".badge")[2:]
    for part in (title, verdict, numbers, "Conditions", "Necessary:", "Sufficient:"):
        assert part in text, part
    for part in ("Copy link", "Potential:", "Pause", "Across"):
        assert part not in text, part


def test_back_leads_to_the_scene_before(stranger, address):
    """Across five scenes with their numbers, and forward; one more Back leaves the page."""
    page = stranger.new_page()
    page.goto(address)
    shown(page)
    visited = []
    for number, value in ((0, "1.25"), (3, "7/4"), (9, "0.3"), (5, "2*sqrt(2)"), (6, "3")):
        picked(page, number)
        assert typed(page, "value-I1", value)[1] == ""
        page.wait_for_function("""value =>
            location.hash.includes(new URLSearchParams({ set: `I1=${value}` }))""", arg=value)
        visited.append(page.evaluate(SCENE))
    ways = [(page.go_back, there) for there in visited[-2::-1]]
    ways += [(page.go_forward, there) for there in visited[1:]]
    for go, there in ways:
        go()
        shown(page)
        assert page.evaluate(SCENE) == there
    for there in visited[-2::-1]:
        page.go_back()
        shown(page)
        page.wait_for_timeout(1000)                      # the address of what is shown is written by then
        assert page.evaluate(SCENE) == there
    page.go_back()
    assert page.url == "about:blank"


def test_a_text_that_is_typed_is_one_scene_before(stranger, address):
    """Letter by letter; an equilibrium that is picked is another."""
    page = stranger.new_page()
    page.goto(address)
    shown(page)
    before, length = page.evaluate(SCENE), page.evaluate("history.length")
    page.click("#asked > summary")
    page.focus("#potential")
    page.keyboard.press("End")
    page.keyboard.type(" - k3^2", delay=120)
    shown(page)
    typed_in = page.evaluate(SCENE)
    page.wait_for_timeout(500)
    page.check("input[value=E2]")
    shown(page)
    page.wait_for_timeout(500)
    assert page.evaluate("history.length") == length + 2
    for there in (typed_in, before):
        page.go_back()
        shown(page)
        assert page.evaluate(SCENE) == there
