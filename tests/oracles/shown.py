"""Whether the numbers shown against a printed formula or claim show what they are shown for.

From the output alone. No gyrostat here.
"""
from fractions import Fraction

import damped
import held
import mpmath as mp
import oracle
import refuted
import reread
import rotating
import shown_framed
import turned


def is_true(statement, scene, shown, weaker=False):
    """True or False; None where nothing here reads that kind.

    Parameters
    ----------
    statement : dict
        quantity, printed, kind, let, at, given, and the entry (from 1) where the sides of a matrix differ, or
        None
    scene : dict
        the table of the file
    shown : dict
        counterexample or not_sharp of the JSON output
    weaker : bool
        the claim does not fail there
    """
    values, kind = shown["values"], statement["kind"]
    if shown_framed.KEYS & scene.keys():
        return shown_framed.is_true(statement, scene, shown, weaker)
    if kind not in ("condition", "statement"):
        return (
            not weaker
            and _inserted(statement, values)
            and differs(statement, scene, {**statement["at"], **values})
        )
    # of k, which has a unit length, one component may be a root: the others say as much
    v = {name: Fraction(text) for name, text in values.items()
         if name not in ("k1", "k2") or "sqrt" not in text}
    texts = [t for t in (scene.get("given", ""), statement["given"]) if t]
    own, plain = Own(v, statement["let"], scene), Own(v, {}, scene)
    if not all(compared(t, plain) for t in texts) or not _inserted(statement, values):
        return False
    if statement["quantity"] == "second variation, Casimirs alone":
        return None
    fails = _fails(statement, scene, v, own)
    return None if fails is None else fails != weaker


def _inserted(statement, values):
    """Whether what is inserted has been inserted."""
    with mp.workdps(40):
        n = {name: reread.Texts({}).value(text, None) for name, text in values.items()}
        return all(abs(reread.Texts(n).value(text, None) - n[name]) < 1e-25
                   for name, text in statement["at"].items() if name in n)


def differs(statement, scene, numbers):
    """Whether the two sides of a formula differ at numbers, which are texts, and what is given holds there.
    """
    kind, printed, entry = statement["kind"], statement["printed"], statement["entry"]
    with mp.workdps(40):
        n = {name: reread.Texts({}).value(text, None) for name, text in numbers.items()}
        if not all(reread.Texts(n).value(text, None)
                   for text in (scene.get("given"), statement["given"]) if text):
            return False
        world = (turned.Turning if "angles" in scene else reread.Motion)(scene, n, statement["let"].items())
        if kind == "solution":
            return _leaves(world, statement["quantity"], printed, n, entry)
        if kind == "equilibrium":
            return max(map(abs, world.field(list(world.value(printed, world.start))))) > 1e-15
        sides = [world.value(text, world.start) for text in (printed, statement["quantity"])]
        if kind == "number":
            return abs(sides[0] - sides[1]) > mp.mpf(10) ** -len(printed.partition(".")[2]) / 2
        if entry:
            sides = [side[entry[0] - 1, entry[1] - 1] for side in sides]
        # of 40 digits, differences keep 20; D4 needs none
        least = 1e-18 if statement["quantity"] == "D4" else 1e-15
        return abs(mp.im(sides[0])) > 0 or abs(sides[0] - sides[1]) > least * (1 + abs(sides[1]))


def _leaves(world, quantity, printed, n, entry):
    """Whether printed functions are no solution: at a time, or because a start is not reached."""
    texts = reread.Texts(n, world.let)

    def at(t):
        texts.numbers = {**n, "t": t}
        return [texts.value(text, None) for text in printed]

    if not entry:
        return any(abs(world.base(name, world.start) - f) > 1e-15 for name, f in zip(quantity, at(mp.mpf(0))))
    turn = [m if quantity[0].startswith("omega") else 1 for m in world.inertia]
    t, i = n.get("t", mp.mpf(0)), entry[0] - 1
    if any(mp.im(f) for f in at(t)):
        return True
    field = world.field([m * f for m, f in zip(turn, at(t))])[i] / turn[i]
    return abs(mp.diff(lambda s: at(s)[i], t) - field) > 1e-15 * (1 + abs(field))


class Own(dict):
    """Numbers by name, with abbreviations, each of which may use those before it, and p, q of the differenced
    field.
    """

    def __init__(self, numbers, let, scene):
        super().__init__(numbers)
        self.numbers, self.scene = numbers, scene
        for name, text in let.items():
            self[name] = refuted.value(text, self)

    def __missing__(self, name):
        if name in ("p", "q"):
            return _spectrum(self.scene, self.numbers)[name == "q"]
        return refuted.stability(scene_of(self.scene), self.numbers)[1][name]


