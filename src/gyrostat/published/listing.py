"""Writes findings for a reader: as text, source by source, and as JSON."""
from collections.abc import Iterable
from itertools import groupby
from textwrap import wrap
from typing import Any

from sympy import Expr, Float, MatrixBase

from ..algebra.rings.readable import readable
from ..mechanics.classical.attitude import reduced
from ..printing.formats.text import plain
from ..printing.formats.unicode import unicode
from ..stability.criteria.conditions import Criterion
from .checks.findings import Finding, source_of
from .hypotheses import hypotheses
from .statements import Counterexample, as_text, entry_of

NOT_SHARP = "no point was found at which it fails, but it is not the whole condition:"
SCENE = "the numbers of the scene"
SHORT = 36                                             # characters of an exact number beside its digits
IN_WORDS = ("condition", "statement", "count")         # kinds whose quantity is a claim in words
_MARK = {"confirmed": "✓", "misprint": "✗", "unchecked": "–"}


def rows(finding: Finding) -> list[tuple[str, str, Any]]:
    """Return ("printed" or "right", entry, value) for each entry in which the two differ.

    There are two rows if the statement is corrected, or has no entries. What is printed is the text of the
    source, or its texts; it comes once if one text stands for all entries. What is right is such a text too
    if the statement is corrected, otherwise it is the derived value.
    """
    printed, outcome = finding.statement.printed, finding.outcome
    if outcome.corrected is not None:
        return [("printed", "", printed), ("right", "", outcome.corrected)]
    if not outcome.difference or not isinstance(outcome.derived, MatrixBase):
        return [("printed", "", printed), ("right", "", _shown(outcome.derived))]
    found = [("printed", "", printed)] if isinstance(printed, str) else []
    for (i, j), _ in outcome.difference:
        entry = entry_of((i, j), outcome.derived)
        if not isinstance(printed, str):
            found.append(("printed", entry, printed[i][j] if isinstance(printed[i], list) else printed[i]))
        found.append(("right", entry, _shown(outcome.derived[i, j])))
    return found


def _shown(value: Any) -> Any:
    return readable(reduced(value)) if isinstance(value, Expr) else value


def _one_line(value: Any, at: Any = None) -> str:
    if isinstance(value, (str, list, type(None))):
        return as_text(value or "")
    return plain(value) if isinstance(value, Criterion) else unicode(value, at)


def place(finding: Finding) -> Any:
    """Return the k3 at which derivatives of U are taken, as typesetting needs it."""
    eq = finding.statement.scene.equilibrium
    if "k3" in finding.statement.at:
        return finding.statement.at["k3"]
    return eq.at if eq and eq.system.potential else None


def text(findings: Iterable[Finding], width: int = 100, full: bool = False) -> str:
    """List findings by source: what is derived, and for a misprint its counterexample.

    If full is True, each statement has its hypotheses, and a confirmed one the route of its comparison.
    """
    lines: list[str] = []
    for _, group in groupby(findings, key=lambda f: f.statement.file):
        found = list(group)
        source = source_of(found[0])
        lines += wrap(f"{source.name}: {source.title}", width) + [f"  {_counts(found)}", ""]
        size = max(len(f.statement.key) for f in found)
        for f in found:
            unexpected = f"   ← expected: {f.expected}" if source.expects and f.status != f.expected else ""
            lines += wrap(f"  {_MARK[f.status]} {f.status:<10} {f.statement.key:<{size}}  "
                          f"{f.statement.where}{unexpected}", width, subsequent_indent=" " * 15)
            lines += _lines([*(_confirmed(f, width, full) if f.status == "confirmed" else _details(f)),
                             *(_assumed(f) if full else [])], width)
        lines.append("")
    return "\n".join(lines)


def summary(findings: Iterable[Finding]) -> str:
    """Count the statuses; where a source says what is expected, name what is not as expected."""
    found, wrong, known = list(findings), list[str](), 0
    for _, group in groupby(found, key=lambda f: f.statement.file):
        ours = list(group)
        if source_of(ours[0]).expects:
            wrong += [f"{f.statement.source}:{f.statement.key}" for f in ours if f.status != f.expected]
            known += sum(f.status == f.expected == "misprint" for f in ours)
    if wrong:
        return f"{_counts(found)}; not as expected: {', '.join(wrong)}"
    if known:
        return _counts(found) + ("; the known misprint was found" if known == 1
                                 else f"; all {known} known misprints were found")
    return _counts(found)


def _counts(found: list[Finding]) -> str:
    if len(found) == 1:
        return f"1 statement: {found[0].status}"
    counts = [(sum(f.status == status for f in found), status) for status in _MARK]
    return f"{len(found)} statements: " + ", ".join(
        f"{n} {status}{'s' if status == 'misprint' and n > 1 else ''}" for n, status in counts if n)


def _confirmed(f: Finding, width: int, full: bool) -> list[tuple[str, str]]:
    """Return what is derived, cut to two lines; if full, all of it, with the route of the comparison."""
    derived = _derived(f)
    if full:
        return [("derived", derived), ("compared", f.outcome.route)]
    if len(derived) > 2 * (width - 26):
        derived = f"{derived[:width - 60].rpartition(' ')[0]} … ({len(derived)} characters, see --full)"
    return [("derived", derived)]


def _derived(f: Finding) -> str:
    """Return what the library derives for the quantity of a statement, beside the quantity."""
    value, said = f.outcome.derived, as_text(quantity(f))
    if f.statement.kind in IN_WORDS:
        return f"{said}: {_one_line(value, place(f))}"
    if f.statement.kind == "number":
        return f"{said} {_decimal(value)}"
    return f"{said} = {_entries(value, place(f))}"


