"""The boundary theorem against the motion: how far k3 goes from a boundary point that is moved by ε.

The reduced motion of z = k3 is I1² ż² = g(z) = 2 I1 (e − U(z))(1 − z²) − (v − P z)². A boundary point is a
    root z0 of g of
multiplicity m = n + 2 > 2. Put z = z0 + σ y, with σ = −s at E1, E2 (z0 = s = ±1, y ≥ 0) and σ = 1 at E3 (y of
    both signs);
g = c y^m + …. Stable: c < 0, at E3 with m even. The states, the perturbations and g are exact; turning points
    are proved
enclosures of the roots of g.
"""
import random
from dataclasses import dataclass
from fractions import Fraction
from functools import cache

import numpy as np
import oracle
import pytest
from flint import arb, fmpq, fmpq_poly
from scipy.integrate import solve_ivp

import gyrostat as gs
from gyrostat.stability.report import Verdict

CASES, DEGREE, REACH = 15, 6, fmpq(1, 4)
NAMED = tuple(fmpq(1, 10**d) for d in (2, 3, 4))
SMALL = tuple(fmpq(1, 10**d) for d in (12, 14))
KINDS = [(family, verdict, n) for family in ("upright", "hanging") for verdict in ("STABLE", "UNSTABLE")
         for n in (1, 2, 3)]
KINDS += [("inclined", "STABLE", n) for n in (2, 4)] + [("inclined", "UNSTABLE", n) for n in (1, 2, 3)]
STABLE, UNSTABLE = ([kind for kind in KINDS if kind[1] == verdict] for verdict in ("STABLE", "UNSTABLE"))
# m = 3 is never stable at E3
INTEGRATED = [kind for kind in KINDS if kind[2] == 1] + [("inclined", "STABLE", 2)]


@dataclass(frozen=True)
class Case:
    """A boundary point: moments, l, U = a1 z + … + a6 z⁶, state (π, k), σ, spin ω (E3), direction (rotation
    of k, δπ).
    """

    family: str
    I1: fmpq
    I3: fmpq
    l: fmpq
    potential: list
    state: np.ndarray
    sigma: int
    omega: fmpq
    first: fmpq
    direction: tuple

    def integrals(self, x):
        return oracle.axial_integrals(x, self.I1, self.l, self.potential)

    def reduced(self, x):
        """g of the motion through x, in powers of y."""
        return oracle.expand(oracle.reduced_motion(self.I1, *self.integrals(x), self.potential),
                             self.state[5], self.sigma)

    def moved(self, step, level=False):
        """The state with k turned and π moved by about abs(step), abs(k) = 1 exactly.

        On its level: the same π3, at E3 also C1.
        """
        turn, change = self.direction
        k, pi = turned(self.state[3:], step * vector(turn) / 2), self.state[:3] + step * vector(change)
        if level:
            pi[2] = self.state[2]
            if self.family == "inclined":
                v = self.integrals(self.state)[1]
                pi[:2] += k[:2] * ((v - self.integrals(np.concatenate([pi, k]))[1]) / (k[0] ** 2 + k[1] ** 2))
        return np.concatenate([pi, k])

    def values(self):
        """What the library is given."""
        named = {f"a{i}": a for i, a in enumerate(self.potential) if i} | {"I1": self.I1, "I3": self.I3}
        named |= {"l": self.l} | ({"omega": self.omega, "k3": self.state[5]} if self.family == "inclined"
                                  else {"pi3_0": self.state[2]})
        return {name: Fraction(int(a.p), int(a.q)) for name, a in named.items()}


def plain(x):
    """A rational as a float."""
    return int(x.p) / int(x.q) if isinstance(x, fmpq) else float(x)


def vector(numbers):
    return np.array([fmpq(a) for a in numbers], dtype=object)


def turned(k, a):
    """k rotated about a by 2 arctan abs(a), rational where both are."""
    once = np.cross(a, k)
    return k + 2 * (once + np.cross(a, once)) / (1 + a.dot(a))


