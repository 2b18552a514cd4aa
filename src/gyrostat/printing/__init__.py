"""Everything that is derived, as Unicode, LaTeX and JSON.

What is found becomes `blocks`: headings, sentences and displayed formulas (`results`). One `order` is kept
for terms, factors and sides, one form for `numbers`, which `cells` makes short for columns, with long
coefficients as `decimals`, and the `letters` are those that the scene leaves free. `nomenclature` lists what
the symbols mean, `glossary` what the terms mean. `formats` writes blocks for a terminal, as LaTeX or as JSON.
`files` are written whole or not at all.
"""
