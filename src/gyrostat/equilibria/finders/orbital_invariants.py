"""What decides an equilibrium of a satellite: K, the sextic, and what internal damping does not reach."""
from collections.abc import Sequence
from typing import Any

from ...algebra.rings.matrices import adjugate, cross
from ...stability.criteria.amended_form import dot, trace
from ...stability.form import Invariants


def invariants(tensor: Sequence[Sequence[Any]], rotor: Sequence[Any], n: Sequence[Any], r: Sequence[Any],
               rate: Any) -> Invariants:
    """Of K its trace, second invariant and determinant; the sextic, a cubic in λ², times det I.

    In the basis (t, n, r): K = [[4ω0² (I_nn − I_rr) + ω0 l_n, −3ω0² I_tn, 0], [., 3ω0² (I_tt − I_rr),
    3ω0² I_nr], [0, ., ω0² (I_nn − I_tt) + ω0 l_n]], g = (−ω0 I_tn, ω0 (I_tt + I_rr − I_nn) − l_n, 2ω0 I_nr).

    Parameters
    ----------
    tensor : rows, shape (3, 3)
        here as below numbers, balls or expressions
    rotor, n, r : sequence, shape (3,)
    rate : Any
        ω0

    Returns
    -------
    Invariants
    """
    frame = cross(n, r), n, r
    I = [[dot(a, [dot(row, b) for row in tensor]) for b in frame] for a in frame]
    along, square = dot(rotor, n) * rate, rate**2
    (tt, tn, _), (_, nn, nr), (_, _, rr) = I
    K = [[4 * square * (nn - rr) + along, -3 * square * tn, 0 * square],
         [-3 * square * tn, 3 * square * (tt - rr), 3 * square * nr],
         [0 * square, 3 * square * nr, square * (nn - tt) + along]]
    g = [-rate * tn, rate * (tt + rr - nn) - dot(rotor, n), 2 * rate * nr]
    minors, whole = adjugate(K), dot(K[0], cross(K[1], K[2]))
    d = dot(I[0], cross(I[1], I[2]))
    a = sum((dot(x, y) for x, y in zip(adjugate(I), K)), 0 * square) + dot(g, [dot(row, g) for row in I])
    b = sum((dot(x, y) for x, y in zip(minors, I)), 0 * square) + dot(g, [dot(row, g) for row in K])
    return Invariants((trace(K), trace(minors), whole), (d, a, b, whole))


def unreached(tensor: Sequence[Sequence[Any]], n: Sequence[Any], r: Sequence[Any]) -> tuple[Any, Any]:
    """t·In and n·In − r·Ir."""
    along, vertical = ([dot(row, a) for row in tensor] for a in (n, r))
    return dot(cross(n, r), along), dot(n, along) - dot(r, vertical)
