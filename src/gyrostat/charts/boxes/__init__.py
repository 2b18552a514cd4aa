"""Verdicts that are proved for every point of a box of parameters, by interval analysis.

`intervals` rounds outward after each operation, and `box_enclosures` encloses an expression on many boxes at
once. `regions` are what a user asks about, `proofs` says what a report proves there, `paving` bisects until
something is proved, and `certified_boxes` has the verbs.
"""
