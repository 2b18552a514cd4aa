"""Draws rational points of a scene, in a fixed order, at which two formulas are compared."""
import random
from collections.abc import Iterable, Iterator, Mapping

from sympy import Expr, Integer, Rational, Symbol, sqrt

from ...algebra.reals.exact import sign_of_constant
from ...mechanics.classical.attitude import ANGLES
from ...notation import jet, symbol
from ..scenes import Scene

_SIZES = [Rational(*pair) for pair in ((1, 1), (2, 1), (3, 1), (1, 2), (3, 2), (5, 2), (2, 3), (4, 3),
                                       (5, 1), (7, 2), (1, 4), (8, 1))]
_DIRECTIONS = [tuple(Rational(x, n) for x in v) for *v, n in (
    (2, 1, 2, 3), (1, 2, -2, 3), (6, 3, 2, 7), (2, 6, -3, 7), (4, 4, 7, 9), (1, 4, 8, 9), (8, -4, 1, 9),
    (2, -3, 6, 7), (3, 4, 0, 5))]
K = tuple(symbol(f"k{i}") for i in (1, 2, 3))
TRIALS = 400


def unknowns(scene: Scene, expressions: Iterable[Expr]) -> list[Symbol]:
    """Return every symbol that a point of the scene needs a number for."""
    found = {s for e in expressions for s in e.free_symbols} | scene.parameters
    eq = scene.equilibrium
    if "angles" in scene.table:
        found |= {*ANGLES, *([symbol(scene.table["vertical"])] if "vertical" in scene.table else [])}
    elif eq is None:
        found |= set(scene.system.space.coordinates)
    else:
        turned = {s for e in (*scene.point, *eq.existence()) for s in e.free_symbols}
        # where k3 is solved for, any k1 and k2 on its circle
        found |= turned - {*K} if K[2] in dict(eq.relations) else turned
        found -= {name for name, _ in eq.relations if not jet(name.name)
                  or not (scene.potential and scene.potential.given)}
    return sorted(found - {symbol("t")} if "angles" in scene.table else found, key=str)


def points(scene: Scene, expressions: Iterable[Expr], given: Iterable[Expr], at: Mapping[Symbol, Expr],
           inside: bool = True) -> Iterator[dict[Symbol, Expr]]:
    """Yield points of the scene where everything given is positive.

    k is a unit vector. If inside is True, the equilibrium exists at each point.
    """
    names, positive, eq = unknowns(scene, expressions), list(given), scene.equilibrium
    # l of omega = m0/l, though the family expresses l by omega: the two have to agree, and evidence asks that
    asked = set[Symbol]().union(*(value.free_symbols for value in at.values())) - at.keys()
    names = sorted({*names, *asked}, key=str)
    positive += eq.existence() if eq and inside else []
    directions: list[tuple[Expr, ...]] = [v for v in _DIRECTIONS if v[2] == at.get(K[2], v[2])]
    if K[2] in at and not directions:
        directions = [(sqrt(1 - at[K[2]] ** 2), Integer(0), at[K[2]])]
    chance, found = random.Random(1), 0
    for trial in range(50 * TRIALS):
        if trial > 2000 and not found:                     # nothing satisfies what is given
            return
        values = {s: chance.choice(_SIZES) * (1 if s.is_positive or chance.random() < 0.7 else -1)
                  for s in names}
        values |= {s: x.xreplace(values) for s, x in zip(K, chance.choice(directions)) if s in values}
        values |= {name: value.xreplace(values) for name, value in at.items()}
        values = on_family(scene, values)
        if (
            all(e.xreplace(values).is_positive for e in positive)
            and is_a_body(scene, values)
            and all(x.is_finite for x in values.values())
        ):
            yield values
            if (found := found + 1) == TRIALS:
                return


def on_family(scene: Scene, values: dict[Symbol, Expr]) -> dict[Symbol, Expr]:
    """Return the values with those that the relations of the equilibrium determine."""
    # U' uses what is solved for
    for name, value in reversed(scene.equilibrium.relations) if scene.equilibrium else ():
        values = values | {name: value.xreplace(values)}
        if name == K[2] and not values.keys().isdisjoint(K[:2]):
            values |= {K[0]: sqrt(1 - values[name] ** 2), K[1]: Integer(0)}
    return values


def is_a_body(scene: Scene, values: Mapping[Symbol, Expr]) -> bool:
    """Return whether drawn moments are possible: none exceeds the sum of the others.

    Of a tensor, whose axes are not principal, and of a vehicle, which moves a fluid, only positivity is
    asked. Moments that are not drawn count as possible.
    """
    positive = [e.xreplace(dict(values)) for e in scene.body.positive]
    if any(e.free_symbols for e in positive) or not any(e.free_symbols for e in scene.body.positive):
        return True
    if "vehicle" in scene.table or len(scene.body.entries) > 3:
        return all(sign_of_constant(e) == 1 for e in positive)
    moments = [moment.xreplace(dict(values)) for moment in scene.body.moments]
    return all(sign_of_constant(sum(moments) - 2 * m) in (0, 1) for m in moments)
