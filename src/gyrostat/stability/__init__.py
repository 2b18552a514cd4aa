"""From two matrices to a verdict.

At an equilibrium the field is linearised and the energy is varied twice; `criteria` makes inequalities of
both. A verdict comes with what decided it and with the reason, as a `decision`. The `ladder` asks the
criteria first; where they are silent it asks `theorems` about terms of higher order, and `normal_forms` where
gyroscopic forces stabilise a maximum. `damping` says what is left when the body loses energy inside. A
`report` keeps what is derived of one equilibrium and gives its verdicts at numbers.
"""
