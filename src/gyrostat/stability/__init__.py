"""Decides the stability of an equilibrium, from its two matrices to a verdict with a reason.

At an equilibrium the field is linearised and the energy is varied twice; `criteria` makes inequalities of
both. A verdict comes with what decided it and with the reason, as a `decision`, about a `notion` of
stability. The `ladder` is a list of rungs, and an equilibrium at numbers is `standing` on the first that
applies: the criteria, then `theorems` about terms of higher order, and `normal_forms` if gyroscopic forces
stabilise a maximum (`deciders` has the interfaces of what decides between the criteria). `damping` says what
remains stable if the body loses energy inside. A `report` keeps what is derived for one equilibrium. For
equilibria found in lists a `form` has the second variation in numbers, and its `spectrum` gives frequencies
and growth rate.
"""
