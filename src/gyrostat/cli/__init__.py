"""The command line: gyrostat VERB --option.

`parser` understands it, or says what was `meant`, with the words of `help` and a script for `completion`;
`carried` runs the verb, a module of its name, within its time (`watch`): `report`; `conditions`, with
`solve_for`; `decide`, which gives `answers`, of a `batch` line by line (`batch_lines`, `batch_worker`), or
`arcs`; `chart`; `motion`; `plot`; `verify`.
`options` make scenes and numbers of texts, `labels` say which equilibria they name, `output` writes,
`printing` says it: a criterion, or where an equilibrium exists, in `printing.conditions`. `start` answers
Ctrl-C while the rest is being loaded.
"""
