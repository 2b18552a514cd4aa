"""The table of names that mean something: assumptions, LaTeX, dimension, meaning, where they may stand."""
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields
from enum import Enum
from functools import lru_cache
from types import MappingProxyType
from typing import Any, ClassVar

from sympy import Expr, Symbol

from .errors import ArgumentError, article, brief


class Use(Enum):
    """What a name is for, which decides in which expressions of a scene it may stand."""

    BODY = "a moment of the body: it may stand anywhere in a scene, and means that moment"
    FIELD = "a parameter of the named fields: in an expression of your own it is a parameter of yours"
    ROTOR = "the rotor: it may stand in the rotor, and is refused in a potential and in an inertia tensor"
    MOTION = "the motion: it is refused in a potential and in a body"
    ANGLE = "Euler's angles: refused in a potential, whose variables are k1, k2, k3"
    TIME = "the time: it is refused wherever a scene has numbers"
    LEVEL = "yours in a potential or a body; verbs that ask for a level by this name then refuse the scene"
    PRINTED = "a letter of what is printed: in your expressions it is yours, and the print takes another"


@dataclass(frozen=True)
class Entry:
    """What one name means; dimension (a, b) and length c stand for [M L²]ᵃ [T]⁻ᵇ [L]ᶜ.

    If the name is somebody else's, one of the names in `instead` is proposed, or taken.
    """

    name: str
    latex: str
    text: str
    dimension: tuple[int, int]
    meaning: str
    positive: bool = False
    length: int = 0
    use: Use = Use.MOTION
    instead: str = ""


def units(energy: int, rate: int, length: int) -> str:
    """Return [M L²]ᵃ [T]⁻ᵇ [L]ᶜ in SI, such as kg m2 s-1; 1 for a pure number."""
    powers = (("kg", energy), ("m", 2 * energy + length), ("s", -rate))
    return " ".join(unit if power == 1 else f"{unit}{power}" for unit, power in powers if power) or "1"


_JET = re.compile(r"d(\d*)U(?:_([123]+))?")


def jet_name(order: int, axes: str = "") -> str:
    """Return the name of a derivative of U: dU, d2U, d3U, … in k3, or d2U_13, … in k1 and k3."""
    return f"d{order if order > 1 else ''}U{'_' + axes if axes else ''}"


def jet(name: str) -> tuple[int, str] | None:
    """Return order and axes of the derivative of U that a name stands for, None if it stands for none."""
    match = _JET.fullmatch(name)
    if match is None or match[1] in ("0", "1") or match[1].startswith("0"):
        return None
    return int(match[1] or 1), match[2] or ""


# of the J_n of the table; those above are real parameters like any other
_ORDERS = range(3, 10)
_SUB = "₀₁₂₃₄₅₆₇₈₉"


