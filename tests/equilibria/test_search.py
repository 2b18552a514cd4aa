"""The one verb for every kind of scene: each kind has a finder, each form says all that is asked."""
import pytest
from scene_kinds import CASES

import gyrostat as gs
from gyrostat.equilibria.finders.free_form import FreeForm
from gyrostat.equilibria.finders.heavy_form import HeavyForm
from gyrostat.equilibria.finders.orbital_form import OrbitalForm
from gyrostat.equilibria.finders.revolution_form import RevolutionForm
from gyrostat.equilibria.search import FINDERS
from gyrostat.mechanics.scenes.kind import Kind
from gyrostat.stability.form import Form

ASKED = ("described", "point", "rates", "reached", "invariants")


@pytest.mark.parametrize("kind", Kind)
def test_each_kind_has_a_finder_or_is_refused(kind):
    """A new kind without a row would end in a KeyError."""
    cases = [case for case in CASES.values() if case.equilibrium.system.kind is kind]
    assert cases, "scene_kinds has no case of it"
    if kind not in FINDERS:
        with pytest.raises(gs.errors.ScopeError, match="relative_equilibria"):
            gs.relative_equilibria(cases[0].equilibrium.system, {})
    else:
        assert any(case.level is not None for case in cases), "no case of it is found in a list"


FORMS = [FreeForm, HeavyForm, OrbitalForm, RevolutionForm]


def test_no_form_is_forgotten():
    """A finder is loaded when a scene of its kind comes: all are known here."""
    assert set(Form.__subclasses__()) <= set(FORMS)


@pytest.mark.parametrize("form", FORMS)
def test_each_form_says_all_that_is_asked(form):
    """Its place, its numbers and the words of its reasons; LEAVES where two pairs of eigenvalues can meet."""
    for name in ASKED:
        assert getattr(form, name) is not getattr(Form, name), (form, name)
    known = form.known is not Form.known and form.__name__ == "RevolutionForm"      # by a report
    assert known or {form.LEAST.verdict.name, form.ODD.verdict.name} == {"STABLE", "UNSTABLE"}
    assert known or form.greatest or form.LEAVES.unstable
