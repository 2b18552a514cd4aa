"""What options mean: a scene, numbers, axes of a chart, LaTeX.

`scene_options` declares the options that name a scene, and `scene_files` fills them from a file.
`scene_texts` makes the body and the field of them, `options` the exact numbers and the axes. `latex_options`
says how LaTeX is written.
"""
