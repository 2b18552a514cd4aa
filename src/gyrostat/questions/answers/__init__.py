"""What the documents and the verbs ask the library, and how they name it.

`equilibria` finds the equilibria that are asked for, by their `equilibrium_labels` or as a point, with
their reports. A `report_list` has the derivations and decisions of them, a `condition_list` the conditions,
with what decides `between_criteria`, the condition of a dual spinner (`energy_sink`) and the
`closed_wells`. `solve_for` solves them for a parameter, `wheel_answer` for the speed of a wheel, and
`brief_solutions` shortens the sets. `answers` gives the decisions of decide, of one equilibrium or an
`answer_list` of all, which an `answer_table` shows at a glance, and which `answer_rows` gives for CSV and
`answer_latex` for a paper; `arcs` those along curves.
"""
