"""The documents of the command line, asked by a scene as a table."""
from collections.abc import Mapping
from dataclasses import fields
from typing import Any

from sympy import Expr

from ..algebra.text.inputs import name_of
from ..arguments import checked
from ..mechanics.families.scene_tables import SceneTable
from ..printing.formats.json_data import document
from .answers.answer_list import answers_data
from .answers.answers import answers_at
from .answers.arcs import arcs_at, arcs_data
from .answers.condition_list import condition_list
from .answers.equilibria import labels_of, some
from .answers.report_list import report_list
from .answers.solve_for import solutions_data, solved
from .answers.wheel_answer import speeds_at, speeds_data
from .given_numbers import numbers_of
from .scene_texts import Asked, asked_value, entries_of

Scene = Mapping[str, Any]


@checked
def report(scene: Scene) -> dict[str, Any]:
    """Derive the equilibria of a scene, as `gyrostat report --format json` does.

    Parameters
    ----------
    scene : mapping
        the keys of a scene file, texts or whole numbers: potential, inertia, equilibrium, values, …

    Returns
    -------
    dict
        the document of schema/report.json; with enough values each equilibrium has a decision

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = {"potential": "m0*k3", "inertia": ["I1", "I1", "I3"],
    ...        "equilibrium": "E1"}
    >>> found = gs.questions.report(top)
    >>> sufficient = found["equilibria"][0]["sufficient"]
    >>> found["integrals"], sufficient["any_of"][0]["all_of"][0]["margin"]
    (['pi3'], '-4*I1*m0 + pi3_0**2')
    """
    asked, label, numbers = _question(scene)
    return document(report_list(asked, label and [label], numbers).data())


@checked
def conditions(scene: Scene, *, solve_for: str | None = None, windows: bool = False) -> dict[str, Any]:
    """Give the conditions of the equilibria of a scene, as `gyrostat conditions --format json` does.

    Parameters
    ----------
    scene : mapping
        the keys of a scene file, texts or whole numbers; values are inserted
    solve_for : str, optional
        a name, for which they are solved
    windows : bool
        whether what decides between the two conditions is added

    Returns
    -------
    dict
        the document of schema/conditions.json, or of schema/solution.json

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = {"potential": "m0*k3", "inertia": ["I1", "I1", "I3"],
    ...        "equilibrium": "E1"}
    >>> top = top | {"values": {"I1": 1, "m0": 1}}
    >>> found = gs.questions.conditions(top, solve_for="pi3_0")
    >>> part = found["equilibria"][0]["parts"][0]
    >>> [(i["low"], i["high"]) for i in part["cases"][0]["intervals"]]
    [('-oo', '-2'), ('2', 'oo')]
    """
    asked, label, numbers = _question(scene, solve_for or "")
    name = solve_for and (name_of(solve_for) or solve_for)
    if name and (speeds := speeds_at(asked, label and [label], name, numbers)):
        return document(speeds_data(speeds))
    labels, others = labels_of(asked, label and [label], numbers)
    some(labels, others)
    if name is not None:
        return document(solutions_data(*solved(asked, labels, name, numbers)))
    return document(condition_list(asked, labels, others, numbers, windows).data())


@checked
def decide(scene: Scene) -> dict[str, Any]:
    """Decide at the values of a scene whether its equilibria are stable, as `gyrostat decide` does.

    Parameters
    ----------
    scene : mapping
        the keys of a scene file, texts or whole numbers; without an equilibrium all are found

    Returns
    -------
    dict
        the document of schema/decide.json

    Examples
    --------
    >>> import gyrostat as gs
    >>> values = {"I1": 1, "I3": "8/5", "l": 0, "m0": 1, "omega": 2}
    >>> top = {"potential": "m0*k3", "inertia": ["I1", "I1", "I3"],
    ...        "gyrostatic_momentum": [0, 0, "l"]}
    >>> found = gs.questions.decide(top | {"values": values})
    >>> [(e["label"], e["decision"]["verdict"]) for e in found["equilibria"]]
    [('E1', 'STABLE'), ('E3', 'STABLE'), ('E2', 'STABLE')]
    """
    asked, label, numbers = _question(scene)
    if arcs := arcs_at(asked, label, numbers):
        return document(arcs_data(arcs))
    return document(answers_data(answers_at(asked, label, numbers)))


def _question(scene: Scene, *names: str) -> tuple[Asked, str | None, dict[str, Expr]]:
    """The scene of a table, the equilibrium that it names, and its values."""
    read = SceneTable(scene)
    _ = read.system                                        # what is wrong in it is said of the table
    table = entries_of(read)
    texts: dict[str, Any] = {name: asked_value(name, table[name])
                             for name in (entry.name for entry in fields(Asked)) if name in table}
    numbers = numbers_of([f"{name}={value}" for name, value in table.get("values", {}).items()])
    return Asked(**texts).of_body({*numbers, *names}), table.get("equilibrium"), numbers
