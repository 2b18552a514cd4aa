"""All relative equilibria of a scene, and what becomes of them along a parameter.

`search` is the one verb: it asks the finder for the scene's kind (`finders`) for a complete list. Each is a
`relative_equilibrium`, decided by its form in the same way for every kind of scene; `doubles` has its numbers
rounded, `attitude_in_orbit` its attitude as engineers write it, and `table_rows` makes a table of a list,
with `well_columns` if they are asked for. One that is named is found `in_its_list`.
`continuation` follows them along a parameter, through the values at which they meet, appear or
vanish. `curves` has the sets that they form: Staude's cone and its arcs, regular precessions, and the
critical points of the amended potential. `wells` has how much a stable one survives: the barriers round it.
"""