def _spectrum(scene, v):
    """p and q of λ⁴ + p λ² + q."""
    if "k1" in scene["potential"]:
        return held.spectrum(scene, v)
    label, coefficients = scene_of(scene)
    names = refuted.stability((label, coefficients), v)[1]
    if label == "E3":
        second = (
            v.get("d2U", Fraction(0))
            if coefficients is None
            else refuted.derivative(coefficients(v), 2, names["k3"])
        )
        x, field = oracle.inclined(v["I1"], v["I3"], v.get("l", 0), v["omega"], (v["k1"], v["k2"], v["k3"]),
                                   second)
    else:
        spin = v["pi3_0"] if "pi3_0" in v else v["I3"] * v["omega3_0"]
        x, field = oracle.vertical(v["I1"], v["I3"], v.get("l", Fraction(0)), spin,
                                   {"E1": 1, "E2": -1}[label], names["dU"], Fraction(0))
    c = oracle.characteristic(oracle.jacobian(field, x))
    return c[2], c[4]


def scene_of(table):
    """Label, and the coefficients of U(k3) at numbers, or None where U is not given."""
    U = table.get("potential")
    label = table.get("equilibrium")
    return label, None if U in (None, "none", "U(k3)") else lambda v: _coefficients(U, v)


def _coefficients(text, v, size=5):
    """Of a polynomial of degree below size, in powers of k3, through its values at 0, 1, 2, …"""
    points = [Fraction(i) for i in range(size)]
    rows = [refuted.value(text, {**v, "k3": x, "k1": Fraction(0), "k2": Fraction(0)}) for x in points]
    found = [Fraction(0)] * size
    for i, x in enumerate(points):
        basis = [Fraction(1)]
        for y in (y for y in points if y != x):
            basis = oracle.product(basis, [-y / (x - y), 1 / (x - y)])
        found = [a + rows[i] * b for a, b in zip(found, basis)]
    return found


def compared(text, own):
    """A text of comparisons joined by and."""
    return text != "never" and refuted.value(text.replace("\n", " "), own)


def _fails(statement, scene, v, own):
    """Whether the claim, read as it is, fails at the numbers; None where nothing is decided here."""
    claim, printed = statement["quantity"], statement["printed"]
    if claim == "existence":
        return compared(printed, own) != _exists(scene, v)
    if claim == "sufficient for periodic motion":
        E2, L2 = 2 * v["E"], v["L2"]
        return compared(printed, own) and not (L2 != E2 * v["I2"] and E2 * v["I1"] < L2 < E2 * v["I3"])
    if not _is_body(scene, v):
        return False
    if claim.endswith("Casimirs alone"):
        sign = _in_field(scene, v, rotating.definite) if "k1" in scene["potential"] else _form(scene, v)
        return None if sign is None else compared(printed, own) and sign != 1
    if claim.endswith("internal damping"):
        return compared(printed, own) and damped.least(scene, scene_of(scene)[1], v) == -1
    sign = _stability(scene, v)
    if claim == "stability":
        return sign == (1 if printed == "unstable" else -1)
    says = compared(printed, own)
    if claim.startswith("necessary and sufficient"):
        return says and sign == -1 or not says and sign == 1
    if claim.startswith("necessary"):
        return not says and sign == 1
    return says and sign == (1 if "instability" in claim else -1)


def _stability(scene, v):
    """1 proved stable, -1 proved unstable, 0 neither."""
    if "k1" in scene.get("potential", ""):
        return _in_field(scene, v, rotating.stability) or held.stability(scene, v)
    if "point" in scene:                                   # of a free body
        return damped.stability(scene, v)
    return refuted.stability(scene_of(scene), v)[0]


def _in_field(scene, v, what):
    """What is true of a rotation in a field."""
    with mp.workdps(40):
        return what(reread.Motion(scene, {name: mp.mpf(x.numerator) / x.denominator
                                          for name, x in v.items()}))


def _is_body(scene, v):
    inertia = [refuted.value(t, v) for t in scene.get("inertia", ["I1", "I2", "I3"])]
    unit = not {"k1", "k2", "k3"} <= v.keys() or v["k1"]**2 + v["k2"]**2 + v["k3"]**2 == 1
    return (
        unit and min(inertia) > 0 and all(2 * m <= sum(inertia) for m in inertia) and abs(v.get("k3", 0)) <= 1
    )


def _exists(scene, v):
    """Whether the numbers are those of an equilibrium inclined, or nothing but what is given is claimed."""
    if "equilibrium" not in scene:
        return True
    k3, omega = v["k3"], v["omega"]
    coefficients = scene_of(scene)[1]
    slope = v.get("dU") if coefficients is None else refuted.derivative(coefficients(v), 1, k3)
    balance = omega * v.get("l", 0) - omega**2 * k3 * (v["I1"] - v["I3"])
    unit = not {"k1", "k2"} <= v.keys() or v["k1"]**2 + v["k2"]**2 + k3**2 == 1
    return k3**2 <= 1 and unit and slope in (None, balance)


def _form(scene, v):
    """1 if D²(h + ν·C) is definite at a pole of a body of revolution, else -1; None elsewhere."""
    label, coefficients = scene_of(scene)
    if label not in ("E1", "E2"):
        return None
    s, slope = (1 if label == "E1" else -1), refuted.stability((label, coefficients), v)[1]["dU"]
    omega = v["omega3_0"] if "omega3_0" in v else v["pi3_0"] / v["I3"]
    nu1, nu2 = -s * omega, s * (s * omega * (v["I3"] * omega + v.get("l", 0)) - slope)    # ν2 doubled
    return 1 if nu2 / v["I1"] > nu1**2 else -1
