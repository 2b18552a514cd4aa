"""A body of any shape in an ideal fluid, with weight or without: Kirchhoff's equations."""
from collections.abc import Sequence
from typing import Any

from sympy import Expr, ImmutableMatrix, Symbol

from ...algebra.reals.exact import sign_of_constant
from ...algebra.rings.matrices import leading_minors
from ...algebra.rings.polynomials import lowest_terms
from ...algebra.text.numbers import exact_expression, shown
from ...algebra.text.tensor_entries import tensor_of
from ...arguments import checked, several
from ...errors import BodyError
from ...notation import components
from ...registry import check_names
from .body import Gyrostat
from .coupled import coupled_potential, unit_and_orthogonal
from .system import System, system_of

IMPULSE, DOWN = "p", "gamma"


@checked
def underwater_vehicle(inertia: Sequence[Any] = components("I"), mass: Sequence[Any] = components("mass"),
                       coupling: Sequence[Sequence[Any]] | None = None, *,
                       weight: Sequence[Any] | None = None,
                       gyrostatic_momentum: Sequence[Any] = (0, 0, 0)) -> System:
    """Return a neutrally buoyant body in an ideal fluid at rest at infinity: Kirchhoff's equations.

    T = ½ Ω·J Ω + Ω·D v + ½ v·M v is the energy of the body and the fluid that it moves, v the velocity of its
    centre of buoyancy. The coordinates are π = J Ω + D v, the impulse p = Dᵀ Ω + M v and, if the body has
    weight, the direction gamma of gravity, in body axes. In them h = ½ π·A π + π·B p + ½ p·C p − gamma·w with
    the inverse of the matrix of T, so that the tensor of the body of the scene, of which Ω = A (π − …), is
    not J but A⁻¹ = J − D M⁻¹ Dᵀ. Stability is that of π, p and gamma; the place of the vehicle drifts.

    Parameters
    ----------
    inertia : (J1, J2, J3), or matrix, shape (3, 3)
        J, with the added moments of the fluid [M L²]
    mass : (M1, M2, M3), or matrix, shape (3, 3)
        M, with the added masses [M]
    coupling : matrix, shape (3, 3), or None
        D [M L]; m hat(c) of a body of mass m with its centre of gravity at c and three planes of symmetry of
        its hull; default: 0
    weight : (w1, w2, w3) or None
        w = m g c, weight times the position of the centre of gravity from that of buoyancy [M L²/T²];
        default: they are one point, and the only direction is p
    gyrostatic_momentum : (l1, l2, l3)
        of rotors inside [M L²/T]

    Returns
    -------
    System
        of the directions p and gamma, gamma a unit vector, or of p alone; p of any length

    Raises
    ------
    BodyError
        a matrix is not symmetric, or the energy not positive

    References
    ----------
    Lamb, Hydrodynamics, 6th ed. (1932), §§121-126; Leonard, Automatica 33 (1997) 331-346.

    Examples
    --------
    >>> import gyrostat as gs
    >>> glider = gs.underwater_vehicle(weight=(0, 0, gs.symbol("m0")))
    >>> level = gs.steady_motion(glider, (0, gs.symbol("p0"), 0), (0, 0, 1))
    >>> print(gs.analyze(level).sufficient)
    mass₂ mass₃ m₀ + p₀² (mass₂ − mass₃) > 0 and m₀ > 0 and mass₂ > mass₁
    """
    J, M = (_symmetric(given, name) for given, name in ((inertia, "inertia"), (mass, "mass")))
    D = _matrix(coupling if coupling is not None else [[0] * 3] * 3, "coupling")
    _check_positive(M, "the mass")
    each = (M.adjugate() / M.det(method="berkowitz")).applyfunc(lowest_terms)
    tensor = (J - D * each * D.T).applyfunc(lowest_terms)
    _check_positive(tensor, "J − D M⁻¹ Dᵀ =")
    _check_names([*J, *M, *D, *(_exact(weight, "weight") if weight is not None else ())])
    body = Gyrostat(tensor.tolist(), gyrostatic_momentum)
    B = (-body.inverse * D * each).applyfunc(lowest_terms)
    C = (each - B.T * D * each).applyfunc(lowest_terms)
    p, down = (ImmutableMatrix(components(name)) for name in (IMPULSE, DOWN))
    U, drift = p.dot(C * p) / 2, list(B * p)
    if weight is None:
        return system_of(body, coupled_potential(U, (IMPULSE,), drift))
    U -= down.dot(ImmutableMatrix(_exact(weight, "weight")))
    return system_of(body, coupled_potential(U, (IMPULSE, DOWN), drift, unit_and_orthogonal((DOWN,))))


def _check_names(entries: Sequence[Expr]) -> None:
    """Refuse names of the motion, and those of the directions."""
    check_names(entries, "the vehicle", BodyError)
    moving = {*components(IMPULSE), *components(DOWN)}
    if taken := sorted(map(str, moving & set[Symbol]().union(*(e.free_symbols for e in entries)))):
        raise BodyError(f"the vehicle depends on {', '.join(taken)}, a component of the impulse p or of "
                        "gamma, the direction of gravity: write another letter for a number of your own, "
                        "such as a1")


def _exact(given: Any, name: str) -> list[Expr]:
    if len(entries := several(given, name)) != 3:
        raise BodyError(f"{name} has {len(entries)} entries: give three, one for each axis")
    return [exact_expression(x, name) for x in entries]


def _matrix(given: Any, name: str) -> ImmutableMatrix:
    rows = given.tolist() if hasattr(given, "tolist") else given
    if len(rows) != 3:
        raise BodyError(f"{name} has {len(rows)} rows: give three")
    return ImmutableMatrix([_exact(row, name) for row in rows])


def _symmetric(given: Any, name: str) -> ImmutableMatrix:
    """Return a symmetric matrix from three entries, or from a matrix."""
    rows = given.tolist() if hasattr(given, "tolist") else given
    if any(isinstance(row, Sequence) and not isinstance(row, str) for row in rows):
        return tensor_of(_matrix(rows, name).flat())
    return ImmutableMatrix.diag(*_exact(rows, name))


def _check_positive(matrix: ImmutableMatrix, what: str) -> None:
    """Refuse a matrix with a leading minor that is a number and not positive."""
    for minor in leading_minors(matrix):
        if not minor.free_symbols and sign_of_constant(minor) != 1:
            raise BodyError(f"{what} {matrix.tolist()} is not positive definite, a leading minor is "
                            f"{shown(minor)}: the kinetic energy is positive; check the coupling and the "
                            "signs")
