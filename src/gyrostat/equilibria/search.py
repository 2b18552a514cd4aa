"""Finds all relative equilibria of a scene, with their decisions: the one verb for every kind of scene."""
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from .._lazy import loaded
from ..arguments import checked
from ..mechanics.scenes.coupled import in_one_direction
from ..mechanics.scenes.kind import Kind
from ..mechanics.scenes.system import System
from ..stability.form import Form
from .finders.rate_level_tilt import asked_about
from .relative_equilibrium import RelativeEquilibrium


@checked
def relative_equilibria(scene: System, values: Mapping[str, Any]) -> list[RelativeEquilibrium]:
    """Return every relative equilibrium of a scene at given numbers, each with its decision.

    For a body of revolution in U(k3), give numbers for the moments, l and the parameters of U, and one of

    - omega: E1, E2 and every E3 of that rate about the vertical, U' = ω l − ω² k3 (I1 − I3)
    - pi3_0, C1: what lies on that level of π3 and of C1 = (π + l)·k: E1 and E2 if C1 = ±(π3 + l), and
      every regular precession
    - k3: every E3 of that tilt, (I1 − I3) k3 ω² − l ω + U' = 0
    - k3, pi3_0: every regular precession of that tilt, I1 k3 ω² − (π3 + l) ω + U' = 0.

    A body of revolution about another axis is recognised: about axis 1 the names are k1 and pi1_0 in place of
    k3 and pi3_0, about an oblique axis c they are kc = k·c and pic_0 = π·c.

    For any other body in a field, give numbers for the moments, the rotor and the parameters of U, and one of

    - omega: every permanent rotation ω = omega k of that rate, (∇U − omega l − omega² Ik) × k = 0, in a U
      polynomial in k; in one of degree d at most 2 (d² − d + 1), or circles and other curves of them
    - C1: every permanent rotation on that level of C1 = M·k, the critical points of the amended potential
      U + (C1 − l·k)²/(2 k·Ik), at rational numbers and in the same U; minima − saddles + maxima = 2 if all
      are points that are not degenerate
    - k1, k2, k3: every rate of a permanent rotation in that direction, omega² Ik × k + omega l × k = ∇U × k.

    For a free body or gyrostat, give numbers for the moments and the rotor, and M, the length of M = π + l:
    every permanent rotation on that momentum sphere is found.

    For a satellite in a circular orbit, give numbers for the tensor, the rotor and omega0, if they are
    names: every attitude in which it rests in the frame of the orbit is found, 8 to 24 if its moments are
    different. In another potential beside the gravity gradient, of degree 2 in n, r and n × r as of drag, a
    magnet or an asteroid, or with a free rotor, there are at most 40, those of least energy first. If a turn
    of the body or of the frame is a symmetry, as for a body of revolution in any axes with rotor and torques
    along its axis, the list has a point of each circle of attitudes; on a closed curve it has those that are
    in principal planes. `locus` has the equations. Other curves are refused.

    Parameters
    ----------
    scene : System
        a body of revolution, U rational in the component of k along its axis; or any body, in a field that is
        given or without one
    values : mapping of name to number
        rational or algebraic, as in Report.verdict

    Returns
    -------
    list of RelativeEquilibrium
        complete; for a body in a field in the order of k3 from E1 down to E2, then of omega, without a pole
        at which U is infinite; for a circle of rotations a point, for another curve a point and its equation;
        for a free body by energy

    Raises
    ------
    ValuesError
        names are missing, unknown or too many, or a number is not admissible
    ScopeError
        U is unspecified; for a body of revolution it is not rational in k3; for any other, at a rate or on a
        level, not a polynomial; or a number is not rational, on a level or in a U of degree 3 or more, and
        the numbers have no common factor

    References
    ----------
    Goldstein, Classical Mechanics, §5.7 (the heavy top); Staude (1894) and Kharlamov (1965) (permanent
    rotations); Hughes, Spacecraft Attitude Dynamics (1986), chapter 6 (free gyrostats); else derived.

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> numbers = {"I1": 2, "I3": 1, "l": 0, "m0": 3}
    >>> tilt = {"k3": "1/2", "pi3_0": 6}
    >>> for e in gs.relative_equilibria(top, numbers | tilt):
    ...     print(e.label, e.rates["omega"], e.decision.verdict.name)
    precession 3 - sqrt(6) STABLE
    precession sqrt(6) + 3 STABLE
    >>> free = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)))
    >>> for e in gs.relative_equilibria(free, {"M": 1})[::2]:
    ...     print(e.momentum, e.decision.verdict.name)
    (0, 0, -1) STABLE
    (0, -1, 0) UNSTABLE
    (-1, 0, 0) STABLE
    """
    if scene.kind not in FINDERS:
        in_one_direction(scene.potential, "relative_equilibria")
    return [RelativeEquilibrium(form) for form in FINDERS[scene.kind](scene, values)]


def _free(scene: System, values: Mapping[str, Any]) -> Sequence[Form]:
    return loaded("equilibria.finders.free:free_forms")(scene, values)


def _of_revolution(scene: System, values: Mapping[str, Any]) -> Sequence[Form]:
    return loaded("equilibria.finders.revolution:revolution_forms")(scene, values)


def _in_field(scene: System, values: Mapping[str, Any]) -> Sequence[Form]:
    """Return the forms for a body that is not of revolution about axis 3; it may be about another axis."""
    if scene.unspecified or asked_about(scene, values):
        return _of_revolution(scene, values)
    return loaded("equilibria.finders.heavy:heavy_forms")(scene, values)


def _in_orbit(scene: System, values: Mapping[str, Any]) -> Sequence[Form]:
    return loaded("equilibria.finders.orbit:orbit_forms")(scene, values)


FINDERS: Mapping[Kind, Callable[[System, Mapping[str, Any]], Sequence[Form]]] = {
    Kind.FREE: _free, Kind.REVOLUTION: _of_revolution, Kind.FIELD: _in_field, Kind.ORBIT: _in_orbit}