def _table() -> Mapping[str, Entry]:
    """Return the names of the mathematics, in the order in which they are written in formulas."""
    rows = [Entry(f"pi{i}_0", rf"\pi_{i}^0", f"π{_SUB[i]}⁰", (1, 1), f"π{i} at the equilibrium", instead="P")
            for i in (1, 2, 3)]
    rows += [Entry(f"omega{i}_0", rf"\omega_{i}^0", f"ω{_SUB[i]}⁰", (0, 1),
                   f"body rate about axis {i} at the equilibrium", instead="Omega w")
             for i in (1, 2, 3)]
    rows += [Entry(f"pi{i}", rf"\pi_{i}", f"π{_SUB[i]}", (1, 1),
                   f"angular momentum of the locked body, axis {i}", instead="P")
             for i in (1, 2, 3)]
    rows += [Entry("omega", r"\omega", "ω", (0, 1), "rate about the vertical: ω = omega·k",
                   instead="Omega w"),
             Entry("l", "l", "l", (1, 1), "gyrostatic momentum of the rotor", use=Use.ROTOR, instead="L a")]
    rows += [Entry(f"l{i}", f"l_{i}", f"l{_SUB[i]}", (1, 1), f"gyrostatic momentum, axis {i}", use=Use.ROTOR,
                   instead=f"L{i} a{i}") for i in (1, 2, 3)]
    rows += [Entry(f"I{i}", f"I_{i}", f"I{_SUB[i]}", (1, 0), f"principal moment of inertia, axis {i}", True,
                   use=Use.BODY) for i in (1, 2, 3)]
    rows += [Entry("m0", "m_0", "m₀", (1, 2), "weight times height of the centre of mass: m g z0",
                   use=Use.FIELD),
             Entry("m1", "m_1", "m₁", (0, 2), "3 g / r, r the distance of the centre of attraction",
                   use=Use.FIELD),
             Entry("r", "r", "r", (0, 0), "distance of the centre of attraction from the fixed point", True,
                   1, Use.FIELD)]
    rows += [Entry(f"J{n}", f"J_{n}", f"J{_SUB[n]}", (1, 0), f"∫ |x|^{n} P_{n}(x3/|x|) dm over the body",
                   length=n - 2, use=Use.FIELD) for n in _ORDERS]
    rows += [Entry("omega0", r"\omega_0", "ω₀", (0, 1), "rate of the orbit", True, use=Use.FIELD)]
    rows += [Entry("p0", "p_0", "p₀", (1, 1), "magnitude of the impulse in an ideal fluid", True, -1,
                   Use.FIELD)]
    rows += [Entry(f"mass{i}", rf"\bar{{m}}_{i}", f"mass{_SUB[i]}", (1, 0),
                   f"mass with added mass of the fluid, axis {i}", True, -2, Use.FIELD)
             for i in (1, 2, 3)]
    rows += [Entry(f"k{i}", f"k_{i}", f"k{_SUB[i]}", (0, 0),
                   f"direction of the field (Poisson vector), axis {i}", instead=f"c{i}")
             for i in (1, 2, 3)]
    rows += [Entry(jet_name(n), "U" + "'" * n, "U" + "′″‴"[n - 1], (1, 2), f"derivative {n} of U along k3")
             for n in (1, 2, 3)]
    rows += [Entry("nu1", r"\nu_1", "ν₁", (0, 1), "multiplier of C1", instead="nu"),
             Entry("nu2", r"\nu_2", "ν₂", (1, 2), "multiplier of C2", instead="nu"),
             Entry("nu3", r"\nu_3", "ν₃", (0, 1), "multiplier of an integral", instead="nu"),
             Entry("lamda", r"\lambda", "λ", (0, 1), "eigenvalue of the linearised field", instead="lambda")]
    return MappingProxyType({row.name: row for row in rows})


def _beside() -> Iterator[Entry]:
    """Yield names of the motion that no criterion is written in, those of angles, time and levels."""
    for i in (1, 2, 3):
        yield Entry(f"omega{i}", rf"\omega_{i}", f"ω{_SUB[i]}", (0, 1), f"body rate about axis {i}",
                    instead="Omega w")
    yield Entry("sigma", r"\sigma", "σ", (1, 2), "multiplier of |k| = 1 of a permanent rotation", instead="s")
    yield Entry("energy", "h", "h", (1, 2), "energy of the reduced motion", instead="E")
    yield Entry("p_phi", r"p_\phi", "p_φ", (1, 1), "momentum about the vertical, value of C1", instead="P")
    yield Entry("p_psi", r"p_\psi", "p_ψ", (1, 1), "momentum about the axis of the body", instead="P")
    for name, letter, what in (("theta", "θ", "angle of nutation, k3 = cos(theta)"),
                               ("phi", "φ", "angle of precession"), ("psi", "ψ", "angle of spin")):
        yield Entry(name, f"\\{name}", letter, (0, 0), what, use=Use.ANGLE, instead="alpha beta")
    for name in ("t", "time"):
        yield Entry(name, name, name, (0, -1), "time", use=Use.TIME)
    yield Entry("C1", "C_1", "C₁", (1, 1), "value of the Casimir M·k", use=Use.LEVEL, instead="c1")
    yield Entry("M", "M", "M", (1, 1), "length of the angular momentum of a free body", use=Use.LEVEL,
                instead="m")


