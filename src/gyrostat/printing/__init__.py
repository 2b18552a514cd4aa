"""Everything that is derived, as Unicode, LaTeX and JSON.

Findings become `blocks`: headings, sentences, displayed formulas, put together for a scene and a report
(`document`) and for sets, branches and bifurcations (`results`). Terms and the sides of an inequality stand
in one `order`. `unicode` writes formulas and `text` documents for a terminal, `latex` formulas and `article`
documents with broken lines (`linebreaks`) and the works they cite (`references`), `data` JSON. `files` are
whole or not there.
"""
