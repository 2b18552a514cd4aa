"""How stable: the well of the energy round a motion, its passes, and the kicks that stay inside.

`well` is the one answer, `RelativeEquilibrium.well`. Its energy is a function on a sphere or on the attitudes
(`landscape`), from whose critical points `paths` lead down, certified in balls; which of them join tells what
the well meets first (`merge_tree`). `kicks` has the impulses that are too weak. Where the tilt alone moves,
the energy is a function of one variable (`tilt_line`), and its wells are exact (`tilts`). With names for
numbers, `closed_forms` has those that are known as formulas.
How far k goes after a kick is asked with or without a pass (`within`), by V on circles (`circles`).
"""
