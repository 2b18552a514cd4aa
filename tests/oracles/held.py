"""Whether gyroscopic forces hold an equilibrium in a polynomial field: from the texts of a scene, over Q.

Imports nothing of gyrostat.
"""
import ast
import operator
from fractions import Fraction

import mpmath as mp
import refuted
from flint import fmpq, fmpq_mpoly_ctx
from normal_form import (
    at,
    energy,
    field_of,
    linear_modes,
    on_the_torus,
    removed,
    resonant,
    second_integral,
    triangle,
    twists,
)

DIRECTIONS = fmpq_mpoly_ctx.get(("k1", "k2", "k3"), "lex")

BINARY = {ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul, ast.Div: operator.truediv}
QUANTITIES = ("frequency_1", "frequency_2", "birkhoff_20", "birkhoff_11", "birkhoff_02", "D4")


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


def exact(x):
    """The fraction that a number of 40 digits is."""
    return Fraction(int(mp.floor(x * mp.mpf(10) ** 36 + mp.mpf(1) / 2)), 10**36).limit_denominator(10**16)


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


def spectrum(scene, v):
    """p and q of λ⁴ + p λ² + q."""
    return [Fraction(int(x.p), int(x.q)) for x in field_of(motion(scene, v, 2)[2])[1:]]


def quantities(scene, v):
    """By name: signed frequencies, the coefficients of degree 2 in the actions, D4."""
    parts = motion(scene, {name: exact(x) for name, x in v.items()}, 4)
    A, *invariants = field_of(parts[2])
    F = second_integral(A)                                # −ω1³ J1 − ω2³ J2, where h2 = ω1 J1 + ω2 J2
    found = triangle(parts, lambda n: [parts[2] ** 2, parts[2] * F, F * F] if n == 4 else [])
    p, q, a, b, c = (mp.mpf(int(x.p)) / int(x.q) for x in (*invariants, *found[4]))
    root = mp.sqrt(p * p - 4 * q)
    slow, fast = (1 if at(parts[2], 2 * mode.real) > 0 else -1 for _, mode in linear_modes(parts))
    x, y = fast * mp.sqrt((p + root) / 2), slow * mp.sqrt((p - root) / 2)
    return dict(zip(QUANTITIES, (
        x, y, a * x**2 - b * x**4 + c * x**6,
        2 * a * x * y - b * x * y * (x**2 + y**2) + 2 * c * (x * y) ** 3,
        a * y**2 - b * y**4 + c * y**6, c * q * root**2)))


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
