"""Makes the spectral, the formal and the secular criterion, by discriminants and by minors."""
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from sympy import Expr, Matrix, S

from ..._lazy import loaded
from ...algebra.rings.matrices import blocks
from ...algebra.rings.polynomials import lowest_terms
from ...algebra.solving.margins import Signs
from ...arguments import checked
from ...mechanics.equilibrium.derivation_ring import positive, signs_over
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.scenes.kind import Kind
from ..notion import Notion
from .conditions import Criterion, condition_of
from .energy_casimir import SecondVariation, augmented_hessian
from .implication import Item, eliminate, merge, reduced
from .linearization import Linearization
from .orientation_form import minors_of_stiffness, orientation_form, rests_in_frame
from .sextic import factors_in_squares, items_of_factors, items_of_monic

if TYPE_CHECKING:
    from .defined_names import DefinedNames

Minor = tuple[str, int, Expr]                              # its name, its order, the minor itself


@checked
def spectral_criterion(linearization: Linearization) -> Criterion:
    """Return the criterion that no eigenvalue has a positive real part, necessary for stability.

    For λ² + q it is q ≥ 0. For λ⁴ + pλ² + q it is p ≥ 0, q ≥ 0, p² − 4q ≥ 0: both roots x = λ² are real and ≤
    0. For λ⁶ + … each factor over the rationals in x has real roots ≤ 0; those of x³ + a x² + b x + c are so
    iff a, b, c ≥ 0 and the discriminant Δ ≥ 0.

    Parameters
    ----------
    linearization : Linearization

    Returns
    -------
    Criterion
        of the notion "spectral", with one alternative

    Raises
    ------
    ScopeError
        the polynomial has another degree

    References
    ----------
    Vera & Viguera (2003), §5; derived in docs/explanation/derivations/conditions.md, section 4.

    Examples
    --------
    >>> import gyrostat as gs
    >>> derivation = gs.derivation
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
    >>> linear = derivation.linearize(gs.upright(top))
    >>> criterion = derivation.spectral_criterion(linear)
    >>> ((p, q, discriminant),) = criterion.alternatives
    >>> discriminant.margin
    -4*I1*dU + l**2 + 2*l*pi3_0 + pi3_0**2
    >>> discriminant.degenerate
    (2*I1*pi3_0 - I3*l - I3*pi3_0,)
    """
    eq = linearization.equilibrium
    if len(linearization.coefficients) == 3:
        factors = factors_in_squares(linearization.coefficients)
        signs = signs_over(eq, [c for factor in factors for c in factor])
        items = items_of_factors(factors, signs)
    else:
        signs = signs_over(eq, values := linearization.frequency_coefficients)
        items = items_of_monic([signs.ring.fraction(value) for value in values], signs)
    return Criterion(Notion.SPECTRAL, (tuple(condition_of(signs.ring, item, eq) for item in items),))


@checked
def formal_criterion(variation: SecondVariation) -> Criterion:
    """Return the criterion that the second variation is definite, sufficient for stability.

    It may be of either sign, for some value of the free multiplier. The leading principal minors decide. A
    free multiplier ν enters one margin, quadratically, and is eliminated: a ν² + b ν + c takes a positive
    value if a > 0 or b² > 4ac. For a body in a field without integrals, in a direction in which the second
    variation does not split, trace and determinant of D²U_c on the plane across k (AmendedForm) decide, named
    t and s.

    Parameters
    ----------
    variation : SecondVariation

    Returns
    -------
    Criterion
        of the notion "formal", modulo what the variation is

    References
    ----------
    Holm, Marsden, Ratiu & Weinstein, Phys. Rep. 123 (1985) 1-116; elimination: the maximum of a quadratic.
    Derived in docs/explanation/derivations/conditions.md, sections 5 and 7.

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
    >>> variation = gs.derivation.second_variation(gs.upright(top))
    >>> gs.derivation.formal_criterion(variation).alternatives[0][0].margin
    -4*I1*dU + l**2 + 2*l*pi3_0 + pi3_0**2
    """
    if invariants := _on_sphere(variation):                # two by two: definite iff its determinant is > 0
        signs = signs_over(variation.equilibrium, invariants)
        return _definite(variation, Notion.FORMAL, _minors([(2, invariants[1])]), signs, (1,))
    # beside a positive form of velocities or momenta only a minimum is definite
    if found := across(variation) or of_stiffness(variation):
        return _definite(variation, Notion.FORMAL, found, _signs(variation, found), (1,))
    # one multiplier is eliminated, any value of the others may be chosen
    others = dict.fromkeys(variation.free[1:], S.Zero)
    minors = _minors([(n, minor.xreplace(others)) for n, minor in enumerate(variation.minors, 1)])
    if sum(x != 0 for x in variation.equilibrium.point[3:]) > 1:
        signs = _signs(variation, minors)                  # k·Ik > 0 is assumed: no polynomial shows it
    else:
        signs = signs_over(variation.equilibrium, [minor for _, _, minor in minors])
    return _definite(variation, Notion.FORMAL, minors, signs, (1, -1))


