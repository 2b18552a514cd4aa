"""Figures on pages are those that programs wrote: sections, their parts, and the ratios that are guarded."""
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
PRINTED = "2030-01-01, commit abc\n\n| a | 1 |\n\n### In short\n\n| b | 2 |\n"


@pytest.fixture
def pages(monkeypatch, tmp_path):
    """The module, and two pages with sections of two programs."""
    import sections
    made = [tmp_path / "RESULTS.md", tmp_path / "page.md"]
    made[0].write_text("by hand\n<!-- one -->\nold\n<!-- end -->\n<!-- two -->\nkept\n<!-- end -->\n")
    made[1].write_text("said\n<!-- one: In short -->\nold\n<!-- end -->\nafter\n")
    monkeypatch.setattr(sections, "PAGES", made)
    return sections, made


def test_a_program_writes_its_own_sections_only(pages):
    """What is written by hand, and what another program wrote, stays; a part follows the line of the date."""
    sections, (results, page) = pages
    sections.write("one", PRINTED)
    assert results.read_text() == (f"by hand\n<!-- one -->\n{PRINTED.strip()}\n<!-- end -->\n"
                                   "<!-- two -->\nkept\n<!-- end -->\n")
    assert page.read_text() == ("said\n<!-- one: In short -->\n2030-01-01, commit abc\n\n| b | 2 |\n"
                                "<!-- end -->\nafter\n")
    assert sections.stored("one").strip() == PRINTED.strip() and sections.stored("three") == ""


def test_a_part_that_is_not_printed_is_an_error(pages):
    """No page keeps an old part without notice."""
    with pytest.raises(KeyError, match="In short"):
        pages[0].write("one", "2030-01-01\n\n| a | 1 |\n")


def test_the_sections_of_pages_are_those_of_the_results():
    """Each is a program's; a part on a page stands in RESULTS.md or MOTION.md too, with its date."""
    import sections
    known = "".join(page.read_text(encoding="utf-8") for page in sections.PAGES[:2])
    for page in sections.PAGES:
        found = sections.SECTION.findall(page.read_text(encoding="utf-8"))
        assert found, page
        for name, _, text in found:
            assert (ROOT / "benchmarks" / f"{name}.py").exists(), name
            first, rest = text.strip().split("\n", 1)
            assert re.match(r"20\d\d-\d\d-\d\d, .*commit [0-9a-f]{7}", first), (page, name)
            assert first in known and rest.strip() in known, (page, name)


def test_every_benchmark_with_a_section_can_be_run_by_one_command():
    """All but the one that needs a site."""
    import sections
    import write_results
    names = {name for page in sections.PAGES for name, _, _ in sections.SECTION.findall(
        page.read_text(encoding="utf-8"))}
    assert names - {"bench_page"} == {command.split()[0] for command in write_results.COMMANDS}


def guard_of(monkeypatch, row, processor=None):
    """The guard of one row, beside ratios that were stored on a processor, this one by default."""
    import guard
    text = f"2030-01-01, commit abcdef0\n\nProcessor: {processor or guard.measured.processor()}.\n\n"
    monkeypatch.setattr(guard.sections, "stored", lambda name: text)
    monkeypatch.setattr(guard, "rows", lambda: iter([row]))
    return guard


def test_a_speed_that_is_lost_twice_fails(monkeypatch, capsys):
    """Once may be noise; a row that is not stored, or is no longer measured, fails as well."""
    from flagship_rows import Row
    guard = guard_of(monkeypatch, Row("a list", "a script", lambda: None, lambda: None))
    for stored, measured, count in (
            ({("a list", "a script"): 1.0}, [1.29], 0), ({("a list", "a script"): 1.0}, [1.4, 1.2], 0),
            ({("a list", "a script"): 1.0}, [1.4, 1.31], 1), ({}, [], 1),
            ({("a list", "a script"): 1.0, ("gone", "a script"): 1.0}, [1.0], 1)):
        left = iter(measured)
        monkeypatch.setattr(guard, "stored", lambda stored=stored: dict(stored))
        monkeypatch.setattr(guard, "watched", lambda row, left=left: (next(left), 0.6))
        assert guard.compare() == count
        assert list(left) == []
    assert "gone / a script: stored, and not measured" in capsys.readouterr().out


@pytest.mark.parametrize(("noisy", "share", "processor", "why"), [
    ("a picture waits for memory", 1.0, None, "a picture waits for memory"),
    ("", 0.4, None, "this process had 40% of a core"),
    ("", 1.0, "Abacus, family 1, model 2", "are of another processor (Abacus, family 1, model 2)")])
def test_a_loss_that_may_be_noise_is_told_with_its_reason(monkeypatch, capsys, noisy, share, processor, why):
    """On another processor, beside too many processes, or of a row that says why."""
    from flagship_rows import Row
    guard = guard_of(monkeypatch, Row("a list", "a script", str, str, noisy=noisy), processor)
    monkeypatch.setattr(guard, "stored", lambda: {("a list", "a script"): 1.0})
    monkeypatch.setattr(guard, "watched", lambda row: (2.0, share))
    assert guard.compare() == 0
    said = capsys.readouterr().out
    assert "lost twice, which is not counted: " in said and why in said


def test_a_processor_has_a_name_and_numbers(tmp_path):
    """Two models that a virtual machine calls alike are two."""
    import measured
    file = tmp_path / "cpuinfo"
    file.write_text("processor\t: 0\ncpu family\t: 25\nmodel\t\t: 1\nmodel name\t: AMD EPYC\n\n"
                    "processor\t: 1\ncpu family\t: 25\nmodel\t\t: 17\n")
    assert measured.processor(file) == "AMD EPYC, family 25, model 1"
    assert measured.processor(tmp_path / "none")


def test_the_stored_ratios_are_read():
    """Each of the table."""
    import guard
    import sections
    rows = sections.stored("guard").strip().splitlines()[6:]
    assert guard.PROCESSOR.search(sections.stored("guard"))
    assert len(guard.stored()) == len(rows) > 20 and all(ratio > 0 for ratio in guard.stored().values())
