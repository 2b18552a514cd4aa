"""Is every motion answered that starts close to a pole, and is it right.

Does every equilibrium confirm its verdict, or say why not?

    python benchmarks/near_poles.py            500 starts of each kind, 200 equilibria
    python benchmarks/near_poles.py --quick    a seeded part; exit status 1 if anything is not answered, wrong
        or in contradiction

Starts: 10⁻⁴ to 10⁻¹⁴ from either pole, at rest, with a momentum of that size or with any; U a polynomial,
exponential, rational or trigonometric; l of both signs; oblate and prolate. Hard starts: fields with a
singularity near the pole, roots and logarithms, scales from 10⁻⁶ to 10⁶, starts close to separatrices and to
steady precessions, at the pole itself. The reference: Taylor series to 40 digits (axial_reference.py), at ten
times over three periods. The deviation is that of the worst coordinate, over the size of momenta.
"""
import argparse
import platform
import random
import sys
import time
from collections import Counter
from fractions import Fraction as F

import sympy
from axial_reference import Reference, deviation

import gyrostat as gs
from gyrostat.errors import GyrostatError
from gyrostat.trajectories import confirm, motion

K3 = gs.symbol("k3")
# LONGEST: of a motion without a period, and of what the reference follows
TIMES, PERIODS, LONGEST = 10, 3, 200
ALLOWED = 1e-13


def fraction(rng, low=-3, high=3, denominator=8):
    return F(rng.randint(low * denominator, high * denominator), denominator)


def nonzero(rng, *given):
    while not (x := fraction(rng, *given)):
        pass
    return x


def field(rng, kind):
    """The terms of U for the reference, and U."""
    a, b = nonzero(rng), nonzero(rng, -2, 2)
    if kind == "polynomial":
        terms = [("polynomial", 0, *(fraction(rng) for _ in range(rng.randint(0, 4))), a)]
    elif kind == "exponential":
        terms = [("exp", a, b)]
    elif kind == "rational":
        terms = [("power", a, rng.choice((-1, 1)) * fraction(rng, 2, 4), -rng.randint(1, 3))]
    elif kind == "trigonometric":
        terms = [("sin", a, b, rng.choice((F(0), fraction(rng, -1, 1))))]
    elif kind == "singular":
        terms = [("power", a / 1000, rng.choice((-1, 1)) * (1 + F(1, 10 ** rng.randint(1, 4))), -1)]
    elif kind == "root":
        c = fraction(rng, 2, 3)
        terms = [rng.choice((("power", a, c, F(rng.choice((1, 3, -1)), 2)), ("log", a, c),
                             ("tan", a, F(1, 2))))]
    else:
        terms = [("exp", a, b), ("polynomial", 0, fraction(rng), fraction(rng)), ("sin", fraction(rng), b, 0)]
    if kind in ("rational", "exponential") and rng.random() < 0.3:
        terms.append(("polynomial", 0, fraction(rng)))
    return terms


def expression(terms):
    def one(kind, *given):
        c = [sympy.Rational(F(x).numerator, F(x).denominator) for x in given]
        return {"polynomial": lambda: sum(x * K3**n for n, x in enumerate(c)),
                "exp": lambda: c[0] * sympy.exp(c[1] * K3),
                "sin": lambda: c[0] * sympy.sin(c[1] * K3 + c[2]), "tan": lambda: c[0] * sympy.tan(c[1] * K3),
                "power": lambda: c[0] * (K3 + c[1]) ** c[2],
                "log": lambda: c[0] * sympy.log(K3 + c[1])}[kind]()

    return sum(one(*term) for term in terms)


def close(rng, pole, e):
    """A direction about 2 e from the pole: rational."""
    c, s = rng.choice(((1, 0), (0, -1), (F(3, 5), F(4, 5)), (F(-5, 13), F(12, 13))))
    return 2 * e * c / (1 + e * e), 2 * e * s / (1 + e * e), pole * (1 - e * e) / (1 + e * e)


KINDS = ("polynomial", "exponential", "rational", "trigonometric")
HARD = ("singular", "root", "mixed")