@cache
def cases(family, verdict, n):
    """Random boundary points; every fifth of E1, E2 has P = 0 = U'."""
    draw = random.Random(f"{family} {verdict} {n}")

    def number(low, high):
        return fmpq(draw.randint(32 * low, 32 * high), 32)

    def signed(low, high):
        return draw.choice((-1, 1)) * number(low, high)

    found, m = [], n + 2
    while len(found) < CASES:
        I1, P = number(1, 3), fmpq(0) if len(found) % 5 == 0 and family != "inclined" else signed(1, 2)
        I3, first = I1 * number(1, 7) / 4, number(4, 8) * (4 if family == "inclined" else 1)
        if verdict == "STABLE":
            first = -first
        elif family == "inclined" and m % 2:
            first *= draw.choice((-1, 1))
        if family == "inclined":
            t, sigma, omega = number(1, 3) / 2, 1, signed(1, 2)
            k = [2 * t / (1 + t * t), 0, draw.choice((-1, 1)) * (1 - t * t) / (1 + t * t)]
            pi = [I1 * omega * k[0], 0, I3 * omega * k[2]]
        else:
            s = 1 if family == "upright" else -1
            sigma, omega, k, pi = -s, fmpq(0), [0, 0, s], [0, 0, signed(0, 3)]
        l = P - pi[2]
        v = pi[0] * k[0] + P * k[2]
        # 2 I1 (e − U)(1 − z²) = (v − P z)² + c y^m + …, a power series in y: U up to y⁶
        sphere = oracle.expand([fmpq(1), 0, -1], k[2], sigma)
        drift = oracle.expand([v, -P], k[2], sigma)
        wanted = oracle.product(drift, drift) + [fmpq(0)] * (DEGREE + 2)
        wanted[m] += first
        for j in range(m + 1, DEGREE + 2):
            wanted[j] += first * signed(0, 1) / 2
        energy = oracle.quotient(wanted, [2 * I1 * c for c in sphere], DEGREE)
        potential = oracle.expand([-c for c in energy], -sigma * k[2], sigma)        # y = σ (z − z0)
        potential[0] = fmpq(0)
        turn, change = [[signed(1, 3) / 6 for _ in range(3)] for _ in range(2)]
        case = Case(family, I1, I3, l, potential, vector(pi + k), sigma, omega, first, (turn, change))
        g = case.reduced(case.state)
        assert g[:m] == [0] * m and g[m] == first
        if sum(abs(c) * REACH ** (j + 1) for j, c in enumerate(g[m + 1:])) <= abs(first) / 2:
            found.append(case)
    return found


def roots(g):
    """Real roots of a polynomial with rational coefficients, as disjoint proved balls of relative radius
    2⁻⁵³; and all roots.
    """
    every = [r for r, _ in fmpq_poly(g).complex_roots()]
    return sorted((r.real for r in every if r.imag == 0), key=float), every


def turning_points(case, x):
    """The ends of the interval of y in which k3 moves from x: the roots of g next to it."""
    g, y = case.reduced(x), case.sigma * (x[5] - case.state[5])
    assert oracle.polynomial(g, y) == (x[3] * x[1] - x[4] * x[0]) ** 2 > 0             # g(z) = I1² ż²
    y, real = arb(y), roots(g)[0]
    assert all((r < y) != (r > y) for r in real)       # the balls decide: one of the two is proved
    return [r for r in real if r < y][-1], [r for r in real if r > y][0]


def excursion(case, eps, level=False):
    """max abs(k3 − z0) over the motions from the point moved by +ε and by −ε, and the step of the larger one.
    """
    return max((max(abs(float(y)) for y in turning_points(case, case.moved(step, level))), step)
               for step in (eps, -eps))


@cache
def excursions(kind, level=False):
    """Of every case, at every ε."""
    steps = NAMED + (SMALL if kind in STABLE else SMALL[:1])
    return [[excursion(case, eps, level)[0] for eps in steps] for case in cases(*kind)[::3 if level else 1]]


