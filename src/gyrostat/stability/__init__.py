"""From two matrices to a verdict.

At an equilibrium the field is linearised and the energy is varied twice; `criteria` makes inequalities of
both. A verdict comes with what decided it and with the reason, as a `decision`, of a `notion` of stability.
The `ladder` is a list of rungs, and an equilibrium at numbers is `standing` on the first that applies: the
criteria, then `theorems` about terms of higher order, and `normal_forms` where gyroscopic forces stabilise a
maximum (`deciders` says what each of them answers). `damping` says what is left when the body loses energy
inside. A `report` keeps what is derived of one equilibrium; of those found in lists a `form` has the second
variation in numbers, and its `spectrum` frequencies and growth rate.
"""
