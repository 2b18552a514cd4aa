"""What another scene decides, exactly where it is degenerate: held against motions of 20 neighbours."""
import numpy as np
import pytest
from nearby import Motion, turned
from sympy import Rational, sqrt

import gyrostat as gs

R = Rational
E1, E2, E3 = np.eye(3)


def numbers(values):
    return np.array([float(x) for x in values])


def in_orbit(inertia, rotor):
    """At the rate 1: U = (3/2) r·Ir − n·l, β = −n."""
    tensor, l = np.diag(numbers(inertia)), numbers(rotor)
    coupling = np.array([-np.eye(3), np.zeros((3, 3))])
    return Motion(tensor, l, lambda x: np.stack([0 * x[:, 0] - l, 3 * x[:, 1] @ tensor], 1), coupling)


def in_field(inertia, rotor, slope):
    """In U(k) with the gradient given, of k with shape (n, 3)."""
    return Motion(np.diag(numbers(inertia)), numbers(rotor), lambda x: slope(x[:, 0])[:, None])


def satellite(inertia, rotor, n, r):
    scene = gs.assemble(gs.Gyrostat(inertia, rotor), gs.circular_orbit(1))
    return gs.analyze(gs.steady_motion(scene, n, r)), in_orbit(inertia, rotor)


def precession(kind, I3, n3):
    """Of a family at numbers, and the body at numbers."""
    scene = gs.assemble(gs.symmetric_gyrostat(), gs.circular_orbit(1))
    report = gs.analyze(gs.orbital_precession(scene, kind))
    values = {"I1": 1, "I3": I3, "n3": n3}
    point = [x.subs({gs.symbol(n): v for n, v in values.items()}) for x in report.equilibrium.point]
    rotor = (1 if kind == "hyperbolic" else 4) * (1 - R(I3)) * R(n3)
    return report, in_orbit((1, 1, R(I3)), (0, 0, rotor)), values, point


def field(inertia, rotor, U, slope, point):
    scene = gs.assemble(gs.Gyrostat(inertia, rotor), gs.general_potential(U))
    return gs.analyze(gs.equilibrium(scene, point)), in_field(inertia, rotor, slope)


def free(inertia, rotor, point):
    scene = gs.assemble(gs.Gyrostat(inertia, rotor))
    return gs.analyze(gs.equilibrium(scene, point)), Motion(np.diag(numbers(inertia)), numbers(rotor))


def vehicle(weight, rate):
    """Of revolution, rising at p = 2 along axis 3, turning about it."""
    d = 0.3
    D = np.array([[0, -d, 0], [d, 0, 0], [0, 0, 0]])
    M = np.diag([2.0, 2, 1])
    whole = np.linalg.inv(np.block([[np.eye(3), D], [D.T, M]]))
    A, B, C = whole[:3, :3], whole[:3, 3:], whole[3:, 3:]
    scene = gs.underwater_vehicle((1, 1, 1), (2, 2, 1), [[0, "-3/10", 0], ["3/10", 0, 0], [0, 0, 0]],
                                  weight=(0, 0, weight))
    motion = Motion(np.linalg.inv(A), (0, 0, 0), lambda x: np.stack(
        [x[:, 0] @ C, np.broadcast_to([0, 0, -float(weight)], x[:, 1].shape)], 1),
        np.array([B, np.zeros((3, 3))]))
    return gs.analyze(gs.steady_motion(scene, (0, 0, 2), (0, 0, 1), omega=(0, 0, rate))), motion


def constant(k):
    return 2 * k


def of_one_rate(side):
    """At ω = k where k3 = 3/5: U − k·Ik/2 = ±(k3 − 3/5)²."""
    return field((1, 2, 3), (0, 0, 0), lambda k1, k2, k3: (
        (k1**2 + 2 * k2**2 + 3 * k3**2) / 2 + side * (k3 - R(3, 5))**2), lambda k: (
        k * [1, 2, 3] + 2 * side * (k[:, 2:] - 0.6) * E3), (0, R(-8, 5), R(9, 5), 0, R(-4, 5), R(3, 5)))


