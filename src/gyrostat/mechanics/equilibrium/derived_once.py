"""Makes a verb of an equilibrium derive its answer the first time it is asked, and keep it."""
from collections.abc import Callable
from functools import wraps

from .equilibrium import Derived, Equilibrium


def once(verb: Callable[[Equilibrium], Derived]) -> Callable[[Equilibrium], Derived]:
    """Return the verb, or the class of what is derived, asked once for each equilibrium."""
    @wraps(verb, updated=())
    def kept(eq: Equilibrium) -> Derived:
        return eq.derived(verb)

    return kept
