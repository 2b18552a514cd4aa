"""What the library derives against Newton and Euler's equations at numbers."""
import ast
import re
from pathlib import Path

import pytest
from published.written_sources import LONG, STATEMENTS
from sympy import MatrixBase

import gyrostat
from gyrostat.published.checks.readings import Reading
from gyrostat.published.independent import names_at_numbers as independent_names
from gyrostat.published.language import read

DERIVED = [s for s in STATEMENTS if s.kind in ("identity", "family") and "rank" not in str(s.quantity)]


def names(statement):
    return set(re.findall(r"[A-Za-z]\w*", str(statement.quantity)))


def with_new_names():
    """Of the shorter statements those in which a name of the language occurs for the first time."""
    seen = set()
    for s in DERIVED:
        if (s.source, s.key) not in LONG and not names(s) <= seen:
            seen |= names(s)
            yield s.source, s.key


FIRST = set(with_new_names())


@pytest.mark.few(3)
@pytest.mark.parametrize("statement", [
    pytest.param(s, marks=[pytest.mark.slow] * ((s.source, s.key) not in FIRST), id=f"{s.source}:{s.key}")
    for s in DERIVED])
def test_derived_quantities_are_those_of_newton_and_euler(statement):
    """Every quantity the library derives from the bracket, at numbers, by cross products and turns."""
    r = Reading(statement)
    derived = r.finish(read(statement.quantity, r.own))
    entries = list(derived) if isinstance(derived, MatrixBase) else [derived]
    printed = r.finish(read(statement.printed, r.own))
    values = next(v for v in r.points([*entries,
                                       *(printed if isinstance(printed, MatrixBase) else [printed])])
                  if all(e.subs(v).evalf(20).is_Number for e in entries))
    theirs = r.independently(statement.quantity, values)
    for ours, other in zip(entries, theirs if isinstance(theirs, MatrixBase) else [theirs]):
        value = independent_names.number(other, statement.scene, values)
        assert abs((ours.subs(values) - value).evalf(25)) < 1e-15 * (1 + abs(value.evalf(25)))


def test_independent_confirmation_uses_no_derivation():
    """Neither the bracket nor the linearisation nor the criteria stand behind a counterexample."""
    for path in (Path(gyrostat.__file__).parent / "published" / "independent").glob("*.py"):
        if path.stem != "names_at_numbers":                # it has both derivations, name by name
            used = [n for n in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
                    if isinstance(n, ast.ImportFrom) and n.level]
            assert "names_at_numbers" not in {n.module for n in used if n.level == 1}, path
            assert {n.module for n in used if n.level > 1} <= {
                "_cached", "errors", "notation", "scenes", "names.kinematics", "algebra.reals.exact",
                "algebra.enclosures.precision", "algebra.text.grammar", "algebra.text.quantities",
                "mechanics.families.orbit_rates"}, path    # of which it has the constants of planets
