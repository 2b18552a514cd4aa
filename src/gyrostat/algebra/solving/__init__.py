"""Signs on domains, and complete lists of roots and zeros, all exact.

`margins` tells the sign of a polynomial on a domain, `binary_forms` the signs of forms in two variables,
`definite_combination` which combination of matrices is definite. `roots` isolates all real roots of a
polynomial, as numbers that `root_numbers` lets SymPy evaluate; `zeros` does so for any expression in one
name. Where polynomials vanish on a sphere, `sphere_curves` splits the curves off, `sphere_points` finds the
points that are left, in `real_fields`, and `sphere_zeros` gives both. Zeros that come in pairs ±k are found
by one resultant, in `opposite_zeros`, as `common_points` of two plane curves. Of a plane curve F(x, t) = 0,
`plane_curves` finds common points with others, `stations` where its branches meet, begin and end as t grows,
`plane_branches` the branches between.
"""
