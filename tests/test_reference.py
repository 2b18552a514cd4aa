"""The reference: every public name has its place in it, and so has nothing else."""
import re
from collections import Counter
from pathlib import Path

import gyrostat as gs

PAGES = Path(__file__).parents[1] / "docs" / "reference" / "api"
NAMESPACES = ("charts", "derivation", "mechanics", "plotting", "published", "questions", "trajectories")
LINE = re.compile(r"^\.\. currentmodule:: (\S+)$|^   (\w+)$|^\.\. py:data:: (\w+)$", flags=re.MULTILINE)


def listed():
    """The full names in the summary tables."""
    for page in PAGES.glob("*.md"):
        for module, name, data in LINE.findall(page.read_text(encoding="utf-8")):
            if module:
                home = module
            else:
                yield f"{home}.{name or data}"


def public():
    """The full names that there are."""
    errors = [name for name, what in vars(gs.errors).items()
              if isinstance(what, type) and issubclass(what, gs.errors.GyrostatError)]
    homes = {"gyrostat": set(gs.__all__) - {"__version__", "errors", *NAMESPACES}, "gyrostat.errors": errors}
    homes |= {f"gyrostat.{name}": getattr(gs, name).__all__ for name in NAMESPACES}
    return {f"{home}.{name}" for home, names in homes.items() for name in names}


def test_every_public_name_is_on_one_page():
    """A name that comes, goes or moves does so in the reference too."""
    found = Counter(listed())
    assert set(found) == public()
    assert set(found.values()) == {1}
