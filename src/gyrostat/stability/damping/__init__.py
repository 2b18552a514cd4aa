"""Says what internal damping makes of an equilibrium, by the second variation with the Casimirs alone.

`secular` tells whether it stays stable if the body loses energy inside, `secular_two_directions` does so in
the frame of two directions, and `growing_modes` counts what grows. `energy_sink` has the condition of a dual
spinner with a damper in each body.
"""
