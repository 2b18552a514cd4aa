"""Curves of relative equilibria, with the verdicts along them.

`staude` has the cone of directions about which a body in a field turns permanently, `staude_arcs` its arcs
where omega² is positive. With a rotor these are `rate_curves`, cut into `gyrostat_arcs`. `amended_potential`
has the rotations on a level as its critical points. For a body of revolution, `precessions` are the regular
ones at fixed momentum, and `critical_values` their energies.
"""
