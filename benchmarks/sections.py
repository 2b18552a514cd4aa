"""Sections of pages that programs write: what stands between `<!-- NAME -->` and `<!-- end -->`.

What a benchmark prints is its section. If it prints parts, each below a heading of the third level, a page
can have one of them alone, below the first line: `<!-- NAME: HEADING -->`.
"""
import re

from measured import ROOT

PAGES = [ROOT / name for name in ("benchmarks/RESULTS.md", "benchmarks/MOTION.md", "docs/benchmarks.md",
                                  "docs/explanation/growth.md")]
SECTION = re.compile(r"<!-- (\w+)(?:: (.+?))? -->\n(.*?)<!-- end -->", re.DOTALL)


def parts(printed: str) -> dict[str, str]:
    """What stands below each heading, after the line of date and commit; all of it below ""."""
    first = printed.partition("\n")[0]
    heads = re.split(r"^### (.+)\n", printed, flags=re.MULTILINE)
    return {"": printed} | {head: f"{first}\n{text}" for head, text in zip(heads[1::2], heads[2::2])}


def stored(name: str) -> str:
    """What a benchmark has written into RESULTS.md; "" if nothing."""
    sections = SECTION.findall(PAGES[0].read_text(encoding="utf-8"))
    return "".join(text for script, part, text in sections if script == name and not part)


def write(name: str, printed: str) -> None:
    """Put what a benchmark has printed into its sections of all pages."""
    found = parts(printed)

    def filled(section: re.Match[str]) -> str:
        script, part, _ = section.groups("")
        if script != name:
            return section[0]
        head = section[0].partition("\n")[0]
        return f"{head}\n{found[part].strip()}\n<!-- end -->"

    for page in PAGES:
        text = page.read_text(encoding="utf-8")
        new = SECTION.sub(filled, text)
        if new != text:
            page.write_text(new, encoding="utf-8")
