"""Turns what is found into headings, sentences and formulas, before any typesetting.

`document` is a whole report: its `scene`, the point, both matrices and the `inequalities`; `boundary`,
`drift` and `normal_form` say what decides between the criteria, `rotations` which names a family in any
direction has, `two_directions` what is special of two. `decision` is a verdict at numbers. `beyond_reports`
has every other result, with `critical_points` for rotations and satellites, `wheel_speeds` for attitudes in
orbit, `staude` for Staude's cone, `well` for barriers and kicks and `closed_wells` for their formulas.
"""
