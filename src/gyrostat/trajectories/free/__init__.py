"""The exact motion of a free body or gyrostat.

It is a `uniform_motion`, or the momentum runs along one of the `polhodes` by Jacobi's functions, or, with any
rotor, around a closed curve: by one turn of Taylor's method in balls (`taylor`), a `repeated_turn`.
`free_motion` puts momentum and attitude together.
"""
