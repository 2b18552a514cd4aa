"""What stands in two files of the repository is the same in both."""
import re
from pathlib import Path

import gyrostat as gs
from gyrostat.published import SOURCES, load

ROOT = Path(__file__).parents[1]


def text(name):
    return (ROOT / name).read_text(encoding="utf-8")


def test_the_version_is_one():
    """In the citation, in README and on top of the changelog."""
    for name, line in (("CITATION.cff", r"^version: (\S+)$"), ("README.md", r"^  version = {(\S+)},$"),
                       ("CHANGELOG.md", r"^## \[(\d\S*)\]")):
        assert re.search(line, text(name), re.MULTILINE)[1] == gs.__version__, name


def test_the_changelog_counts_the_statements_of_verify():
    """As they are entered."""
    count = sum(len(load(source).statements) for source in SOURCES)
    assert f"derives {count} statements of seven sources" in text("CHANGELOG.md") and len(SOURCES) == 7
