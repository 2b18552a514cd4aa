"""Every symbol once: assumptions, LaTeX, Unicode, dimension, meaning."""
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, fields
from functools import lru_cache
from types import MappingProxyType
from typing import Any

from sympy import Expr, Symbol


@dataclass(frozen=True)
class Entry:
    """What one name means; dimension (a, b) and length c stand for [M L²]ᵃ [T]⁻ᵇ [L]ᶜ."""

    name: str
    latex: str
    text: str
    dimension: tuple[int, int]
    meaning: str
    positive: bool = False
    length: int = 0


def units(energy: int, rate: int, length: int) -> str:
    """[M L²]ᵃ [T]⁻ᵇ [L]ᶜ in SI, such as kg m2 s-1; 1 for a pure number."""
    powers = (("kg", energy), ("m", 2 * energy + length), ("s", -rate))
    return " ".join(unit if power == 1 else f"{unit}{power}" for unit, power in powers if power) or "1"


_JET = re.compile(r"d(\d*)U(?:_([123]+))?")


def jet_name(order: int, axes: str = "") -> str:
    """Name of a derivative of U: dU, d2U, d3U, … in k3, or d2U_13, … in k1 and k3."""
    return f"d{order if order > 1 else ''}U{'_' + axes if axes else ''}"


def jet(name: str) -> tuple[int, str] | None:
    """Order and axes of the derivative of U that a name stands for, None if it stands for none."""
    match = _JET.fullmatch(name)
    if match is None or match[1] in ("0", "1") or match[1].startswith("0"):
        return None
    return int(match[1] or 1), match[2] or ""


# of the J_n of the table; those above are real parameters like any other
_ORDERS = range(3, 10)


def _table() -> Mapping[str, Entry]:
    sub = "₀₁₂₃₄₅₆₇₈₉"
    rows = [Entry(f"pi{i}_0", rf"\pi_{i}^0", f"π{sub[i]}⁰", (1, 1), f"π{i} at the equilibrium")
            for i in (1, 2, 3)]
    rows += [Entry(f"omega{i}_0", rf"\omega_{i}^0", f"ω{sub[i]}⁰", (0, 1),
                   f"body rate about axis {i} at the equilibrium")
             for i in (1, 2, 3)]
    rows += [Entry(f"pi{i}", rf"\pi_{i}", f"π{sub[i]}", (1, 1),
                   f"angular momentum of the locked body, axis {i}")
             for i in (1, 2, 3)]
    rows += [Entry("omega", r"\omega", "ω", (0, 1), "rate about the vertical: ω = omega·k"),
             Entry("l", "l", "l", (1, 1), "gyrostatic momentum of the rotor")]
    rows += [Entry(f"l{i}", f"l_{i}", f"l{sub[i]}", (1, 1), f"gyrostatic momentum, axis {i}")
             for i in (1, 2, 3)]
    rows += [Entry(f"I{i}", f"I_{i}", f"I{sub[i]}", (1, 0), f"principal moment of inertia, axis {i}", True)
             for i in (1, 2, 3)]
    rows += [Entry("m0", "m_0", "m₀", (1, 2), "weight times height of the centre of mass: m g z0"),
             Entry("m1", "m_1", "m₁", (0, 2), "3 g / r, r the distance of the centre of attraction"),
             Entry("r", "r", "r", (0, 0), "distance of the centre of attraction from the fixed point", True,
                   1)]
    rows += [Entry(f"J{n}", f"J_{n}", f"J{sub[n]}", (1, 0), f"∫ |x|^{n} P_{n}(x3/|x|) dm over the body",
                   length=n - 2) for n in _ORDERS]
    rows += [Entry("omega0", r"\omega_0", "ω₀", (0, 1), "rate of the orbit", True)]
    rows += [Entry("p0", "p_0", "p₀", (1, 1), "magnitude of the impulse in an ideal fluid", True, -1)]
    rows += [Entry(f"mass{i}", rf"\bar{{m}}_{i}", f"mass{sub[i]}", (1, 0),
                   f"mass with added mass of the fluid, axis {i}", True, -2)
             for i in (1, 2, 3)]
    rows += [Entry(f"k{i}", f"k_{i}", f"k{sub[i]}", (0, 0),
                   f"direction of the field (Poisson vector), axis {i}")
             for i in (1, 2, 3)]
    rows += [Entry(jet_name(n), "U" + "'" * n, "U" + "′″‴"[n - 1], (1, 2), f"derivative {n} of U along k3")
             for n in (1, 2, 3)]
    rows += [Entry("nu1", r"\nu_1", "ν₁", (0, 1), "multiplier of C1"),
             Entry("nu2", r"\nu_2", "ν₂", (1, 2), "multiplier of C2"),
             Entry("nu3", r"\nu_3", "ν₃", (0, 1), "multiplier of an integral"),
             Entry("lamda", r"\lambda", "λ", (0, 1), "eigenvalue of the linearised field")]
    return MappingProxyType({row.name: row for row in rows})


