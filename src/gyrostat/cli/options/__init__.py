"""What options mean: a scene, an axis of a chart, a motion, LaTeX.

`scene_options` declares the options that name a scene, and `scene_files` fills them from a file;
`units_given` tells whether their numbers have units, and `units_shown` writes those of SI behind results.
`axis_option` has the values of an axis, `motion_options` a motion and its times. `latex_options` say how
LaTeX is written. `kinds_of_pictures` declares the pictures, and `picture_options` say how one is written.
"""
