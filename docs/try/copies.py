"""A scene and its equilibrium to take away: as LaTeX, as Python, as a scene file."""
import json
import re
from collections.abc import Mapping
from typing import Any

from sympy import ImmutableMatrix
from sympy.printing.str import StrPrinter

from gyrostat.mechanics.family import Family
from gyrostat.mechanics.system import System
from gyrostat.printing.article import article
from gyrostat.printing.document import conditions_blocks
from gyrostat.printing.names import Paper
from gyrostat.stability.report import Report

_PRINTER = StrPrinter({"sympy_integers": True})        # 1/3 is S(1)/3


def latex(report: Report) -> str:
    """The conditions as they stand in a paper."""
    return article("", conditions_blocks(report), Paper(fragment=True))


def scene_file(table: Mapping[str, Any], values: Mapping[str, str]) -> str:
    """The table of a scene, as `--scene` and `verify` read it."""
    lines = [f"{name} = {_quoted(value)}" for name, value in table.items()]
    pairs = ", ".join(f"{name} = {_quoted(text)}" for name, text in values.items())
    return "\n".join(["[scene.mine]", *lines, f"values = {{ {pairs} }}", ""])


def program(scene: System, family: Family, table: Mapping[str, Any], values: Mapping[str, str]) -> str:
    """A program that prints the conditions, and the verdict at the values."""
    body, potential = scene.body, scene.potential
    tensor = isinstance(body.inertia, ImmutableMatrix)
    parts = [f"gs.Gyrostat({_code(body.inertia.tolist() if tensor else list(body.moments))}, "
             f"{_code(list(body.gyrostatic_momentum))})"]
    names = set(body.symbols)
    if potential is not None:
        names |= potential.expression.free_symbols if potential.given else set()
        made = "axial_potential" if potential.axial else "general_potential"
        parts.append(f"gs.{made}({_code(potential.expression) if potential.given else ''})")
    known = sorted(map(str, names))
    words = set(re.findall(r"(?<![\w.])[A-Za-z_]\w*", " ".join(parts))) - {"gs", *known}
    lines = [f"from sympy import {', '.join(sorted(words))}", ""] if words else []
    lines += ["import gyrostat as gs", ""]
    if known:
        lines += [f"{', '.join(known)}{'' if known[1:] else ','} = map(gs.symbol, {_quoted(known)})"]
    return "\n".join([*lines, f"scene = gs.assemble({', '.join(parts)})",
                      f"report = gs.analyze({_maker(family, table)})",
                      "print(report.necessary)", "print(report.sufficient)",
                      f"print(report.verdict({_quoted(values)}).verdict.name)", ""])


def _maker(family: Family, table: Mapping[str, Any]) -> str:
    """The call that makes the equilibrium."""
    given = [f"{name}={_quoted(table[name])}" for name in (family.made_with,) if name in table]
    given += [f"{name}={value}" for name, value in family.make.keywords.items()]
    return f"gs.{family.make.args[1]}({', '.join(['scene', *given])})"


def _code(value: Any) -> str:
    """Expressions in Python."""
    if isinstance(value, list):
        return f"[{', '.join(map(_code, value))}]"
    return str(value) if value.is_Integer else _PRINTER.doprint(value)


def _quoted(value: Any) -> str:
    """Texts as Python, JSON and TOML read them."""
    return json.dumps(value, ensure_ascii=False)
