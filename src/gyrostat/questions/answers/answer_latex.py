"""The answers of decide as a table in LaTeX: place, frequencies, doubling time and the two verdicts."""
from collections.abc import Sequence
from decimal import ROUND_HALF_EVEN, Decimal

from ..._lazy import loaded
from ...printing.formats.latex_names import Paper
from ...printing.formats.latex_rows import longtable
from ...printing.formats.text_tables import Column
from ...printing.numbers import BESIDE, with_digits
from .answer_list import note_once
from .answer_table import counted, legend, notes_of, place_columns, verdict_columns
from .answers import Answer
from .equilibria import Missing

MOST = 3                                               # frequencies
FREQUENCIES = "f: frequencies of the small motions"
DOUBLING = "T: time in which a small deviation doubles."


def answer_latex(answers: Sequence[Answer | Missing], paper: Paper, with_units: bool,
                 wells: bool = False) -> str:
    """Return a document, or a fragment, with the table; what is not answered is said below it.

    wells says below the row of each stable equilibrium how far it is stable.
    """
    note, bare = note_once(answers)
    found = [a for a in bare if isinstance(a, Answer)]
    missing = [f"{m.label}: {m.why}." for m in bare if isinstance(m, Missing)]
    rates = _rate_columns(found, with_units)
    said = [legend(found)] if found else []
    if rates:
        orbital = found[0].found is not None and found[0].found.attitude is not None
        said += [f"{FREQUENCIES}, {'per orbit' if orbital else 'in rad per unit of time'}. {DOUBLING}"]
    columns = [*place_columns(found, with_units), *rates, *verdict_columns(found)] if found else []
    below = [". ".join(filter(None, (note, " ".join(_of_well(a, wells, with_units)))))
             for a, note in zip(found, notes_of(found))]
    return longtable(counted(found) if found else "", columns, below,
                     [*said, *missing, *([note] if note else [])], paper)


def _of_well(answer: Answer, asked: bool, with_units: bool) -> list[str]:
    """The sentences about the well of a stable equilibrium, if they are asked for."""
    said: list[str] = loaded("printing.results.well:well_sentences")(answer.well, with_units) if (
        asked and answer.decision.stable) else []
    return said


def _rate_columns(answers: Sequence[Answer], with_units: bool) -> list[Column]:
    """The frequencies, of a satellite per orbit, and the doubling time; none if all vary or are not known."""
    numbers = [None if a.at_point is None else a.at_point.doubles for a in answers]
    rows = [() if x is None else x.frequencies_per_orbit or x.frequencies for x in numbers]
    times = [None if x is None else x.doubling_time for x in numbers]
    in_orbit = any(x is not None and x.frequencies_per_orbit is not None for x in numbers)
    unit = "rad/s" if with_units and not in_orbit else ""
    columns = [Column(f"f{'₁₂₃'[n]}", [_four(row[n]) if n < len(row) else "" for row in rows], unit, True)
               for n in range(min(MOST, max(map(len, rows), default=0)))]
    if any(time is not None for time in times):
        columns.append(Column("T", ["" if time is None else _four(time) for time in times],
                              "s" if with_units else "", number=True))
    return columns


def _four(number: float) -> str:
    """Four digits of a double."""
    return with_digits(Decimal(repr(number)), BESIDE, ROUND_HALF_EVEN).text
