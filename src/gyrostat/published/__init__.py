"""Published formulas: exactly as printed, each checked against what the library derives.

A source is a file (`sources`) of `statements`; their texts are `readings` of a small `language`, with
`comparisons`, of `names` that a scene has (`scenes`, `kinematics`, `jacobi`, `rotations`, `windows`).
`checks` compares each with what is derived: `formulas`, `criteria` and `claims`, at points of `sampling` and
`search`. A counterexample is made in one place (`evidence`, of `truths` and `sides`) and confirmed from
Newton and Euler's equations (`independent`, in the names of `independent_names`, with
`independent_kinematics`, `independent_rotations`, `independent_separatrix` and `independent_windows`, of
`independent_oscillations` in `independent_series`). `listing`, `typesetting` and `errata` show what was
found.
"""
from .checks.findings import Finding, check
from .sources import SOURCES, Source, load
from .statements import Counterexample, Outcome, Statement

__all__ = ["check", "Counterexample", "Finding", "load", "Outcome", "Source", "SOURCES", "Statement"]
