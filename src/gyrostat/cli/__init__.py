"""The command line: gyrostat VERB --option.

`start` answers Ctrl-C while the rest is loaded. `parser` reads the options, with the words of `help`; it says
which one was likely meant (`did_you_mean`) and writes the script with which a shell completes (`completion`).
`run_verb` calls the verb, a module of `verbs`, within its `time_limit`. A verb takes a scene and numbers from
its `options`, asks `gyrostat.questions`, for each line of a file in a `batch`, and writes to `output`.
"""
