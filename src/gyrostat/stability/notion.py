"""The notions of stability that are proved, or violated."""
from enum import Enum


class Notion(Enum):
    """The notion of stability that is proved or violated; NOTHING, which is false, if it is undecided.

    A notion prints as its value, and is equal to that text.

    References
    ----------
    Spectral and formal: Holm, Marsden, Ratiu & Weinstein, Phys. Rep. 123 (1985) 1-116; secular: Kelvin &
    Tait, Treatise on Natural Philosophy (1879), §345; energy sink: Likins, J. Spacecraft 4 (1967).

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> report = gs.analyze(gs.upright(top))
    >>> decision = report.verdict({"I1": 1, "l": 0, "m0": 1, "pi3_0": 1})
    >>> decision.notion is gs.Notion.SPECTRAL
    True
    """

    NOTHING = ""
    LYAPUNOV = "Lyapunov"
    ARNOLD_MOSER = "Lyapunov (Arnold-Moser)"               # by a normal form, with two degrees of freedom
    SPECTRAL = "spectral"                                  # no eigenvalue has a positive real part
    FORMAL = "formal"                                      # the second variation is definite
    SECULAR = "secular"                                    # under internal damping
    ENERGY_SINK = "energy sink"                            # to first order in weak dampers
    PRINTED = "printed"                                    # a condition as a paper prints it

    def __str__(self) -> str:
        return self.value

    def __bool__(self) -> bool:
        return self is not Notion.NOTHING

    def __eq__(self, other: object) -> bool:
        return self.value == other if isinstance(other, str) else self is other

    def __hash__(self) -> int:
        return hash(self.value)
