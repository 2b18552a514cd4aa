"""Three-valued answers on arrays: 1 proved to hold, −1 proved not to hold, 0 not proved."""
from collections.abc import Iterable
from functools import reduce

import numpy as np

from ...algebra.enclosures.floats import Array


def answered(holds: Array, fails: Array) -> Array:
    """Return answers from where something is proved and where the contrary is, neither at once."""
    return holds.view(np.int8) - fails.view(np.int8)


def every(answers: Iterable[Array]) -> Array:
    """Return the conjunction of answers."""
    given = list(answers)
    return reduce(np.minimum, given) if given else np.ones((), np.int8)


def some(answers: Iterable[Array]) -> Array:
    """Return the disjunction of answers."""
    given = list(answers)
    return reduce(np.maximum, given) if given else -np.ones((), np.int8)
