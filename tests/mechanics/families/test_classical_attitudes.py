"""Attitudes along the axes of the orbit, under each torque of the how-to page, against the Lagrangian."""
from itertools import combinations
from pathlib import Path
from random import Random

import pytest
from attitude_motion import coefficients, positive, small_motion, spectrally_stable
from slow import sampled
from sympy import Rational, diag, expand, sympify

import gyrostat as gs

PAGE = Path(__file__).parents[3] / "docs" / "how-to" / "satellites.md"
I, W, L = tuple(map(gs.symbol, ("I1", "I2", "I3"))), gs.symbol("omega0"), gs.symbol("l")
NAMES = {name: gs.symbol(name) for name in ("I1", "I2", "I3", "omega0", "l", "a", "b", "A", "B", "J", "h")}


def formula(text):
    """A text of the page."""
    return sympify(text.strip(" `").replace("^", "**") or "0", NAMES)


def rows():
    """(title, potential, the parts of roll, pitch and yaw) of the table."""
    section = PAGE.read_text(encoding="utf-8").split("## What each torque adds")[1].split("\n## ")[0]
    lines = [line for line in section.splitlines() if line.startswith("|")]
    cells = [[cell.strip() for cell in line.strip("|").split("|")] for line in lines]
    return [(title, text.strip("`"), [formula(x) for x in parts]) for title, text, *parts in cells[2:]]


ROWS = rows()


def of_directions(text):
    """V(t, n, r) of a potential in components."""
    def potential(t, n, r):
        components = {f"{a}{i}": x for a, v in zip("tnr", (t, n, r)) for i, x in enumerate(v, 1)}
        return expand(sympify(text.replace("^", "**") or "0", NAMES | components))
    return potential


@pytest.mark.slow
def test_every_row_of_the_page_is_a_part_of_the_stiffness():
    """Where the torques vanish; K is diagonal, and what a row says is what it adds."""
    def stiffness(text, l):
        gradient, K, _ = small_motion(I, I, (0, l, 0), W, of_directions(text))
        assert gradient == [0, 0, 0]
        return K

    alone = stiffness("", 0)
    assert len(ROWS) == 8
    for title, text, parts in ROWS:
        wheel = L if title.startswith("wheel") else 0
        K = stiffness(text, wheel) - (alone if text or wheel else 0 * alone)
        assert (K - diag(*parts)).expand() == 0 * alone, title


def drawn(rng, names):
    """Numbers for names: moments and rates are positive."""
    def sign(x):
        return 1 if x.is_positive else rng.choice([1, -1])

    return {x: Rational(sign(x) * rng.randint(1, 40), rng.choice([7, 10, 20]))
            for x in sorted(names, key=str)}


def holds(criterion, numbers):
    """Whether one alternative does."""
    def true(c):
        value = c.margin.xreplace(numbers)
        return value > 0 if c.strict else value >= 0

    return any(all(map(true, alternative)) for alternative in criterion.alternatives)


def compared(full, scene, moments, gravity, l, text, seed):
    """Necessary, sufficient and damped at random numbers against the oracle; whether each truth was met."""
    report, rng, met = gs.analyze(gs.earth_pointing(scene)), Random(seed), set()
    _, K, G = small_motion(moments, gravity, (0, l, 0), W, of_directions(text))
    c = coefficients(moments, K, G)
    for _ in range(sampled(200, full, 50)):
        numbers = drawn(rng, set().union(*(x.free_symbols for x in (*c, K))))
        if any(x.xreplace(numbers) <= 0 for x in moments):
            continue
        stable, definite = spectrally_stable([x.xreplace(numbers) for x in c]), positive(K.xreplace(numbers))
        assert holds(report.necessary, numbers) == stable
        assert holds(report.sufficient, numbers) == holds(report.damped, numbers) == definite
        met.add((stable, definite))
    return met


@pytest.mark.slow
@pytest.mark.parametrize("rotor", [0, L])
@pytest.mark.parametrize("number", [n for n in range(8) if n != 1])
def test_the_conditions_of_each_torque(full, number, rotor):
    """With a wheel and without: all three criteria."""
    text = ROWS[number][1]
    scene = gs.assemble(gs.Gyrostat(I, (0, rotor, 0)), gs.circular_orbit(potential=text or 0))
    assert (True, True) in compared(full, scene, I, I, rotor, text, number)


@pytest.mark.slow
def test_torques_together(full):
    """Two of them, and a wheel."""
    for one, other in list(combinations([text for _, text, _ in ROWS if text], 2))[::1 if full else 9]:
        text = f"{one} + {other}"
        scene = gs.assemble(gs.Gyrostat(I, (0, L, 0)), gs.circular_orbit(potential=text))
        assert compared(full, scene, I, I, L, text, 5)


@pytest.mark.slow
def test_a_wheel_that_runs_free(full):
    """Counts as l = h − ω0 J, but its moment is missing from pitch."""
    J, h = NAMES["J"], NAMES["h"]
    wheel = gs.Rotor((0, 1, 0), J, momentum=h)
    body = gs.gyrostat_with_rotors(I, [wheel], lumped=True)
    scene = gs.assemble(body, gs.circular_orbit())
    assert compared(full, scene, (I[0], I[1] - J, I[2]), I, h, "", 3)
    _, K, _ = small_motion((I[0], I[1] - J, I[2]), I, (0, h, 0), W, of_directions(""))
    _, driven, _ = small_motion(I, I, (0, h - W * J, 0), W, of_directions(""))
    assert (K - driven).expand() == 0 * K
