"""What arrays carry beside their numbers.

Masks, which are refused, and labels, which must agree, for numbers meet by their places.
"""
import sys
from collections.abc import Mapping
from typing import Any

import numpy as np

from ..errors import ValuesError

# a pandas Index, or None where there is none, by the name of the axis
Labels = dict[str, Any]


def check_plain(values: Mapping[str, Any]) -> None:
    """Raise ValuesError where a number is masked, or two arrays of xarray or pandas differ in their labels.
    """
    first: tuple[str, Labels] | None = None
    for name, value in values.items():
        mask = np.ma.getmask(value)
        if mask.any():
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
    """The labels of an array of xarray or pandas by axis; none of any other, or of a single number."""
    # where they are not loaded there is no such array
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
    """Whether the axes are the same, in order, and so are their labels where both have some."""
    if list(one) != list(other):
        return False
    return all(a is None or b is None or a.equals(b) for a, b in zip(one.values(), other.values()))


def _shown(labels: Labels) -> str:
    """Axes, with the ends of their labels."""
    return " × ".join(name if index is None or not len(index) else f"{name} {index[0]}…{index[-1]}"
                      for name, index in labels.items())
