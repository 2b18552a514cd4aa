"""Says what a refused potential was likely meant to be, written with k1, k2, k3."""
from collections.abc import Sequence

from sympy import Expr, Symbol, acos, cos, expand_trig, sin, sqrt

from ...notation import Use, components, symbol
from ...registry import free_letters, refused, use_of, what_they_are, why_refused

K1, K2, K3 = components("k")
THETA, PHI, PSI = map(symbol, ("theta", "phi", "psi"))
_TILTS = ("theta", "Theta", "vartheta", "th", "nutation")
# names of papers for the direction, or for its component along axis 3
_VERTICAL = ("K3", "k_3", "kz", "k_z", "zeta", "costheta", "cos_theta", "gamma", "gammapp")
_DIRECTIONS = ("gamma", "Gamma", "nu", "alpha", "beta", "e", "s")
_HEIGHTS = ("z", "Z")
_ANGLES = ("k1 = sin(theta)*sin(psi), k2 = sin(theta)*cos(psi), k3 = cos(theta); phi turns the body about "
           "the field, which changes nothing")
_IN_ORBIT = {*components("n"), *components("r")}
LONG = 80                                                  # characters of a potential in a message


def why_not(expression: Expr, variables: Sequence[Symbol]) -> str:
    """Return why a potential may not have its names, and what to write; "" if it may."""
    own = expression.free_symbols - {*variables}
    names = refused(own, Use.ANGLE)
    if names and use_of(names[0]) is Use.TIME:
        return f"depends on {why_refused(names, ())}"
    if across := sorted(s.name for s in own & {K1, K2}):
        return f"depends on {', '.join(across)}, and a U(k3) on k3 alone: use general_potential"
    angles = sorted(s.name for s in own if use_of(s.name) is Use.ANGLE)
    if not names and not angles:
        return ""
    right = _shown(_renamed(in_components(expression), variables))
    if not names:
        return f"depends on {' and '.join(angles)}, an angle of Euler: write " + (
            f"k3 for cos(theta){right}" if right and angles == ["theta"] else _ANGLES)
    if all(use_of(name) is Use.MOTION for name in names):
        return (f"depends on {what_they_are(names)}, and a potential on the direction k alone: for a number "
                f"of your own write another letter{right}")
    return f"depends on {why_refused(names, [s.name for s in own])}{right}"


def in_components(expression: Expr, tilt: Symbol = THETA) -> Expr:
    """Return the expression with components of k for Euler's angles, where they stand for them."""
    across = sqrt(1 - K3**2)
    turned = expand_trig(expression).subs({sin(PSI): K1 / sin(tilt), cos(PSI): K2 / sin(tilt)}).expand()
    return (turned if turned.has(K1, K2) else expand_trig(expression)).subs(
        {cos(tilt): K3, sin(tilt): across}).subs(tilt, acos(K3))


def _renamed(expression: Expr, variables: Sequence[Symbol]) -> Expr:
    """Return the expression with free letters for the names that are refused."""
    return expression.xreplace({symbol(name): symbol(letter)
                                for name, letter in _letters(expression, variables).items()})


def _letters(expression: Expr, variables: Sequence[Symbol]) -> dict[str, str]:
    """Return a free letter for each name that is refused."""
    own = expression.free_symbols - {*variables, K1, K2, K3}
    return free_letters(refused(own, Use.ANGLE), {s.name for s in own})


def _shown(expression: Expr) -> str:
    """Return "as in U = …", if that is short and has no angle any more."""
    text = str(expression)
    angles = [s for s in expression.free_symbols if use_of(s.name) is Use.ANGLE]
    return "" if angles or len(text) > LONG else f", as in U = {text}"


def without_k(expression: Expr, variables: Sequence[Symbol]) -> str:
    """Return what to write for a potential that has no component of k: a formula, or k for other names."""
    names = {s.name for s in expression.free_symbols}
    if time := [name for name in sorted(names) if use_of(name) is Use.TIME]:
        return f" and depends on {why_refused(time, ())}"
    if expression.free_symbols & _IN_ORBIT:
        return ("; for a direction that is fixed in space write k1, k2, k3; n and r are those of a satellite "
                "in orbit: circular_orbit(potential=…), --orbit, which has the gravity gradient already")
    if expression.is_Symbol and expression.name not in {*_VERTICAL, *_HEIGHTS}:
        return ("; U is a formula, such as m0*k3 of a uniform field; those of fields with a name are in "
                "docs/reference/fields.md")
    meant, right = _angles_meant(expression) or _components_meant(expression) or ("", expression)
    letters = _letters(right, variables)
    if not meant and letters:
        return f"; it has {what_they_are([*letters])}, and a potential depends on the direction k alone"
    if not meant:
        return "; k3 is the cosine of the angle between axis 3 and the field"
    also = "".join(f", {letter} for {what_they_are([name])}" for name, letter in letters.items())
    return f"; {meant}{also}{_shown(_renamed(right, variables))}"


def _angles_meant(expression: Expr) -> tuple[str, Expr] | None:
    """Return what is meant by an angle between the axis and the field: k3 is its cosine."""
    arguments = {f.args[0] for f in expression.atoms(cos, sin) if f.args[0].is_Symbol}
    tilts = [s for s in expression.free_symbols if s.name in _TILTS] or list(arguments - {PSI, PHI})
    if not tilts and {PSI, PHI} & expression.free_symbols or len(tilts) > 1:
        return _ANGLES, expression
    if not tilts:
        return None
    right = in_components(expression, tilts[0])
    if {PSI, PHI} & right.free_symbols:
        return _ANGLES, right
    return f"k3 for cos({tilts[0]})", right


def _components_meant(expression: Expr) -> tuple[str, Expr] | None:
    """Return what is meant by other names for the direction, and by a height: z = z0 k3."""
    meant: dict[Symbol, Expr] = {}
    for s in expression.free_symbols:
        letter, axis = s.name[:-1].removesuffix("_"), s.name[-1]
        if letter in _DIRECTIONS and axis in "123":
            meant[s] = symbol(f"k{axis}")
        elif s.name in _VERTICAL:
            meant[s] = K3
        elif s.name in _HEIGHTS:
            meant[s] = K3 if "m0" in map(str, expression.free_symbols) else symbol(f"{s.name}0") * K3
    said = ", ".join(f"{meant[s]} for {s}" for s in sorted(meant, key=str))
    return (said, expression.xreplace(meant)) if meant else None
