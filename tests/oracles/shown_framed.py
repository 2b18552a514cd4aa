"""Whether what is shown of satellites, bodies in two fields and vehicles is so, from the output alone."""
import mpmath as mp
import orbital_search
from framed import Framed
from reread import Texts

KEYS = {"orbit", "directions", "vehicle"}
SMALL = mp.mpf(10) ** -15
CURVE = "not finite: there is a closed curve of equilibria"


def is_true(statement, scene, shown, weaker):
    """As shown.is_true."""
    with mp.workdps(40):
        numbers = {name: Texts({}).value(text, None) for name, text in shown["values"].items()}
        plain = Texts(numbers)
        if any(abs(plain.value(text, None) - numbers[name]) > 1e-25
               for name, text in statement["at"].items() if name in numbers):
            return False
        body = Framed(scene, numbers, statement["let"].items())
        if not all(body.value(text, body.start) for text in (scene.get("given"), statement["given"]) if text):
            return False
        kind = statement["kind"]
        if kind == "count":
            return _counted(body, statement)
        if kind == "equilibrium":
            return mp.norm(body.field(list(body.value(statement["printed"], body.start)))) > SMALL
        if kind in ("condition", "statement"):
            return _fails(body, statement) != weaker
        sides = [body.value(statement[name], body.start) for name in ("printed", "quantity")]
        if kind == "number":
            digits = len(statement["printed"].partition(".")[2])
            return abs(sides[0] - sides[1]) > mp.mpf(10) ** -digits / 2
        if statement["entry"]:
            sides = [side[statement["entry"][0] - 1, statement["entry"][1] - 1] for side in sides]
        return abs(sides[0] - sides[1]) > SMALL * (1 + abs(sides[1]))


def _fails(body, statement):
    claim, printed = statement["quantity"], statement["printed"]
    if claim.endswith("internal damping"):
        return body.value(printed, body.start) and min(body.squares(False)) < -SMALL
    sign = body.stability()
    if claim == "stability":
        return sign == (1 if printed == "unstable" else -1)
    says = printed != "never" and body.value(printed.replace("\n", " "), body.start)
    if claim.endswith("spectral stability"):
        return says != (sign != -1)
    return not says and sign == 1 if claim.startswith("necessary") else says and sign == -1


def _counted(body, statement):
    found = orbital_search.search([body.tensor[i, i] for i in range(3)], body.rotor, body.rate)
    negative = []
    for place in found:
        body.start = [mp.mpf(0)] * 3 + [mp.mpf(x) for x in place]
        squares = body.squares(False)
        negative.append(None if min(map(abs, squares)) < 1e-6 else sum(x < 0 for x in squares))
    asked, printed = ([x] if isinstance(x, str) else x for x in (statement["quantity"], statement["printed"]))
    if None in negative:
        return printed != [CURVE]
    return printed != [str(len(found) if name == "equilibria" else negative.count(int(name[-1])))
                       for name in asked]
