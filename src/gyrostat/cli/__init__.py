"""The command line: gyrostat VERB --option.

`parser` understands it, `carried` runs the verb, a module of its name, within its time (`watch`, `worker`);
`options` make scenes and numbers of texts; `output` writes. `start` answers Ctrl-C while the rest is being
loaded.
"""
