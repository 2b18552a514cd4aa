"""Whether the energy is least at an equilibrium on the level of the Casimirs: what internal damping leaves.

In fractions, by the amended potential. Imports nothing of gyrostat.
"""
from fractions import Fraction

import oracle
import refuted


def least(scene, coefficients, v):
    """1 if it is strictly least, along the spin constant; -1 if it is less nearby; 0 where nothing decides.

    scene: the table of the file; coefficients of U(k3) at numbers, or None where the numbers give
    derivatives.
    """
    inertia = [refuted.value(t, v) for t in scene.get("inertia", ["I1", "I2", "I3"])]
    rotor = [refuted.value(t, v) for t in scene.get("gyrostatic_momentum", ["0", "0", "0"])]
    label = scene.get("equilibrium")
    if label is None:
        signs = across(scene, v)
    elif label.startswith("axis"):
        signs = _on_sphere(int(label[-1]) - 1, inertia, rotor, v)
    elif "k1" in scene["potential"]:
        signs = _above(scene["potential"], inertia, rotor[2], v)
    else:
        signs = _at_height(label, coefficients, inertia, rotor[2], v)
    return -1 if min(signs) < 0 else 1 if min(signs) > 0 else 0


def _on_sphere(axis, inertia, rotor, v):
    """The energy on abs(M) = m along the other axes, to second order, or to fourth; 0 where m is."""
    omega = v[f"omega{axis + 1}_0"]
    m = inertia[axis] * omega + rotor[axis]
    if not m:
        return [0]
    return [1 / other - omega / m or 1 / inertia[axis] - 1 / other
            for i, other in enumerate(inertia) if i != axis]


def across(scene, v):
    """Two numbers with the signs of the squares of the energy on abs(M) = G at a point.

    By the form in the basis M_n e_i − M_i e_n of the plane across M; 0 where G is.
    """
    inertia = [refuted.value(t, v) for t in scene.get("inertia", ["I1", "I2", "I3"])]
    M, pi = momentum(scene, v), [refuted.value(t, v) for t in scene["point"]]
    if not M:
        return [0, 0]
    n = next(i for i, m in enumerate(M) if m)
    nu = pi[n] / inertia[n] / M[n]
    i, j = (k for k in range(3) if k != n)
    d = [1 / moment - nu for moment in inertia]
    first, second = (d[k] * M[n] ** 2 + d[n] * M[k] ** 2 for k in (i, j))
    determinant, trace = first * second - (d[n] * M[i] * M[j]) ** 2, first + second
    # where it is 0 the third order along the kernel decides: a fold
    if determinant < 0 or determinant == 0 and all(d):
        return [1, -1]
    return [trace, trace * determinant]


def stability(scene, v):
    """1 proved stable, as where the sphere is a point, -1 proved unstable, 0 neither."""
    if not momentum(scene, v):
        return 1
    one, other = across(scene, v)
    return (one * other > 0) - (one * other < 0)


def momentum(scene, v):
    """M = π + l at the point; empty where it is 0."""
    rotor = scene.get("gyrostatic_momentum", ["0", "0", "0"])
    M = [refuted.value(p, v) + refuted.value(l, v) for p, l in zip(scene["point"], rotor)]
    return M if any(M) else []


def _above(potential, inertia, rotor, v):
    """The squares across k = (0, 0, 1), U of the second degree in k without products."""
    def U(*k):
        return refuted.value(potential, {**v, **dict(zip(("k1", "k2", "k3"), map(Fraction, k)))})

    rate, slope = v["omega3_0"], (U(0, 0, 2) - U(0, 0, 0)) / 2
    mu = rate * (inertia[2] * rate + rotor) - slope
    bends = [U(*e) + U(*(-x for x in e)) - 2 * U(0, 0, 0) for e in ((1, 0, 0), (0, 1, 0))]
    return [bend + mu - rate**2 * moment for bend, moment in zip(bends, inertia)]


def _at_height(label, coefficients, inertia, rotor, v):
    """How the energy rises about the point: the first power of 2 J (U − e) + (c − l z)² at z = k3, with
    J = I1 (1 − z²) + I3 z².
    """
    k3 = {"E1": Fraction(1), "E2": Fraction(-1)}.get(label, v.get("k3"))
    spin = v.get("omega3_0", v.get("pi3_0", 0) / inertia[2])
    axial = v["omega"] * k3 if label == "E3" else spin
    across = v["omega"] ** 2 * inertia[0] * (1 - k3**2) if label == "E3" else Fraction(0)
    momentum = (inertia[2] * axial + rotor) * k3 + (across / v["omega"] if across else 0)
    energy = (across + inertia[2] * axial**2) / 2
    if coefficients is None:
        omega = v.get("omega", 0)
        balance = omega * rotor - omega**2 * k3 * (inertia[0] - inertia[2])
        jets = [v.get("dU", balance), v.get("d2U", 0), v.get("d3U", 0)]
    else:
        jets = [refuted.derivative(coefficients(v), n, k3) for n in range(1, 5)]
    rise = [-energy, *(d / f for d, f in zip(jets, (1, 2, 6, 24)))]
    moment = oracle.expand([inertia[0], Fraction(0), inertia[2] - inertia[0]], k3, Fraction(1))
    level = [momentum - rotor * k3, -rotor]
    excess = [2 * c for c in oracle.product(moment, rise)]
    for n, c in enumerate(oracle.product(level, level)):
        excess[n] += c
    if label != "E3":                                      # inside is k3 (1 − y)
        excess = [c * (-k3) ** n for n, c in enumerate(excess)]
    assert excess[0] == 0 and (label != "E3" or excess[1] == 0)
    power, first = next(((n, c) for n, c in enumerate(excess) if c), (0, 0))
    return [-1 if label == "E3" and power % 2 else first]
