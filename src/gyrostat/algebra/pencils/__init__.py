"""Points of a sphere that a symmetric pencil of matrices takes to a vector: equilibria at a rate.

`exact_points` finds all of them by resultants, exactly; with numbers of high degree `enclosed_points` finds
them in balls, if all are simple.
"""
