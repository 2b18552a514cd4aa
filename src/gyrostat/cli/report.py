"""gyrostat report: the derivation as text, LaTeX or JSON."""
import argparse
import contextlib
import json
from typing import Any

from ..body import Gyrostat, symmetric_gyrostat
from ..conditions import Criterion
from ..document import Block, Heading, criterion_blocks, decision_blocks, existence, report_blocks, scene_blocks
from ..equilibria import Equilibrium
from ..errors import EquilibriumError, ValuesError
from ..expressions import exact_number, parse
from ..families import hanging, inclined, principal_rotation, static_tilt, upright
from ..notation import jet, symbol
from ..potential import axial_potential
from ..stability import Decision, Report, analyze
from ..system import System, assemble
from ..values import unknown


def run(given: argparse.Namespace) -> str:
    """What the command prints."""
    numbers = _numbers(given.values)
    scene = _scene(given.potential)
    if scene.potential is None and given.equilibrium:
        raise ValuesError(f"--equilibrium {given.equilibrium[0]} needs a field, --potential none has none: leave out one of the two")
    reports = [analyze(eq) for eq in _equilibria(scene, given.equilibrium or ["E1", "E2", "E3"], numbers)]
    decisions: list[Decision | None] = _decisions(reports, numbers) if numbers else [None for _ in reports]
    if given.conditions and given.format == "json":
        raise ValuesError("--conditions is a table, --format json has the conditions anyway: leave out one of the two")
    if given.conditions:
        return _conditions(reports, given)
    if given.format == "json":
        return json.dumps(_json(scene, reports, decisions), indent=2, ensure_ascii=False) + "\n"
    if given.format == "latex":
        from ..article import document
        return document(reports, decisions, given.fragment)
    from ..unicode import text
    blocks: list[Block] = scene_blocks(scene)
    for report, decision in zip(reports, decisions):
        blocks += report_blocks(report) + (decision_blocks(decision, report.equilibrium.at) if decision else [])
    return text(blocks)


def _conditions(reports: list[Report], given: argparse.Namespace) -> str:
    """Only where each equilibrium exists and its two conditions."""
    if given.format == "latex":
        from ..article import conditions_table
        return conditions_table(reports, given.fragment)
    from ..unicode import text
    blocks: list[Block] = []
    for report in reports:
        eq = report.equilibrium
        blocks += [Heading(eq.label), *(existence(d, eq.at) for d in eq.existence()),
                   *criterion_blocks("Necessary", report.necessary, eq.at), *criterion_blocks("Sufficient", report.sufficient, eq.at)]
    return text(blocks)


def _numbers(settings: list[str]) -> dict[str, Any]:
    numbers: dict[str, Any] = {}
    for setting in settings:
        name, equals, value = setting.partition("=")
        name = name.strip()
        if not equals or not name.isidentifier():
            raise ValuesError(f"--set {setting} is not NAME=VALUE: write, for example, --set I1=1.6")
        if name in numbers:
            raise ValuesError(f"--set gives {name} twice: give it once")
        numbers[name] = exact_number(value, name)
    if {"pi3_0", "omega3_0"} <= numbers.keys():
        raise ValuesError("--set gives both pi3_0 and omega3_0 = pi3_0/I3: give one of them")
    return numbers


def _scene(potential: str | None) -> System:
    if potential is not None and potential.strip() == "none":
        return assemble(Gyrostat(gyrostatic_momentum=(0, 0, symbol("l"))))
    return assemble(symmetric_gyrostat(), axial_potential(None if potential is None else parse(potential)))


def _equilibria(scene: System, labels: list[str], numbers: dict[str, Any]) -> list[Equilibrium]:
    if scene.potential is None:
        return [principal_rotation(scene, 3)]
    spin = "omega3_0" if "omega3_0" in numbers else "pi3_0"
    found = []
    for label in dict.fromkeys(labels):
        if label == "E3":
            found += _tilted(scene, numbers)
        else:
            found.append((upright if label == "E1" else hanging)(scene, spin))
    return found


