"""Everything that is derived, as Unicode, LaTeX and JSON.

Findings become `blocks`, sentences and displayed formulas: where an equilibrium exists, such as abs(k3) < 1,
and its criteria (`conditions`), what decides between them (`boundary`, `drift`), a `decision` at numbers, the
`document` of a report with its `scene`, other `results` (`critical_points`, `rotations` in any direction,
Staude's cone in `staude`, a `normal_form`). Terms and the sides of an inequality stand in one `order`.
`unicode` writes formulas and `text` documents for a terminal, each in `letters` that the scene leaves free,
`latex` formulas in the symbols of a paper (`names`) and `article` documents with broken lines (`linebreaks`)
and the works they cite (`references`), `tables` the conditions alone, both with what their `symbols` are;
`data` JSON. `files` are whole or not there.
"""
