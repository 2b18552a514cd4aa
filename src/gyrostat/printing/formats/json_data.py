"""Makes data for JSON of scenes, reports and decisions; expressions are texts in the grammar."""
import json
import math
import re
from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from sympy import Expr

from ...algebra.enclosures.balls import accurate
from ...mechanics.scenes.system import System
from ...stability.criteria.conditions import Condition, Criterion
from ...stability.criteria.orientation_form import orientation_form, rests_in_frame
from ...stability.decision import Decision
from ...stability.report.report import Report
from ...stability.theorems.drift import Drift
from ...version import DOCUMENT_FORMAT
from ..results.boundary import ladder, undecided
from .exact_text import short_text

if TYPE_CHECKING:
    from ...stability.normal_forms.d4_along_family import Window
    from ...stability.normal_forms.normal_form import NormalForm


def scene_data(scene: System) -> dict[str, Any]:
    """Coordinates, bracket, integrals and field."""
    return {
        "coordinates": strings(scene.space.coordinates),
        "tensor": [strings(row) for row in scene.space.tensor.tolist()],
        "casimirs": strings(scene.space.casimirs), "hamiltonian": str(scene.hamiltonian),
        "integrals": strings(scene.integrals),
        "vector_field": strings(scene.vector_field() if scene.potential and scene.potential.given
                                else scene.jet_field)}


def report_data(report: Report) -> dict[str, Any]:
    """The whole derivation of one equilibrium."""
    eq = report.equilibrium
    family, criteria = conditions_data(report), {"casimirs_only": criterion_data(report.casimirs_only)}
    drift = {} if report.boundary is None or report.boundary.pole else {"drift": drift_data(report.drift)}
    relations = {str(name): str(value) for name, value in eq.relations}
    place: dict[str, Any] = {"point": strings(eq.point), "relations": relations}
    if rests_in_frame(eq):
        form = orientation_form(eq)
        place |= {"stiffness": [strings(row) for row in form.stiffness.tolist()],
                  "gyroscopic": strings(form.gyroscopic)}
    if report.closed is not None:
        return family | criteria | place | {"tangent_basis": None, "matrix": None,
                                            "characteristic_polynomial": str(report.closed.polynomial)}
    linear = report.linearization
    return family | criteria | drift | place | {
        "tangent_basis": [strings(row) for row in linear.basis.T.tolist()],
        "matrix": [strings(row) for row in eq.insert_field(linear.matrix).tolist()],
        "characteristic_polynomial": str(eq.insert_field(linear.characteristic_polynomial()))}


def conditions_data(report: Report) -> dict[str, Any]:
    """When an equilibrium exists, and what decides there."""
    eq = report.equilibrium
    definitions = {}
    if report.closed is not None:
        definitions = {"definitions": {str(name): str(value) for name, value in report.closed.definitions}}
    eliminated = eq.eliminated[0] if len(eq.eliminated) == 1 else list(eq.eliminated) or None
    return {"label": eq.label, "positive": strings(eq.existence()), "eliminated": eliminated,
            "parameters": list(report.parameters),
            "necessary": criterion_data(report.necessary), "sufficient": criterion_data(report.sufficient),
            "boundary": boundary_data(report), "damped": criterion_data(report.damped)} | definitions


def boundary_data(report: Report) -> dict[str, Any] | None:
    """The ladder between the two criteria as it is shown.

    None where they leave nothing open, or nothing decides it.
    """
    if not undecided(report) or report.boundary is None:
        return None
    (rungs, _), last = ladder(report.boundary), report.boundary.last
    return {"rungs": [{"power": r.power if isinstance(r.power, int) else str(r.power), "escapes": r.escapes}
                      | condition_data(r.condition) for r in rungs],
            "last": None if last is None else int(last)}


def drift_data(drift: Drift) -> dict[str, Any]:
    """D, and the rates of the relative equilibria nearby; None if every rate occurs."""
    return {"defect": str(drift.defect), "rates": strings(drift.rates) if drift.omega else None}


