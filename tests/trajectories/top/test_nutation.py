"""k3 between two turning points by elliptic functions, for every arrangement of the roots of g."""
from collections import Counter

import numpy as np
import pytest
from flint import acb, arb, ctx

from gyrostat.trajectories.top.nutation import nutation
from gyrostat.trajectories.top.turning_points import Roots

RATES = 2.0**-40                                           # step of the differences in balls


def roots(lower, upper, others, double=(False, False)):
    """Numbers as enclosures, counted; a complex one brings its conjugate."""
    every = Counter(z for x in others for z in {complex(x), complex(x).conjugate()})
    return Roots(arb(lower), arb(upper), double, [(acb(z.real, z.imag), m) for z, m in every.items()], arb(1))


# kind, the roots of q beside the turning points, those that are left
LAYOUTS = {
    "either side": (roots(-0.5, 0.25, [-2, 3]), "neighbours", [-2, 3], []),
    "either side and more": (roots(-0.5, 0.25, [-2, 3, -5, 7, 4 + 4j]), "neighbours", [-2, 3],
                             [-5, 7, 4 + 4j, 4 - 4j]),
    "both above": (roots(-0.5, 0.25, [1, 3]), "neighbours", [3, 1], []),
    "both below": (roots(-0.5, 0.25, [-1, -3]), "neighbours", [-1, -3], []),
    "one above": (roots(-0.5, 0.25, [1.5]), "neighbours", [1.5], []),
    "one below": (roots(-0.5, 0.25, [-1.5]), "neighbours", [-1.5], []),
    "none": (roots(-0.5, 0.25, []), "neighbours", [], []),
    "pair": (roots(-0.5, 0.25, [0.125 + 0.5j]), "pair", [0.125 + 0.5j, 0.125 - 0.5j], []),
    "pair nearer the lower end": (roots(-0.5, 0.25, [-1 + 0.25j, 2]), "pair", [-1 + 0.25j, -1 - 0.25j], [2]),
    "pair far away": (roots(-0.5, 0.25, [3 + 9j, -1]), "neighbours", [-1], [3 + 9j, 3 - 9j]),
    "pair that almost meets the lower end": (roots(-0.5, 0.25, [-0.5 + 2**-20 * 1j]), "pair",
                                             [-0.5 + 2**-20 * 1j, -0.5 - 2**-20 * 1j], []),
    "close on either side": (roots(-0.5, 0.25, [-0.5 - 2**-30, 0.25 + 2**-20]), "neighbours",
                             [-0.5 - 2**-30, 0.25 + 2**-20], []),
    "a double root above": (roots(-0.5, 0.25, [1, 1]), "neighbours", [1, 1], []),
    "a triple root below": (roots(-0.5, 0.25, [-1, -1, -1]), "neighbours", [-1, -1], [-1]),
}
ASYMPTOTIC = {
    "to the upper end": (roots(-0.5, 0.25, [-2], (False, True)), "neighbours", [-2, 0.25], []),
    "to the upper end, nothing below": (roots(-0.5, 0.25, [], (False, True)), "neighbours", [0.25], []),
    "to the upper end, two above": (roots(-0.5, 0.25, [1, 2], (False, True)), "neighbours", [2, 0.25], [1]),
    "to the lower end": (roots(-0.5, 0.25, [3], (True, False)), "neighbours above", [-0.5, 3], []),
    "to the lower end, two below": (roots(-0.5, 0.25, [-1, -2], (True, False)), "neighbours above",
                                    [-0.5, -2], [-1]),
    "to the lower end, a pair": (roots(-0.5, 0.25, [0.1 + 0.1j], (True, False)), "neighbours above", [-0.5],
                                 [0.1 + 0.1j, 0.1 - 0.1j]),
    "between two": (roots(-0.5, 0.25, [2], (True, True)), "passage", [-0.5, 0.25], [2]),
}
EVERY = LAYOUTS | ASYMPTOTIC


def multiset(found):
    """Roots with multiplicity as sorted complex numbers."""
    return sorted((complex(float(x.real), float(x.imag)) for x, m in found for _ in range(m)),
                  key=lambda z: (z.real, z.imag))


@pytest.mark.parametrize("case", EVERY.values(), ids=EVERY)
def test_roots_of_the_quartic_are_the_nearest(case):
    """Neighbours on the real line, which closes at infinity, or the conjugate pair that is nearer.

    The rest is left.
    """
    given, kind, used, rest = case
    found = nutation(given)
    assert found.kind == kind
    assert multiset([(x, 1) for x in found.used]) == multiset([(acb(complex(x).real, complex(x).imag), 1)
                                                               for x in used])
    assert multiset(found.rest) == multiset([(acb(complex(x).real, complex(x).imag), 1) for x in rest])


def height(path, u):
    s, c, _ = path.shape(u)
    return c * c * path.roots.lower + s * s * path.roots.upper


