"""How stable: the well of the energy round a motion, its passes, and the kicks that stay inside.

`well` is the one answer, `RelativeEquilibrium.well`, and `find_well` finds it. Its energy is a function on a
sphere or on the attitudes (`landscape`), from whose critical points `paths` lead down, certified in balls
(`in_balls`); which of them join (`merge_tree`) tells what the well meets first, and how all wells of its
level become one (`joining`). `contained` tells whether a state is inside, and `damped` whether it
comes back. `kicks` has the impulses and the tilts that are too weak, `within` those that keep a vertical axis
within an angle, by the least energy on `circles`. Where the tilt alone moves, the energy is a function of one
variable (`tilt_line`), and its wells are exact (`tilts`). With names for numbers, `closed_forms` has those
that are known as formulas.
"""
