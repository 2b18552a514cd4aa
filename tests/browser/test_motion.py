"""The motion nearby, against the library's motions."""
import json
from fractions import Fraction
from math import cos, sin
from pathlib import Path
from random import Random

import pytest
import session
from browser.driving import picked, typed

import gyrostat as gs
from gyrostat.mechanics.scenes.system import names_of_scene
from gyrostat.questions.page.chosen import chosen
from gyrostat.questions.page.programs import steps_to

EXAMPLES = json.loads((Path(session.__file__).parent / "examples.json").read_text(encoding="utf-8"))
FIELDS = ["m0*k3", "k3^4 - k3^2/2", "m0*k3 + m1*k3^2", "exp(k3)*m0", "c1*k1 + c3*k3", "m0*k3 + m1*k1*k2",
          "none", "sin(k3) + sqrt(k3 + 2)", "log(k3 + 3)/(k1 + 4)"]
TIMES = [0.5, 2.5, 10]
FOLLOW = """async (given) => {
    const { compiled } = await import("./numerics/programs.js");
    const { Motion } = await import("./numerics/integrator.js");
    return given.map(({ rates, coordinates, numbers, state }) => {
        const run = compiled(rates);
        const motion = new Motion(x => run({ ...numbers, ...Object.fromEntries(coordinates.map((name, i) =>
            [name, x[i]])) }), state);
        return [0.5, 2.5, 10].map(time => motion.at(time));
    });
}"""


def scenes(count):
    """Bodies, fields of every kind of function, states that are not near anything."""
    rng = Random("motions")

    def number(low, high):
        return Fraction(rng.randint(20 * low, 20 * high), 20)

    for n in range(count):
        field, (a, b, c) = FIELDS[n % len(FIELDS)], (number(1, 2) for _ in range(3))
        values = {name: str(number(-1, 1)) for name in ("m0", "m1", "c1", "c3") if name in field}
        table = {"potential": field, "inertia": [str(a), str(b if n % 3 else a), str(c)],
                 "gyrostatic_momentum": ["0", "0", str(number(-1, 1))]}
        k = rng.choice([(3, 0, 4, 5), (2, -1, 2, 3), (2, 3, 6, 7)])
        state = [number(-1, 1), number(-1, 1), number(-2, 2), *(Fraction(x, k[3]) for x in k[:3])]
        yield table, values, state[:3 if field == "none" else 6]


def test_motions_are_those_of_the_library(page):
    """To 1e-9, 50 of them."""
    given, expected = [], []
    for table, values, state in scenes(50):
        scene = chosen(table).scene
        given.append({"rates": steps_to(scene.vector_field()), "state": [float(x) for x in state],
                      "coordinates": [x.name for x in scene.space.coordinates],
                      "numbers": {name: float(Fraction(text)) for name, text in values.items()}})
        expected.append(gs.trajectories.motion(scene, [float(x) for x in state], values)(TIMES).tolist())
    for there, here in zip(page.evaluate(FOLLOW, given), expected, strict=True):
        for state, same in zip(there, here, strict=True):
            assert state == pytest.approx(same, rel=0, abs=1e-9)


@pytest.mark.parametrize("number, state", [
    (0, (0, 0, 2.4, 0, -sin(0.1), cos(0.1))),            # upright, k turned about axis 1
    (5, (0, 2 * cos(0.1), 2 * sin(0.1)))])               # free, π turned about axis 1
def test_what_is_read_is_on_the_path(page, number, state):
    """The vector that is shown is that of the library at the time that is shown."""
    picked(page, number)
    page.locator("#motion").scroll_into_view_if_needed()
    page.evaluate("""() => { const push = document.getElementById("push");
        push.value = 0.1; push.dispatchEvent(new Event("input")); }""")
    page.wait_for_timeout(1500)
    time, vector = page.inner_text("#state").removeprefix("t = ").split(": ")
    scene, values = chosen(EXAMPLES[number]["scene"]).scene, EXAMPLES[number]["scene"]["values"]
    known = {str(name) for name in names_of_scene(scene)}
    motion = gs.trajectories.motion(scene, state, {name: values[name] for name in values if name in known})
    there = [float(x) for x in vector.split("= (")[1].rstrip(")").split(", ")]
    assert float(time) > 0.1 and there == pytest.approx(motion([float(time)])[0][-3:].tolist(), abs=1e-5)


def test_a_motion_that_there_is_not_is_said(page):
    """A field that is not given; a number that is none."""
    picked(page, 1)
    page.wait_for_selector("#no-motion:has-text('needs a field that is given')")
    assert page.is_visible("#motion") and page.inner_text("#state") == ""     # the body is drawn at rest
    picked(page, 0)
    page.wait_for_selector("#motion:visible")
    assert "number" in typed(page, "value-I1", "two")[1]
    assert "a motion needs numbers" in page.inner_text("#no-motion") and page.is_hidden("#motion")
