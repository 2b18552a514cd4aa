"""Is zero recognised for what it is? Random identities, true by construction, and the same moved by 10⁻³⁰.

    python benchmarks/zero_identities.py [--quick] [--seed N]

Each kind writes one number in two ways: by polynomial identities between symbols, which then become numbers
(π, e^(k/n), roots, cosines), by the addition theorems, by the rules of logarithms, by denesting roots. The
sign of the difference has to be 0, that of the difference ± 10⁻³⁰ has to be ±1. Undecided and wrong answers
and everything over 20 s are counted, by kind.
"""
import argparse
import platform
import random
import signal
import statistics
import sys
import time
from collections import Counter

import flint
import sympy
from sympy import (
    Add,
    CRootOf,
    Expr,
    Mul,
    Pow,
    Rational,
    Symbol,
    cos,
    cosh,
    exp,
    log,
    pi,
    root,
    sin,
    sinh,
    sqrt,
    symbols,
    tan,
    tanh,
)

import gyrostat
from gyrostat.algebra.enclosures.balls import ball
from gyrostat.algebra.reals.exact import sign_of_constant

TINY, LIMIT = Rational(1, 10**30), 20                  # s for one sign
X, A, B = symbols("X A B")


def rational(rng: random.Random, most: int = 9) -> Rational:
    return Rational(rng.randint(1, most) * rng.choice((1, -1)), rng.randint(1, most))


def algebraic(rng: random.Random) -> Expr:
    """An irrational algebraic number of degree up to 64."""
    x = Symbol("x")
    return rng.choice((
        lambda: sqrt(rng.choice((2, 3, 5, 6, 7, 10, 30))),
        lambda: root(rng.randint(2, 9), rng.choice((3, 5, 7, 12))),
        lambda: root(2, rng.choice((16, 32, 64))),
        lambda: sqrt(2) + sqrt(3) + rng.choice((0, 1)) * sqrt(5) * rational(rng),
        lambda: Add(*(sqrt(p) for p in (2, 3, 5, 7, 11, 13))),
        lambda: sqrt(rng.randint(1, 5) + sqrt(rng.choice((2, 3, 5)))),
        lambda: root(2, 12) * root(3, 5),
        lambda: CRootOf(x**5 - x + rng.randint(1, 5), 0),
        lambda: cos(rng.randint(1, 59) * pi / rng.randint(7, 120)),
    ))()


def spelled(rng: random.Random) -> Expr:
    """A polynomial or rational identity between symbols.

    An expression that is 0, written as the difference of two forms.
    """
    def factor() -> Expr:
        return (
            rational(rng) * X ** rng.randint(0, 3)
            + rational(rng) * A
            + rational(rng) * B * X ** rng.randint(0, 1)
            + rational(rng)
        )

    f, g, h = factor(), factor(), factor()
    return rng.choice((
        lambda: Add(Mul(f, g, h), -sympy.expand(f * g * h)),
        lambda: Add(Pow(f, 4), -sympy.expand(f**4)),
        lambda: Add(Mul(f, g), -((f + g) / 2) ** 2, ((f - g) / 2) ** 2),
        lambda: Add(1 / f, 1 / g, -sympy.expand(f + g) / sympy.expand(f * g)),
        lambda: Add(1 / (1 + 1 / (2 + h / f)), -sympy.expand(2 * f + h) / sympy.expand(3 * f + h)),
        lambda: Add(sympy.expand(f * g) / f, -g),
    ))()


def of_pi(rng: random.Random) -> Expr:
    return spelled(rng).xreplace({X: pi, A: algebraic(rng), B: algebraic(rng)})


def of_one_power(rng: random.Random) -> Expr:
    """e^(a/n), its powers and products written in several ways."""
    n, a, b = rng.randint(1, 24), rng.randint(1, 12), rng.randint(-12, 12)
    value, moved = exp(Rational(a, n)), exp(Rational(b, 2 * n))
    again = rng.choice((lambda: cosh(Rational(a, n)) + sinh(Rational(a, n)),
                        lambda: exp(Rational(a, n) - Rational(b, 2 * n)) * moved,
                        lambda: 1 / (cosh(Rational(a, n)) - sinh(Rational(a, n))),
                        lambda: Mul((1 + tanh(Rational(a, 2 * n))), 1 / (1 - tanh(Rational(a, 2 * n))))))()
    alpha = algebraic(rng)
    mixed = spelled(rng)
    left, right = mixed.args[0], Add(*mixed.args[1:])
    return left.xreplace({X: value, A: alpha, B: moved}) + right.xreplace({X: again, A: alpha, B: moved})


def of_logarithms(rng: random.Random) -> Expr:
    """Σ c log r with one product of powers of rationals that is 1."""
    primes = (2, 3, 5, 7, 11, 13)
    parts = [{p: rng.randint(-3, 3) for p in rng.sample(primes, rng.randint(1, 4))}
             for _ in range(rng.randint(1, 4))]
    scale = rng.choice((rational(rng), algebraic(rng)))
    terms, total = [], Counter()
    for part in parts:
        n = rng.randint(1, 4)
        terms.append(n * scale * log(Mul(*(Rational(p) ** e for p, e in part.items()))))
        for p, e in part.items():
            total[p] += n * e
    held = rng.sample(sorted(total), rng.randint(0, len(total)))             # together, the others one by one
    return Add(*terms, -scale * log(Mul(*(Rational(p) ** total[p] for p in held))),
               *(-scale * total[p] * log(p) for p in total if p not in held))


