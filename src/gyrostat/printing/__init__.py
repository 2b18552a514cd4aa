"""Everything that is derived, as Unicode, LaTeX and JSON.

Findings become `blocks`: headings, sentences, displayed formulas, put together for a scene and a report
(`document`) and for sets, branches and bifurcations (`results`). Terms and the sides of an inequality stand
in one `order`. `unicode` writes them for a terminal, `latex` as formulas, `article` as documents with broken
lines (`linebreaks`) and the works they cite (`references`), `data` as JSON. `files` are whole or not there.
"""
