"""The exact motion of a body of revolution in U(k3).

The `level` of its integrals is a handful of exact numbers; on it g(k3), in balls (`profiles`), has proved
`turning_points`, between which k3 moves by elliptic functions (`nutation`). Two angles of the Cayley-Klein
parameters (`cayley_klein`) have smooth `integrands`, whose integrals (`series_integrals`) converge spectrally
(`quadrature`). `precession` holds every constant in balls, `precession_in_doubles` rounds each once, and
`top_motion` answers at any times.
"""
