"""Each answer on the page stands beside its own question, however fast the questions change."""
import html
import json
import os
import re
from collections import Counter
from functools import lru_cache
from math import cos, sin
from pathlib import Path
from random import Random
from urllib.parse import parse_qs, urlsplit

import pytest
import session
from browser.driving import AGREE, cells, picked, pixels

from gyrostat import trajectories
from gyrostat.algebra.text.numbers import exact_number
from gyrostat.mechanics.scenes.system import names_of_scene
from gyrostat.questions.page.chosen import chosen

CHANGES = int(os.environ.get("GYROSTAT_CHANGES", "200"))
VISITOR = Path(__file__).with_name("visitor.js").read_text(encoding="utf-8")
# a field of some seconds; names of JavaScript's own objects; capitals; what is refused
FIELDS = ["m0*k3", "m0*k3 + m1*k3^2", "k3^4 - c*k3^2/2", "constructor*k3", "M0*k3", "m0*", "U(k3)", "",
          "toString*k3 + valueOf*k3^2", "__proto__*k3", "exp(-1/(1-k3))", "c1*k1 + c3*k3", "sqrt(1 - k3)",
          "+".join(f"a{n}*(1+b{n}*k3)^{n}" for n in range(1, 6))]
NUMBERS = ["1", "1.25", "5/4", "0.3", "-2", "sqrt(2)", "0", "0x10", "1/0", "3 rpm", "2.5e-1", "-1/3", "4"]
LATE = "This took longer than 10 s"                    # on a machine that has other things to do
EMPTY = ([], "", ["No verdict", []])
BY_PAGE = ("no chart", "a picture needs numbers")


@lru_cache(maxsize=4000)
def asked(want, question, *more):
    """The library's answer, here, to what stands on the page."""
    return json.loads(session.answer(json.dumps({"want": want, "scene": table(question),
                                                 "more": list(map(json.loads, more))})))


def table(question):
    """The scene that the fields say."""
    said = json.loads(question)
    potential, orbit, inertia, momentum = said["texts"]
    (made, text), equilibrium = said["made"], said["equilibrium"]
    scene = {"inertia": listed(inertia), "gyrostatic_momentum": listed(momentum), "spin": said["spin"],
             "values": said["values"]}
    scene |= {name: text for name, text in (("potential", potential), ("orbit", orbit)) if text.strip()}
    if equilibrium == "point":
        return {**scene, "point": listed(text)}
    if made and text.strip():
        scene[made] = text
    return {**scene, "equilibrium": equilibrium} if equilibrium else scene


def listed(text):
    rows = [[entry.strip() for entry in row.split(",")] for row in text.split(";")]
    return rows if len(rows) > 1 else rows[0]


def says(link, question):
    """Whether a link has the fields and numbers of the page."""
    said, found = json.loads(question), parse_qs(urlsplit(link).fragment, keep_blank_values=True)
    fields = [found[name][0] for name in ("potential", "orbit", "inertia", "gyrostatic_momentum")]
    numbers = dict(each.split("=", 1) for each in found.get("set", ()))
    return fields == said["texts"] and found["spin"] == [said["spin"]] and (
        said["values"].items() <= numbers.items())


def formulas(blocks):
    """Those of some blocks, in their order."""
    found = []
    for block in blocks:
        cells = [cell for row in block.get("rows", ()) for cell in row] + [block.get("sentence", [])]
        found += [block["display"]] if "display" in block else []
        found += [part["tex"] for cell in cells for part in cell if "tex" in part]
    return found


def right(what, question, answer):
    """Whether an answer that was seen is that of the question beside which it was seen."""
    analysed = asked("analysed", question)
    error = analysed.get("error", "")
    if what == "error":
        return answer == error
    if what == "conditions":
        return answer == ([] if error else formulas(analysed.get("conditions", ())))
    if what == "names":
        return answer == [name["name"] for name in analysed.get("names", ())]
    decided = {} if error else asked("decided", question)
    if what == "wrong":
        return answer == decided.get("error", "")
    if what == "verdict":
        return answer == shown(decided)
    if what == "here":
        return "verdict" in decided and answer.endswith(f": {decided.get('verdict', '').lower()}") and all(
            json.loads(question)["values"].get(name) == text
            for name, text in (part.split(" = ") for part in answer.rpartition(":")[0].split(", ")))
    if what == "copied":
        frame = re.search('src="([^"]+)"', answer)
        linked = frame[1] if answer.startswith("<iframe") else answer
        return says(html.unescape(linked), question) if linked.startswith("http") else (
            answer in asked("copied", question).values())
    if what in ("between", "blocks"):
        found = asked("opened" if what == "between" else "derived", question)
        return answer == formulas(found.get("blocks", ()))
    axes, told = answer
    found = {"why": error} if error else asked("charted", question, json.dumps(axes))
    if what == "no-chart":
        return told == found.get("why", found.get("error")) or told.startswith(BY_PAGE)
    assert what == "chart", what
    return "steps" in found and [name for name, low, _ in told["ranges"] if low] == axes and all(
        verdict in AGREE[word] for word, verdict, _ in pixels(report(question), told))


