"""Reads what is asked of a scene: its names, exact numbers for them, and a rate, a level or a tilt."""
from collections.abc import Mapping
from typing import Any

from sympy import Expr, ImmutableMatrix, Matrix, S

from ...algebra.enclosures.algebraic import is_algebraic
from ...algebra.reals.exact import Point, evaluate, proved_sign
from ...algebra.text.numbers import exact_number
from ...algebra.text.quantities import not_mixed
from ...errors import ScopeError, ValuesError, brief
from ...mechanics.equilibrium.recognition import Recognition, recognise
from ...mechanics.equilibrium.reduction import K3
from ...mechanics.scenes.kind import Kind
from ...mechanics.scenes.system import System, at_numbers, names_of_scene
from ...notation import symbol
from ...registry import free_letters, what_they_are
from ...stability.criteria.numbers_asked import check_names, unknown

PI3, C1, LENGTH = symbol("pi3_0"), symbol("C1"), symbol("M")
OTHERS = "relative_equilibria finds those of another body in a field"
MARKED = "continuation marks where rotations of another body in a field meet, over a range of one name"
# of the motion: a rate about the vertical, a level, a tilt, a tilt on a level
ASKED = (("omega",), ("pi3_0", "C1"), ("k3",), ("k3", "pi3_0"))


def names_of(scene: System, instead: str = OTHERS) -> set[str]:
    """Return the names of moments, l and parameters of U, for a body of revolution in a given U(k3).

    Any other scene is refused, with what there is instead.
    """
    if scene.potential is not None and scene.unspecified:
        raise ScopeError(f"U = {scene.potential.expression} is unspecified, and all equilibria are found in "
                         "a field that is given: give one; conditions in any field are those of upright, "
                         "hanging and inclined")
    require_revolution(scene, instead)
    assert scene.potential is not None
    needed = {s for e in (*scene.body.moments, scene.body.gyrostatic_momentum[2], scene.potential.expression)
              for s in e.free_symbols}
    return {s.name for s in needed - {K3}}


def require_revolution(scene: System, instead: str) -> None:
    """Refuse a scene that is no body of revolution in U(k3)."""
    if scene.kind is Kind.REVOLUTION:
        return
    inertia = scene.body.inertia
    shown = "a full inertia tensor" if isinstance(inertia, ImmutableMatrix) else f"inertia = {brief(inertia)}"
    field = "no field" if scene.potential is None else f"U = {brief(scene.potential.expression)}"
    if isinstance(inertia, ImmutableMatrix):
        instead = f"principal_axes(body) turns the body into its axes; {instead}"
    raise ScopeError(f"{shown}, {field}: this is no body of revolution about axis 3 in a field U(k3); "
                     + instead)


def refuse_as_level(scene: System, name: str) -> None:
    """Refuse a scene that has a parameter of the name by which a level is asked for.

    Raises
    ------
    ScopeError
        M or C1 is a parameter of the scene
    """
    own = {s.name for s in names_of_scene(scene)}
    if name in own:
        raise ScopeError(f"the scene has a parameter {name}, and here {what_they_are([name])}, must be "
                         "given: write another letter for the parameter, such as "
                         f"{free_letters([name], own)[name]}")


def exact_point(scene: System, values: Mapping[str, Any], known: set[str]) -> Point:
    """Return the values as exact numbers.

    Unknown names are refused, and moments that are not positive, as far as they are given.
    """
    for name in values:
        if name not in known:
            raise ValuesError(unknown(name, sorted(known), "the scene"))
    not_mixed(values.items())
    numbers = Point({symbol(name): exact_number(value, name) for name, value in values.items()})
    if scene.potential is not None:
        scene.potential.check_size(numbers)
    for moment in dict.fromkeys(scene.body.positive):
        if moment.free_symbols <= numbers.keys() and proved_sign(value := evaluate(moment, numbers)) != 1:
            raise ValuesError(f"{moment} = {value}, but a moment of inertia must be positive: give a "
                              "positive number")
    return numbers


