"""Whether gyroscopic forces hold an equilibrium in a polynomial field: from the texts of a scene, over Q.

Imports nothing of gyrostat.
"""
import ast
import operator
from fractions import Fraction

import refuted
from flint import fmpq, fmpq_mpoly_ctx
from normal_form import energy, field_of, on_the_torus, removed, resonant, twists

DIRECTIONS = fmpq_mpoly_ctx.get(("k1", "k2", "k3"), "lex")

BINARY = {ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul, ast.Div: operator.truediv}


def polynomial(node, names):
    """A text over Q in k1, k2, k3."""
    if isinstance(node, ast.Constant):
        return fmpq(node.value)
    if isinstance(node, ast.Name):
        return names[node.id]
    if isinstance(node, ast.UnaryOp):
        return -polynomial(node.operand, names)
    left = polynomial(node.left, names)
    if isinstance(node.op, ast.Pow):
        return left ** node.right.value
    return BINARY[type(node.op)](left, polynomial(node.right, names))


def motion(scene, v, degree):
    """h near the equilibrium, by degree."""
    inertia = [refuted.value(t, v) for t in scene.get("inertia", ["I1", "I2", "I3"])]
    rotor = [refuted.value(t, v) for t in scene.get("gyrostatic_momentum", ["0", "0", "0"])]
    if "point" in scene:
        x = [refuted.value(t, v) for t in scene["point"]]
    else:
        spin = v["pi3_0"] if "pi3_0" in v else inertia[2] * v["omega3_0"]
        x = [0, 0, spin, 0, 0, {"E1": 1, "E2": -1}[scene["equilibrium"]]]
    numbers = {name: fmpq(c.numerator, c.denominator) for name, c in v.items()}
    names = {**numbers, **dict(zip(("k1", "k2", "k3"), DIRECTIONS.gens()))}
    U = 0 * DIRECTIONS.gens()[0] + polynomial(ast.parse(scene["potential"], mode="eval").body, names)
    inverse = [[Fraction(int(i == j)) / inertia[i] for j in range(3)] for i in range(3)]
    momentum = [Fraction(a) + b for a, b in zip(x[:3], rotor)]
    return energy(inverse, rotor, list(map(Fraction, x[3:])), momentum, U.to_dict(), degree)


def stability(scene, v):
    """1 proved stable, -1 unstable at 1:2 or 1:3, 0 neither."""
    parts = motion(scene, v, 4)
    _, p, q = field_of(parts[2])
    if 4 * p * p == 25 * q:
        return -1 if removed(parts[2], parts[3], []) is None else 0
    if 9 * p * p == 100 * q:
        mean, amplitude = on_the_torus(parts, resonant(parts)[4])
        return -1 if amplitude > abs(mean) * 1.001 else 0
    return int(twists(parts)[0] != 0)
