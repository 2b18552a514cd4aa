"""Published formulas: exactly as printed, each checked against what the library derives.

A source is a file (`sources`) of `statements` about `scenes`, in a small `language`. `names` derives what a
formula may name, `checks` compares the formula with what is derived, and `independent` confirms each
counterexample from Newton and Euler's equations. `listing` shows what was found as text and JSON, with the
`hypotheses` of each statement, `errata` the misprints in LaTeX, each formula as it is printed
(`printed_latex`).
"""
from .checks.findings import Finding, check
from .sources import SOURCES, Source, load
from .statements import Counterexample, Outcome, Statement

__all__ = ["check", "Counterexample", "Finding", "load", "Outcome", "Source", "SOURCES", "Statement"]