def asked_for(scene: System, values: Mapping[str, Any]) -> tuple[tuple[str, ...], Point]:
    """Return by which names relative equilibria are asked for, and all numbers, exact."""
    needed = names_of(scene)
    ways = [names for names in ASKED if needed.isdisjoint(names)]
    extra = {name for names in ways for name in names}
    numbers = exact_point(scene, values, needed | extra)
    asked = next((names for names in ways if set(names) == values.keys() & extra), None)
    if asked is None:
        if "pi3_0" in values:
            refuse_as_level(scene, C1.name)
        raise ValuesError(
            f"given were {', '.join(sorted(values.keys() & extra)) or 'no names of the motion'}: give "
            + ", or ".join(" and ".join(names) for names in ways)
        )
    if missing := sorted(needed - values.keys()):
        raise ValuesError(f"the scene needs {', '.join(missing)}: give a number for each")
    if K3 in numbers and proved_sign(1 - numbers[K3] ** 2) != 1:
        raise ValuesError(f"k3 = {numbers[K3]} is not the tilt of a precession: give −1 < k3 < 1; E1 and "
                          "E2 are found with omega")
    return asked, numbers


def asked_about(scene: System, values: Mapping[str, Any]) -> tuple[Recognition, dict[str, Any]] | None:
    """Return what a scene is at given numbers, and what is asked in the names of the standard scene.

    None if it is not one of revolution. About axis 1 the names are k1 and pi1_0, about an oblique axis c they
    are kc = k·c and pic_0 = π·c; omega and C1 are the same in all.

    Raises
    ------
    ValuesError
        a name is unknown, or one of the scene is missing
    """
    names = sorted(s.name for s in names_of_scene(scene))
    numbers = {symbol(name): exact_number(value, name) for name, value in values.items() if name in names}
    if not (found := recognise(at_numbers(scene, numbers))):
        return None
    check_names([s.name for s in numbers], names, "the scene")
    axis = found.name[-1]
    own = {f"k{axis}": "k3", f"pi{axis}_0": "pi3_0", "omega": "omega", "C1": "C1"}
    own = {name: standard for name, standard in own.items() if name not in names}
    if foreign := sorted(values.keys() - own.keys() - set(names)):
        raise ValuesError(unknown(foreign[0], sorted({*names, *own}), "the scene"))
    ways = [way for way in ({"omega"}, {f"pi{axis}_0", "C1"}, {f"k{axis}"}, {f"k{axis}", f"pi{axis}_0"})
            if way <= own.keys()]
    if values.keys() - set(names) not in ways:
        raise ValuesError("give the rate about the vertical, the level or the tilt, each in the axes of "
                          "the scene: "
                          + ", or ".join(" and ".join(sorted(way)) for way in ways))
    return found, {own[name]: value for name, value in values.items() if name not in names}


def numbers_of_rotations(scene: System, values: Mapping[str, Any], free: str | None = None) -> Point:
    """Return the values as exact numbers for every name of a scene without a field and for M.

    One name may be free.
    """
    needed = {s.name for s in names_of_scene(scene)}
    refuse_as_level(scene, LENGTH.name)
    needed |= {LENGTH.name}
    if free is not None and free not in needed:
        raise ValuesError(unknown(free, sorted(needed), "the scene"))
    numbers = exact_point(scene, values, needed)
    if free is not None and free in values:
        raise ValuesError(f"{free} is free, and the value {values[free]} is given for it: leave out one of "
                          "the two")
    if missing := sorted(needed - values.keys() - {free}):
        raise ValuesError(f"the permanent rotations need {', '.join(missing)}: give a number for each; M is "
                          "the length of the angular momentum Iω + l")
    if LENGTH in numbers and proved_sign(numbers[LENGTH]) not in ((0, 1) if free is None else (1,)):
        raise ValuesError(f"M = {numbers[LENGTH]} is not the radius of a momentum sphere: give a number that "
                          f"is {'not negative' if free is None else 'positive'}")
    return numbers


def without_pi(vector: Matrix, radius: Expr) -> tuple[Matrix, Expr, Expr]:
    """Return a vector along with l, and abs(M), both over abs(M) if that is not algebraic; and the divisor.

    ν is the same, and algebraic if both have π.
    """
    unit = S.One if radius.free_symbols or is_algebraic(radius) else radius
    return (vector / unit).expand(), radius / unit, unit
