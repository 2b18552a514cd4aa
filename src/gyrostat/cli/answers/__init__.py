"""What several verbs ask the library, and how they name it.

`equilibria` finds the equilibria that are asked for, by their `equilibrium_labels` or as a point, with their
reports. `answers` gives the decisions of decide, of one equilibrium or an `answer_list` of all, `arcs` those
along curves. For conditions `between_criteria` says what decides between the two, `solve_for` solves them for
a parameter, and `energy_sink` has the condition of a dual spinner. `motion_options` makes a motion.
"""
