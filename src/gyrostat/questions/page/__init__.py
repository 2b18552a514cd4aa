"""What a page shows of a scene and an equilibrium of it, as data for JSON.

An equilibrium is `chosen`, and what is asked of it is `shown`: blocks are `typeset` in LaTeX, the margins and
the equations of motion become `programs` that a page runs itself, `chart_edges` are the exact boundary of a
chart, and `copies` are LaTeX, Python and a scene file to take away.
"""
