"""Blocks and formulas, written for a terminal, as LaTeX and as JSON.

`unicode` writes a formula in one line, `text` a document for a terminal. `latex` writes a formula, with the
`latex_names` that a paper has for ours; `linebreaks` breaks it where it is wider than a line. `article` is a
document in LaTeX, with `prose`, and with the works that it cites (`references`), `tables` has the conditions
alone. `json_data` writes data, `exact_text` their numbers as expressions, `exact_numbers` by polynomials.
`text_tables` aligns columns for a terminal, with `si_units` in the titles if the numbers given have units;
`csv_rows` and `latex_rows` write tables to files.
"""