def start(rng, kind):
    """A scene, its reference and a state close to a pole."""
    e = F(10) ** -rng.randint(4, 14) * rng.randint(1, 9)
    I1, I3 = fraction(rng, 1, 4), F(rng.randint(1, 32), 8)
    size = rng.choice((F(0), e, e, e, e, F(1)))
    p = size * fraction(rng), size * fraction(rng)
    return field(rng, kind), I1, I3, fraction(rng), (*p, fraction(rng), *close(rng, rng.choice((1, -1)), e))


def scaled(rng, kind):
    """Moments of 10⁻⁶ to 10⁶, U and momenta so that times are of order one."""
    terms, I1, I3, l, x = start(rng, rng.choice(KINDS))
    unit = F(10) ** rng.choice((-6, -3, 3, 6))
    terms = [(name, *(c * unit if i == 0 or name == "polynomial" else c for i, c in enumerate(given)))
             for name, *given in terms]
    return terms, I1 * unit, I3 * unit, l * unit, (*(c * unit for c in x[:3]), *x[3:])


def at_pole(rng, kind):
    """Exactly at the pole, at rest there or not, or passing it: v = ±P."""
    terms, I1, I3, l, x = start(rng, rng.choice((*KINDS, *HARD)))
    pole = rng.choice((1, -1))
    size = rng.choice((F(0), F(1), F(1, 10**6), F(1, 10**12)))
    return terms, I1, I3, l, (size * fraction(rng), size * nonzero(rng), x[2], 0, 0, pole)


def through_pole(rng, kind):
    """A state from which the axis reaches the pole: the twist v − P k3 is P (±1 − k3)."""
    terms, I1, I3, l, x = start(rng, rng.choice((*KINDS, *HARD)))
    k1, k2, k3 = x[3:]
    twist, along = (x[2] + l) * ((1 if k3 > 0 else -1) - k3), fraction(rng) * rng.choice((1, x[3] + x[4]))
    square = k1 * k1 + k2 * k2
    p = ((twist * k1 - along * k2) / square, (twist * k2 + along * k1) / square) if square else (F(0), F(0))
    if max(map(abs, p)) > 10:
        p = twist * k1 / square, twist * k2 / square
    return terms, I1, I3, l, (*p, *x[2:])


def near_steady(rng, kind):
    """About 10⁻⁴ to 10⁻¹⁴ from a steady precession: P = (U′ + I1 k3 W²)/W, p = I1 W (k1, k2)."""
    terms, I1, I3, l, _ = start(rng, rng.choice(("polynomial", "rational")))
    k1, k2, k3 = rng.choice(((F(3, 5), 0, F(4, 5)), (F(4, 5), 0, F(-3, 5)), (1, 0, 0),
                             (F(5, 13), 0, F(12, 13))))
    W = nonzero(rng)
    slope = expression(terms).diff(K3).subs(K3, sympy.Rational(k3.numerator, k3.denominator)
                                            if isinstance(k3, F) else k3)
    slope = F(int(slope.p), int(slope.q))
    P, e = (slope + I1 * k3 * W * W) / W, F(10) ** -rng.randint(4, 14)
    return terms, I1, I3, l, (I1 * W * k1 + e * fraction(rng), e * fraction(rng), P - l + e * fraction(rng),
                              k1, k2, k3)


def near_separatrix(rng, kind):
    """The energy and v of an unstable pole but for 10⁻⁴ to 10⁻¹⁴.

    The momentum p is across the meridian, and its size is the one that reaches the pole.
    """
    while True:
        terms, I1, I3, l, _ = start(rng, "polynomial")
        k1, k3 = rng.choice(((F(3, 5), F(4, 5)), (F(4, 5), F(-3, 5)), (F(5, 13), F(12, 13))))
        pole = 1 if k3 > 0 else -1
        values = (
            [sum(c * z**n for n, c in enumerate(terms[0][1:])) for z in (F(pole), k3)]
            if len(terms) == 1
            else None
        )
        spin = fraction(rng, -1, 1)
        if values is None:
            continue
        first = (spin + l) * (pole - k3) / k1
        square = 2 * I1 * (values[0] - values[1]) - first**2
        if square > 0:
            second = (
                F(int(float(square) ** 0.5 * 10**12), 10**12)
                if rng.random() < 0.5
                else F(float(square) ** 0.5)
            )
            second += F(10) ** -rng.randint(4, 14)
            return terms, I1, I3, l, (first, second, spin, k1, F(0), k3)