NOTATION = _table()
_PLACES = MappingProxyType({name: place for place, name in enumerate(NOTATION)})
PARAMETERS = frozenset({"I1", "I2", "I3", "l", "l1", "l2", "l3", "m0", "m1", "r", "p0", "omega0", "mass1",
                        "mass2", "mass3"} | {f"J{n}" for n in _ORDERS})   # a body or a potential may use it
INTERNAL = frozenset({"nu1", "nu2", "nu3", "lamda"})   # names that a derivation introduces itself


def dimension_of(name: str) -> tuple[int, int, int] | None:
    """The dimension of a name, (a, b, c) for [M L²]ᵃ [T]⁻ᵇ [L]ᶜ; None of a parameter of the user.

    Examples
    --------
    >>> dimension_of("l"), dimension_of("d2U"), dimension_of("a")
    ((1, 1, 0), (1, 2, 0), None)
    """
    if jet(name):
        return 1, 2, 0
    entry = NOTATION.get(name)
    return None if entry is None else (*entry.dimension, entry.length)


def order(name: str) -> tuple[int, str, int]:
    """Where a name stands among others: as in the table, derivatives of U with U.

    Parameters of the user before k, a mass first, as in m g z0, the others by name, a2 before a10.

    Examples
    --------
    >>> sorted(["k3", "z0", "g", "m"], key=order)
    ['m', 'g', 'z0', 'k3']
    """
    if name in _PLACES:
        return _PLACES[name], "", 0
    place = _PLACES["d3U"] if jet(name) else _PLACES["k1"] - 1
    word = name.rstrip("0123456789")
    return place, "" if word == "m" else word, int(name[len(word):] or 0)


def of_the_motion(symbols: Iterable[Symbol]) -> list[str]:
    """The names among the symbols that mean something of the motion, and so cannot be parameters of a body or
    a potential.
    """
    return sorted(s.name for s in symbols if jet(s.name) or (s.name in NOTATION and s.name not in PARAMETERS))


@lru_cache(maxsize=4096)                                # a second symbol of one name is equal to the first
def symbol(name: str) -> Symbol:
    """The one symbol of that name; names that are not in the table are real parameters.

    Parameters
    ----------
    name : str
        those of the table of notation have its assumptions: a moment of inertia is positive

    Returns
    -------
    Symbol

    Examples
    --------
    >>> import gyrostat as gs
    >>> gs.symbol("I1").is_positive, gs.symbol("a").is_positive, gs.symbol("a").is_real
    (True, None, True)
    """
    return (
        Symbol(name, positive=True)
        if name in NOTATION and NOTATION[name].positive
        else Symbol(name, real=True)
    )


def own(expression: Expr) -> Expr:
    """The same expression in our symbols, matched by name."""
    return expression.xreplace({s: symbol(s.name) for s in expression.free_symbols if s != symbol(s.name)})


