"""The named families: upright E1, hanging E2, inclined E3 and its limit at rest, principal rotations of a
free body.

FAMILIES is the one list of them: a family that is added to it is known to the command line, to documents, to
pictures and to published files.
"""
from .family import Family
from .principal import PRINCIPAL
from .tilted import E3, E3_AT_REST
from .vertical import E1, E2

FAMILIES = {family.label: family for family in (E1, E2, E3, E3_AT_REST, *PRINCIPAL)}


def in_a_field() -> list[Family]:
    """The families that are asked for by their label, of a body in a field."""
    return [family for family in FAMILIES.values() if family.asked_for and not family.free]
