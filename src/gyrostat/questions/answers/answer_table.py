"""The answers of decide as a table: of each equilibrium its place, its rates and its two verdicts."""
from collections import Counter
from collections.abc import Iterable, Sequence
from textwrap import wrap

from sympy import Expr

from ...algebra.text.grammar import parse
from ...printing.cells import in_a_cell, in_cells
from ...printing.formats.text_tables import Column, table_text
from ...printing.formats.unicode import unicode
from ...stability.decision import Decision, Verdict
from .answers import Answer

NO_EQUILIBRIUM = "none"
ANGLES, DEGREES = ("roll", "pitch", "yaw"), "deg"


def answer_table(answers: Sequence[Answer], with_units: bool, width: int) -> str:
    """How many are stable, the table, and what its words mean.

    The number of a row is that of the equilibrium in the list of `relative_equilibria`.

    Parameters
    ----------
    answers : sequence of Answer
    with_units : bool
        whether the numbers given have units: columns have those of SI
    width : int
        of a line
    """
    columns = [*place_columns(answers, with_units), *verdict_columns(answers)]
    return "\n".join([*wrap(counted(answers), width), "", table_text(columns, notes_of(answers), width), ""])


def place_columns(answers: Sequence[Answer], with_units: bool) -> list[Column]:
    """Number, name and place of each; a satellite is placed by its angles against t, n and r."""
    labels = [_label(a) for a in answers]
    columns = [Column("#", [str(n) for n in range(1, len(answers) + 1)], number=True)]
    if len(set(labels)) > 1:
        columns.append(Column("name", labels))
    places = [_place(a) for a in answers]
    return columns + [Column(name if name in ANGLES else unicode(parse(name)),
                             [place.get(name, "") for place in places],
                             DEGREES if name in ANGLES else answers[0].unit_of(name) if with_units else "",
                             number=True)
                      for name in dict.fromkeys(name for place in places for name in place)]


def verdict_columns(answers: Sequence[Answer]) -> list[Column]:
    """The two verdicts of each."""
    return [Column("verdict", [_verdict(a.decision) for a in answers]),
            Column("damped", [_verdict(a.damped) for a in answers])]


def notes_of(answers: Sequence[Answer]) -> list[str]:
    """What stands below a row: the set of equilibria, and what is determined if pitch is ±90°."""
    found = [a.found for a in answers]
    return ["; ".join(filter(None, (e.locus, "" if e.attitude is None else e.attitude.note))) if e else ""
            for e in found]


def legend(answers: Sequence[Answer]) -> str:
    """What the words in the table mean, as sentences."""
    decisions = [d for a in answers for d in (a.decision, a.damped) if d is not None]
    said = ["Stable means Lyapunov stable; damped is the verdict under internal damping."]
    said += [f"mod {name}: modulo the flow of {name}." for name in _occurring(d.modulo for d in decisions)]
    said += [f"at {name}: for motions that keep {name}." for name in _occurring(d.level for d in decisions)]
    if any(d.locus for d in decisions):
        said.append("as a set: the set of equilibria is stable, its points need not be.")
    if any(a.found is not None and a.found.attitude is not None for a in answers):
        said.append("From the axes t along the velocity, n along the normal of the orbit and r away from the "
                    "Earth the body is turned by yaw about r, then by pitch about axis 2, then by roll about "
                    "axis 1.")
    if any(a.damped is None for a in answers):
        said.append(f"{NO_EQUILIBRIUM}: no equilibrium under damping, because ω turns in the body.")
    return " ".join([*said, "Decimals are rounded."])


def _occurring(lists: Iterable[Iterable[Expr]]) -> list[str]:
    """The integrals in a cell, each list of them once."""
    return list(dict.fromkeys(", ".join(map(unicode, integrals)) for integrals in lists if integrals))


def counted(answers: Sequence[Answer]) -> str:
    """How many equilibria there are, and how many of each verdict."""
    labels = [_label(a) for a in answers]
    verdicts = Counter(a.decision.verdict for a in answers)
    label = f" ({labels[0]})" if len(set(labels)) == 1 else ""
    counts = ", ".join(f"{verdicts[verdict]} {verdict.name.lower()}" for verdict in Verdict
                       if verdicts[verdict])
    return f"{len(answers)} relative equilibria{label}: {counts}."


def _label(answer: Answer) -> str:
    return answer.label if answer.found is None else answer.found.label


def _place(answer: Answer) -> dict[str, str]:
    """Where it lies, and how fast it turns, in cells; of a pole that was named its k3.

    A satellite is placed by roll, pitch and yaw; two of them are empty if pitch is ±90°. A body of revolution
    is placed by the tilt of its axis; the rate of an orbit, which is given, is left out.
    """
    found = answer.found
    if found is None:
        return {"k3": in_a_cell(answer.at)} if answer.at.is_number else {}
    if found.attitude is not None:
        angles = found.attitude.roll, found.attitude.pitch, found.attitude.yaw
        return dict(zip(ANGLES, map(_degrees, angles)))
    if all(isinstance(name, Expr) for name, _ in found.form.described):
        return {str(name): in_a_cell(value) for name, value in found.form.described}
    cells = {name: cell for names, numbers in answer.placed for name, cell in zip(names, in_cells(numbers))}
    return cells | {name: in_a_cell(x) for name, x in found.rates.items() if name != "omega0"}


def _degrees(angle: float | None) -> str:
    """An angle with two decimals."""
    return "" if angle is None else f"{round(angle, 2) + 0.0:.2f}".replace("-", "−")


def _verdict(decision: Decision | None) -> str:
    """The verdict and what it leaves out, in a cell."""
    if decision is None:
        return NO_EQUILIBRIUM
    said = decision.verdict.name.lower()
    if decision.modulo:
        said += f" mod {', '.join(map(unicode, decision.modulo))}"
    if decision.level:
        said += f" at {', '.join(map(unicode, decision.level))}"
    return f"{said} as a set" if decision.locus else said
