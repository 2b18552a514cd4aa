"""Everything that is derived, as Unicode, LaTeX and JSON.

What is found becomes `blocks`: headings, sentences and displayed formulas (`results`). Their terms, factors
and sides stand in one `order`, their `numbers` in one form, in `letters` that the scene leaves free, and
`nomenclature` lists what they mean. `formats` writes blocks for a terminal, as LaTeX or as JSON. `files` are
whole or not there.
"""
