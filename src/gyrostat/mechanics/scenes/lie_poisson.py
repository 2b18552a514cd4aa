"""The Lie-Poisson bracket of a gyrostat on so(3)*, on e(3)* = (so(3) ⋉ R³)*, and with two directions.

Every sign convention has its one home here:

{F, G} = −M·(∂πF × ∂πG) − Σ a·(∂πF × ∂aG + ∂aF × ∂πG),  M = π + l,  a each direction, so that with
ω = ∂h/∂π: π̇ = M × ω + Σ a × ∂h/∂a and ȧ = a × ω.
"""
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import combinations, combinations_with_replacement
from typing import Any

from sympy import Add, Expr, ImmutableMatrix, Symbol, expand, zeros

from ..._cached import cached_property
from ..._display import Shown
from ...algebra.rings.matrices import applied
from ...algebra.rings.polynomials import Ring, derivatives, lowest_terms
from ...algebra.text.numbers import exact_expression
from ...arguments import checked
from ...errors import BodyError, ScopeError, StructureError, brief
from ...notation import NOTATION, Stored, Use, components
from ...registry import check_names


def hat(v: Sequence[Expr]) -> ImmutableMatrix:
    """Return the matrix of R³ → so(3): hat(v) w = v × w."""
    return ImmutableMatrix([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


@dataclass(frozen=True)
class LiePoisson(Shown, Stored):
    """A Poisson structure on Rⁿ.

    Once it is built, it is antisymmetric, obeys the Jacobi identity, and has the Casimirs it names.

    Parameters
    ----------
    coordinates : tuple of Symbol, shape (n,)
        momenta [M L²/T], then directions [1]
    tensor : ImmutableMatrix, shape (n, n)
        B with {F, G} = ∇F · B ∇G
    casimirs : tuple of Expr
        functions C with B ∇C = 0

    Raises
    ------
    StructureError
        the tensor or a Casimir fails; the message says where

    Examples
    --------
    >>> import gyrostat as gs
    >>> space = gs.lie_poisson(directions=())
    >>> space.tensor
    Matrix([
    [        0, -l3 - pi3,  l2 + pi2],
    [ l3 + pi3,         0, -l1 - pi1],
    [-l2 - pi2,  l1 + pi1,         0]])
    """

    coordinates: tuple[Symbol, ...]
    tensor: ImmutableMatrix
    casimirs: tuple[Expr, ...]

    def __post_init__(self) -> None:
        if self.tensor.shape != (len(self.coordinates),) * 2 or any(map(expand, self.tensor + self.tensor.T)):
            raise StructureError(f"a {self.tensor.rows}×{self.tensor.cols} tensor that is antisymmetric "
                                 f"and has one row for each of the {len(self.coordinates)} coordinates is "
                                 "needed: B[i, j] = {x_i, x_j}")
        for i, j, k in combinations(range(len(self.coordinates)), 3):
            if value := self.jacobiator(i, j, k):
                names = ", ".join(str(self.coordinates[n]) for n in (i, j, k))
                raise StructureError(f"the tensor breaks the Jacobi identity: the jacobiator of {names} is "
                                     f"{value}, not 0; check its entries")
        for casimir in self.casimirs:
            if any(entry := [lowest_terms(e) for e in applied(self.tensor.tolist(), self.gradient(casimir))]):
                raise StructureError(f"{casimir} is not a Casimir: B ∇C = {entry}, not 0; correct it")

    @checked
    def gradient(self, f: Expr) -> ImmutableMatrix:
        """Return ∇f.

        Parameters
        ----------
        f : Expr
            in the coordinates

        Returns
        -------
        ImmutableMatrix, shape (n, 1)
        """
        return _gradient(f, self.coordinates)

    @checked
    def hessian(self, f: Expr) -> ImmutableMatrix:
        """Return D²f.

        Parameters
        ----------
        f : Expr
            in the coordinates

        Returns
        -------
        ImmutableMatrix, shape (n, n)
        """
        return _hessian(f, self.coordinates)

    def bracket(self, f: Any, g: Any) -> Expr:
        """Return {f, g} = ∇f · B ∇g, expanded.

        Parameters
        ----------
        f, g : Expr
            smooth functions of the coordinates; symbols are matched by name

        Returns
        -------
        Expr

        References
        ----------
        Vera & Viguera (2003), §2; written out in docs/explanation/derivations/conditions.md, section 1.

        Examples
        --------
        >>> import gyrostat as gs
        >>> space = gs.lie_poisson(directions=("k",))
        >>> pi1, pi2, k3 = map(gs.symbol, ("pi1", "pi2", "k3"))
        >>> space.bracket(pi1, pi2), space.bracket(pi1, k3)
        (-l3 - pi3, k2)
        """
        f, g = exact_expression(f, "f"), exact_expression(g, "g")
        rows, slopes = zip(self.gradient(f).flat(), self.tensor.tolist()), self.gradient(g).flat()
        return expand(Add(*(a * entry * b for a, row in rows if a
                            for entry, b in zip(row, slopes) if entry and b)))

    @checked
    def jacobiator(self, i: int, j: int, k: int) -> Expr:
        """Return {xᵢ, {xⱼ, xₖ}} + cyclic, which is 0 for every Poisson tensor.

        Parameters
        ----------
        i, j, k : int
            places of coordinates, from 0

        Returns
        -------
        Expr
        """
        ring, tensor, place = self._polynomials
        total = ring.zero
        for a, b, c in ((i, j, k), (j, k, i), (k, i, j)):
            for m, x in enumerate(place):
                if tensor[a][m] and (slope := tensor[b][c].derivative(x)):
                    total += tensor[a][m] * slope
        return ring.expression(total)

    @cached_property
    def _polynomials(self) -> tuple[Ring, list[list[Any]], list[int]]:
        ring = Ring([*self.tensor, *self.coordinates])
        entries, bottom = ring.matrix(self.tensor.tolist())
        bound = set(self.coordinates)
        if ring.expression(bottom).free_symbols & bound or any(g not in bound and g.free_symbols & bound
                                                               for g in ring.generators):
            raise StructureError("a Lie-Poisson tensor is a polynomial in its coordinates: check its entries")
        return ring, entries, [ring.generators.index(x) for x in self.coordinates]


# a bounded cache: Casimirs are few, Hamiltonians any number
@lru_cache(maxsize=256)
def _gradient(f: Expr, coordinates: tuple[Symbol, ...]) -> ImmutableMatrix:
    return ImmutableMatrix(derivatives(f, coordinates))


@lru_cache(maxsize=256)
def _hessian(f: Expr, coordinates: tuple[Symbol, ...]) -> ImmutableMatrix:
    return ImmutableMatrix([derivatives(g, coordinates) for g in _gradient(f, coordinates).flat()])


@checked
def lie_poisson(directions: Sequence[str] = ("k",),
                gyrostatic_momentum: Sequence[Any] | None = None) -> LiePoisson:
    """Return the space of a gyrostat: so(3)* without directions, e(3)* with one, or that with two.

    B = hat M on so(3)*, B = [[hat M, hat k], [hat k, 0]] on e(3)*, M = π + l. On so(3)* ⋉ (R³ × R³), with two
    directions, each has its row and its column. A third is a combination of two and their cross product: it
    has nothing to add.

    Parameters
    ----------
    directions : sequence of str
        none, one or two names; the coordinates of a are a1, a2, a3
    gyrostatic_momentum : (l1, l2, l3) or None
        l [M L²/T]; default: the symbols l1, l2, l3

    Returns
    -------
    LiePoisson
        Casimir abs(M)² on so(3)*; C1 = M·k, C2 = abs(k)² on e(3)*; a·a, a·b, b·b of two directions

    Raises
    ------
    ScopeError
        more than two directions, one twice, or one whose components have another meaning
    BodyError
        the gyrostatic momentum has not three entries

    References
    ----------
    Vera & Viguera (2003), §2; Marsden, Ratiu & Weinstein, Trans. Amer. Math. Soc. 281 (1984) 147-177.

    Examples
    --------
    >>> import gyrostat as gs
    >>> gs.lie_poisson(directions=()).casimirs
    ((l1 + pi1)**2 + (l2 + pi2)**2 + (l3 + pi3)**2,)
    """
    names = tuple(map(str, directions))
    if len(names) > 2 or len(set(names)) < len(names):
        raise ScopeError(f"directions = {brief(names)}: a gyrostat needs none without a field, ('k',) with "
                         "one, or two that differ; a third is made of two and of their cross product")
    if taken := [name for name in names if name != "k" and (
            not name.isidentifier() or any(f"{name}{i}" in NOTATION for i in (1, 2, 3)))]:
        raise ScopeError(f"directions = {brief(names)}: the components of {brief(taken[0])} have "
                         "another meaning: give a name such as k, e, n or r")
    given = ("l1", "l2", "l3") if gyrostatic_momentum is None else gyrostatic_momentum
    if len(given) != 3:
        raise BodyError(f"gyrostatic_momentum has {len(given)} entries: give three, one for each axis")
    rotor = tuple(map(exact_expression, given))
    check_names(rotor, "the rotor", BodyError, Use.ROTOR, Use.ANGLE)
    return _space(names, rotor)


@lru_cache(maxsize=64)                                  # what is proved of a space is proved once
def _space(directions: tuple[str, ...], rotor: tuple[Expr, ...]) -> LiePoisson:
    pi, *vectors = map(components, ("pi", *directions))
    M = [p + rotor_i for p, rotor_i in zip(pi, rotor)]
    if not vectors:
        return LiePoisson(pi, hat(M), (sum(m**2 for m in M),))
    blocks, empty = [hat(M), *map(hat, vectors)], zeros(3, 3 * len(vectors))
    tensor = ImmutableMatrix.vstack(ImmutableMatrix.hstack(*blocks),
                                    *(ImmutableMatrix.hstack(block, empty) for block in blocks[1:]))
    pairs = [(M, vectors[0]), (vectors[0], vectors[0])]
    if len(vectors) == 2:
        pairs = list(combinations_with_replacement(vectors, 2))
    return LiePoisson(tuple(x for v in (pi, *vectors) for x in v), tensor,
                      tuple(Add(*(x * y for x, y in zip(a, b))) for a, b in pairs))
