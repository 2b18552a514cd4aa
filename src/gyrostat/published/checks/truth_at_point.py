"""Decides what is true of a printed condition or verdict at a point, by Newton and Euler's equations."""
from ...algebra.reals.exact import sign_of_constant
from ...errors import GyrostatError, PublishedError
from ...notation import symbol
from ..independent.arnold import stability
from ..independent.counterexample import Model, Values
from ..independent.frame_equations import model_of
from ..independent.least_energy import is_least
from ..independent.separatrix_residual import separatrix_residual
from ..statements import Doubt, Seen
from .comparisons import NEVER, holds_as_printed
from .criteria import DAMPED, SPECTRAL
from .readings import Reading


def model_at(r: Reading, values: Values) -> Model | None:
    """Return the scene at numbers; None if its equilibrium does not exist there."""
    try:
        return model_of(r.scene, values)
    except GyrostatError:
        return None


def condition_at(r: Reading, values: Values, doubt: Doubt) -> Seen | None:
    """Compare a printed condition, as it is read, with what is proved about the point."""
    claim, model = str(r.statement.quantity), model_at(r, values)
    if model is None:
        return None
    says, equal = (
        (False, False)
        if r.statement.printed == NEVER
        else holds_as_printed(r.statement.printed, r.independent(values))
    )
    truth, why = _truth(r, claim, model, values)
    if None in (says, truth) or says == truth:
        return None
    either = claim in ("existence", "necessary and sufficient for stability", SPECTRAL)
    note = ", though two of the sides printed are equal" if equal else ""
    return Seen("holds" if says else "fails", _word(claim, bool(truth)), why + note,
                either or says == claim.startswith("sufficient"))


def _word(claim: str, truth: bool) -> str:
    """Return what is true, in the words of the claim."""
    if claim.endswith("Casimirs alone"):
        return "definite" if truth else "not definite"
    if claim == DAMPED:
        return "least" if truth else "not least"
    if claim == SPECTRAL:
        return "spectrally stable" if truth else "unstable"
    if claim in ("existence", "sufficient for periodic motion"):
        return ("" if truth else "not ") + ("an equilibrium" if claim == "existence" else "periodic")
    return "stable" if truth == ("instability" not in claim) else "unstable"


def _truth(r: Reading, claim: str, model: Model, values: Values) -> tuple[bool | None, str]:
    """Return whether what a condition is claimed for is true at a point; None if neither is proved."""
    if claim == "existence":
        return _exists(r, model)
    if claim == "sufficient for periodic motion":
        return _periodic(r, values)
    if claim.endswith("Casimirs alone"):
        definite = model.is_definite()
        return (
            definite,
            "the squares of D²(h + ν·C) on the tangent space of the orbit, counted exactly, are "
            + ("of one sign" if definite else "not of one sign"),
        )
    if claim == SPECTRAL:
        grows = model.grows()
        return not grows, ("the characteristic polynomial of the linearised field, its signs exact, has "
                           + ("a root with a positive real part" if grows else "no root with one"))
    if claim == DAMPED:
        least = is_least(model)
        return least, ("the energy on the level of the Casimirs, its squares counted exactly, is "
                       + ("least there" if least else "not least there: damping takes it away"))
    if claim.endswith("on the boundary") and not model.is_on_boundary():
        return None, ""
    sign, why = stability(model)
    return None if not sign else (sign == 1) == ("instability" not in claim), why


def _exists(r: Reading, model: Model) -> tuple[bool | None, str]:
    """Return whether the equilibrium exists: its direction is real, and the model has checked its field."""
    if r.scene.equilibrium is None:
        return True, "what is given holds there"
    if len(model.point) == 6 and sign_of_constant(1 - model.k3**2) == -1:
        return False, f"there is no such direction, k3 = {model.k3}"
    if len(model.point) == 6 and sum(x**2 for x in model.point[3:]) != 1:
        return None, ""
    return True, f"the field of Newton and Euler vanishes there, at {model.point}"


def _periodic(r: Reading, values: Values) -> tuple[bool | None, str]:
    moments, E, L2 = [m.subs(dict(values))
                      for m in r.scene.body.moments], values[symbol("E")], values[symbol("L2")]
    if moments != [1, 2, 3] or L2 != 1 or 4 * E != 1:
        return None, ""
    if (worst := separatrix_residual()) > 1e-20:
        raise PublishedError(f"the separatrix does not satisfy Euler's equations: residual {worst}")
    return False, ("on the separatrix M2 = tanh(√((1/I1 − 1/I2)(1/I2 − 1/I3)) t) satisfies Euler's "
                   "equations (residual below 1e-20) and "
                   "increases for ever")


def verdict_at(r: Reading, values: Values, doubt: Doubt) -> Seen | None:
    """Compare a verdict in words, or the signature of a form, with what is proved about the point."""
    model = model_at(r, values)
    if model is None:
        return None
    if r.statement.quantity == "stability":
        sign, why = stability(model)
        if not sign or (sign == 1) == (r.statement.printed != "unstable"):
            return None
        return Seen(r.statement.printed, "stable" if sign == 1 else "unstable", why, True)
    plus, zero, minus = model.inertia_of_second_variation() or (0, 0, 0)
    if not plus or not minus:
        return None
    return Seen(r.statement.printed, f"{plus} positive, {zero} zero and {minus} negative squares",
                "they are counted exactly on the tangent space of the orbit, as those of D²(h + ν·C) there",
                True)
