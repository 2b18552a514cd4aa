"""Follows critical points of quartic forms F = Σ sᵏ F_k along s, in doubles and by proof."""
from collections.abc import Sequence

import numpy as np
from flint import acb, arb

from ...errors import ScopeError
from ..enclosures.floats import Array
from ..enclosures.precision import own_precision
from .boxes import TURNS, CriticalEquations, turned
from .quartic_forms import Form, QuarticForm, monomials

POWERS = np.array([*monomials(4)])
STEPS, CLOSE, LEAST = 16, 1e-11, 1e-15                 # of Newton's method; the turn, or torque, that ends it
FARTHEST, HALVINGS = 0.1, 30                           # of one step; how often it is halved
APART = 1e-7                                           # points that are different
PROOFS = 44, 36, 28                                    # bits of the enclosures: the box has half of them


class FollowedRotations:
    """Critical points q of Σ sᵏ F_k on N = 1, several at once.

    Parameters
    ----------
    forms : sequence of Form
    """

    def __init__(self, forms: Sequence[Form]):
        self._forms = forms
        size = max(abs(int(c)) for form in forms for c in form.values())
        torques = [[turned(form, turn) for turn in TURNS] for form in forms]
        self._torques = np.array([[_row(f, size) for f in each] for each in torques])
        self._bends = np.array([[[_row(turned(f, turn), size) for turn in TURNS] for f in each]
                                for each in torques])

    def along(self, start: Array, values: Sequence[float]) -> Array:
        """Return q at each value, shape (values, points, 4), by those near the first, shape (points, 4).

        Raises
        ------
        ScopeError
            two of them come so near to each other that doubles do not tell them apart
        """
        found = [self._at(start, values[0])]
        for before, after in zip(values, values[1:]):
            found.append(self._step(found[-1], before, after, HALVINGS))
        return np.array(found)

    def goes_on(self, q: Array, values: arb) -> bool:
        """Tell whether it is proved that a simple critical point goes on near q at all values in a ball.

        References
        ----------
        Krawczyk, Computing 4 (1969) 187-201, with s in an interval.
        """
        whole = {e: sum((values**k * form[e] for k, form in enumerate(self._forms) if form[e]), arb(0))
                 for e in monomials(4)}
        equations = CriticalEquations(QuarticForm(whole))
        return any(self._is_near(q, equations, bits) for bits in PROOFS)

    def _is_near(self, q: Array, equations: CriticalEquations, bits: int) -> bool:
        """Tell whether a box with one critical point is found around q, and not around another point."""
        with own_precision(bits):
            box = equations.enclosed([acb(x) for x in q.tolist()])
        near = 2 ** (-bits // 2)
        return box is not None and all(abs(float(x.real.mid()) - y) < near for x, y in zip(box, q))

    def _step(self, q: Array, s: float, to: float, halvings: int) -> Array:
        try:
            slope, bend = self._system(q, s)[1:]
            ahead = self._at(_moved(q, np.linalg.solve(bend, -(to - s) * slope)), to)
            if np.abs(ahead - q).max() < FARTHEST:
                return ahead
        except (np.linalg.LinAlgError, ArithmeticError):
            pass
        if not halvings or (half := (s + to) / 2) in (s, to):
            raise ScopeError("two attitudes come so near to each other that doubles do not tell them apart: "
                             "take a range without this value")
        return self._step(self._step(q, s, half, halvings - 1), half, to, halvings - 1)

    def _at(self, q: Array, s: float) -> Array:
        """Return the critical points near others, by Newton's method."""
        for _ in range(STEPS):
            torque, _, bend = self._system(q, s)
            q = _moved(q, turn := np.linalg.solve(bend, -torque))
            if np.abs(turn).max() < CLOSE or np.abs(torque).max() < LEAST:
                break
        else:
            raise ArithmeticError
        if (apart(q, q) + np.eye(len(q)) < APART).any():
            raise ArithmeticError
        return q

    def _system(self, q: Array, s: float) -> tuple[Array, Array, Array]:
        """Return torques, their derivatives by s, and by the turns."""
        values = np.prod(q[:, None, :] ** POWERS, axis=2)
        powers = s ** np.arange(len(self._forms))
        slopes = np.array([k * s ** max(k - 1, 0) for k in range(len(self._forms))])
        torque, slope = (np.einsum("k,kim,pm->pi", c, self._torques, values)[..., None]
                         for c in (powers, slopes))
        return torque, slope, np.einsum("k,kijm,pm->pij", powers, self._bends, values)


def apart(first: Array, second: Array) -> Array:
    """Return the distances of points ±q of two lists."""
    return np.minimum(*(np.linalg.norm(first[:, None] - sign * second[None], axis=2) for sign in (1, -1)))


def _moved(q: Array, turns: Array) -> Array:
    """Return q + Σ δ_i J_i q of length 1."""
    ahead = q.copy()
    for i, turn in enumerate(TURNS):
        for place, (j, sign) in enumerate(turn):
            ahead[:, place] += sign * turns[:, i, 0] * q[:, j]
    return ahead / np.linalg.norm(ahead, axis=1)[:, None]


def _row(form: Form, size: int) -> list[float]:
    return [int(form.get(e, 0)) / size for e in monomials(4)]
