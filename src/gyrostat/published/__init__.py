"""Checks published formulas, exactly as they are printed, against what the library derives.

A source is a file (`sources`) of `statements` about `scenes`, in a small `language`. `names` derives what a
formula may name, `checks` compares the formula with what is derived, and `independent` confirms each
counterexample from Newton and Euler's equations. `listing` shows what was found as text and JSON, with the
`hypotheses` of each statement. `latex` writes a document of two tables (`longtable`): the misprints
(`errata`) and what is confirmed (`confirmations`). `printed_latex` typesets a formula as it is printed.
"""
from .checks.findings import Finding, check
from .sources import SOURCES, Source, load
from .statements import Counterexample, Outcome, Statement

__all__ = ["check", "Counterexample", "Finding", "load", "Outcome", "Source", "SOURCES", "Statement"]