def _printed() -> Iterator[Entry]:
    """Yield the letters of what is printed, with those that take their place if a scene has them.

    C_ stands for the letter with numbers below it, C1 and C2, and K* for the letter with them and without.
    """
    for names, what, instead in (
            ("vector_M", "angular momentum Iω + l", ""), ("vector_l", "gyrostatic momentum", ""),
            ("vector_omega", "angular velocity", ""), ("vector_k", "direction of the field", ""),
            ("vector_I", "inertia tensor", ""), ("vector_n vector_r", "directions of an orbit", ""),
            ("vector_p vector_gamma", "impulse and direction of gravity of a vehicle", ""),
            ("h", "energy", "E W"), ("B", "Poisson tensor", "P"), ("U", "potential", "V"),
            ("C", "Casimir of a free body, |M|²", "Z"), ("C_", "Casimirs in a field, C1 = M·k", "Z Gamma"),
            ("F* G", "functions in the bracket, integrals, gyroscopic term", "Phi Psi"),
            ("T", "basis of the tangent space of the orbit", "Y"), ("S", "basis of the slice", "X"),
            ("J*", "linearised field, k·Ik, actions", "L"), ("H", "second variation", "Q X"),
            ("Delta*", "minors of H, square of a frequency", "d"), ("lamda", "eigenvalue", "Lambda"),
            ("p", "coefficient of λ² in the characteristic polynomial", "P"),
            ("q", "its last coefficient", "Q"), ("t s", "trace and determinant of K", "tau d"),
            ("K*", "second variation of the amended potential", "Y Gamma"), ("g_", "components of g", "mu"),
            ("A*", "inertia of the motion near a rotation", "R"), ("v_", "2 ω Ik + l", "w"),
            ("g", "square of I1 dk3/dt, or gyroscopic vector", "f"), ("c_", "coefficients of g", "b"),
            ("x", "deviation of k3, or λ²", "y xi"), ("f_", "factors of the polynomial in λ²", "phi"),
            ("beta", "coupling in the energy", "eta"), ("D*", "defect of the eigenvalue 0, twists", "E d"),
            ("N P", "numerator and denominator of D4", "Q R"), ("R_", "what stands under roots", "Q"),
            ("e_", "axes of the body", "a"), ("nu", "multiplier of a rotation", "mu"),
            ("V", "effective potential", "W"), ("M_", "components of M in a picture", "Lambda"),
            ("a b c", "coefficients of the sextic", "u v w"), ("i", "imaginary unit", "j iota")):
        for name in names.split():
            yield Entry(name, name, name, (0, 0), what, use=Use.PRINTED, instead=instead)


NOTATION = _table()
REGISTRY = (*NOTATION.values(), *_beside(), *_printed())
_PLACES = MappingProxyType({name: place for place, name in enumerate(NOTATION)})


@lru_cache(maxsize=4096)                                # a second symbol of one name is equal to the first
def symbol(name: str) -> Symbol:
    """Return the one symbol of that name; names that are not in the table are real parameters.

    Parameters
    ----------
    name : str
        those of the table of notation have its assumptions: a moment of inertia is positive

    Returns
    -------
    Symbol

    Raises
    ------
    ArgumentError
        the name is not a text

    Examples
    --------
    >>> import gyrostat as gs
    >>> moment, own = gs.symbol("I1"), gs.symbol("a")
    >>> moment.is_positive, own.is_positive, own.is_real
    (True, None, True)
    """
    if not isinstance(name, str):
        raise ArgumentError(f"name = {brief(name)} is {article(type(name))}, not a text: give I1, say")
    positive = name in NOTATION and NOTATION[name].positive
    return Symbol(name, positive=True) if positive else Symbol(name, real=True)


def components(name: str) -> tuple[Symbol, Symbol, Symbol]:
    """Return the symbols of the three components of a vector: k1, k2, k3."""
    return symbol(f"{name}1"), symbol(f"{name}2"), symbol(f"{name}3")


def own(expression: Expr) -> Expr:
    """Return the same expression in our symbols, matched by name."""
    return expression.xreplace({s: symbol(s.name) for s in expression.free_symbols if s != symbol(s.name)})


def dimension_of(name: str) -> tuple[int, int, int] | None:
    """Return the dimension (a, b, c) of a name, [M L²]ᵃ [T]⁻ᵇ [L]ᶜ; None for a parameter of the user.

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
    """Return the place of a name among others: as in the table, derivatives with U, rates with coordinates.

    Parameters of the user come before k, a mass first, as in m g z0, the others by name, a2 before a10.

    Examples
    --------
    >>> sorted(["k3", "z0", "g", "m"], key=order)
    ['m', 'g', 'z0', 'k3']
    """
    if (coordinate := name.removesuffix("_dot")) in _PLACES:
        return _PLACES[coordinate], "", 0
    place = _PLACES["d3U"] if jet(name) else _PLACES["k1"] - 1
    word = name.rstrip("0123456789")
    return place, "" if word == "m" else word, int(name[len(word):] or 0)


class Stored:
    """The base of dataclasses that are pickled without what is derived, but for what _carried names."""

    _carried: ClassVar[tuple[str, ...]] = ()

    def __getstate__(self) -> dict[str, Any]:
        names = [field.name for field in fields(self)]  # type: ignore[arg-type]
        return {n: getattr(self, n) for n in (*names, *(n for n in self._carried if n in self.__dict__))}