def turned(rng: random.Random, a: Expr, b: Expr) -> Expr:
    """An identity between the functions of two angles."""
    n = rng.randint(2, 7)
    return rng.choice((
        lambda: cos(a) ** 2 + sin(a) ** 2 - 1,
        lambda: cos(a) * cos(b) - (cos(a - b) + cos(a + b)) / 2,
        lambda: sin(a) * cos(b) + cos(a) * sin(b) - sin(a + b),
        lambda: cos(n * a) - sympy.chebyshevt(n, X).xreplace({X: cos(a)}),
        lambda: sin(2 * a) - 2 * tan(a) / (1 + tan(a) ** 2),
        lambda: tan(a + b) - (tan(a) + tan(b)) / (1 - tan(a) * tan(b)),
        lambda: sin(3 * a) - 4 * sin(a) * sin(pi / 3 - a) * sin(pi / 3 + a),
        lambda: cos(a) ** 4 - (3 + 4 * cos(2 * a) + cos(4 * a)) / 8,
    ))()


def of_turns(rng: random.Random) -> Expr:
    """Sines and cosines of rπ with denominators up to 120."""
    q = rng.randint(7, 120)
    p = rng.choice([q, *(d for d in (1, 2, 3, 4, 5, 6, 8, 12) if q % d == 0)])
    a, b = Rational(rng.randint(1, 2 * q), q) * pi, Rational(rng.randint(1, 2 * p), p) * pi
    if rng.random() < 0.2:
        n = rng.randint(5, 40)
        return rng.choice((Add(*(cos(2 * k * pi / n) for k in range(1, n + 1))),
                           Add(-Rational(n, 2), *(cos(k * pi / n) ** 2 for k in range(n)))))
    return turned(rng, a, b)


def of_angles(rng: random.Random) -> Expr:
    """Sines and cosines of rational numbers, or of those and rπ."""
    n = rng.randint(1, 12)
    a, b = Rational(rng.randint(1, 30), n), Rational(rng.randint(1, 30), n)
    return turned(rng, a, b if rng.random() < 0.7 else Rational(rng.randint(1, 20), rng.randint(7, 20)) * pi)


def of_turns_and_pi(rng: random.Random) -> Expr:
    """Both at once, in a field of degree at most 64."""
    q = rng.choice([n for n in range(7, 60) if sympy.totient(12 * n) <= 64])
    angle = Rational(rng.randint(1, q - 1), q) * pi
    zero = spelled(rng).xreplace({X: pi, A: cos(angle), B: sin(rng.randint(1, 9) * angle)})
    return turned(rng, angle, 2 * angle) * (rational(rng) + rational(rng) * pi) + zero


def of_nested_roots(rng: random.Random) -> Expr:
    a, b = rng.sample(range(2, 40), 2)
    scale = rng.choice((1, pi, exp(Rational(rng.randint(1, 5), 3)), log(rng.randint(2, 9)), cos(1)))
    value = sqrt(a + b + 2 * sqrt(a * b))
    return rng.choice((Add(value * scale, -sqrt(a) * scale, -sqrt(b) * scale),
                       Add(1 / (value + scale), -1 / (sqrt(a) + sqrt(b) + scale)),
                       Add((value + scale) ** 3,
                           -sympy.expand((X + A + B) ** 3).xreplace({X: sqrt(a), A: sqrt(b), B: scale}))))


KINDS = {"ℚ(α)(π)": of_pi, "e^(a/n)": of_one_power, "logarithms": of_logarithms, "sin, cos of rπ": of_turns,
         "sin, cos of rationals": of_angles, "rπ and π": of_turns_and_pi, "nested roots": of_nested_roots}


def identities(seed: int, count: int):
    """(kind, an expression that is 0), those that SymPy does not see through by itself."""
    rng = random.Random(seed)
    names = list(KINDS)
    while count:
        kind = names[count % len(names)]
        zero = KINDS[kind](rng)
        if zero == 0 or not ball(zero, 128).is_finite():
            continue
        count -= 1
        yield kind, zero


def run(seed: int, count: int) -> tuple[Counter, dict[str, list[float]]]:
    """What became of the identities and near-identities, and the seconds of CPU of each sign, by kind."""
    def stop(*_: object) -> None:
        raise TimeoutError

    signal.signal(signal.SIGPROF, stop)
    outcome, spent = Counter(), {kind: [] for kind in KINDS}
    for kind, zero in identities(seed, count // 2):
        for shift in (0, random.Random(str(zero)).choice((1, -1))):
            begun = time.process_time()
            signal.setitimer(signal.ITIMER_PROF, LIMIT)
            try:
                found = sign_of_constant(zero + shift * TINY)
                answer = "right" if found == shift else "undecided" if found is None else "wrong"
            except TimeoutError:
                answer = "hung"
            signal.setitimer(signal.ITIMER_PROF, 0)
            spent[kind].append(time.process_time() - begun)
            outcome[kind, answer] += 1
            if answer != "right":
                print(f"{answer}: {kind}, shift {shift}: {zero}", file=sys.stderr)
    return outcome, spent


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true", help="400 signs in place of 10⁴")
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    outcome, spent = run(given.seed, 400 if given.quick else 10_000)
    print(f"gyrostat {gyrostat.__version__}, SymPy {sympy.__version__}, python-flint {flint.__version__}, "
          "Python "
          f"{platform.python_version()}, {platform.machine()}; seed {given.seed}")
    print("kind                     signs  wrong  undecided  hung   median    worst")
    for kind in KINDS:
        times = spent[kind]
        print(f"{kind:24s} {len(times):5d} {outcome[kind, 'wrong']:6d} {outcome[kind, 'undecided']:10d} "
              f"{outcome[kind, 'hung']:5d} "
              f"{1e3 * statistics.median(times):6.1f} ms {1e3 * max(times):6.0f} ms")
    return int(any(answer != "right" for _, answer in outcome))


if __name__ == "__main__":
    sys.exit(main())