def quartic(z, used):
    value = (z - arb(-0.5)) * (z - arb(0.25))
    for x in used:
        value *= z - acb(complex(x).real, complex(x).imag)
    return abs(value)


@pytest.mark.parametrize("case", EVERY.values(), ids=EVERY)
def test_height_follows_the_quartic(case):
    """s² + c² = 1, (dz/du)² = scale² abs(q(z)), and the rate is that of the angle of c + i s."""
    given, _, used, _ = case
    with ctx.workprec(256):
        path, h = nutation(given), arb(RATES)
        for u in map(arb, ("0.1", "0.7", "-0.4", "1.3", "-1.9")):
            s, c, rate = path.shape(u)
            assert (s * s + c * c).contains(1)
            slope = (height(path, u + h) - height(path, u - h)) / (2 * h)
            assert abs(slope**2 / (path.scale**2 * quartic(height(path, u), used)) - 1) < arb("1e-15")
            (s1, c1, _), (s0, c0, _) = path.shape(u + h), path.shape(u - h)
            turned = (s1 * c0 - c1 * s0) / (2 * h)
            assert abs(turned / rate - 1) < arb("1e-15")
            assert abs(path.quartic(height(path, u), False) / quartic(height(path, u), used) - 1) < arb(
                "1e-55"
            )


@pytest.mark.parametrize("case", EVERY.values(), ids=EVERY)
def test_doubles_follow_the_enclosures(case):
    """c², s², s c and the rate in doubles, to rounding; those of a number are those of an array."""
    with ctx.workprec(200):
        path = nutation(case[0])
        K = 2.5 if path.quarter is None else float(path.quarter)
        u = K * np.array([-1, -0.9, -0.6, 0.0, 0.3, 0.8, 1])
        shapes = [path.shape(arb(v)) for v in u]
        exact = np.array([[float(x) for x in (c * c, s * s, s * c, turn)] for s, c, turn in shapes]).T
    half = np.cos(np.pi / 2 * u / K), np.sin(np.pi / 2 * u / K)
    found = np.array(path.squares(u, half))
    np.testing.assert_allclose(found, exact, rtol=0, atol=5e-15 * max(1, np.abs(exact).max()))
    singly = [path.squares(v, (c, s)) for v, c, s in zip(u, *half)]
    np.testing.assert_array_equal(np.array(singly).T, found)


@pytest.mark.parametrize("case", LAYOUTS.values(), ids=LAYOUTS)
def test_a_quarter_leads_from_end_to_end(case):
    """At u = 0 the lower end, at K the upper one, at 2 K the lower again with the sign of c changed."""
    with ctx.workprec(200):
        path = nutation(case[0])
        K = path.quarter
        for u, end in ((arb(0), -0.5), (K, 0.25), (2 * K, -0.5), (-K, 0.25)):
            assert abs(height(path, u) - end) < arb("1e-40")
        assert path.shape(K / 3)[0] > 0 > path.shape(-K / 3)[0] and path.shape(2 * K)[1] < 0


@pytest.mark.parametrize("case", ASYMPTOTIC.values(), ids=ASYMPTOTIC)
def test_a_double_root_is_not_reached(case):
    """There is no quarter; far away in both directions the height is that of the double roots."""
    given, kind, _, _ = case
    with ctx.workprec(200):
        path = nutation(given)
        assert path.quarter is None
        ends = {"neighbours": (0.25, 0.25), "neighbours above": (-0.5, -0.5), "passage": (-0.5, 0.25)}[kind]
        for u, end in zip((arb(-60), arb(60)), ends):
            assert abs(height(path, u) - end) < arb("1e-20")
        assert height(path, arb(0)) - {"neighbours": -0.5, "neighbours above": 0.25, "passage": -0.125}[
            kind
        ] < arb("1e-40")
        double = {"neighbours": [arb(0.25)], "neighbours above": [arb(-0.5)],
                  "passage": [arb(-0.5), arb(0.25)]}[kind]
        for z in double:
            step = arb("1e-20")
            assert abs(path.quartic(z, True) / (quartic(z + step, case[2]) / step**2) - 1) < arb("1e-15")


@pytest.mark.parametrize("case", EVERY.values(), ids=EVERY)
def test_start_inverts_the_shape(case):
    """The u of the sine and cosine of the angle, on either side of the turning point."""
    with ctx.workprec(200):
        path = nutation(case[0])
        for u in map(arb, ("0.2", "-0.3", "0.9", "1e-9", "-1")):
            if path.quarter is None or abs(u) < path.quarter:
                s, c, _ = path.shape(u)
                assert abs(path.start(s, c) - u) < arb("1e-45")
        if path.kind != "passage":
            assert abs(
                path.start(*((arb(0), arb(1)) if path.kind != "neighbours above" else (arb(1), arb(0))))
            ) < arb("1e-45")