def criterion_data(criterion: Criterion) -> dict[str, Any]:
    """A criterion: it holds if all conditions of one of the alternatives do."""
    return {"notion": str(criterion.notion), "modulo": strings(criterion.modulo),
            "any_of": [{"all_of": [condition_data(c) for c in alternative]}
                       for alternative in criterion.alternatives]}


def condition_data(c: Condition) -> dict[str, Any]:
    """A condition: margin > 0, or margin ≥ 0 if it is not strict."""
    return {"margin": str(c.margin), "strict": c.strict, "source": c.source,
            "zero_where": strings(c.degenerate), "at": str(c.at)}


# no text has a line break, so none looks like a list of numbers
_VECTOR = re.compile(r"\[\n\s+(-?[\d.e+-]+(?:,\n\s+-?[\d.e+-]+)*)\n\s+\]")
_text = lru_cache(maxsize=4096)(str)                     # the same margins come in every line of a batch


def decision_data(decision: Decision) -> dict[str, Any]:
    """A verdict with its reason."""
    return {"verdict": decision.verdict.name, "notion": str(decision.notion),
            "modulo": strings(decision.modulo), "level": strings(decision.level),
            "locus": decision.locus, "rung": decision.rung.value,
            "proved": decision.proved, "reason": decision.reason,
            "margins": {_text(margin): short_text(value) for margin, value in decision.margins},
            "certificate": {str(F): str(a) for F, a in decision.certificate},
            "note": decision.note}


def damped_data(decision: Decision) -> dict[str, Any]:
    """A verdict under internal damping, with the number of growing modes."""
    return decision_data(decision) | {"growing": decision.growing}


def form_data(form: "NormalForm") -> dict[str, Any]:
    """A normal form: numbers exactly, if they are known so, and as decimals."""
    return {"frequencies": [number_data(omega) for omega in form.frequencies],
            "coefficients": [{"powers": [m, n], "value": number_data(c)} for m, n, c in form.coefficients],
            "twists": {f"D{2 * degree}": number_data(D) for degree, D in enumerate(form.twists, 2)},
            "resonances": [list(pair) for pair in form.resonances]}


def window_data(window: "Window") -> dict[str, Any]:
    """D4 along a family: expressions as texts."""
    return {"p": str(window.p), "q": str(window.q),
            "resonances": [{"frequencies": [m, n], "zero_where": str(x)} for m, n, x in window.resonances],
            "D4": str(window.D4), "margin": str(window.margin), "zero_where": [str(x) for x in window.zeros]}


def number_data(number: Expr | None) -> dict[str, Any] | None:
    """A number exactly, if that is short, and as a decimal; None stays None."""
    return None if number is None else {"exact": short_text(number), "decimal": double(number)}


def double(number: Expr) -> float | None:
    """The double next to a number; None if there is none, as JSON has no infinity."""
    enclosed = accurate(number, 60)                        # of nested roots sooner than evalf
    value = float(enclosed.mid() if enclosed.is_finite() else number.evalf(17))
    return value if math.isfinite(value) else None


def reports_data(scene: System, reports: Sequence[Report],
                 decisions: Mapping[str, tuple[Decision, Decision]]) -> dict[str, Any]:
    """A scene with its reports, and their decisions if there are numbers."""
    equilibria = []
    for report in reports:
        both = decisions.get(report.equilibrium.label)
        decided = both and {"decision": decision_data(both[0]), "damped_decision": damped_data(both[1])}
        equilibria.append(report_data(report) | (decided or {}))
    return scene_data(scene) | {"equilibria": equilibria}


def document(data: Mapping[str, Any]) -> dict[str, Any]:
    """A document: its format first."""
    return {"format": DOCUMENT_FORMAT, **data}


def json_text(data: Mapping[str, Any]) -> str:
    """A document that every reader reads: its format first, neither NaN nor Infinity, vectors in a line."""
    text = json.dumps(document(data), indent=2, ensure_ascii=False, allow_nan=False)
    return _VECTOR.sub(lambda found: f"[{' '.join(found[1].split())}]", text) + "\n"


def strings(expressions: Any) -> list[str]:
    """Expressions in the grammar of the command line."""
    return [str(expression) for expression in expressions]
