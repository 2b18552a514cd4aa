"""The exact motion of a body of revolution in U(k3).

The `level` of a motion is a handful of exact numbers; its g(k3), in balls (`profiles`), has proved
`turning_points`, between which k3 moves by elliptic functions (`nutation`). Two angles of the Cayley-Klein
parameters (`cayley_klein`) have smooth `integrands`, whose integrals (`integrals`) converge spectrally
(`quadrature`); `precession` holds every constant in balls, `doubles` rounds them and states follow, `motion`
answers at any times.
"""
