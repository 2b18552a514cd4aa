"""How what is stored of the pages is compared with what is made: docs/stored.py."""
import pytest
import stored
from matplotlib.figure import Figure
from matplotlib.text import Text
from PIL import Image


def picture(path, *styles):
    """Lines of some styles."""
    figure = Figure(figsize=(3, 2))
    ax = figure.add_subplot()
    for n, style in enumerate(styles):
        ax.plot([0, 1], [n, n + 1], style)
    figure.savefig(path)
    return path


@pytest.mark.slow
def test_one_line_of_a_picture_is_seen(tmp_path):
    """Drawn twice it is the same; another style of one line, a line more and another size are not."""
    first = picture(tmp_path / "first.png", "-", "--", ":")
    assert not list(stored.differences(first, picture(tmp_path / "again.png", "-", "--", ":")))
    for styles in (("-", "--", "-"), ("-", "--"), ("-", "--", ":", "-")):
        (said,) = stored.differences(first, picture(tmp_path / "other.png", *styles))
        assert "pixels differ" in said
    Image.open(first).resize((10, 10)).save(tmp_path / "size.png")
    (said,) = stored.differences(first, tmp_path / "size.png")
    assert "another size" in said


def test_every_frame_of_an_animation_is_compared(tmp_path):
    """The last of three, and one that is missing."""
    frames = [Image.new("RGB", (4, 4), (60 * n, 0, 0)) for n in range(4)]
    for name, chosen in (("stored", frames[:3]), ("other", [*frames[:2], frames[3]]), ("short", frames[:2])):
        chosen[0].save(tmp_path / f"{name}.gif", save_all=True, append_images=chosen[1:])
    (said,) = stored.differences(tmp_path / "stored.gif", tmp_path / "other.gif")
    assert said == "frame 2: 16 of 16 pixels differ"
    (said,) = stored.differences(tmp_path / "stored.gif", tmp_path / "short.gif")
    assert said.startswith("frame 2: another size")


def test_a_thumbnail_can_be_read(tmp_path):
    """At 200 pixels no letter is below 7 points, an axis has at most five ticks, and marks have no names."""
    figure = Figure(figsize=(7, 4))
    ax, other = figure.subplots(1, 2)
    ax.plot([0, 1], [0, 1], label="a line")
    ax.legend()
    ax.set_title("a title")
    ax.set_xlabel("$x$ $[\\mathrm{M}]$", fontsize=5)
    ax.annotate("a mark", (0.5, 0.5))
    stored.small(figure, tmp_path / "small.png")
    assert figure.axes == [ax] and ax.get_legend() is None and not ax.texts and not ax.get_title()
    assert ax.get_xlabel() == "$x$" and figure.get_size_inches()[0] * 96 == 200
    letters = [text for text in figure.findobj(Text) if text.get_text()]
    assert len(letters) > 4 and min(text.get_fontsize() for text in letters) >= 7
    assert max(len(axis.get_ticklocs()) for axis in (ax.xaxis, ax.yaxis)) <= 5
    with Image.open(tmp_path / "small.png") as image:
        assert image.width == stored.WIDTH


def shown(source, *texts):
    """What a cell shows that prints some texts."""
    return stored.outputs({"source": source, "outputs": [{"name": "stdout", "text": text} for text in texts]})


def test_an_output_of_a_notebook_is_compared_but_for_its_times():
    """In a cell that is timed the numbers before units are left out, and nothing else."""
    timed = "route()                     # times are those of this run"
    assert shown(timed, "fast: 12.5 ms, 3 wrong") == shown(timed, "fast: 9 ms, 3 wrong")
    assert shown(timed, "fast: 12.5 ms, 3 wrong") != shown(timed, "fast: 12.5 ms, 4 wrong")
    assert shown("route()", "period 5 s") != shown("route()", "period 6 s")
    assert shown("route()", "a", "b") != shown("route()", "a")
    for now, said in (("69 right", "stored is '63 right', made '69 right'"),
                      (None, "stored is '63 right', made 'nothing'")):
        assert list(stored.changes("stdout", "63 right", now)) == [said]


def test_a_picture_that_rounding_decides_is_not_compared():
    """Its texts are, as those of any other cell."""
    def made(source, picture, text="3 wrong"):
        return stored.outputs({"source": source, "outputs": [
            {"data": {"image/png": picture}}, {"name": "stdout", "text": text}]})

    rounds = "draw()      # rounding decides these curves"
    assert made(rounds, "one") == made(rounds, "other") and made("draw()", "one") != made("draw()", "other")
    assert made(rounds, "one") != made(rounds, "one", "4 wrong")
