"""What a visitor does on the page, and what it then shows."""
from fractions import Fraction

from gyrostat.errors import GyrostatError

SLOW = "+".join(f"a{n}*(1+b{n}*k3)^{n}" for n in range(1, 30))   # longer than the page waits
# of each colour of a chart the verdicts that the library may give there
AGREE = {"stable": {"STABLE"}, "unstable": {"UNSTABLE"}, "open": {"STABLE", "UNSTABLE", "UNDECIDED"},
         "nowhere": {"NOWHERE"}}


def shown(page):
    """The word of the verdict and what is refused, when the page has answered."""
    page.wait_for_selector("body[aria-busy=false]")
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


def pixels(report, places, drawn):
    """Of each pixel that has a colour of the key: its word, what the library says, and its numbers.

    The library says NOWHERE if it refuses the numbers.
    """
    words = dict(drawn["key"])
    for place, colour in zip(places, drawn["colours"], strict=True):
        word = words.get(colour, "unknown")              # else the cross, or a dot
        if word == "unknown":
            continue
        shares = (place[0] + 0.5) / 400, (399 - place[1] + 0.5) / 400
        values = {name: text for name, text in drawn["values"].items() if name in report.required}
        for (name, low, high), share in zip(drawn["ranges"], shares, strict=True):
            values[name] = str(Fraction(float(low) + (float(high) - float(low)) * share))
        try:
            yield word, report.verdict(values).verdict.name, values
        except GyrostatError:
            yield word, "NOWHERE", values
