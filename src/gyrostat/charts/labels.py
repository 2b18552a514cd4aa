"""Checks what arrays carry beside their numbers: masks, which are refused, and labels, which must agree.

Numbers of different arrays meet by their places, so that labels which differ would be ignored.
"""
import sys
from collections.abc import Mapping
from typing import Any

import numpy as np

from ..errors import ValuesError

# a pandas Index by the name of the axis, or None if the axis has none
Labels = dict[str, Any]


def check_plain(values: Mapping[str, Any]) -> None:
    """Raise ValuesError if a number is masked, or two arrays of xarray or pandas differ in their labels."""
    first: tuple[str, Labels] | None = None
    for name, value in values.items():
        if (mask := np.ma.getmask(value)) is not np.ma.nomask and mask.any():
            place = tuple(int(i) for i in np.argwhere(mask)[0])
            raise ValuesError(f"{name}{list(place) if place else ''} is masked, a verdict needs a number: "
                              f"leave it out, or pass {name}.filled(np.nan), which "
                              "verdicts(…, invalid=\"mark\") marks")
        if not (labels := _labels(value)):
            continue
        first = first or (name, labels)
        if not _agree(labels, first[1]):
            raise ValuesError(f"{name} and {first[0]} differ in their labels, {_shown(labels)} and "
                              f"{_shown(first[1])}, but arrays are combined by the places of their "
                              "numbers: align them first, or pass their .values in shapes that broadcast")


def _labels(value: Any) -> Labels:
    """Return the labels of an array of xarray or pandas by axis; none for any other, or a single number."""
    # if a library is not loaded, no array is one of its own; loading it would take longer than the check
    xarray, pandas = sys.modules.get("xarray"), sys.modules.get("pandas")
    if xarray and isinstance(value, (xarray.DataArray, xarray.Variable)):
        indexes = value.indexes if isinstance(value, xarray.DataArray) else {}
        return {str(axis): indexes.get(axis) for axis in value.dims}
    if pandas and isinstance(value, pandas.Series):
        return {"index": value.index}
    if pandas and isinstance(value, pandas.DataFrame):
        return {"index": value.index, "columns": value.columns}
    return {}


def _agree(one: Labels, other: Labels) -> bool:
    """Tell whether the axes are the same, in order, and their labels too if both have some."""
    if list(one) != list(other):
        return False
    return all(a is None or b is None or a.equals(b) for a, b in zip(one.values(), other.values()))


def _shown(labels: Labels) -> str:
    """Return the axes as text, with the ends of their labels."""
    return " × ".join(name if index is None or not len(index) else f"{name} {index[0]}…{index[-1]}"
                      for name, index in labels.items())