def _tilted(scene: System, numbers: dict[str, Any]) -> list[Equilibrium]:
    """E3; its tilt eliminated where l is set and k3 is not; without numbers the tilt at rest of a given U too, if there is one."""
    if not scene.potential or not scene.potential.given:
        return [inclined(scene)]
    with contextlib.suppress(EquilibriumError):
        if numbers:
            return [inclined(scene, eliminate="k3" if "l" in numbers and "k3" not in numbers else None)]
        at_rest = static_tilt(scene)
        return [inclined(scene), at_rest] if at_rest.eliminated in ("k3", None) else [inclined(scene)]
    return [inclined(scene)]


def _decisions(reports: list[Report], numbers: dict[str, Any]) -> list[Decision | None]:
    """A decision for each report whose names are all set; at least one must be."""
    known = {name for report in reports for name in report.parameters}
    free_jet = any(r.equilibrium.system.potential and not r.equilibrium.system.potential.given for r in reports)
    for name in numbers:
        if name not in known and not (free_jet and jet(name)):
            raise ValuesError(unknown(name, sorted(known), "the scene"))
    missing = [[name for name in report.required if name not in numbers] for report in reports]
    if all(missing):
        wanted = "; ".join(f"{r.equilibrium.label}: {', '.join(names)}" for r, names in zip(reports, missing))
        raise ValuesError(f"these numbers are not enough for a verdict, set also, for {wanted}" + (
            " (or omega3_0 in place of pi3_0)" if "pi3_0" in wanted else ""))
    return [None if names else report.verdict({n: v for n, v in numbers.items() if n in report.parameters})
            for report, names in zip(reports, missing)]


def _json(scene: System, reports: list[Report], decisions: list[Decision | None]) -> dict[str, Any]:
    return {
        "coordinates": _strings(scene.space.coordinates), "tensor": [_strings(row) for row in scene.space.tensor.tolist()],
        "casimirs": _strings(scene.space.casimirs), "hamiltonian": str(scene.hamiltonian), "integrals": _strings(scene.integrals),
        "vector_field": _strings(scene.vector_field() if scene.potential and scene.potential.given else scene.jet_field),
        "equilibria": [_equilibrium(report, decision) for report, decision in zip(reports, decisions)]}


def _equilibrium(report: Report, decision: Decision | None) -> dict[str, Any]:
    eq, linear = report.equilibrium, report.linearization
    result: dict[str, Any] = {
        "label": eq.label, "point": _strings(eq.point), "relations": {str(name): str(value) for name, value in eq.relations},
        "positive": _strings(eq.existence()), "eliminated": eq.eliminated, "parameters": list(report.parameters),
        "tangent_basis": [_strings(row) for row in linear.basis.T.tolist()],
        "matrix": [_strings(row) for row in linear.matrix.tolist()], "characteristic_polynomial": str(linear.characteristic_polynomial()),
        "necessary": _criterion(report.necessary), "sufficient": _criterion(report.sufficient),
        "casimirs_only": _criterion(report.casimirs_only)}
    if decision:
        result["decision"] = {
            "verdict": decision.verdict.name, "notion": decision.notion, "modulo": _strings(decision.modulo), "reason": decision.reason,
            "margins": {str(margin): str(value) for margin, value in decision.margins}, "note": decision.note}
    return result


def _criterion(criterion: Criterion) -> dict[str, Any]:
    return {"notion": criterion.notion, "modulo": _strings(criterion.modulo), "any_of": [
        {"all_of": [{"margin": str(c.margin), "strict": c.strict, "source": c.source, "zero_where": _strings(c.degenerate), "at": str(c.at)}
                    for c in alternative]} for alternative in criterion.alternatives]}


def _strings(expressions: Any) -> list[str]:
    return [str(expression) for expression in expressions]
