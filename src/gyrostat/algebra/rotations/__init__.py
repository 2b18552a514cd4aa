"""Critical points of a function of degree 2 on the rotations: all of them, proved, by a quartic form.

`quartic_forms` writes the function as a form in a quaternion. `bounds` says how many critical points there
are at most, `boxes` approximates all at once and proves a simple one in each box, `critical_rotations`
compares the numbers: then they are all. `exact_rotations` has them in number fields, multiple ones too.
`symmetries` are the turns under which the function stays; then it is one of a unit vector, `by_axis`.
If the form depends on a parameter, `meeting_polynomial` has the values at which some meet, and
`followed_rotations` goes along it; `modular_fractions` finds fractions modulo primes.
"""
