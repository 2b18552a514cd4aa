"""What a visitor does on the page, and what it then shows."""
from fractions import Fraction

from gyrostat.errors import GyrostatError

SLOW = "+".join(f"a{n}*(1+b{n}*k3)^{n}" for n in range(1, 30))   # longer than the page waits
# of each colour of a chart the verdicts that the library may give there
AGREE = {"stable": {"STABLE"}, "unstable": {"UNSTABLE"}, "open": {"STABLE", "UNSTABLE", "UNDECIDED"},
         "nowhere": {"NOWHERE"}}


def shown(page):
    """The word of the verdict and what is refused, when the page has answered."""
    page.wait_for_selector("body[aria-busy=false]:has(#early[hidden])")
    return page.inner_text(".badge").split()[-1], page.inner_text("#error") + page.inner_text("#wrong")


def picked(page, number):
    """An example."""
    page.select_option("#example", str(number))
    return shown(page)


def typed(page, field, text):
    """A text in a field of the scene, or of a number."""
    page.fill(f"#{field}", text)
    return shown(page)


def latex(page, place):
    """The formulas shown there, as they are written."""
    return page.eval_on_selector_all(f"#{place} annotation", "all => all.map(one => one.textContent)")


def slid(page, name, number):
    """A slider is moved to the step that is nearest to a number."""
    page.evaluate("""async ([name, number]) => {
        const { stepOf } = await import("/sources/views/scales.js");
        const row = document.getElementById(`value-${name}`).closest(".value");
        const slider = row.querySelector("[type=range]"), { low, high } = row.dataset;
        slider.value = stepOf([Number(low), Number(high)], number);
        slider.dispatchEvent(new Event("input"));
    }""", [name, number])
    return shown(page)


def at(page, across, upwards):
    """Where numbers of the two axes are on the chart, in pixels from its corner."""
    x, y = page.evaluate("""async (point) => {
        const { placed } = await import("/sources/views/plot.js");
        const ends = ["across", "upwards"].map((id) => document.getElementById(id).value).map((name) => {
            const { low, high } = document.getElementById(`value-${name}`).closest(".value").dataset;
            return [Number(low), Number(high)];
        });
        return placed(document.getElementById("chart").clientWidth, ends, point);
    }""", [across, upwards])
    return {"x": x, "y": y}


def cells(page):
    """Lets the page say which colour some of the 400 × 400 regions of its chart have on the screen.

    A pixel of the screen is of the region in which its centre is; "" if that is too near to another one.
    """
    page.evaluate("""async () => {
        const { frame } = await import("/sources/views/plot.js");
        window.cells = (places) => {
            const canvas = document.getElementById("chart"), sharp = devicePixelRatio;
            const { left, top, side } = frame(canvas.clientWidth), { width, height } = canvas;
            const { data } = canvas.getContext("2d").getImageData(0, 0, width, height);
            return places.map((place) => {
                const corner = [left, top];
                const pixel = place.map((x, n) => Math.floor((corner[n] + (x + 0.5) / 400 * side) * sharp));
                const cell = pixel.map((x, n) => ((x + 0.5) / sharp - corner[n]) / side * 400);
                const first = 4 * (pixel[1] * width + pixel[0]);
                const colour = cell.every((x) => Math.abs(x - Math.round(x)) > 0.01)
                    ? data.slice(first, first + 3).join() : "";
                return [...cell.map(Math.floor), colour];
            });
        };
    }""")


def pixels(report, drawn):
    """Of each pixel that has a colour of the key: its word, what the library says, and its numbers.

    The library says NOWHERE if it refuses the numbers.
    """
    words = dict(drawn["key"])
    for x, y, colour in drawn["cells"]:
        word = words.get(colour, "unknown")              # else the ring, or a dot
        if word == "unknown":
            continue
        shares = (x + 0.5) / 400, (399 - y + 0.5) / 400
        values = {name: text for name, text in drawn["values"].items() if name in report.required}
        for (name, low, high), share in zip(drawn["ranges"], shares, strict=True):
            values[name] = str(Fraction(float(low) + (float(high) - float(low)) * share))
        try:
            yield word, report.verdict(values).verdict.name, values
        except GyrostatError:
            yield word, "NOWHERE", values
