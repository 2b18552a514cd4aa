"""Writes a scene and its equilibrium to take away: as LaTeX, as Python, as a scene file."""
import json
import re
from collections.abc import Mapping, Sequence
from typing import Any

from sympy import ImmutableMatrix, S
from sympy.printing.str import StrPrinter

from ...algebra.text.grammar import parse
from ...mechanics.equilibrium.unit_vectors import STEREOGRAPHIC
from ...mechanics.families.circular_orbit import orbital_rate
from ...mechanics.families.family import Family
from ...mechanics.families.scene_tables import NONE
from ...mechanics.scenes.system import System
from ...printing.blocks import Block
from ...printing.formats.article import article
from ...printing.formats.latex_names import Paper
from ...printing.nomenclature import occurring, symbol_rows

_PRINTER = StrPrinter({"sympy_integers": True})        # 1/3 is S(1)/3


def latex(scene: System, blocks: Sequence[Block]) -> str:
    """Conditions, or equilibria, as they stand in a paper, and what their symbols are."""
    return article("", [*blocks, symbol_rows(scene, occurring(blocks))], Paper(fragment=True))


def scene_file(table: Mapping[str, Any], values: Mapping[str, str], every: str) -> str:
    """The table of a scene, as `--scene` and `verify` read it.

    If all equilibria on a level are asked for, it says so: it names none, and `decide` finds all that its
    numbers allow.
    """
    level = ", ".join(f"{name} = {' '.join(values[name].split())}"           # on one line
                      for name in every.split()[1:] if name in values)
    said = f"# every equilibrium{f' at {level}' if level else ''}: gyrostat decide --scene FILE"
    asked = [said] if every else []
    lines = [f"{name} = {_toml(value)}" for name, value in {**table, "values": values}.items()]
    return "\n".join([*asked, "[scene.mine]", *lines, ""])


def _toml(value: Any) -> str:
    """A text, a list or a table as TOML has it."""
    if not isinstance(value, Mapping):
        return _quoted(value)
    return f"{{ {', '.join(f'{name} = {_quoted(text)}' for name, text in value.items())} }}"


def program(scene: System, family: Family | None, table: Mapping[str, Any], values: Mapping[str, str]) -> str:
    """A program that prints the conditions, and the verdict at the values; or all equilibria there."""
    body, potential = scene.body, scene.potential
    tensor = body.inertia.tolist() if isinstance(body.inertia, ImmutableMatrix) else list(body.moments)
    parts = [f"gs.Gyrostat({_code(tensor)}, "
             f"{_code(list(body.gyrostatic_momentum))})"]
    names = set(body.symbols)
    if "orbit" in table:
        beside = parse(table["potential"]) if table.get("potential", NONE).strip() != NONE else S.Zero
        rate = orbital_rate(scene)
        names |= beside.free_symbols | rate.free_symbols
        orbit = [f"rate={_code(rate)}", *([f"potential={_code(beside)}"] if beside else [])]
        parts.append(f"gs.circular_orbit({', '.join(orbit)})")
    elif potential is not None:
        names |= potential.expression.free_symbols if potential.given else set()
        made = "axial_potential" if potential.axial else "general_potential"
        parts.append(f"gs.{made}({_code(potential.expression) if potential.given else ''})")
    made = _maker(family, table)
    for name in ("point", "direction"):
        if f"{name}=[" in made or name == "point":
            names |= set().union(*(parse(text).free_symbols for text in table.get(name, ())))
    known = sorted(map(str, names))
    called = re.sub(r"\"[^\"]*\"|\w+=", "", " ".join([*parts, made]))
    words = set(re.findall(r"(?<![\w.])[A-Za-z_]\w*", called)) - {"gs", "scene", *known}
    lines = [f"from sympy import {', '.join(sorted(words))}", ""] if words else []
    lines += ["import gyrostat as gs", ""]
    if known:
        lines += [f"{', '.join(known)}{'' if known[1:] else ','} = map(gs.symbol, {_quoted(known)})"]
    return "\n".join([*lines, f"scene = gs.assemble({', '.join(parts)})",
                      *_asked(made, _quoted(values)), ""])


def _asked(made: str, values: str) -> list[str]:
    """The lines that print one equilibrium, or all."""
    if not made:
        return [f"for found in gs.relative_equilibria(scene, {values}):",
                "    print(found)"]
    return [f"report = gs.analyze({made})", "print(report.necessary)", "print(report.sufficient)",
            f"print(report.verdict({values}).verdict.name)"]


def _maker(family: Family | None, table: Mapping[str, Any]) -> str:
    """The call that makes the equilibrium; "" if all are asked for."""
    if family is None:
        return f"gs.equilibrium(scene, {_parsed(table['point'])})" if "point" in table else ""
    if family.made_with == "pointing":
        return f"gs.earth_pointing({', '.join(['scene', *map(str, table.get('pointing', []))])})"
    given = [f"{name}={_quoted(table[name])}" for name in (family.made_with,) if name in table]
    if family.made_with == "direction" and given:
        texts = table["direction"]
        given = [f"direction={'gs.stereographic()' if texts == [STEREOGRAPHIC] else _parsed(texts)}"]
    made: Any = family.make                            # its maker, called by name
    given += [f"{name}={_quoted(value)}" for name, value in made.keywords.items()]
    return f"gs.{made.args[1]}({', '.join(['scene', *given])})"


def _parsed(texts: Sequence[str]) -> str:
    """Expressions that are given as texts."""
    return _code(list(map(parse, texts)))


def _code(value: Any) -> str:
    """Expressions in Python."""
    if isinstance(value, list):
        return f"[{', '.join(map(_code, value))}]"
    return str(value) if value.is_Integer else _PRINTER.doprint(value)


def _quoted(value: Any) -> str:
    """Texts as Python, JSON and TOML read them."""
    return json.dumps(value, ensure_ascii=False)
