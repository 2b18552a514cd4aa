"""The licences of what the page ships: a table of its parts, and beside it the text of each licence."""
import re
import tomllib
from collections.abc import Mapping
from html import escape
from pathlib import Path
from typing import Any

HERE = Path(__file__).parent / "licences"
Sources = Mapping[str, Mapping[str, Any]]


def parts() -> list[dict[str, Any]]:
    """What the page ships, as parts.toml has it."""
    found: list[dict[str, Any]] = tomllib.loads((HERE / "parts.toml").read_text(encoding="utf-8"))["part"]
    return found


def shipped(stage: Path, sources: Sources, target: Path) -> None:
    """Write the texts and the table into a folder of the page."""
    target.mkdir()
    for part in parts():
        for name, place in part["texts"].items():
            stored = HERE / place
            text = stored if stored.is_file() else next(stage.glob(place))
            (target / name).write_bytes(text.read_bytes())
    page = (HERE / "index.html").read_text(encoding="utf-8")
    rows = "\n".join(_row(part, sources) for part in parts())
    (target / "index.html").write_text(page.replace("{rows}", rows), encoding="utf-8")


def version(part: Mapping[str, Any], sources: Sources) -> str:
    """That of a part, or of the source that brings it, pyodide@314.0.7 or sympy==1.14.0."""
    source = sources.get(part.get("of", ""), {})
    named: str = part.get("version") or source.get("npm", source.get("pip", ""))
    return re.split("==|@", named)[-1]


def _row(part: Mapping[str, Any], sources: Sources) -> str:
    address = re.sub(r"https://[^\s,]+", lambda link: _link(link[0]), escape(part["source"]))
    cells = (escape(f"{part['name']} {version(part, sources)}"),
             f"{escape(part['licence'])}: {', '.join(map(_link, part['texts']))}", address,
             escape(part.get("changed", "nothing")))
    return f"<tr>{''.join(f'<td>{cell}</td>' for cell in cells)}</tr>"


def _link(address: str) -> str:
    return f'<a href="{address}">{address}</a>'
