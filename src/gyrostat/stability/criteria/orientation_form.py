"""A body at rest in the frame of two directions: the stiffness K of its orientation, and the gyroscopic g."""
from typing import NamedTuple

from sympy import Expr, ImmutableMatrix, zeros

from ...algebra.rings.polynomials import lowest_terms
from ...mechanics.equilibrium.derived_once import once
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.equilibrium.parallel_directions import parallel
from ...mechanics.scenes.coupled import CoupledPotential
from ...mechanics.scenes.lie_poisson import hat


class OrientationForm(NamedTuple):
    """I θ̈ + g × θ̇ + K θ = 0, the linearised motion of a body turned by a small θ.

    Parameters
    ----------
    stiffness : ImmutableMatrix, shape (3, 3)
        K, symmetric: the second variation of V = U − ½ β·Iβ; positive definite: the energy is least, the
        equilibrium stable [M L²/T²]
    gyroscopic : tuple of Expr, shape (3,)
        g [M L²/T]
    inertia : ImmutableMatrix, shape (3, 3)
        [M L²]
    """

    stiffness: ImmutableMatrix
    gyroscopic: tuple[Expr, Expr, Expr]
    inertia: ImmutableMatrix

    @property
    def coefficients(self) -> tuple[Expr, Expr, Expr]:
        """c2, c1, c0 of λ⁶ + c2 λ⁴ + c1 λ² + c0, det(λ² I + gλ + K) over det I."""
        K, inertia, g = self.stiffness, self.inertia, ImmutableMatrix(self.gyroscopic)
        whole = inertia.det(method="berkowitz")
        c2 = (inertia.adjugate() * K).trace() + g.dot(inertia * g)
        c1 = (K.adjugate() * inertia).trace() + g.dot(K * g)
        return c2 / whole, c1 / whole, K.det(method="berkowitz") / whole


def rests_in_frame(eq: Equilibrium) -> bool:
    """Whether it is an equilibrium in two directions, not parallel: the body is at rest in their frame."""
    return eq.system.coupled and len(eq.point) == 9 and parallel(eq) is None


@once
def orientation_form(eq: Equilibrium) -> OrientationForm:
    """K and g of an equilibrium in two directions.

    K = Σ_a [V_a aᵀ − (V_a·a) 1] + Σ_ab hat(a)ᵀ V_ab hat(b), V = U − ½ β·Iβ; with m = l − Iβ and
    N = Σ (∂m/∂a) hat(a), hat(g) = N − Nᵀ − hat(m).

    References
    ----------
    Derived; Simo, Lewis & Marsden, Arch. Rational Mech. Anal. 115 (1991) 15-59, for the amended potential V.
    """
    potential, body = eq.system.potential, eq.system.body
    assert isinstance(potential, CoupledPotential)
    beta = ImmutableMatrix(potential.drift)
    m = ImmutableMatrix(body.gyrostatic_momentum) - body.tensor * beta
    turns = [[eq.at_point(entry.diff(x)) for x in potential.variables] for entry in m]
    N = zeros(3, 3)
    for i in range(0, len(eq.point) - 3, 3):
        N += ImmutableMatrix([row[i:i + 3] for row in turns]) * hat(eq.point[3 + i:6 + i])
    G = N - N.T - hat([eq.at_point(entry) for entry in m])
    g1, g2, g3 = map(lowest_terms, (G[2, 1], G[0, 2], G[1, 0]))
    return OrientationForm(stiffness_with(eq, beta), (g1, g2, g3), body.tensor)


def stiffness_with(eq: Equilibrium, beta: ImmutableMatrix) -> ImmutableMatrix:
    """K of an equilibrium for a coupling β, that of the field or another that differs by a constant."""
    potential = eq.system.potential
    assert isinstance(potential, CoupledPotential)
    V = potential.expression - beta.dot(eq.system.body.tensor * beta) / 2
    slopes = [eq.at_point(x) for x in eq.system.space.gradient(V).flat()[3:]]
    bends = [[eq.at_point(x) for x in row[3:]] for row in eq.system.space.hessian(V).tolist()[3:]]
    vectors = [eq.point[i:i + 3] for i in range(3, len(eq.point), 3)]
    K = zeros(3, 3)
    for i, a in enumerate(vectors):
        slope = ImmutableMatrix(slopes[3 * i:3 * i + 3])
        K += slope * ImmutableMatrix(a).T - slope.dot(ImmutableMatrix(a)) * ImmutableMatrix.eye(3)
        for j, b in enumerate(vectors):
            block = ImmutableMatrix([row[3 * j:3 * j + 3] for row in bends[3 * i:3 * i + 3]])
            K += hat(a).T * block * hat(b)
    # symmetric at an equilibrium
    half = {(i, j): lowest_terms(K[i, j]) for i in range(3) for j in range(i + 1)}
    return ImmutableMatrix(3, 3, lambda i, j: half[max(i, j), min(i, j)])
