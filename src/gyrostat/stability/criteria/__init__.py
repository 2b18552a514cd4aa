"""The spectral, the formal and the secular criterion: inequalities, and whether they hold.

`linearization` gives the linearised field on the orbit with its characteristic polynomial, `energy_casimir`
the second variation on the symplectic slice. Their closed forms are in `amended_form` for permanent rotations
and in `orientation_form` for a body at rest in the frame of two directions. `sextic` factors a polynomial in
λ² and gives the signs that it needs, `three_criteria` makes the criteria, `conditions` writes them as
inequalities, and `implication` drops those that follow from others. Long conditions are written in
`defined_names`: those of rotations in `closed_form`, those of bodies at rest in `sextic_in_names`.
`short_sufficient` gives short inequalities that suffice. At numbers, `numbers_asked` reads the names,
`number_notes` says what is unusual about the numbers, and `truth` tells whether a criterion holds.
"""
