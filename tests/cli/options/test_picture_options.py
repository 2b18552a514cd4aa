"""The file of a picture: its kind, its width, its dots per inch, and no title."""
import re
from contextlib import nullcontext

import matplotlib
import pytest
from PIL import Image

from gyrostat.cli.parser import main

CONES = ["cones", "--set=I1=2", "--set=I3=1", "--transverse", "1", "--axial", "2"]


@pytest.mark.slow
@pytest.mark.parametrize(("size", "across"), [
    ([], 1020), (["--width", "86mm"], 1016), (["--width", "2", "--dpi", "100"], 200),
    (["--width", "17 cm", "--dpi", "72"], 482)])
@pytest.mark.parametrize("kind", ["png", "jpg"])
def test_a_picture_is_as_wide_as_asked(tmp_path, kind, size, across):
    """In dots: inches, or mm and cm of 25.4 and 2.54 an inch, times the dots per inch."""
    path = tmp_path / f"picture.{kind}"
    assert main(["plot", *CONES, *size, "--output", str(path)]) == 0
    with Image.open(path) as image:
        assert across - 1 <= image.width <= across and image.format == {"png": "PNG", "jpg": "JPEG"}[kind]


@pytest.mark.slow
def test_vectors_are_as_wide_as_asked(tmp_path):
    """In points, 72 an inch."""
    for kind, pattern in (("svg", r'<svg[^>]* width="([\d.]+)pt"'), ("pdf", r"/MediaBox \[ *0 0 ([\d.]+) ")):
        path = tmp_path / f"picture.{kind}"
        assert main(["plot", *CONES, "--width", "5", "--output", str(path)]) == 0
        (points,) = re.findall(pattern, path.read_text(encoding="latin-1"))
        assert float(points) == pytest.approx(360)


@pytest.mark.slow
def test_format_without_title(tmp_path, monkeypatch):
    """A file without a suffix is of the kind asked for, and the title is not on it."""
    texts = {}
    monkeypatch.setitem(matplotlib.rcParams, "svg.fonttype", "none")       # letters stay letters
    monkeypatch.setattr("gyrostat.cli.verbs.plot.printed_look", nullcontext)
    for option in ("--format=svg", "--no-title"):
        path = tmp_path / f"with{option}"
        assert main(["plot", *CONES, "--format=svg", option, "--output", str(path)]) == 0
        texts[option] = path.read_text(encoding="utf-8")
    assert "space cone" in texts["--no-title"] and "body cone" in texts["--no-title"]
    assert texts["--format=svg"].count("<text") > texts["--no-title"].count("<text") > 4


@pytest.mark.slow
def test_a_chart_has_the_width_and_no_title(tmp_path, monkeypatch):
    """The options of pictures hold for charts, too; more dots than a picture may have are refused."""
    asked = ["chart", "--potential", "m0*k3", "--equilibrium", "E1", "--x", "pi3_0=-4:4:5", "--y", "l=-2:2:4",
             "--set", "I1=1", "m0=1/3"]
    widths, texts = {}, {}
    monkeypatch.setitem(matplotlib.rcParams, "svg.fonttype", "none")
    monkeypatch.setattr("gyrostat.cli.verbs.chart.printed_look", nullcontext)
    for more in ((), ("--no-title", "--width", "5")):
        path = tmp_path / f"chart{len(more)}.svg"
        assert main([*asked, *more, "--output", str(path)]) == 0
        texts[more] = path.read_text(encoding="utf-8")
        widths[more] = float(re.findall(r'<svg[^>]* width="([\d.]+)pt"', texts[more])[0])
    assert [*widths.values()] == pytest.approx([3.4 * 72, 360])
    with_title, without = texts.values()
    assert with_title.count("E1, ") == 1 and "E1, " not in without
    assert main([*asked, "--width", "40", "--dpi", "2400", "--output", str(tmp_path / "x.png")]) == 2


@pytest.mark.parametrize(("options", "why"), [
    (["--width", "0"], "0 is no width: give 1 to 40 inches"), (["--width", "-3"], "-3 is no width"),
    (["--width", "86 km"], "86 km is no width"), (["--width", "nan"], "nan is no width"),
    (["--width", "41"], "41 is no width"), (["--width", "1e400"], "1e400 is no width"),
    (["--dpi", "0"], "0 is no number of dots per inch: give a whole number, 20 to 2400"),
    (["--dpi", "72.5"], "72.5 is no number of dots"), (["--dpi", "99999999"], "is no number of dots"),
    (["--width", "40", "--dpi", "2400"], "is 96000 dots across: give a width and dpi of at most 12000"),
    (["--format", "gif"], "gif"), (["--format", "pdf"], "ends with .png, and --format is pdf")])
def test_an_impossible_file_is_refused(capsys, tmp_path, monkeypatch, options, why):
    """With what is possible, and nothing is written."""
    monkeypatch.chdir(tmp_path)
    try:
        status = main(["plot", *CONES, *options, "--output", "x.png"])
    except SystemExit as stop:
        status = stop.code
    assert status == 2 and why in capsys.readouterr().err and not list(tmp_path.iterdir())
