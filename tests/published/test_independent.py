"""What the library derives against Newton and Euler's equations at numbers."""
import ast
from pathlib import Path

import pytest
from sympy import MatrixBase
from written_sources import LONG, STATEMENTS

import gyrostat
from gyrostat.published import independent_names
from gyrostat.published.language import read
from gyrostat.published.readings import Reading

HERE = Path(gyrostat.__file__).parent / "published"
# others like them are derived too
ALIKE = {("N2025", key) for key in ("Euler-2", "Euler-3", "dA", "dA-cause", "dA-rotation", "torque",
                                    "transport")} | {
    ("EA", "4.32-2"), ("EA", "4.32-3"), ("AR", "M-rate-1"), ("AR", "M-rate-2"), ("AR", "m-rate")}


@pytest.mark.parametrize("statement", [
    pytest.param(s, marks=[pytest.mark.slow] * ((s.source, s.key) in LONG | ALIKE), id=f"{s.source}:{s.key}")
    for s in STATEMENTS if s.kind in ("identity", "family") and "rank" not in str(s.quantity)])
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
    for name in ("independent", "independent_kinematics", "independent_separatrix"):
        tree = ast.parse((HERE / f"{name}.py").read_text(encoding="utf-8"))
        ours = {n.module for n in ast.walk(tree) if isinstance(n, ast.ImportFrom) and n.level}
        assert ours <= {"errors", "algebra.exact", "notation", "scenes", "independent", "kinematics"}
