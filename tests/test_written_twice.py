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


def test_the_speeds_on_the_page_of_benchmarks_are_the_measured_ones():
    """How many times as fast as eigvals certified arrays on a grid are; three digits of it are recorded."""
    page, recorded = text("docs/benchmarks.md").lower(), text("benchmarks/RESULTS.md")
    for backend in ("numba", "numpy"):
        shown, = re.findall(rf"^\| certified arrays, {backend} \| (\d+) \| (\d+) \|$", page, re.MULTILINE)
        times = re.findall(rf"^\| \S+(?:, E2)? \| certified arrays, {backend} \|.*? / (\d\.\d+e\+\d+) \|",
                           recorded, re.MULTILINE)
        assert len(times) == 2
        assert all(abs(int(here) / float(there) - 1) < 0.005 for here, there in zip(shown, times))