def quantity(f: Finding) -> Any:
    """Return the text, or texts, of what the derived value is equal to."""
    s = f.statement
    if s.kind == "equilibrium":
        return "state" if s.scene.equilibrium else "field"
    if s.kind == "solution":
        return [f"dt({name})" for name in s.quantity]
    if set(as_text(s.quantity)) <= set("0[], "):           # what is printed is equal to 0
        return s.printed
    return s.quantity


def _entries(value: Any, at: Any) -> str:
    """Return a formula, or the formulas of a vector or matrix as a list."""
    if not isinstance(value, MatrixBase):
        return unicode(shortest(value, at), at)
    rows = [[unicode(shortest(entry, at), at) for entry in row] for row in value.tolist()]
    return as_text([row[0] for row in rows] if value.cols == 1 else rows)


def shortest(value: Expr, at: Any) -> Expr:
    """Return a formula as it was derived, or factored if that is shorter."""
    return min(value, _shown(value), key=lambda e: len(unicode(e, at)))


def is_short(value: Expr) -> bool:
    """Return whether an exact number is short enough to stand beside its digits."""
    return len(unicode(value)) <= SHORT and not value.has(Float)


def _decimal(value: Expr) -> str:
    """Return a number after its sign: = before the exact number if it is short, ≈ before 15 digits."""
    digits = str(value.evalf(15))
    if not is_short(value):
        return f"≈ {digits}"
    return f"= {unicode(value)}" if value.is_Rational else f"= {unicode(value)} ≈ {digits}"


def _assumed(f: Finding) -> list[tuple[str, str]]:
    """Return the hypotheses of a statement as text; derivatives of U are written at its k3."""
    return [(name, "".join(x if isinstance(x, str) else unicode(x, place(f)) for x in pieces))
            for name, pieces in hypotheses(f.statement)]


def _details(f: Finding) -> list[tuple[str, str]]:
    """Return what is right in place of a misprint and what shows it, or why a statement is unchecked."""
    pairs: list[tuple[str, str]] = []
    if f.status == "misprint":
        pairs.append(("about", as_text(f.statement.quantity)))
        pairs += [(word, entry + _one_line(value, place(f))) for word, entry, value in rows(f)]
        pairs += [("differ by", difference)] if (difference := _differences(f)) else []
        if c := f.outcome.counterexample or f.outcome.not_sharp:
            pairs += [("not sharp", NOT_SHARP)] if f.outcome.not_sharp else []
            pairs.append(("at", ", ".join(f"{name} = {value}" for name, value in c.values) or SCENE))
            pairs.append(("there",
                          f"printed {number(c.printed)}, derived {number(c.derived)}; {c.confirmation}"))
    else:
        pairs.append(("claim", as_text(f.statement.printed)))
        if f.outcome.remark and f.outcome.derived is not None:
            pairs.append(("derived", _one_line(_shown(f.outcome.derived), place(f))))
        pairs += [("because", f.outcome.remark)] if f.outcome.remark else []
    return pairs + ([("note", f.statement.note)] if f.statement.note else [])


def _lines(pairs: Iterable[tuple[str, str]], width: int) -> list[str]:
    lines = []
    for label, value in pairs:
        lines += wrap(f"{label + ':':<10} {value}", width, initial_indent=" " * 15,
                      subsequent_indent=" " * 26, break_long_words=False)
    return lines


def _differences(f: Finding) -> str:
    """Return printed − derived, or "" if it has 400 characters or more; JSON always has it."""
    outcome = f.outcome
    found = [entry_of(entry, outcome.derived) + unicode(readable(value), place(f))
             for entry, value in outcome.difference or () if not isinstance(outcome.derived, str)]
    return "; ".join(found) if sum(map(len, found)) < 400 else ""


def number(value: Any) -> str:
    """Return a value of a counterexample: exact if it is rational, else to 15 digits."""
    return str(value) if not isinstance(value, Expr) or value.is_Rational else str(value.evalf(15))


def to_json(findings: Iterable[Finding]) -> list[dict[str, Any]]:
    """Return one object for each statement, as docs/reference/formats.md describes it."""
    return [{"source": f.statement.source, "key": f.statement.key, "where": f.statement.where,
             "quantity": f.statement.quantity,
             "kind": f.statement.kind, "printed": f.statement.printed,
             "derived": _plain(f.outcome.derived, f.status) if f.outcome.corrected is None
             else f.outcome.corrected,
             "status": f.status, "expected": f.expected, "difference": _difference(f),
             "counterexample": _example(f.outcome.counterexample),
             "not_sharp": _example(f.outcome.not_sharp), "remark": f.outcome.remark,
             "note": f.statement.note, "route": f.outcome.route,
             "hypotheses": {name: "".join(map(str, pieces)) for name, pieces in hypotheses(f.statement)}}
            for f in findings]


def _plain(value: Any, status: str) -> Any:
    if value is None or isinstance(value, str):
        return value
    if isinstance(value, MatrixBase):
        return [[_plain(entry, status) for entry in row] for row in value.tolist()]
    if isinstance(value, Criterion):
        return plain(value)
    return str(reduced(value)) if status == "misprint" else str(value)


def _difference(f: Finding) -> Any:
    if f.status != "misprint" or not f.outcome.difference:
        return None
    return [{"entry": entry and [i + 1 for i in entry], "printed_minus_derived": str(value)}
            for entry, value in f.outcome.difference]


def _example(c: Counterexample | None) -> Any:
    return c and {"values": {name: str(value) for name, value in c.values}, "printed": number(c.printed),
                  "derived": number(c.derived),
                  "confirmation": c.confirmation}
