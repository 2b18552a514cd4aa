"""The linearised motion of a body at rest in the frame of two directions: stiffness and gyroscopic term.

It is derived from the amended potential V = U − ½ β·Iβ of the orientation.
"""
from typing import NamedTuple

from sympy import Expr, ImmutableMatrix, zeros

from ...algebra.rings.matrices import blocks
from ...algebra.rings.polynomials import lowest_terms
from ...mechanics.equilibrium.derived_once import once
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.equilibrium.parallel_directions import parallel
from ...mechanics.scenes.coupled import CoupledPotential
from ...mechanics.scenes.lie_poisson import hat


class OrientationForm(NamedTuple):
    """The linearised motion I θ̈ + g × θ̇ + K θ = 0 of a body that is turned by a small θ.

    Parameters
    ----------
    stiffness : ImmutableMatrix, shape (3, 3)
        K, symmetric, the second variation of V = U − ½ β·Iβ; if it is positive definite, the energy is least,
        and the equilibrium is stable [M L²/T²]
    gyroscopic : tuple of Expr, shape (3,)
        g [M L²/T]
    inertia : ImmutableMatrix, shape (3, 3)
        I [M L²]
    """

    stiffness: ImmutableMatrix
    gyroscopic: tuple[Expr, Expr, Expr]
    inertia: ImmutableMatrix

    @property
    def coefficients(self) -> tuple[Expr, Expr, Expr]:
        """The coefficients c2, c1, c0 of λ⁶ + c2 λ⁴ + c1 λ² + c0, which is det(λ² I + λ hat(g) + K)/det I.

        They follow from det(A + hat(v)) = det A + v·A v for a symmetric A.
        """
        K, inertia, g = self.stiffness, self.inertia, ImmutableMatrix(self.gyroscopic)
        whole = inertia.det(method="berkowitz")
        c2 = (inertia.adjugate() * K).trace() + g.dot(inertia * g)
        c1 = (K.adjugate() * inertia).trace() + g.dot(K * g)
        return c2 / whole, c1 / whole, K.det(method="berkowitz") / whole


def rests_in_frame(eq: Equilibrium) -> bool:
    """Tell whether it is in two directions that are not parallel: the body is at rest in their frame."""
    return eq.system.coupled and len(eq.point) == 9 and parallel(eq) is None


@once
def orientation_form(eq: Equilibrium) -> OrientationForm:
    """Return K and g of an equilibrium in two directions.

    K = Σ_a [V_a aᵀ − (V_a·a) 1] + Σ_ab hat(a)ᵀ V_ab hat(b), where V = U − ½ β·Iβ, a and b are the two
    directions and indices of V are derivatives. With m = l − Iβ and N = Σ (∂m/∂a) hat(a), hat(g) = N − Nᵀ −
    hat(m).

    Parameters
    ----------
    eq : Equilibrium
        of a scene in two directions

    Returns
    -------
    OrientationForm

    References
    ----------
    Derived in docs/explanation/derivations/satellite.md, sections 1 to 4; Simo, Lewis & Marsden, Arch.
    Rational Mech. Anal. 115 (1991) 15-59, for the amended potential V.
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
    """Return the K of an equilibrium for a coupling β: that of the field, or another.

    Another one differs by a constant, as β − ω if ω·π is conserved.
    """
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
    # symmetric at an equilibrium: the torque Σ a × V_a vanishes; half of the entries are enough
    half = {(i, j): lowest_terms(K[i, j]) for i in range(3) for j in range(i + 1)}
    return ImmutableMatrix(3, 3, lambda i, j: half[max(i, j), min(i, j)])


def minors_of_stiffness(K: ImmutableMatrix) -> list[tuple[str, int, Expr]]:
    """Return the leading principal minors of each block of K, or of a part of it, with names and orders."""
    return [(f"minor {n} of K", n, K.extract(block[:n], block[:n]).det(method="berkowitz"))
            for block in blocks(K.tolist()) for n in range(1, len(block) + 1)]
