"""Bodies in polynomial fields drawn so that complex curves, or real ones, lie among the rotations."""
from fractions import Fraction as F

KINDS = ("at rest", "missing components", "Clebsch", "Brun", "Brun on its curve", "equal moments",
         "Kovalevskaya", "cubic at rest", "cubic", "a factor", "at a rate")


def drawn(rnd, kind):
    """Moments, rotor, U as {exponents: coefficient}, and the level {"C1": …} or rate {"omega": …}."""
    def number(most=4, below=2):
        return F(rnd.randint(-most, most), rnd.randint(1, below))

    def sparse(exponents, keep=0.5):
        return {e: number() for e in exponents if rnd.random() < keep}

    inertia = rnd.sample([F(1), F(2), F(3), F(4), F(3, 2), F(5, 2)], 3)
    rotor, level = [F(0)] * 3, F(0)
    first = [(1, 0, 0), (0, 1, 0), (0, 0, 1)]
    squares = [(2, 0, 0), (0, 2, 0), (0, 0, 2)]
    mixed = [(1, 1, 0), (1, 0, 1), (0, 1, 1)]
    cubes = [(3, 0, 0), (0, 3, 0), (0, 0, 3), (1, 1, 1), (2, 1, 0), (0, 2, 1), (1, 0, 2)]
    if kind == "at rest":
        terms = sparse(first + squares + mixed)
    elif kind == "missing components":
        terms = sparse(first, 0.6) | sparse(mixed, 0.3)
        rotor, level = [number(2) * rnd.randint(0, 1) for _ in range(3)], number()
    elif kind == "Clebsch":
        c = rnd.choice([-1, 1]) * F(rnd.randint(1, 6))
        terms, level = {e: c / m for e, m in zip(squares, inertia)}, number()
    elif kind == "Brun":
        c = number() or F(1)
        terms, level = {e: c * m for e, m in zip(squares, inertia)}, number(9)
    elif kind == "Brun on its curve":
        low, high = min(inertia), max(inertia)
        J, omega = low + (high - low) * F(rnd.randint(1, 5), 6), F(rnd.randint(1, 5), 2)
        terms, level = {e: omega**2 * m / 2 for e, m in zip(squares, inertia)}, J * omega
    elif kind == "equal moments":
        inertia = [inertia[0], inertia[0], rnd.choice(inertia[:2])]
        rnd.shuffle(inertia)
        terms = sparse(first + squares + mixed, 0.4)
        rotor, level = [number(2) * rnd.randint(0, 1) for _ in range(3)], number() * rnd.randint(0, 1)
    elif kind == "Kovalevskaya":
        inertia, terms, level = [F(2), F(2), F(1)], sparse(first[:2], 0.8), number()
        rotor = [F(0), F(0), number() * rnd.randint(0, 1)]
    elif kind == "cubic at rest":
        terms = sparse(first + squares + mixed + cubes, 0.25)
    elif kind == "cubic":
        terms, level = sparse(first + cubes, 0.3), number() * rnd.randint(0, 1)
        rotor = [number(2) * rnd.randint(0, 1) for _ in range(3)]
    elif kind == "a factor":                               # a power: all zeros of its base are critical
        form, power = {e: number() for e in (first if rnd.random() < 0.5 else squares)}, rnd.randint(2, 3)
        terms = {(0, 0, 0): F(1)}
        for _ in range(power):
            terms = _product(terms, form)
    else:
        terms, rotor = sparse(first + cubes, 0.3), [number(2) * rnd.randint(0, 1) for _ in range(3)]
        return inertia, rotor, {e: c for e, c in terms.items() if c}, {"omega": number() * rnd.randint(0, 1)}
    return inertia, rotor, {e: c for e, c in terms.items() if c}, {"C1": level}


def _product(f, g):
    found = {}
    for e, c in f.items():
        for m, d in g.items():
            place = tuple(x + y for x, y in zip(e, m))
            found[place] = found.get(place, 0) + c * d
    return found
