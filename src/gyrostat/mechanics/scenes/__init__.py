"""A scene: a body and its field, assembled into a Lie-Poisson system.

`body` holds inertia and rotor, which `rotors` computes from data sheets; `principal_axes` turns it into its
principal axes, `body_names` inserts its numbers into formulas. A `potential` is a U(k) with its derivatives:
`entered_potential` makes it of what a user gives, `potential_hints` says what was likely meant, `fields` has
those with names. `functions_on_sphere` brings a U to a normal form. `coupled` adds a second direction and a
term linear in π, with which `vehicles` move in a fluid. The bracket and every sign convention are in
`lie_poisson`. `equations` has the motion, `integrals` what it conserves, and `system` assembles all of it;
what kind of scene that is, `kind` names.
"""
