"""Links between README, contributing and docs; how extras are installed."""
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted(ROOT.glob("docs/**/*.md"))]
PAGES = [page for page in PAGES if page.parent.name != "measured"]         # copies, made by the site
LINK = re.compile(r'(?:\]\(|(?:src|href)=")([^)"\s]+)')


def prose(page):
    """The text without code, in which a link is none."""
    return re.sub(r"```.*?```|`[^`\n]*`", "", page.read_text(encoding="utf-8"), flags=re.DOTALL)


def anchors(page):
    """What the headings of a page are called in an address."""
    titles = re.findall(r"^#+ +(.*)$", prose(page), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-") for title in titles}


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_links_lead_somewhere(page):
    """To a file or folder of the repository, and to a heading where one is named; README's only there."""
    targets = LINK.findall(prose(page))
    foreign = [target for target in targets if target.startswith("http")]
    assert page.name != "README.md" or targets and not foreign
    for target in set(targets) - set(foreign):
        path, _, anchor = target.partition("#")
        goal = (page.parent / path).resolve() if path else page
        if goal.suffix == ".ipynb":                            # the site has copies beside its pages
            goal = ROOT / "notebooks" / goal.name
        assert goal.exists() and goal.is_relative_to(ROOT), target
        if anchor:
            assert anchor in anchors(goal), target


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_extras_are_installed_in_one_way(page):
    """By the name of the library, which is installed before: so it holds in every folder."""
    text = page.read_text(encoding="utf-8")
    installs = re.findall(r'pip install (?!.*--editable).*?(".*?\[.*?\]"|\S*\[\S*\])', text)
    assert all(install.startswith('"gyrostat[') for install in installs), installs
