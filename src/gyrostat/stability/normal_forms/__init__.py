"""Decides if gyroscopic forces stabilise a maximum: Birkhoff's normal form and Arnold's theorem.

`orbit_chart` writes the energy in canonical coordinates of the orbit, `local_motion` expands it at exact
numbers, and `birkhoff` brings it to its normal form; `d4_by_averages` has the determinant D4 without
eigenvalues. `windows` decides by Arnold's theorem, and `resonances` where that theorem is silent, at
frequencies in the ratios 1:1, 1:2 and 1:3. `normal_form` gives users the form itself, `d4_along_family` D4 in
names.
"""