class Stored:
    """Dataclasses that are pickled without what was derived: that is derived again where it is asked for."""

    def __getstate__(self) -> dict[str, Any]:
        return {field.name: getattr(self, field.name) for field in fields(self)}  # type: ignore[arg-type]


def typeset(name: str, at: Any = None, style: str = "latex") -> str:
    """A name as it is printed; derivatives of U take their argument from at."""
    if order_axes := jet(name):
        return _typeset_jet(*order_axes, at, style)
    if entry := NOTATION.get(name):
        return entry.latex if style == "latex" else entry.text
    return _typeset_parameter(name, style)


def _typeset_jet(order: int, axes: str, at: Any, style: str) -> str:
    latex = style == "latex"
    if axes:
        return rf"\partial_{{{axes}}} U" if latex else "∂" + axes.translate(str.maketrans("123", "₁₂₃")) + "U"
    if order <= 3:
        primes = "'" * order if latex else "′″‴"[order - 1]
    else:
        primes = f"^{{({order})}}" if latex else "⁽" + str(order).translate(SUPERSCRIPTS) + "⁾"
    argument = "k3" if at is None else str(at).replace("-", "-" if latex else "−")
    return f"U{primes}({typeset(argument, style=style) if argument == 'k3' else argument})"


SUPERSCRIPTS = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")
SUBSCRIPTS = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
GREEK = MappingProxyType({
    "alpha": "α", "beta": "β", "gamma": "γ", "delta": "δ", "epsilon": "ε", "zeta": "ζ", "eta": "η",
    "theta": "θ", "kappa": "κ", "lambda": "λ", "mu": "μ", "nu": "ν", "xi": "ξ", "pi": "π", "rho": "ρ",
    "sigma": "σ", "tau": "τ", "phi": "φ", "chi": "χ", "psi": "ψ", "omega": "ω",
    "Gamma": "Γ", "Delta": "Δ", "Theta": "Θ", "Lambda": "Λ", "Xi": "Ξ", "Pi": "Π", "Sigma": "Σ", "Phi": "Φ",
    "Psi": "Ψ", "Omega": "Ω"})
# a letter or a word, its number, with or without _, and a subscript
_NAME = re.compile(r"([A-Za-z]+?)(?:_?(\d+))?(?:_([A-Za-z][A-Za-z0-9]*))?")


def _typeset_parameter(name: str, style: str) -> str:
    """A user's parameter: a letter or Greek name with its subscripts, a word upright, else as it is."""
    latex = style == "latex"
    if rate := re.fullmatch(r"(\w+)_(d?dot)", name):        # a rate: one dot, or two in phi_ddot
        inner = _typeset_parameter(rate[1], style)
        dots = "\u0307" if rate[2] == "dot" else "\u0308"
        return rf"\{rate[2]}{{{inner}}}" if latex else f"{inner[0]}{dots}{inner[1:]}"
    if name.startswith("delta_") and len(name) > 6 and not name[6:].isdecimal():          # a variation
        return (r"\delta " if latex else "δ") + typeset(name[6:], style=style)
    word, digits, below = match.groups("") if (match := _NAME.fullmatch(name)) else ("", "", "")
    single = word in GREEK or len(word) == 1
    # m_0 is not the m0 of the table
    if not word or (below and not single) or (digits and f"_{digits}" in name and word + digits in NOTATION):
        return r"\mathrm{" + name.replace("_", r"\_") + "}" if latex else name
    if below and below.rstrip("0123456789") in GREEK:
        below = _typeset_parameter(below, style)
    if not latex:
        return GREEK.get(word, word) + digits.translate(SUBSCRIPTS) + (f"_{below}" if below else "")
    shown = "\\" + word if word in GREEK else word if single else rf"\mathrm{{{word}}}"
    subscripts = ",".join(filter(None, (digits, below)))
    return f"{shown}_{{{subscripts}}}" if subscripts else shown
