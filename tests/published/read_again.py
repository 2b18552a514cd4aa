"""What is shown against a printed formula or claim, read again from its JSON.

Python's own parser reads the texts. Their names are computed by Newton and Euler's equations at the numbers
that are shown, where the check has compared them with what is derived. What is true of a point, which the
check shows from these equations, is asked of the library's verdicts.
"""
import ast
import operator
from collections import ChainMap

from sympy import Abs, Matrix, Rational, cos, cosh, exp, log, sin, sqrt, tanh

import gyrostat as gs
from gyrostat.algebra.reals.exact import Point
from gyrostat.notation import jet
from gyrostat.published.checks.criteria import DAMPED, SPECTRAL
from gyrostat.published.independent.frame_equations import model_of
from gyrostat.published.independent.names_at_numbers import names, number
from gyrostat.published.listing import to_json
from gyrostat.published.names.jacobi import cn, dn, sn
from gyrostat.stability.criteria.numbers_asked import names_accepted
from gyrostat.stability.criteria.truth import holds

PLAIN = {"sqrt": sqrt, "sin": sin, "cos": cos, "exp": exp, "cosh": cosh, "tanh": tanh, "log": log, "abs": Abs}
OPERATIONS = {ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul, ast.Div: operator.truediv,
              ast.Pow: operator.pow}
COMPARED = {ast.Lt: operator.lt, ast.LtE: operator.le, ast.Gt: operator.gt, ast.GtE: operator.ge}
TRUE = {"existence": "an equilibrium", "sufficient for periodic motion": "periodic", DAMPED: "least",
        SPECTRAL: "spectrally stable", "sufficient for stability, Casimirs alone": "definite"}
EITHER = ("existence", "necessary and sufficient for stability", SPECTRAL)


def value(text, named):
    """A text at names, or the matrix of a list of texts."""
    if isinstance(text, list):
        return Matrix([[value(x, named) for x in row] if isinstance(row, list) else [value(row, named)]
                       for row in text])
    text = text.replace("\n", " ").strip()

    def of(node):
        if isinstance(node, ast.Constant):
            return Rational(ast.get_source_segment(text, node))
        if isinstance(node, ast.Name):
            return named[node.id]
        if isinstance(node, ast.UnaryOp):
            return -of(node.operand) if isinstance(node.op, ast.USub) else of(node.operand)
        if isinstance(node, ast.Call):
            return named[node.func.id](*map(of, node.args))
        if isinstance(node, ast.BoolOp):
            return all(map(of, node.values))
        if isinstance(node, ast.Compare):
            sides = list(map(of, (node.left, *node.comparators)))
            rises = [near(b - a) for a, b in zip(sides, sides[1:])]
            return all(COMPARED[type(op)](0, rise) for op, rise in zip(node.ops, rises))
        return OPERATIONS[type(node.op)](of(node.left), of(node.right))

    return of(ast.parse(text, mode="eval").body)


def near(x):
    """A number to 40 digits, 0 where all but the last ten vanish."""
    found = x.evalf(40)
    return 0 if abs(found) < Rational(1, 10**30) else found


def is_shown(finding, instead=None):
    """Whether its counterexample, or the point that it leaves out, is one; instead: of another text.

    None of the squares of a second variation, which NumPy counts in a test of its own.
    """
    (data,) = to_json([finding])
    statement, scene = finding.statement, finding.statement.scene
    if str(statement.quantity).startswith("second variation"):
        return None
    example, printed = data["counterexample"] or data["not_sharp"], instead or data["printed"]
    at = {gs.symbol(name): value(text, PLAIN) for name, text in example["values"].items()}
    named = ChainMap(PLAIN, names(scene, at))
    given = [text for text in (scene.table.get("given"), statement.given) if text]
    fixed = {gs.symbol(name): text for name, text in statement.at.items()}
    if not all(value(text, named) for text in given) or any(
            near(number(value(text, named), scene, at) - at[x]) for x, text in fixed.items() if x in at):
        return False
    for name, text in statement.let.items():
        named = ChainMap(PLAIN, {name: value(text, named)}, named)
    if statement.kind == "count":
        return data["derived"] != ", ".join([printed] if isinstance(printed, str) else printed)
    if statement.kind in ("condition", "statement"):
        return _is_false(statement, printed, named, at, example) is bool(data["counterexample"])
    if statement.kind == "equilibrium":
        model = model_of(scene, at)
        rest = dict(zip(model.coordinates, value(printed, named)))
        return any(map(near, model.field.subs(rest).subs(at)))
    (difference, *_) = data["difference"]
    ours, theirs = _sides(statement, printed, named, at, difference["entry"])
    if statement.kind == "number":
        return abs(ours - theirs) > Rational(1, 2 * 10 ** len(printed.partition(".")[2]))
    if ours.evalf(20).is_real is False:
        return example["printed"] == "not real"
    said = {"derived": theirs} | ({} if instead else {"printed": ours})
    return near(ours - theirs) != 0 and all(
        abs(x - value(example[name], PLAIN)) <= (1 + abs(x)) / 10**12 for name, x in said.items())


