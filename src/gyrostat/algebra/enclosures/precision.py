"""Sets the precision of python-flint, which is one number for the whole process, under a lock."""
import threading
from collections.abc import Iterator
from contextlib import contextmanager

from flint import ctx

from ...errors import ValuesError, brief

MOST = 2**24                                           # bits
ONE_AT_A_TIME = threading.RLock()                      # held by every computation of ours with enclosures


def doubled(bits: int, most: int | None = None) -> Iterator[int]:
    """Yield a number of bits and its doubles, as long as they are not above a maximum.

    The default maximum is 16 times the first number: four doublings pay before a number is asked for as an
    expression.

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
    """Give every enclosure that is computed inside so many bits, whatever other threads compute.

    A computation of the library waits for those of other threads. Other code that calls python-flint beside
    it has to hold ONE_AT_A_TIME as well.

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
        bits is not a whole number, or not one of these

    Examples
    --------
    >>> import gyrostat as gs
    >>> from flint import ctx
    >>> with gs.derivation.own_precision(100):
    ...     ctx.prec
    100
    """
    if type(bits) is not int or not 2 <= bits <= MOST:
        raise ValuesError(f"bits = {brief(bits)} is not a whole number from 2 to 2²⁴: give 53, for example")
    with ONE_AT_A_TIME, ctx.workprec(bits):
        yield
