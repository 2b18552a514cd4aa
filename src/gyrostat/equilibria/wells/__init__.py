"""How stable: the well of the energy round a motion, its passes, and the kicks that stay inside.

`well` is the one answer, `RelativeEquilibrium.well`, and `find_well` finds it: a `basin` on its level, beside
which stands that in the `frame` that turns with a rotation, whatever C1 is. Its energy is a function on a
sphere or on the attitudes (`landscape`), from whose critical points `paths` lead down, certified in balls
(`in_balls`); which of them join (`merge_tree`) tells what the well meets first, and how all wells of its
level become one (`joining`). `contained` tells whether a state is inside, `damped` whether it comes back, and
`disturbances` what is too weak to lead out. Where the tilt alone moves, the energy is a function of one
variable (`tilt_line`), and its wells are exact (`tilts`). With names for numbers, `closed_forms` has those
that are known as formulas.
"""
