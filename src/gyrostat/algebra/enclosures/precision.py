"""How many bits the enclosures of python-flint have, which is one number for the whole process."""
import threading
from collections.abc import Iterator
from contextlib import contextmanager

from flint import ctx

from ...errors import ValuesError, brief

MOST = 2**24                                           # bits
ONE_AT_A_TIME = threading.RLock()                      # held by every computation of ours with enclosures


def doubled(bits: int, most: int | None = None) -> Iterator[int]:
    """So many bits, and twice as often as they are not above the most.

    Default are four times, as is worth while before a number is asked for as an expression.

    Examples
    --------
    >>> list(doubled(100))
    [100, 200, 400, 800, 1600]
    """
    most = most or 16 * bits
    while bits <= most:
        yield bits
        bits *= 2


@contextmanager
def own_precision(bits: int) -> Iterator[None]:
    """Every enclosure that is computed inside has so many bits, whatever other threads compute.

    A computation of ours waits for those of other threads. Whoever calls python-flint besides has to hold
    ONE_AT_A_TIME as well.

    Parameters
    ----------
    bits : int
        from 2 to 2²⁴

    Returns
    -------
    context manager

    Raises
    ------
    ValuesError
        another number of bits, or no whole number

    Examples
    --------
    >>> import gyrostat as gs
    >>> from flint import ctx
    >>> with gs.derivation.own_precision(100):
    ...     ctx.prec
    100
    """
    if type(bits) is not int or not 2 <= bits <= MOST:
        raise ValuesError(f"bits = {brief(bits)} is no whole number from 2 to 2²⁴: give 53, say")
    with ONE_AT_A_TIME, ctx.workprec(bits):
        yield
