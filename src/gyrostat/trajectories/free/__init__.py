"""The exact motion of a free body or gyrostat.

A motion is `uniform`, or runs along a polhode by Jacobi's functions (`polhodes`), or, with any rotor, around
a closed curve by one turn of Taylor's method in balls (`taylor`), `repeated`; `motion` puts momentum and
attitude together.
"""
