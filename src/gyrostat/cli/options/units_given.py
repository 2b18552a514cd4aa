"""Whether the numbers that are given have units: then those that are printed have them, in SI."""
import argparse
import re
from collections.abc import Iterator
from typing import Any

from ...algebra.text.units import unit
from .scene_files import scene_of_file

# a unit stands after a number, and a blank or none
_AFTER_A_NUMBER = re.compile(r"[\d.)\]]\s*([A-Za-z_]+)")
_OPTIONS = ("orbit", "inertia", "gyrostatic_momentum", "rotors", "point", "state", "until", "step", "x", "y",
            "axis")


def units_given(given: argparse.Namespace) -> bool:
    """Whether a number of the options, or of the file of --scene, has a unit."""
    texts = [*_texts([getattr(given, name, None) for name in _OPTIONS]), *given.values]
    if getattr(given, "scene", None) is not None:
        texts += _texts(scene_of_file(given.scene).table)
    return any(unit(name) for text in texts for name in _AFTER_A_NUMBER.findall(text))


def _texts(entry: Any) -> Iterator[str]:
    """The texts in a table of a file, however deep they stand."""
    if isinstance(entry, str):
        yield entry
    elif isinstance(entry, dict | list):
        for part in entry.values() if isinstance(entry, dict) else entry:
            yield from _texts(part)
