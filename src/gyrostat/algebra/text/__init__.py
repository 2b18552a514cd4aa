"""Text of a user becomes an exact expression, through a whitelist and without evaluation.

`inputs` bounds files and lines before their parsers see them. `spelling` turns the letters of papers, π₃⁰ and
ω, into ASCII, `scanner` cuts a text into tokens, plain numerals at once, and `grammar` makes an expression of
them. Each of the `bounded_parts` of a text carries bounds on what its expansion would cost, `magnitudes` says
how large a constant is before it is computed, and `limits` refuses what would be slow. `units` are
those that `quantities` may have, `tensors` reads vectors and tensors with one unit, `tensor_entries` makes
them exact, and `numbers` reads all numbers and expressions of users, texts or not.
"""
