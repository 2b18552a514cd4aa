"""Whatever says that it shows itself does: as text and in LaTeX there is a writer for it."""
import importlib
import pkgutil

import pytest

import gyrostat
from gyrostat._display import Shown
from gyrostat.printing.formats.latex import _formula
from gyrostat.printing.formats.text import plain
from gyrostat.printing.results.beyond_reports import LATER, RESULTS


def kinds(parent):
    """All classes below one."""
    for each in parent.__subclasses__():
        yield each
        yield from kinds(each)


@pytest.mark.slow
def test_every_class_that_is_shown_has_its_writers():
    """Print and Jupyter fail for none of them; all modules are imported to know all."""
    for module in pkgutil.walk_packages(gyrostat.__path__, "gyrostat."):
        if "__main__" not in module.name:
            importlib.import_module(module.name)
    found = [each for each in kinds(Shown) if not each.__subclasses__()]
    assert len(found) > 20
    for each in found:
        for writer in (plain, _formula):
            known = issubclass(each, RESULTS) or each.__module__ in LATER
            assert writer.dispatch(each) is not writer.dispatch(object) or known, each