def exponent(family, n, level):
    """α with excursion ~ ε^α: the state is moved by ε, and g by what follows.

    E1, E2: g = −O(ε⁴) + O(ε²) y + (P² − P'²) y² + c y^(n+2). Where P² changes by ε, that balances c yⁿ: α =
    1/n. Where it does not, or by ε² only (P = 0), ε² y balances c y^(n+2): α = 2/(n + 1). E3: e, v, P change
    by ε, but g = I1² ż² = O(ε²) where the motion starts, at y = O(ε); hence g = O(ε²) + O(ε) y + … + c
    y^(n+2): α = 1/(n + 1). With v and P kept, e changes by ε²: α = 2/(n + 2).
    """
    if family == "inclined":
        return 2 / (n + 2) if level else 1 / (n + 1)
    return 2 / (n + 1) if level else 1 / n


def names(kind):
    return "-".join(map(str, kind))


def test_written_out_field_is_the_field():
    """The Euler-Poisson field in numbers is the one with np.cross, exactly.

    It vanishes at the boundary points.
    """
    for kind in KINDS:
        case = cases(*kind)[0]
        slope = [i * a for i, a in enumerate(case.potential)][1:]
        x = case.moved(fmpq(1, 3))
        field = oracle.field(x, vector([case.I1, case.I1, case.I3]), vector([0, 0, case.l]),
                             lambda k: vector([0, 0, oracle.polynomial(slope, k[2])]))    # noqa: B023
        assert list(field) == oracle.axial_field(x, case.I1, case.I3, case.l, slope)
        assert not any(oracle.axial_field(case.state, case.I1, case.I3, case.l, slope))
        assert x[3:].dot(x[3:]) == 1


