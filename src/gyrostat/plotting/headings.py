"""Writes the title of a picture: U and the numbers, typeset, in lines that fit its axes."""
from collections.abc import Mapping, Sequence
from typing import Any

from sympy import Float

from ..algebra.text.numbers import exact_number
from ..errors import optional
from ..mechanics.families.circular_orbit import CircularOrbit
from ..mechanics.families.named_entries import named_entries
from ..mechanics.scenes.potential import Potential
from ..mechanics.scenes.system import System
from ..notation import order, symbol
from ..printing.formats.latex import tex
from ..printing.formats.latex_names import Names
from ..printing.formats.linebreaks import broken, width
from ..printing.letters import letters_in
from ..trajectories import Motion
from ..typesetting import typeset

# points of a line at 10 pt, as wide as a page and at least; lines of U
ROOM, NARROWEST, LINES = 400.0, 150.0, 3


def number(value: Any, exact: str = "") -> str:
    r"""A number as Matplotlib sets it: the exact text, or its own, where that is short, else four digits.

    Examples
    --------
    >>> number(0.333, "1/3"), number(0.123456789), number(2.5e-12)
    ('1/3', '0.1235', '2.5 \\times 10^{-12}')
    """
    exact = exact or str(value)
    if len(exact) <= 8 and set(exact) <= set("0123456789./-"):
        return exact
    try:
        near = f"{float(value):.4g}"
    except OverflowError:                                  # beyond doubles
        near = str(Float(value, 4))
    mantissa, _, power = near.partition("e")
    if not power:
        return mantissa
    shown = f"10^{{{int(power)}}}"
    return {"1": shown, "-1": f"-{shown}"}.get(mantissa, rf"{mantissa} \times {shown}")


def components_in(vector: Sequence[str]) -> str:
    """Return the components of a vector as a formula, in which no minus after a comma is a binary one.

    Examples
    --------
    >>> components_in(["1", "-1/2", "0"])
    '$(1, {-1/2}, 0)$'
    """
    return f"$({', '.join(f'{{{x}}}' if x.startswith('-') else x for x in vector)})$"


def numbers(values: Mapping[str, Any]) -> list[str]:
    """Return name = number for each value, in the order of the notation."""
    return [f"${typeset(name)} = {number(values[name])}$" for name in sorted(values, key=order)]


def field(latex: str, letter: str = "U") -> list[str]:
    """Return U = …, or nothing if Matplotlib cannot set the formula."""
    text = rf"${letter} = {latex}$".replace(r"\dfrac", r"\frac")
    try:
        optional("matplotlib.mathtext", "plot").MathTextParser("path").parse(text)
    except ValueError:
        return []
    return [text]


def of_scene(scene: System, values: Mapping[str, Any]) -> tuple[list[str], list[str]]:
    """Return U, or that the body is in orbit, and the numbers of the body and the values."""
    entries = named_entries(scene)
    known = {name: entry for name, entry in entries.items() if not entry.free_symbols and entry != 0}
    made = [f"${typeset(name)} = {tex(entry, Names())}$" for name, entry in entries.items()
            if entry.free_symbols and entry != symbol(name)]
    given = {name: exact_number(x, name) for name, x in values.items()}
    return _of_field(scene.potential), [*made, *numbers(known | given)]


def of_sphere(scene: System, values: Mapping[str, Any], momentum: Any) -> tuple[list[str], list[str]]:
    """Return the numbers of a free body and the radius of its momentum sphere."""
    above, shown = of_scene(scene, {name: x for name, x in values.items() if name != "M"})
    return above, [*shown, f"$|M| = {number(momentum)}$"]


def _of_field(potential: Potential | None) -> list[str]:
    if potential is None:
        return []
    if isinstance(potential, CircularOrbit):
        return ["in orbit", *(field(tex(potential.beside, Names())) if potential.beside else ())]
    if potential.given:
        return field(tex(potential.expression, Names()), typeset(letters_in([potential.expression]).of("U")))
    return ["$U(k_3)$" if potential.axial else "$U(k)$"]


def of_motion(motion: Motion) -> tuple[list[str], list[str]]:
    """Return U, and the numbers of the body and of the state at the time 0."""
    above, shown = of_scene(motion.scene, {})
    potential = motion.scene.potential
    for i, name in enumerate(("pi", *(potential.directions if potential else ()))):
        part = motion.state[3 * i:3 * i + 3]
        shown.append(rf"${typeset(name)}(0) = {components_in(list(map(number, part)))[1:]}")
    return above, shown


def lines(above: Sequence[str], shown: Sequence[str], most: float = ROOM) -> str:
    """Join what is above, a colon and the numbers with commas, and begin a new line when one is full.

    Examples
    --------
    >>> lines(["E1", "$U = k_3$"], ["$I_1 = 1$", "$l = 0$"])
    'E1, $U = k_3$: $I_1 = 1$, $l = 0$'
    """
    items = [*above, *shown]
    marks = [*(":" if n == len(above) else "," for n in range(1, len(items))), ""]
    rows: list[str] = []
    for item, mark in zip(items, marks):
        *wide, last = _broken(item, most)
        for part in (*wide, last + mark):
            row = f"{rows[-1]} {part}" if rows else ""
            if rows and width(row.replace("$", "")) <= most:
                rows[-1] = row
            else:
                rows.append(part)
    return "\n".join(rows)


def _broken(item: str, most: float) -> list[str]:
    """Break a formula before plus and minus signs into parts that fit a line; a long one is cut.

    Matplotlib knows no parentheses of a fixed size.
    """
    if not item.startswith("$") or width(item[1:-1]) <= most:
        return [item]
    formula = item[1:-1].replace(r"\left(", "(").replace(r"\right)", ")")
    parts = [f"${part.strip()}$" for part in broken(formula, most)]
    return parts if len(parts) <= LINES else [*parts[:LINES], r"$+\;\ldots$"]


def heading(above: Sequence[str], shown: Sequence[str], wide: float) -> str:
    """Return the title in lines that are no wider than axes of a width in points."""
    size = optional("matplotlib.font_manager", "plot").FontProperties(size="medium").get_size_in_points()
    return lines(above, shown, max(wide * 10 / size, NARROWEST))
