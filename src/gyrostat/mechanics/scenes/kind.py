"""The kinds of scenes: which equations the relative equilibria of a scene solve."""
from enum import Enum


class Kind(Enum):
    """What a scene is, as System.kind: code that treats scenes in different ways asks this and nothing else.

    The value says it in words.

    Examples
    --------
    >>> import gyrostat as gs
    >>> gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field()).kind
    <Kind.REVOLUTION: 'a body of revolution in U(k3)'>
    """

    FREE = "a free body or gyrostat"
    REVOLUTION = "a body of revolution in U(k3)"
    FIELD = "any other body in a field of one direction"
    ORBIT = "a satellite in a circular orbit"
    COUPLED = "a body in two directions, or with a coupling β, in no orbit"