@checked
def secular_criterion(variation: SecondVariation) -> Criterion:
    """Return the criterion that the second variation is positive definite, sufficient under internal damping.

    Damping takes energy: an equilibrium that is not a minimum on the orbit is lost. If the damping reaches
    every motion and the second variation is not degenerate, the criterion is necessary, too.

    Parameters
    ----------
    variation : SecondVariation
        of secular_variation

    Returns
    -------
    Criterion
        of the notion "secular", modulo what the variation is

    References
    ----------
    Kelvin & Tait, Treatise on Natural Philosophy (1879), §345; Bloch, Krishnaprasad, Marsden & Ratiu,
    Ann. Inst. H. Poincaré Anal. Non Linéaire 11 (1994) 37-90.

    Examples
    --------
    >>> import gyrostat as gs
    >>> derivation = gs.derivation
    >>> body = gs.Gyrostat(gyrostatic_momentum=(0, 0, 0))
    >>> spin = gs.principal_rotation(gs.assemble(body), 3)
    >>> variation = derivation.secular_variation(spin)
    >>> criterion = derivation.secular_criterion(variation)
    >>> print(derivation.independent(criterion, spin))
    I₃ > I₁ and I₃ > I₂
    """
    minors = across(variation) or of_stiffness(variation)
    minors = minors or _minors([(2, e) for e in _on_sphere(variation)] or variation.block_minors)
    return _definite(variation, Notion.SECULAR, minors, _signs(variation, minors), (1,))


def across(variation: SecondVariation) -> list[Minor]:
    """Return trace and determinant of D²U_c on the plane across k, for a body in a field without integrals.

    They are the same in any basis. The second variation has D²U_c beside a positive form of the velocities.
    If k is along an axis or the second variation splits, its own minors are shorter, and the list is empty.
    """
    eq = variation.equilibrium
    along = eq.system.kind is not Kind.FIELD or sum(x != 0 for x in eq.point[3:]) < 2
    if along or eq.system.linear_integrals or len(blocks(variation.matrix.tolist())) > 1:
        return []
    form = loaded("stability.criteria.closed_form:closed_form")(eq).invariants
    return [("t", 1, lowest_terms(form.trace)), ("s", 2, lowest_terms(form.determinant))]


def in_names(eq: Equilibrium) -> "DefinedNames | None":
    """Return the names in which conditions are written if they are long, with definitions; else None."""
    if eq.system.kind is Kind.FIELD:
        return loaded("stability.criteria.closed_form:in_names")(eq)
    return loaded("stability.criteria.sextic_in_names:in_names")(eq) if rests_in_frame(eq) else None


def stiffness(variation: SecondVariation) -> Matrix | None:
    """Return K for a body at rest in the frame of two directions, without integrals; else None.

    The second variation is a positive form of the momenta beside K.
    """
    eq = variation.equilibrium
    rests = rests_in_frame(eq) and not eq.system.linear_integrals
    return orientation_form(eq).stiffness if rests else None


def of_stiffness(variation: SecondVariation) -> list[Minor]:
    """Return the leading principal minors of each block of K."""
    K = stiffness(variation)
    return [] if K is None else minors_of_stiffness(K)


def _on_sphere(variation: SecondVariation) -> tuple[Expr, ...]:
    """Return trace and determinant on the plane across M, for a free body off its principal axes.

    They are the same in any basis, while those of a basis of rational vectors have poles. With A = I⁻¹ − ν
    they are tr A M² − M·A M and M·adj(A) M, each M² times the invariant.
    """
    eq = variation.equilibrium
    M = [p + l for p, l in zip(eq.point, eq.system.body.gyrostatic_momentum)]
    if eq.system.kind is not Kind.FREE or variation.matrix.rows != 2 or sum(m != 0 for m in M) == 1:
        return ()
    A = augmented_hessian(eq, eq.system.space.casimirs)
    M = Matrix(M)
    return (lowest_terms(A.trace() * M.dot(M) - M.dot(A * M)), lowest_terms(M.dot(A.adjugate() * M)))


def _minors(of_order: Iterable[tuple[int, Expr]]) -> list[Minor]:
    return [(f"minor {n}", n, minor) for n, minor in of_order]


def _signs(variation: SecondVariation, minors: Sequence[Minor]) -> Signs:
    eq = variation.equilibrium
    return Signs.over([minor for _, _, minor in minors], (*eq.domain, *positive(eq)))


def _definite(variation: SecondVariation, notion: Notion, minors: Sequence[Minor], signs: Signs,
              allowed: Sequence[int]) -> Criterion:
    """Return the criterion that a form is definite with an allowed sign, by minors with names and orders."""
    ring = signs.ring
    fractions = [(name, n, ring.fraction(minor)) for name, n, minor in minors]
    alternatives: list[list[Item]] = []
    for s in allowed:                                      # negative definite: odd minors are negative
        items = [Item(*signs.split(s**n * top, bottom), True, name) for name, n, (top, bottom) in fractions]
        conjunction = reduced(items, signs)
        if conjunction is not None:
            free = [nu for nu in variation.free if nu in ring.gens]
            alternatives += eliminate(conjunction, free[0], signs) if free else [conjunction]
    merged = merge([a for a in (reduced(a, signs) for a in alternatives) if a is not None], signs)
    return Criterion(notion, tuple(tuple(condition_of(ring, item, variation.equilibrium) for item in a)
                                   for a in merged), variation.modulo)
