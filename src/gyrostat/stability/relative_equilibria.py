"""All relative equilibria of a scene, with their decisions: the one verb for every kind of scene."""
from collections.abc import Mapping
from typing import Any

from ..errors import require
from ..mechanics.system import System
from .branch import Branch
from .branches import branches_at
from .permanent_rotations import PermanentRotation, rotations_at


def relative_equilibria(scene: System, values: Mapping[str, Any]) -> list[Branch] | list[PermanentRotation]:
    """Every relative equilibrium of a scene at given numbers, each with its decision.

    Of a body of revolution in U(k3): numbers for the moments, l and the parameters of U, and one of

    - omega: E1, E2 and every E3 of that rate about the vertical, U' = ω l − ω² k3 (I1 − I3)
    - pi3_0, C1: what lies on that level of π3 and of C1 = (π + l)·k: E1 and E2 where C1 = ±(π3 + l), and
      every regular precession
    - k3: every E3 of that tilt, (I1 − I3) k3 ω² − l ω + U' = 0
    - k3, pi3_0: every regular precession of that tilt, I1 k3 ω² − (π3 + l) ω + U' = 0.

    A body of revolution about another axis is recognised: of axis 1 it is k1 and pi1_0 in place of k3 and
    pi3_0, of an oblique axis c it is kc = k·c and pic_0 = π·c.

    Of a free body or gyrostat: numbers for the moments and the rotor, and M, the length of M = π + l: every
    permanent rotation on that momentum sphere.

    Parameters
    ----------
    scene : System
        a body of revolution, U rational in the component of k along its axis; or any body without a field
    values : mapping of name to number
        rational or algebraic, as in Report.verdict

    Returns
    -------
    list of Branch or of PermanentRotation
        complete; of a body in a field in the order of k3 from E1 down to E2, then of omega, without a pole
        where U is infinite; of a free one by energy

    Raises
    ------
    ValuesError
        names are missing, unknown or too many, or a number is not admissible
    ScopeError
        the body is not of revolution, U is unspecified, or not rational in k3; or every rotation of the free
        body is an equilibrium

    References
    ----------
    Goldstein, Classical Mechanics, §5.7 (the heavy top); Hughes, Spacecraft Attitude Dynamics (1986), chapter
    6 (free gyrostats); else derived.

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> for b in gs.relative_equilibria(top, {"I1": 2, "I3": 1, "l": 0, "m0": 3, "k3": "1/2", "pi3_0": 6}):
    ...     print(b.label, b.omega, b.decision.verdict.name)
    precession 3 - sqrt(6) STABLE
    precession sqrt(6) + 3 STABLE
    >>> free = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)))
    >>> [(b.momentum, b.decision.verdict.name) for b in gs.relative_equilibria(free, {"M": 1})[::2]]
    [((0, 0, -1), 'STABLE'), ((0, -1, 0), 'UNSTABLE'), ((-1, 0, 0), 'STABLE')]
    """
    require(scene, System, "the scene")
    return branches_at(scene, values) if scene.potential else rotations_at(scene, values)
