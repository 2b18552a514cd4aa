"""Whether the numbers of a counterexample refute a printed condition.

From the output alone, in fractions. Imports nothing of gyrostat.
"""
import ast
import operator
from fractions import Fraction

import numpy as np
import oracle

_BINARY = {ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul, ast.Div: operator.truediv,
           ast.Pow: operator.pow}
_COMPARED = {ast.Lt: operator.lt, ast.LtE: operator.le, ast.Gt: operator.gt, ast.GtE: operator.ge}


def value(text, names):
    """A printed expression or comparison at numbers."""
    return _value(ast.parse(text.strip(), mode="eval").body, text, names)


def _value(node, text, names):
    if isinstance(node, ast.Constant):
        return Fraction(ast.get_source_segment(text.strip(), node))
    if isinstance(node, ast.Name):
        return names[node.id]
    if isinstance(node, ast.UnaryOp):
        inner = _value(node.operand, text, names)
        return -inner if isinstance(node.op, ast.USub) else inner
    if isinstance(node, ast.BinOp):
        left, right = _value(node.left, text, names), _value(node.right, text, names)
        return _BINARY[type(node.op)](left, int(right) if isinstance(node.op, ast.Pow) else right)
    if isinstance(node, ast.Call):
        return abs(_value(node.args[0], text, names))
    if isinstance(node, ast.BoolOp):
        return all(_value(part, text, names) for part in node.values)
    sides = [_value(side, text, names) for side in (node.left, *node.comparators)]
    return all(_COMPARED[type(op)](a, b) for op, a, b in zip(node.ops, sides, sides[1:]))


def stability(scene, v):
    """1 proved Lyapunov stable (modulo the spin), -1 proved unstable, 0 neither.

    Also what a text may call dU, d2U there.

    scene: label, and for E1, E2, E3 the coefficients of U(k3) in powers of k3, or None where the numbers give
    its derivatives.
    """
    label, coefficients = scene
    if label.startswith("axis"):
        return _about_axis(int(label[-1]), v), {}
    I1, I3, l = v["I1"], v["I3"], v.get("l", Fraction(0))
    k3 = {"E1": Fraction(1), "E2": Fraction(-1)}.get(label, v.get("k3"))
    if coefficients is not None:
        jets = [derivative(coefficients(v), n, k3) for n in range(1, 5)]
    else:
        jets = [v.get("dU"), v.get("d2U", Fraction(0)), v.get("d3U", Fraction(0)), Fraction(0)]
    if label == "E3":
        omega = v["omega"]
        balance = omega * l - omega**2 * k3 * (I1 - I3)
        assert jets[0] in (None, balance), "not on the family"
        jets[0], spin, M = balance, I3 * omega * k3, l + I3 * omega * k3
        momentum, kinetic = I1 * omega * (1 - k3**2) + M * k3, I1 * omega**2 * (1 - k3**2) / 2
    else:
        spin = v["pi3_0"] if "pi3_0" in v else I3 * v["omega3_0"]
        M, kinetic = spin + l, Fraction(0)
        momentum = M * k3
    # I1² k̇3² = 2 I1 (e − U(z)) (1 − z²) − (v − M z)², z = k3 + x, e measured from U(k3)
    fall = [kinetic, *(-d / f for d, f in zip(jets, (1, 2, 6, 24)))]
    disc = [1 - k3**2, -2 * k3, Fraction(-1)]
    level = [momentum - M * k3, -M]
    g = [2 * I1 * c for c in oracle.product(fall, disc)]
    for i, c in enumerate(oracle.product(level, level)):
        g[i] -= c
    assert g[0] == g[1] == 0 or label != "E3" and g[0] == 0
    if label in ("E1", "E2"):                              # inside is x = −k3 y, y > 0
        g = [c * (-k3) ** n for n, c in enumerate(g)]
    assert g[1] == 0
    sign = next(((n, c) for n, c in enumerate(g) if c), None)
    names = dict(zip(("dU", "d2U", "d3U"), jets)) | {"k3": k3}
    if sign is None or sign[0] > 4 and coefficients is None:
        return (-1 if sign is None else 0), names
    return (-1 if sign[1] > 0 or label == "E3" and sign[0] % 2 else 1), names


def derivative(coefficients, order, z):
    for _ in range(order):
        coefficients = [n * c for n, c in enumerate(coefficients)][1:]
    return sum((c * z**n for n, c in enumerate(coefficients)), Fraction(0))


def _about_axis(axis, v):
    """The energy Σ M²/2I − l·M/I on the sphere abs(M) = m near its point on an axis, to fourth order."""
    inertia = [v[f"I{i}"] for i in (1, 2, 3)]
    omega, l = v[f"omega{axis}_0"], v.get("l", Fraction(0))
    m, moment = inertia[axis - 1] * omega + l, inertia[axis - 1]
    if m == 0:
        return 1
    signs = []
    for other in (inertia[i] for i in range(3) if i != axis - 1):
        second = 1 / other - omega / m
        signs.append(second if second else (1 / moment - 1 / other) / m**2)
    return int(np.sign(signs[0] * signs[1]))


def refutes(claim, printed, scene, values):
    """Whether a printed condition, read as it is, is false of the point: by its claim."""
    v = {name: Fraction(text) for name, text in values.items()}
    assert all(v[name] > 0 for name in v if name.startswith("I"))
    moments = [v["I1"], v.get("I2", v["I1"]), v["I3"]]
    assert all(2 * m <= sum(moments) for m in moments)
    if "k1" in v and "k3" in v:
        assert v["k1"]**2 + v["k2"]**2 + v["k3"]**2 == 1
    sign, names = stability(scene, v)
    assert all(v.get(name, x) == x for name, x in names.items()
               if x is not None), "the numbers shown are stale"
    says = value(printed, {**names, **v})
    unstable = "instability" in claim
    if claim.startswith("necessary and sufficient"):
        return says and sign == -1 or not says and sign == 1
    if claim.startswith("necessary"):
        return not says and sign == 1
    return says and sign == (1 if unstable else -1)
