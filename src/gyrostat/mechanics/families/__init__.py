"""Equilibria that have names, and tables of texts that name them.

`family` says what is known of each family, and `named_families` lists all of them. In a field `vertical`
makes E1 and E2, `tilted` E3, `permanent_rotation` all rotations about the vertical; of a free body
`principal_rotation` makes those about an axis. `steady_motion` makes motions of a body in two directions.
`circular_orbit` puts a satellite into the frame of its orbit, whose rate `orbit_rates` has from a height or a
period, and `holding_rotor` lets it point at the Earth there, `held_attitude` by turning it;
`orbital_precession` makes the precessions of a symmetric one, `release` lets one go. `scene_tables` reads a
body, its field, an equilibrium and numbers from a table, as a [scene.NAME] of a file; its `scene_entries`
with parts are rotors, an orbit and directions.
`named_entries` are those of a body and its orbit by their names.
"""