def _sides(statement, printed, named, at, entry):
    """Both sides of a formula, or of the entry of it in which they differ."""
    scene = statement.scene
    if statement.kind == "solution":
        return _motions(statement, printed, named, at, entry)
    sides = [value(text, named) for text in (printed, statement.quantity)]
    if entry:
        sides = [side[entry[0] - 1, entry[1] - 1] for side in sides]
    return [number(side, scene, at) for side in sides]


def _motions(statement, printed, named, at, entry):
    """The slope of a printed function and the rate there; without an entry, a start that differs."""
    t, scene = gs.symbol("t"), statement.scene
    free = {} if entry else {name: gs.symbol(name) for name in statement.constants}
    moving = value(printed, ChainMap({"t": t, "sn": sn, "cn": cn, "dn": dn, **free}, named))
    if not entry:
        starts = [(f, number(value(name, named), scene, at))
                  for name, f in zip(statement.quantity, moving.subs(t, 0)) if f.is_number]
        return next((pair for pair in starts if near(pair[0] - pair[1])), starts[0])
    here, n = moving.subs(t, at.get(t, 0)), entry[0] - 1
    if imaginary := [x for f in here if (x := f.evalf(20)).is_real is False]:
        return imaginary[0], None
    momenta = [x * moment if statement.quantity[0].startswith("omega") else x
               for x, moment in zip(here, scene.body.moments)]
    at = {**at, **{gs.symbol(f"pi{i}"): x.subs(at) for i, x in enumerate(momenta, 1)}}
    rate = value(f"dt({statement.quantity[n]})", names(scene, at))
    return moving[n].diff(t).subs(t, at.get(t, 0)), number(rate, scene, at)


def _is_false(statement, printed, named, at, example):
    """Whether a claim fails at a point, or only leaves it out; None where neither is shown."""
    claim = statement.quantity
    true = _what_is_true(statement.scene, claim, at)
    if claim == "stability":
        return true == example["derived"] and (printed == "unstable") != (true == "unstable") or None
    says = printed != "never" and value(printed, named)
    wanted = TRUE.get(claim, "unstable" if "instability" in claim else "stable")
    shown = "holds" if says else "fails", true
    if shown != (example["printed"], example["derived"]) or says == (true == wanted):
        return None
    return claim in EITHER or says == claim.startswith("sufficient")


def _what_is_true(scene, claim, at):
    """Of the point, by the library, in the words of the evidence."""
    eq, numbers = scene.equilibrium, Point(at)
    if claim == "existence":
        return "an equilibrium" if eq is None or all(near(x.subs(at)) > 0 for x in eq.existence()) \
            else "not an equilibrium"
    if claim == "sufficient for periodic motion":
        low, middle, high = (near(at[gs.symbol("L2")] - 2 * at[gs.symbol("E")] * moment.subs(at))
                             for moment in scene.body.moments)
        return "periodic" if low > 0 > high and middle else "not periodic"
    report = gs.analyze(eq)
    if claim.endswith("Casimirs alone"):
        return "definite" if holds(report.casimirs_only, numbers, {}) else "not definite"
    if claim == SPECTRAL:
        return "spectrally stable" if holds(report.necessary, numbers, {}) else "unstable"
    named, jets = names_accepted(eq, report.required), eq.system.potential and not eq.system.potential.given
    asked = {s.name: x for s, x in at.items() if s.name in named or jets and jet(s.name)}
    decision = report.verdict(asked, claim == DAMPED)
    if claim == DAMPED:
        return "least" if decision.stable else "not least"
    return decision.verdict.name.lower()
