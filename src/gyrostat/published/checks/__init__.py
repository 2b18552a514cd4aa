"""Each published statement, compared with what the library derives.

`findings` takes the statements of a source one by one; `readings` reads their texts, `comparisons` the
conditions among them. `formulas` checks identities and numbers, `claims` conditions and verdicts, by
`criteria` in normal form or their `sign_patterns`, and `counts` how many equilibria there are. Formulas are
compared at points of `sampling`; a condition may fail at `failing_points`. What is shown against it is made
in one place (`evidence`): by what is true there (`truth_at_point`) and by the values of `both_sides`.
`routes` says how a statement was confirmed.
"""
