"""What a well bears: the impulses that leave a motion inside, and the angles.

`kicks` has the impulses and the tilts that are too weak to lift a motion over a barrier, `spin_kicks` those
of a free gyrostat, and `within` those that keep a vertical axis within an angle, by the least energy on
`circles`. After a change of the speed of a rotor `motors` finds the well that holds the motion.
"""
