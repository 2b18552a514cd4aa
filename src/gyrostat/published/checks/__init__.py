"""Compares each published statement with what the library derives.

`findings` refuses a source with `unknown_names`, then takes its statements one by one. `readings` reads their
texts, and `comparisons` the conditions among them. `formulas` checks identities and numbers, `claims` checks
conditions and verdicts, by `criteria` in normal form or by their `sign_patterns`, and `counts` counts
equilibria. Formulas are compared at points of `sampling`; a condition is tried at `failing_points`. What is
shown against a statement is made in one place (`evidence`): by what is true at a point (`truth_at_point`) and
by the values of `both_sides`. `routes` says how a statement was confirmed.
"""