FAMILIES = {**dict.fromkeys((*KINDS, *HARD), start), "scaled": scaled, "at the pole": at_pole,
            "through a pole": through_pole,
            "near a steady precession": near_steady, "near a separatrix": near_separatrix}


def number(x):
    return sympy.Rational(F(x).numerator, F(x).denominator)


def deviation_of(case, precision=None):
    """The worst deviation over three periods, and the route."""
    terms, I1, I3, l, state = case
    scene = gs.assemble(gs.Gyrostat(tuple(map(number, (I1, I1, I3))), (0, 0, number(l))),
                        gs.axial_potential(expression(terms)))
    moving = motion(scene, tuple(map(number, state)), precision=precision)
    end = min(PERIODS * float(moving.period), LONGEST) if moving.period else min(20, LONGEST)
    if moving.period is not None and not 0 < moving.period < float("inf"):
        raise ArithmeticError(f"period {moving.period}")
    times = [F(end * n / (TIMES - 1)).limit_denominator(2**20) for n in range(TIMES)]
    times = [F(int(t * 2**20), 2**20) for t in times]
    reference = Reference(terms, I1, I3, l, state, 40 if precision is None else precision + 15)
    states = [moving(float(t) if precision is None else t) for t in times]
    size = max(1, abs(l), *(abs(float(c)) for c in states[0]))
    return max(deviation(x, reference.at(t)) for x, t in zip(states, times)) / size, moving.route


def starts(seed, count, kinds, precision=None):
    """Print, for each kind of start, how many were answered, refused or broke, and the worst deviation.

    Whether all is well.
    """
    well = True
    for kind in kinds:
        rng, routes, worst, failed, began = (
            random.Random(f"{seed} {kind}"),
            Counter(),
            (0.0, None),
            [],
            time.time(),
        )
        for n in range(count):
            case = FAMILIES[kind](rng, kind)
            try:
                off, route = deviation_of(case, precision)
            except Exception as error:
                whose = "" if isinstance(error, GyrostatError) else " (not ours)"
                failed.append(f"{n}: {type(error).__name__}{whose}: {error}: {case}")
                continue
            routes[route] += 1
            worst = max(worst, (off, (n, case)), key=lambda pair: pair[0])
        allowed = ALLOWED if precision is None else 10.0 ** (2 - precision)
        well = well and not failed and worst[0] <= allowed
        answered = f"{count - len(failed)} of {count} answered, worst {worst[0]:.1e}, {dict(routes)}"
        print(f"{kind:26}{answered}, {time.time() - began:.0f} s", flush=True)
        if worst[0] > allowed:
            print("    ", worst)
        print(*(f"     {text}\n" for text in failed), sep="", end="")
    return well


def of_revolution(rng):
    """E1, E2 or E3 of a body of revolution, inside a criterion or on its boundary."""
    terms = field(rng, rng.choice((*KINDS, *HARD[1:])))
    U, I3 = expression(terms), number(F(rng.randint(1, 24), 8))
    family, boundary = rng.choice((gs.upright, gs.hanging, gs.inclined)), rng.random() < 0.4
    if family is gs.inclined:
        I1, omega, k3 = (
            number(fraction(rng, 1, 3)),
            number(nonzero(rng)),
            rng.choice(
                (
                    number(fraction(rng, 0, 0) + F(3, 5)),
                    *map(number, (0, F(-4, 5), F(1, 3), F(999, 1000), F(-9999, 10000))),
                )
            ),
        )
        if boundary:                                   # the curvature of U that makes the margin 0
            slope, A = U.diff(K3).subs(K3, k3), I1 * omega**2
            wanted = -(A**2 + slope**2 - 2 * k3 * slope * A) / ((1 - k3**2) * A)
            U += (wanted - U.diff(K3, 2).subs(K3, k3)) * (K3 - k3) ** 2 / 2
        eq = family(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(U)))
        return eq, {"I1": I1, "I3": I3, "omega": omega, "k3": k3}, "E3" + " on a boundary" * boundary
    pole = 1 if family is gs.upright else -1
    P, l, slope = number(nonzero(rng)), number(fraction(rng)), U.diff(K3).subs(K3, pole) * pole
    boundary = boundary and bool(slope > 0)
    I1 = P**2 / (4 * slope) if boundary else number(fraction(rng, 1, 4))
    eq = family(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(U)))
    return (
        eq,
        {"I1": I1, "I3": I3, "l": l, "pi3_0": P - l},
        ("E1" if pole == 1 else "E2") + " on a boundary" * boundary,
    )