CASES = {
    "a ball precesses": lambda: precession("conical", 1, "3/4"),
    "a ball precesses in the other plane": lambda: precession("hyperbolic", 1, "1/2"),
    "a ball precesses, its axis nearer to n": lambda: precession("conical", 1, "1/3"),
    "a ball precesses far in the other plane": lambda: precession("hyperbolic", 1, "3/4"),
    "conical, the axis in a well": lambda: precession("conical", "1/2", "3/4"),
    "conical, in a window": lambda: precession("conical", "9/5", "3/4"),
    "a ball along an axis": lambda: satellite((1, 1, 1), (0, 0, 0), (0, 0, 1), (1, 0, 0)),
    "a ball across": lambda: satellite((1, 1, 1), (0, 0, 0), (R(3, 5), 0, R(4, 5)), (0, 1, 0)),
    "a ball, its wheel against n": lambda: satellite((1, 1, 1), (0, 0, -1), (0, 0, 1), (1, 0, 0)),
    "a closed curve": lambda: satellite((R(3, 2), R(9, 10), R(6, 5)), (0, 6 / (5 * sqrt(2)), 0), (
        0, sqrt(2) / 2, -sqrt(2) / 2), (0, sqrt(2) / 2, sqrt(2) / 2)),
    "free, on a circle": lambda: free((1, 1, 2), (0, 0, 0), (1, 0, 0)),
    "free, a circle with a rotor": lambda: free((1, 1, 2), (0, 0, R(-1, 5)), (R(3, 5), 0, R(2, 5))),
    "free, a ball": lambda: free((2, 2, 2), (0, 0, 0), (0, 1, 1)),
    "no torque, k along M": lambda: field((1, 2, 3), (0, 0, 1), lambda *k: sum(x**2 for x in k), constant,
                                          (0, 0, 2, 0, 0, 1)),
    "no torque, on a circle": lambda: field((1, 1, 2), (0, 0, 0), lambda *k: sum(x**2 for x in k), constant,
                                            (1, 0, 0, 1, 0, 0)),
    "no torque, at rest": lambda: field((1, 2, 3), (0, 0, 0), lambda *k: sum(x**2 for x in k), constant,
                                        (0, 0, 0, 0, 0, 1)),
    "no torque, a ball at rest": lambda: field((1, 1, 1), (0, 0, 0), lambda *k: sum(x**2 for x in k),
                                               constant, (0, 0, 0, R(3, 5), 0, R(4, 5))),
    "no torque, a ball turns": lambda: field((1, 1, 1), (0, 0, 0), lambda *k: sum(x**2 for x in k), constant,
                                             (R(6, 5), 0, R(8, 5), R(3, 5), 0, R(4, 5))),
    "a tilt of a body about axis 1": lambda: field((3, 2, 2), (0, 0, 0), lambda k1, k2, k3: k1**2, lambda k: (
        2 * k * E1), (0, 2, 0, 0, 1, 0)),
    "on a circle of one rate, least": lambda: of_one_rate(1),
    "on a circle of one rate, a saddle": lambda: of_one_rate(-1),
    "at the critical spin": lambda: field((2, 2, 1), (0, 0, 0), lambda k1, k2, k3: k3, lambda k: 0 * k + E3, (
        0, 0, sqrt(8), 0, 0, 1)),
    "free, a ball with a wheel": lambda: free((2, 2, 2), (0, 0, 1), (0, 0, 1)),
    "rising": lambda: vehicle(5, 0),
    "rising with less spin": lambda: vehicle(5, R(1, 2)),
    "rising with spin": lambda: vehicle(5, 1),
    "rising, unstable": lambda: vehicle(1, 1),
}


def check(name, size, time):
    """20 neighbours stay by what the decision divides out, or one leaves; turns of a ball leave nothing."""
    report, motion, *given = CASES[name]()
    values, point = given or ({}, report.equilibrium.point)
    point, decisions = numbers(point), [report.verdict(values), report.itself(values)]
    places = [around(report, decision, point) for decision in decisions]
    states = motion.beside(point, size)
    distances = motion.excursions(states, [place for place in places if place is not None], time)
    for decision, place in zip(decisions, places):
        if place is None:
            assert decision.stable
            continue
        far = next(distances)
        assert not decision.stable or far < 3 * size**0.5, (decision, far)
        assert not decision.unstable or far > 6 * size**0.5, (decision, far)


def around(report, decision, point):
    """What the neighbours stay by: the point, its turns about an axis, a curve; None: all turns."""
    point = point.reshape(-1, 3)
    if len(decision.modulo) > 1:
        return None
    if decision.locus:
        return closed_curve()
    if not decision.modulo:
        return point[None]
    return turned(point, numbers(report.equilibrium.system.space.gradient(decision.modulo[0])[:3]))


def closed_curve():
    """Of the satellite above: r on (l·r)² = 16 abs(r × Ir)², n = (Ir − (r·Ir) r)/b, b = −r·l/4."""
    inertia, rotor = np.array([1.5, 0.9, 1.2]), np.array([0, 6 / (5 * np.sqrt(2)), 0])
    found = []
    a, b = inertia[0] - inertia[1], inertia[2] - inertia[1]
    for z in (1 - np.cos(np.linspace(0, np.pi, 8001))) / 2:
        for x in np.roots([-4 * a * a, 4 * (-b * b * z + (a - b)**2 * z + a * a * (1 - z)) + a * b,
                           4 * b * b * (1 - z) * z - a * b * (1 - z)]):
            if abs(x.imag) < 1e-9 and x.real > -1e-12 and (y := 1 - x.real - z) > 0:
                squares = np.sqrt(np.maximum([x.real, y, z], 0))
                for signs in np.stack(np.meshgrid(*[[-1, 1]] * 3), -1).reshape(-1, 3):
                    r = signs * squares
                    n = (inertia * r - (r * r * inertia).sum() * r) / (-(r @ rotor) / 4)
                    found.append([inertia * n, n, r])
    cells = np.round(200 * np.array(found).reshape(len(found), -1))
    return np.array(found)[np.unique(cells, axis=0, return_index=True)[1]]     # one in each cell of 1/200


@pytest.mark.slow
@pytest.mark.parametrize("name", CASES)
def test_twenty_neighbours(name, full):
    """At exactly the degenerate parameters, as the verdict and the decision on the point itself say."""
    check(name, *((1e-4, 63_000) if full else (2e-3, 900)))
