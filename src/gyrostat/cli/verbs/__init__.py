"""The verbs: each module has run(given, out), which returns the exit status.

`report` shows a derivation, `conditions` the inequalities, `decide` verdicts at numbers, `chart` verdicts
over a grid, `motion` a motion from a state on, `plot` a picture, and `verify` checks published formulas.
"""
