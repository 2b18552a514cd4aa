"""Links between README, contributing and docs, and the files that they name; how extras are installed."""
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted(ROOT.glob("docs/**/*.md"))]
PAGES = [page for page in PAGES if page.parent.name != "measured"]         # copies, made by the site
SRC = ROOT / "src" / "gyrostat"
PACKAGES = {path.parent.name for path in SRC.glob("*/__init__.py")}
NAMED = re.compile(r"(?<![\w/.:-])((?:src|tests|docs|benchmarks|\.ci)/[\w./<>-]*\w)")
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


def test_the_library_is_set_up_by_one_command():
    """Home page and install page have that of README."""
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    command, = re.findall(r"^python3 -m venv .* report$", readme, re.MULTILINE)
    for page in ("index.md", "install.md"):
        assert f"\n{command}\n" in (ROOT / "docs" / page).read_text(encoding="utf-8"), page


def is_place(name):
    """Whether it is a folder of the library, or a module in one."""
    return (SRC / name).exists() or (SRC / f"{name}.py").exists()


@pytest.mark.parametrize("page", [*PAGES, ROOT / "CHANGELOG.md", ROOT / "benchmarks" / "RESULTS.md"],
                         ids=lambda page: str(page.relative_to(ROOT)))
def test_files_that_are_named_exist(page):
    """From the root of the repository, or a `package/module` of ours; but for names with a placeholder."""
    text = page.read_text(encoding="utf-8")
    assert [name for name in NAMED.findall(text) if not (ROOT / name).exists()
            and not re.search("<|NAME", name)] == []
    ours = [name for name in re.findall(r"`(\w+(?:/\w+)+)`", text) if name.split("/")[0] in PACKAGES]
    assert [name for name in ours if not is_place(name)] == []


@pytest.mark.parametrize("package", sorted(PACKAGES))
def test_pages_that_docstrings_name_exist(package):
    """Each with its sections, which are numbered."""
    for path in SRC.joinpath(package).rglob("*.py"):
        text = re.sub(r"\s+", " ", path.read_text(encoding="utf-8"))
        for name, sections in re.findall(r"(docs/[\w/-]+\.md)(?:, sections? ([\d, and]*\d))?", text):
            page = (ROOT / name).read_text(encoding="utf-8")
            for number in re.findall(r"\d+", sections):
                assert f"\n## {number}. " in page, (path.name, name, number)


def design(start, end):
    """A part of the page on design."""
    text = (ROOT / "docs" / "explanation" / "design.md").read_text(encoding="utf-8")
    return text.split(start)[1].split(end)[0]


def test_the_house_of_design_is_the_one_that_stands():
    """It has a line for each package and for each module beside them."""
    lines = re.findall(r"^ (\S+(?: · \S+)*)", design("```\n", "```"), re.MULTILINE)
    alone = {path.stem for path in SRC.glob("*.py")} - {"__init__", "__main__"}
    assert sorted(name for line in lines for name in line.split(" · ")) == sorted(PACKAGES | alone)


def test_the_flows_of_design_go_through_modules_that_exist():
    """A name without a path stands in the folder that is named before it."""
    folder = None
    for name in re.findall(r"`(\w+(?:/\w+)*)`", design("## Four flows", "\n## ")):
        place = name if "/" in name else f"{folder}/{name}"
        assert is_place(place), place
        folder = place if (SRC / place).is_dir() else place.rpartition("/")[0]
