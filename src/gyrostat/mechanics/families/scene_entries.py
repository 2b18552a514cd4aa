"""Reads entries of a scene's table that have parts: rotors, an orbit, directions, numbers by their names."""
from typing import Any

from ...algebra.text.inputs import Written, is_name
from ...algebra.text.tensors import rows_of, settings_in
from ...errors import PublishedError, brief
from ..equilibrium.unit_vectors import STEREOGRAPHIC

# of each rotor, texts or numbers but for the axis; data sheets have words of their own
ROTOR = ("axis", "axial", "transverse", "rate", "momentum")
WORDS = {"inertia": "axial", "speed": "rate"}
ORBIT = ("rate", "period", "height", "body", "mu", "radius")   # of an orbit, texts or numbers


def texts_of(name: str, value: Any) -> list[str]:
    """Return a list of numbers or texts as texts."""
    if isinstance(value, list) and None not in (texts := [_text(x) for x in value]):
        return [text for text in texts if text is not None]
    raise PublishedError(f'{name} = {brief(value)}: write a list of numbers, or of texts in quotation '
                         f'marks, {name} = [1, 1, "1/3"]')


def _parameters(value: Any) -> list[str]:
    """Return the names in a list."""
    if not isinstance(value, list) or not all(isinstance(text, str) for text in value):
        raise PublishedError(f"parameters = {brief(value)}: write a list of texts, in quotation marks")
    for text in value:
        if not is_name(text):
            raise PublishedError(f"the parameter {brief(text)} is not a name: letters, digits and _ make one")
    return value


def _rotors(value: Any) -> list[dict[str, Any]]:
    """Return for each rotor its texts by their names."""
    # a text, as of --wheel, is read as a table
    read: list[Any] = [settings_in(rotor) if isinstance(rotor, str) else rotor
                       for rotor in (value if isinstance(value, list) else ())]
    if not read or not all(isinstance(rotor, dict) for rotor in read):
        raise PublishedError(f"rotors = {brief(value)}: write a list of tables, rotors = [{{ "
                             'axis = [0, 1, 0], axial = "0.05 kg m^2", rate = "3000 rpm" }], or a wheel as '
                             '"axis=0,1,0 inertia=0.05 kg m^2 speed=3000 rpm"')
    return [_rotor(rotor) for rotor in read]


def _rotor(given: dict[str, Any]) -> dict[str, Any]:
    """Return the texts of one rotor."""
    if unknown := [name for name in given if name not in (*ROTOR, *WORDS)]:
        raise PublishedError(f"a rotor has no entry {brief(unknown[0])[1:-1]}: its entries are "
                             f"{', '.join(ROTOR)}; inertia is read as axial, speed as rate")
    rotor = {WORDS.get(name, name): x for name, x in given.items()}
    if len(rotor) < len(given):
        raise PublishedError("a rotor has one entry by two names: inertia and axial are one, and so are "
                             "speed and rate; leave out one of the two")
    if missing := [name for name in ("axis", "axial") if name not in rotor]:
        raise PublishedError("a rotor has no " + ("axis: write axis = [0, 1, 0], or axis=0,1,0"
                                                  if missing[0] == "axis" else
                                                  'axial moment of inertia: write axial = "0.05 kg m^2", or '
                                                  "inertia=0.05 kg m^2"))
    axis = rotor["axis"]
    rotor["axis"] = rows_of(axis) if isinstance(axis, str) else axis
    return {name: texts_of(name, x) if name == "axis" else texts_of(name, [x])[0]
            for name, x in rotor.items()}


def _orbit(value: Any) -> dict[str, str]:
    """Return what a table says of an orbit, or the text of an option: 0.0011 rad/s, height=500 km."""
    if isinstance(value, str):
        value = settings_in(value) or {"rate": value.strip()}
    elif (text := _text(value)) is not None:
        value = {"rate": text}
    texts = {name: _text(x) for name, x in value.items()} if isinstance(value, dict) else {"": None}
    if not texts or not texts.keys() <= set(ORBIT) or not all(texts.values()):
        raise PublishedError(f"orbit = {brief(value)}: give its rate, omega0 or 0.0011 rad/s, or one of "
                             "period=95 min, height=500 km, height=100 km body=moon, and "
                             "mu=398600.4418 km^3/s^2 radius=6878 km; in a file a table has them, "
                             'orbit = { height = "500 km" }')
    return {name: text for name, text in texts.items() if text is not None}


def _pointing(value: Any) -> list[int]:
    """Return the body axes of roll, pitch and yaw."""
    axes = value.split(",") if isinstance(value, str) else value if isinstance(value, list) else []
    texts = [str(_text(x)).strip() for x in axes]
    if sorted(text.removeprefix("-") for text in texts) != ["1", "2", "3"]:
        raise PublishedError(f"pointing = {brief(value)}: give the body axes along roll, pitch and yaw, 1, 2 "
                             "and 3 in some order, negative for one that points the other way, [1, 2, 3]")
    return [int(text) for text in texts]


def _direction(value: Any) -> list[str]:
    """Return three expressions, or the word for all directions by two coordinates."""
    texts = [text.strip() for text in (value.split(",") if isinstance(value, str) else
                                       texts_of("direction", value))]
    if len(texts) != 3 and texts != [STEREOGRAPHIC]:
        raise PublishedError(f'direction = {brief(value)}: give three expressions that make a unit vector, '
                             f'["sin(a)", 0, "cos(a)"], or "{STEREOGRAPHIC}"')
    return texts


def _values(value: Any) -> dict[str, str]:
    """Return numbers by their names."""
    if not isinstance(value, dict):
        raise PublishedError(f'values = {brief(value)}: write a table, values = {{ I1 = 1.6, l = "1/3" }}')
    texts = {name: _text(number) for name, number in value.items()}
    for name, text in texts.items():
        if not isinstance(name, str) or not is_name(name):
            raise PublishedError(f"values has {brief(name)}, which is not a name: letters, digits and _ make "
                                 "one")
        if text is None:
            raise PublishedError(f'values.{name} = {brief(value[name])} is not a number: write {name} = 1.6, '
                                 f'or {name} = "sqrt(3)/2"')
    return {name: text for name, text in texts.items() if text is not None}


def _text(value: Any) -> str | None:
    """Return a number or text as it is written, None for anything else."""
    if isinstance(value, Written):
        return value.text
    if isinstance(value, int) and not isinstance(value, bool):
        return str(value)
    return value if isinstance(value, str) else None


# of each entry that is neither a text nor a list of texts, its reader
READ = {"values": _values, "rotors": _rotors, "orbit": _orbit, "pointing": _pointing,
         "direction": _direction, "parameters": _parameters}