def shown(decided):
    """The badge, and the formulas of the reasons."""
    if "verdict" in decided:
        sign = {"STABLE": "✓", "UNSTABLE": "✗", "UNDECIDED": "?"}[decided["verdict"]]
        return [f"{sign} {decided['verdict'].capitalize()}", formulas(decided["blocks"])]
    if "found" in decided:
        count = len(decided["found"])
        return [f"{count} equilibri{'um' if count == 1 else 'a'}",
                formulas(block for each in decided["found"] for block in each["blocks"])]
    return ["No verdict", []]


def report(question):
    return chosen(table(question)).report


def moves(question, answer):
    """Whether a motion is that of the library, from the equilibrium turned as the page says."""
    more, push, told = answer
    if not told:                                       # a body without a motion
        return "why" in asked("moving", question) or "rates" not in asked("moving", question)
    eq = report(question).equilibrium
    point, texts = [eq.insert(x) for x in eq.point], {**json.loads(question)["values"], **more}
    needed = names_of_scene(eq.system).union(*(x.free_symbols for x in point))
    values = {name: exact_number(texts[name.name], name.name) for name in needed if name.name in texts}
    state = [float(x.subs(values)) for x in point]
    near = [abs(x) for x in state[-3:]]
    turned = state[:3] if len(state) > 3 else []
    for n in range(len(turned), len(state), 3):
        turned += rotated(state[n:n + 3], near.index(min(near)), float(push))
    time, vector = told.removeprefix("t = ").split(": ")
    known = {name.name: value for name, value in values.items() if name in names_of_scene(eq.system)}
    there = trajectories.motion(eq.system, turned, known)([float(time)])[0][-3:].tolist()
    seen = [float(x) for x in vector.split("= (")[1].rstrip(")").split(", ")]
    return seen == pytest.approx(there, abs=1e-5)


def rotated(vector, axis, angle):
    """About one of the axes."""
    (x, y, z), c, s = vector, cos(angle), sin(angle)
    return [[x, c * y - s * z, s * y + c * z], [c * x + s * z, y, c * z - s * x],
            [c * x - s * y, s * x + c * y, z]][axis]


PLACES = [(Random("places").randrange(400), y) for y in range(7, 400, 49)]


@pytest.mark.parametrize("seed", range(max(1, CHANGES // 200)))
def test_an_answer_is_shown_only_beside_its_question(page, context, seed):
    """Fields, numbers, examples, equilibria, axes change at random moments, while the library computes too.

    GYROSTAT_CHANGES is how often, 200 by default.
    """
    errors = len(context.errors)
    cells(page)
    found = page.evaluate(VISITOR, {"seed": seed, "changes": min(CHANGES, 200), "fields": FIELDS,
                                    "numbers": NUMBERS, "places": PLACES})["seen"]
    late = {question for question, _, answer in found if str(answer).startswith(LATE)}
    strange = [(what, question, answer) for question, what, answer in found
               if what != "motion" and not right(what, question, answer)
               and not (question in late and (answer in EMPTY or str(answer).startswith(LATE)))]
    assert not strange, (Counter(what for what, *_ in strange), strange[:3])
    motions = [(question, answer) for question, what, answer in found if what == "motion"]
    for question, answer in Random(seed).sample(motions, min(len(motions), 30)):
        try:
            assert moves(question, answer), (question, answer)
        except LookupError:
            raise AssertionError((question, answer)) from None
    count = Counter(what for _, what, _ in found)
    assert count["verdict"] > 20 and count["chart"] > 5 and count["motion"] > 9, count
    assert context.errors[errors:] == [] and picked(page, 1)[1] == ""