def free(rng):
    """A free gyrostat turning about a principal axis along which the rotor lies."""
    inertia, axis = [number(fraction(rng, 1, 4)) for _ in range(3)], rng.randrange(3)
    if rng.random() < 0.3:
        inertia[rng.randrange(3)] = inertia[0]
    rotor, point = [0, 0, 0], [0, 0, 0]
    rotor[axis], point[axis] = number(fraction(rng) * rng.choice((0, 1))), number(nonzero(rng))
    # the rate that makes the body as if it had an equal moment
    if rng.random() < 0.3:
        other = inertia[(axis + 1) % 3]
        rotor[axis] = point[axis] * (other / inertia[axis] - 1)
    return gs.equilibrium(gs.assemble(gs.Gyrostat(inertia, rotor)), point), {}, "free"


def general(rng):
    """A body without symmetry, spinning about the vertical, which is a principal axis and an axis of its
    field.
    """
    inertia = [number(fraction(rng, 1, 4)) for _ in range(3)]
    c = [number(fraction(rng, -2, 2)) for _ in range(4)]
    (m, n), c[3] = rng.choice(((2, 2), (2, 4), (4, 4))), c[3] * rng.choice((0, 1))
    U = gs.general_potential(lambda x, y, z: c[0] * x**m + c[1] * y**n + c[2] * z + c[3] * sympy.exp(z))
    l, spin = number(fraction(rng)), number(fraction(rng))
    return gs.equilibrium(gs.assemble(gs.Gyrostat(inertia, (0, 0, l)), U),
                          (0, 0, spin, 0, 0, rng.choice((1, -1)))), {}, "general"


def confirmations(seed, count, sizes):
    """Print how many verdicts the motions confirm; whether none is contradicted and none raises."""
    rng, outcome, failed, began = random.Random(f"{seed} confirm"), Counter(), [], time.time()
    for n in range(count):
        made = rng.choices((of_revolution, free, general), (6, 2, 2))[0]
        try:
            eq, values, name = made(rng)
        # a field without derivatives there, moments that are none
        except GyrostatError:
            outcome["no equilibrium"] += 1
            continue
        try:
            found = confirm(gs.analyze(eq), values, sizes)
        except Exception as error:
            failed.append(f"{n}: {name}: {type(error).__name__}: {error}: {eq.system.potential}, "
                          f"{eq.system.body}, {values}")
            continue
        answer = {True: "agrees", False: "contradicts", None: found.why}[found.agrees]
        outcome[name, found.decision.verdict.name, answer] += 1
        if found.agrees is False or not answer:
            failed.append(f"{n}: {name}: {found}: {eq.system.potential}, {eq.system.body}, {values}")
    for key, number_of in sorted(outcome.items(), key=str):
        print(f"{number_of:5}  {key}")
    print(*(f"     {text}\n" for text in failed), sep="", end="")
    print(f"{count} equilibria, {len(failed)} contradicted, without a reason or not answered, "
          f"{time.time() - began:.0f} s")
    return not failed


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--seed", default=1)
    parser.add_argument("--count", type=int)
    parser.add_argument("--kinds", nargs="*", default=list(FAMILIES))
    parser.add_argument("--precision", type=int, help="decimal digits of the motions")
    parser.add_argument("--equilibria", type=int)
    given = parser.parse_args()
    print(platform.processor() or platform.machine(), "Python", platform.python_version(), "gyrostat",
          gs.__version__)
    well = starts(given.seed, given.count or (2 if given.quick else 500), given.kinds, given.precision)
    sizes = [F(1, 10**d) for d in ((3, 5, 7) if given.quick else range(2, 9))]
    many = given.equilibria if given.equilibria is not None else 4 if given.quick else 200
    well = confirmations(given.seed, many, sizes) and well
    sys.exit(0 if well else 1)


if __name__ == "__main__":
    main()
