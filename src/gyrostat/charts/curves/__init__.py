"""The curves in a chart, each point of them moved along a line of the grid to the last bits.

`crossings` finds the edges of the grid on which a sign changes, `contours` joins them to the boundaries
between verdicts, and `window_curves` follows resonances and D4 = 0 in windows, where gyroscopic forces
stabilise.
"""
