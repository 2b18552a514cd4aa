"""Scenes as the page is asked for them, drawn: bodies, fields of degree 1 to 4, equilibria, satellites."""
import random

LETTERS = ("a", "b", "c")
NAMES = (*LETTERS, "l", "l1", "l2", "l3", "M", "omega", "omega0", "omega1_0", "omega2_0", "omega3_0", "pi3_0",
         "sigma", "dU", "d2U", *(f"d2U_{ij}" for ij in ("11", "12", "13", "22", "23", "33")))


def drawn_scene(index):
    """Scene number index, with numbers for all its names; a sixth is of each kind."""
    chance = random.Random(f"scene:{index}")
    table = (_axial, _general, _unspecified, _free, _rotation, _satellite)[index % 6](chance)
    values = {name: _number(chance, 4, 8) for name in ("I1", "I2", "I3")}
    values |= {name: _number(chance, 1, 12) for name in NAMES}
    k3 = chance.choice([4, -4]) if "k1" in table["potential"] else chance.randint(-3, 3)
    return {**table, "values": {**values, "k1": "3/5", "k2": "0", "k3": f"{k3}/5"}}


def _number(chance, low, high):
    kind = chance.random()
    if kind < 0.15:
        return f"{chance.randint(low, high) / 4}"
    return f"{chance.randint(low, high)}/4" if kind < 0.9 else f"sqrt({chance.randint(2, 7)})/2"


def _body(chance, three):
    inertia = ["I1", "I2", "I3"] if three else ["I1", "I1", "I3"]
    momentum = chance.choice([["0", "0", "l"], ["0", "0", "0"], ["0", "0", "1/2"]])
    return {"inertia": inertia, "gyrostatic_momentum": momentum}


def _polynomial(chance, variables, degree):
    terms = []
    for n in range(1, degree + 1):
        factors = "*".join(chance.choice(variables) for _ in range(n))
        factor = chance.choice([*LETTERS, "1/2", "-3", "0.7", "sqrt(2)"])
        terms.append(f"{factor}*{factors}")
    return " + ".join(terms)


def _axial(chance):
    field = _polynomial(chance, ["k3"], chance.randint(1, 4))
    return {"potential": field, **_body(chance, False), "equilibrium": chance.choice(
        ["E1", "E2", "E3", "every k3"]), "spin": chance.choice(["pi3_0", "omega3_0"])}


def _general(chance):
    field = _polynomial(chance, ["k1*k1", "k2*k2", "k1*k2", "k3"], chance.randint(1, 2))
    return {"potential": field, **_body(chance, True), "equilibrium": chance.choice(["E1", "E2"]),
            "spin": chance.choice(["pi3_0", "omega3_0"])}


def _unspecified(chance):
    field = chance.choice(["U(k3)", "U(k3)", "U(k1,k2,k3)"])
    return {"potential": field, **_body(chance, "k1" in field),
            "equilibrium": chance.choice(["E1", "E2", "permanent-rotation" if "k1" in field else "E3"])}


def _free(chance):
    body = _body(chance, chance.random() < 0.8)
    if chance.random() < 0.3:
        body["gyrostatic_momentum"] = ["l1", "l2", "l3"]
        return {"potential": "none", **body, "equilibrium": "every M"}
    return {"potential": "none", **body, "equilibrium": f"axis {chance.choice([1, 2, 3, 3])}"}


def _rotation(chance):
    field = " + ".join(f"{c}*k{n}" for n, c in enumerate(LETTERS, 1))
    if chance.random() < 0.3:
        return {"potential": "a*k1 + b*k3", **_body(chance, True), "equilibrium": "every omega"}
    direction = chance.choice([{}, {"direction": "3/5, 0, 4/5"}, {"direction": ["0", "-5/13", "12/13"]}])
    return {"potential": field, **_body(chance, True), "equilibrium": "permanent-rotation", **direction}


def _satellite(chance):
    axes = chance.sample([1, 2, 3], 3)
    momentum = ["0", "0", "0"]
    momentum[axes[1] - 1] = chance.choice(["l", "0", "1/3"])
    pointing = ", ".join(str(axis * chance.choice([1, 1, -1])) for axis in axes)
    asked = chance.choice([{"equilibrium": "earth-pointing", "pointing": pointing}, {"equilibrium": "every"}])
    return {"potential": "none", "orbit": chance.choice(["omega0", "1", "1/10"]), **asked,
            "inertia": ["I1", "I2", "I3"], "gyrostatic_momentum": momentum}
