"""Tells whether the energy is least on the orbit where its second variation is degenerate.

A free body is decided on the momentum sphere, a body of revolution by its amended potential in k3, any other
by the leading form of the amended potential on the sphere of directions.
"""
from collections.abc import Iterator, Mapping

from sympy import Add, Expr, Rational, S, Symbol

from ...algebra.reals.exact import evaluate, sign_of_constant
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.equilibrium.reduced_series import field_coefficient, inward
from ...mechanics.scenes.kind import Kind
from .amended_expansion import Amended
from .momentum_sphere import extremum_at

Least = tuple[bool | None, str]
HIGHEST = 24                                               # the power of x up to which W is expanded
NO_SIGN = "a sign is not proved"


def least_at(eq: Equilibrium, numbers: Mapping[Symbol, Expr]) -> Least:
    """Return whether h has a strict minimum on the orbit, modulo the symmetries, and why.

    It is None if that is not proved.
    """
    if eq.system.kind is Kind.FREE:
        return _on_sphere(eq, numbers)
    if eq.system.kind is Kind.REVOLUTION:
        return _along_axis(eq, numbers)
    values, which = Amended(eq, numbers).leading()
    if values is None:
        return None, which
    what = f"the leading form of the amended potential, {which},"
    if values == {1}:
        return True, f"{what} is positive"
    return (False, f"{what} takes negative values") if -1 in values else (None, f"{what} is positive or 0")


def _on_sphere(eq: Equilibrium, numbers: Mapping[Symbol, Expr]) -> Least:
    """Return whether the energy of a free gyrostat is least, for Δ = 0."""
    found, why = extremum_at(eq, numbers)
    if not found:
        return found if found is None else False, why
    return found == 1, f"to fourth order it is {'least' if found == 1 else 'greatest'}"


def _along_axis(eq: Equilibrium, numbers: Mapping[Symbol, Expr]) -> Least:
    """Return whether W(k3) = U + (C1 − l k3)²/(2 (I1 (1 − k3²) + I3 k3²)) is least, for a body of revolution.

    Its first term beside the point decides; at E1 and E2 it does so on the one side that there is.
    """
    # at a pole x ≥ 0, and the first power may be any; elsewhere x has both signs, and it has to be even
    pole = eq.at**2 == 1
    for power, term in _expanded(eq, numbers):
        if power < (1 if pole else 2):
            continue
        if term.free_symbols:
            missing = ", ".join(sorted(s.name for s in term.free_symbols))
            return None, f"the second variation is degenerate, give {missing} to decide"
        sign = sign_of_constant(term)
        if sign is None:
            return None, NO_SIGN
        if sign:
            what = f"the amended potential changes as the power {power} of the change of k3"
            return (sign == 1 if pole else power % 2 == 0 and sign == 1), what
    return None, f"up to the power {HIGHEST} of k3 the amended potential does not change"


def _expanded(eq: Equilibrium, numbers: Mapping[Symbol, Expr]) -> Iterator[tuple[Rational, Expr]]:
    """Yield the powers of the change x of k3 in W with their coefficients; at a pole x = 1 ∓ k3."""
    root = 1 if eq.near_pole is None else eq.near_pole.order
    kinetic = _kinetic(eq, numbers)
    for n in range(HIGHEST * root + 1):
        slope = eq.insert(eq.at_point(field_coefficient(eq, n))) if n else S.Zero
        if slope.free_symbols <= numbers.keys():
            slope = evaluate(slope, numbers)
        yield Rational(n, root), evaluate(slope if n % root else next(kinetic) + slope, {})


def _kinetic(eq: Equilibrium, numbers: Mapping[Symbol, Expr]) -> Iterator[Expr]:
    """Yield the coefficients of the powers of x in W − U, by long division."""
    body, k3 = eq.system.body, evaluate(eq.insert(eq.at), numbers)
    (I1, _, I3), l = ([evaluate(eq.insert(m), numbers) for m in body.moments],
                      evaluate(eq.insert(body.gyrostatic_momentum[2]), numbers))
    pi, k = ([evaluate(eq.insert(x), numbers) for x in vector] for vector in (eq.point[:3], eq.point[3:]))
    # the numerator is (C1 − l k3 − l x)², with C1 − l k3 = π·k at the point
    rest, way = Add(*(p * x for p, x in zip(pi, k))), inward(eq)
    above = [rest**2, -2 * way * rest * l, l**2]
    below = [2 * (I1 + (I3 - I1) * k3**2), 4 * way * (I3 - I1) * k3, 2 * (I3 - I1)]
    found: list[Expr] = []
    while True:
        n = len(found)
        top = (above[n] if n < 3 else S.Zero) - Add(*(below[m] * found[n - m] for m in (1, 2) if m <= n))
        found.append(evaluate(top / below[0], {}))
        yield found[-1]