@pytest.mark.parametrize("kind", KINDS, ids=names)
def test_boundary_points_are_what_they_are_built_to_be(kind):
    """g = c y^(n+2) + … exactly, c of the sign wanted.

    Nothing else vanishes or takes over for abs(y) ≤ 1/4; P = 0 = U' occurs.
    """
    family, verdict, n = kind
    zero = 0
    for case in cases(*kind):
        g = case.reduced(case.state)
        assert g[:n + 2] == [0] * (n + 2) and g[n + 2] == case.first != 0
        held = case.first < 0 and (family != "inclined" or n % 2 == 0)
        assert held == (verdict == "STABLE")
        assert sum(abs(c) * REACH**j for j, c in enumerate(g[n + 3:], 1)) <= abs(case.first) / 2
        P, slope = case.integrals(case.state)[2], sum(i * a * case.state[5] ** (i - 1)
                                                      for i, a in enumerate(case.potential) if i)
        assert family == "inclined" or (P == 0) == (slope == 0)
        zero += P == 0
    assert len(cases(*kind)) == CASES and zero == (0 if family == "inclined" else CASES // 5)


@cache
def report(family):
    """Of a family in U = a1 z + … + a6 z⁶."""
    k3 = gs.symbol("k3")
    potential = gs.axial_potential(sum(gs.symbol(f"a{i}") * k3**i for i in range(1, DEGREE + 1)))
    return gs.analyze(getattr(gs, family)(gs.assemble(gs.symmetric_gyrostat(), potential)))


@pytest.mark.parametrize("kind", KINDS, ids=names)
def test_verdict_is_what_the_motion_does(kind):
    """STABLE exactly where the excursion from a point moved by ε = 10⁻¹² has become small, UNSTABLE where it
    has not.
    """
    for case, far in zip(cases(*kind), excursions(kind)):
        # ε^(1/5) = 0.004 against 1/4
        motion = Verdict.STABLE if far[len(NAMED)] < 0.05 else Verdict.UNSTABLE
        assert report(kind[0]).verdict(case.values()).verdict is motion is Verdict[kind[1]]


@pytest.mark.parametrize("level", [False, True], ids=["generic", "level"])
@pytest.mark.parametrize("kind", STABLE, ids=names)
def test_excursion_from_a_stable_point_has_the_exponent(kind, level):
    """abs(k3 − z0) ~ ε^(1/n), and ε^(2/(n+1)) with P kept or P = 0, at E1 and E2.

    Ε^(1/(n+1)), with v and P kept ε^(2/(n+2)), at E3.
    """
    family, _, n = kind
    for case, far in zip(cases(*kind)[::3 if level else 1], excursions(kind, level)):
        same = level or (family != "inclined" and case.integrals(case.state)[2] == 0)
        alpha = exponent(family, n, same)
        slopes = [np.log(a / b) / np.log(plain(p / q))
                  for a, b, p, q in zip(far, far[1:], NAMED + SMALL, (NAMED + SMALL)[1:])]
        # next terms are smaller by ε^(1/5) or more: a few hundredths in the slope at 10⁻⁴, below 10⁻³ at
        # 10⁻¹⁴
        assert abs(slopes[1] - alpha) < 0.05 and abs(slopes[-1] - alpha) < 1e-3
        assert min(range(1, 9), key=lambda j: abs(slopes[1] - exponent(family, j, same))) == n  # noqa: B023


@pytest.mark.parametrize("kind", UNSTABLE, ids=names)
def test_excursion_from_an_unstable_point_is_of_order_one(kind):
    """abs(k3 − z0) > 1/4 for every ε, and tends to the next root of the unperturbed g on a side where g > 0.
    """
    for case, far in zip(cases(*kind), excursions(kind)):
        real = [float(r) for r in roots(case.reduced(case.state))[0]]
        sides = [min(r for r in real if r > 0)] if case.first > 0 else []
        if case.family == "inclined" and case.first * (-1) ** kind[2] > 0:
            sides.append(min(-r for r in real if r < 0))
        assert min(far + sides) > plain(REACH)
        # ε = 10⁻¹² over the slope of g there
        assert min(abs(far[-1] / y - 1) for y in sides) < 1e-9


@pytest.mark.parametrize("kind", INTEGRATED, ids=names)
def test_integrated_motion_turns_where_g_says(kind):
    """Over a period of k3 the 6-dimensional motion from a point moved by ε = 10⁻² turns at the roots of g.

    Three cases of each kind.
    """
    for case in cases(*kind)[::6]:
        far, step = excursion(case, NAMED[0])
        x = case.moved(step)
        g, (low, high) = case.reduced(x), map(float, turning_points(case, x))
        others = sorted(map(complex, roots(g)[1]),
                        key=lambda r: min(abs(r - low), abs(r - high)))[2:]       # noqa: B023
        theta = (np.arange(4000) + 0.5) * np.pi / 4000
        y = (low + high) / 2 - (high - low) / 2 * np.cos(theta)
        lead = next(c for c in reversed(g) if c)
        # g = (y − low)(high − y) q
        q = -plain(lead) * np.prod([y - r for r in others], axis=0).real
        period = 2 * plain(case.I1) * np.pi * np.mean(1 / np.sqrt(q))
        slope = [plain(i * a) for i, a in enumerate(case.potential)][1:]
        I1, I3, l = map(plain, (case.I1, case.I3, case.l))
        motion = solve_ivp(lambda t, x: oracle.axial_field(x, I1, I3, l, slope),  # noqa: B023
                           (0, 1.01 * period), list(map(plain, x)), method="DOP853", rtol=1e-11, atol=1e-13,
                           events=lambda t, x: x[3] * x[1] - x[4] * x[0])
        extremes = case.sigma * (motion.y_events[0][:, 5] - plain(case.state[5]))
        # invariants are kept to 10⁻¹⁰; a turning point is as sensitive to e as 1/ε² = 10⁴ times: 10⁻⁶
        assert abs(min(extremes) - low) < 1e-6 * far and abs(max(extremes) - high) < 1e-6 * far
        assert max(abs(motion.y[5] - plain(case.state[5]))) < (1 + 1e-6) * far
        end = vector(fmpq(*a.as_integer_ratio()) for a in motion.y[:, -1])
        for before, after in zip((*case.integrals(x), fmpq(1)), (*case.integrals(end), end[3:].dot(end[3:]))):
            assert abs(plain(after - before)) < 1e-10
