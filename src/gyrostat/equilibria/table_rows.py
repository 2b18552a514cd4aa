"""Makes a table of relative equilibria: a row for each, with the same columns for every kind of scene."""
from collections.abc import Iterable, Sequence
from typing import Any

from .._lazy import loaded
from ..arguments import checked
from ..stability.decision import Decision
from .relative_equilibrium import RelativeEquilibrium

Row = dict[str, Any]


@checked
def table(found: Sequence[RelativeEquilibrium], wells: bool = False) -> list[dict[str, Any]]:
    """Return relative equilibria as rows with the same keys, which pandas.DataFrame takes as they are.

    The columns, of which a kind of scene has those that make sense for it:

    - number: that of the equilibrium in the list, in pictures and in the table of gyrostat decide
    - label; verdict and damped (without and with internal damping), by the names of Verdict
    - roll_deg, pitch_deg, yaw_deg, q_w, …, q_z, t1, …, r3, attitude_note: the numbers of an Attitude
    - k1, …, pi3, …, n1, …: the place, by the names of RelativeEquilibrium.place
    - omega, sigma, omega0: the rates [1/T]
    - frequency_1, …: of the small motions [1/T]; frequency_1_per_orbit, …: over omega0
    - growth_rate [1/T] and doubling_time [T]
    - growing_modes under internal damping
    - locus: the set of equilibria to which it belongs, in words
    - notion and scope: which stability is meant, and what is divided out; reason and damped_reason; note:
      what is unusual about the body

    and of wells, if they are asked for,

    - barrier and escape [M L²/T²], infinite without a pass; barrier_at_least, if only a bound is known
    - pass_kind; passes, how many there are; pass_k1, …: the place of the first one
    - kick, in whatever direction, of a body in a field across k [M L²/T]; any_kick, which keeps k over the
      well of the frame that turns with it; tilt_deg of a satellite
    - well_damped: whether damped motions come back; well_reason: why there is no barrier

    Parameters
    ----------
    found : sequence of RelativeEquilibrium
        of relative_equilibria
    wells : bool
        whether there are columns of the wells

    Returns
    -------
    list of dict
        numbers are the doubles next to the exact ones; None stands for what there is not: the damped verdict
        of a precession, the growth rate of a stable motion, a place that takes every value

    Raises
    ------
    ArgumentError
        it is no list of relative equilibria

    Examples
    --------
    >>> import gyrostat as gs
    >>> body = gs.Gyrostat((60, 70, 35), (12, 5, 0))
    >>> scene = gs.assemble(body, gs.circular_orbit(1))
    >>> rows = gs.table(gs.relative_equilibria(scene, {}))
    >>> len(rows), sorted({row["verdict"] for row in rows})
    (20, ['STABLE', 'UNSTABLE'])
    >>> for name in ("number", "roll_deg", "yaw_deg", "frequency_1_per_orbit"):
    ...     print(name, rows[-2][name])
    number 19
    roll_deg 0.0
    yaw_deg 44.76110019146366
    frequency_1_per_orbit 0.5450428616011218
    """
    return aligned(row(e, e.label, e.decision, e.damped) | (of_well(e.well) if wells else {}) for e in found)


def row(found: RelativeEquilibrium | None, label: str, decision: Decision, damped: Decision | None) -> Row:
    """Return one row without its number; of an equilibrium that was not found in a list only its verdicts."""
    cells: Row = {"label": label, "verdict": decision.verdict.name,
                  "damped": None if damped is None else damped.verdict.name}
    if found is not None:
        cells |= _numbers(found) | {"locus": found.locus}
    return cells | {"growing_modes": None if damped is None else damped.growing,
                    "notion": decision.notion.value, "scope": decision.scope, "reason": decision.reason,
                    "damped_reason": None if damped is None else damped.reason, "note": decision.note}


def of_well(well: Any) -> Row:
    """Return the columns of a well; of none, given by the reason, that alone."""
    if isinstance(well, str):
        return {"well_reason": well}
    cells: Row = loaded("equilibria.well_columns:well_columns")(well)
    return cells


def _numbers(found: RelativeEquilibrium) -> Row:
    """Attitude, place, rates and frequencies; the latter vary where the place takes every value."""
    numbers, attitude = found.doubles, found.attitude
    cells = {} if attitude is None else attitude.columns
    cells |= numbers.place | numbers.rates
    if None in numbers.place.values():
        return cells | {"growth_rate": None, "doubling_time": None}
    cells |= {f"frequency_{n}": x for n, x in enumerate(numbers.frequencies, 1)}
    cells |= {f"frequency_{n}_per_orbit": x for n, x in enumerate(numbers.frequencies_per_orbit or (), 1)}
    return cells | {"growth_rate": numbers.growth_rate, "doubling_time": numbers.doubling_time}


def aligned(rows: Iterable[Row]) -> list[Row]:
    """Number the rows and give them the same keys; what comes in a group stands together."""
    given = list(rows)
    names: list[str] = []
    for cells in given:
        place = 0
        for name in cells:
            if name not in names:
                names.insert(place, name)
            place = names.index(name) + 1
    return [{"number": n} | {name: cells.get(name) for name in names} for n, cells in enumerate(given, 1)]
