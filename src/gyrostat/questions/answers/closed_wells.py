"""The wells of the equilibria of a scene in closed form, at numbers, or why there is none."""
from collections.abc import Mapping, Sequence
from decimal import ROUND_FLOOR
from typing import Any

from sympy import Expr, pi

from ...algebra.text.numbers import exact_number
from ...equilibria.wells.closed_forms import THETA, ClosedForm, closed_forms
from ...errors import ScopeError
from ...notation import symbol
from ...printing.blocks import Block, Heading, prose, sentence
from ...printing.numbers import rounded
from ...printing.results.closed_wells import closed_well_blocks
from ...stability.report.report import Report

KNOWN = ("closed forms are known of a rotation of a free gyrostat about the axis that carries l, of E1, E2 "
         "and E3 in a polynomial U(k3), and of an Earth-pointing satellite whose l is along the pitch axis")
Wells = Mapping[str, Sequence[ClosedForm] | str]


def wells_of(reports: Sequence[Report], numbers: Mapping[str, Expr]) -> Wells:
    """The forms of each equilibrium by label, or the reason; a ScopeError if none has a form."""
    given = {symbol(name): x for name, x in numbers.items()}
    found: dict[str, Sequence[ClosedForm] | str] = {}
    for report in reports:
        label, forms = report.equilibrium.label, closed_forms(report.equilibrium)
        there = [form for known in forms if (form := known.at(given)) is not None]
        found[label] = there or ("it is no strict minimum at these numbers, so that it is in no well" if forms
                                 else f"its well has no closed form: {KNOWN}")
    reasons = [f"{label}: {x}" for label, x in found.items() if isinstance(x, str)]
    if len(reasons) == len(found):
        raise ScopeError("; ".join(reasons) + ". Ask without the well, or give other numbers")
    return found


def safe_kick(report: Report, values: Mapping[str, str]) -> list[Block]:
    """The kick that a stable equilibrium survives, in a sentence, where a formula without a root has it.

    Of a top without a pass it is the kick that keeps it within 10° of its place.
    """
    given = {symbol(name): exact_number(text, name) for name, text in values.items()}
    for form in (form for known in closed_forms(report.equilibrium) if (form := known.at(given)) is not None):
        if form.kick is None or (kick := form.kick.xreplace({THETA: pi / 18})).free_symbols:
            continue
        which, kept = (" across the axis", "keeps it within 10° of its place") if (
            THETA in form.kick.free_symbols) else ("", "does not take it out of its well")
        return [sentence(f"A kick{which} of less than ", rounded(kick, ROUND_FLOOR), f" {kept}.")]
    return []


def wells_blocks(found: Wells) -> list[Block]:
    """The forms, each under its label, or the reason."""
    blocks: list[Block] = []
    for label, forms in found.items():
        blocks.append(Heading(f"{label}, its well"))
        blocks += [prose(forms[0].upper() + forms[1:])] if isinstance(forms, str) else [
            block for form in forms for block in closed_well_blocks(form)]
    return blocks


def wells_data(found: Wells) -> dict[str, Any]:
    """The same for JSON."""
    return {label: {"open": forms} if isinstance(forms, str) else [_data(form) for form in forms]
            for label, forms in found.items()}


def _data(form: ClosedForm) -> dict[str, Any]:
    texts = {name: None if (x := getattr(form, name)) is None else str(x)
             for name in ("barrier", "kick", "tilt", "equation")}
    return {"scene": form.scene, "positive": [str(x) for x in form.conditions],
            "names": {str(name): str(x) for name, x in form.names}, "root": form.root, **texts}
