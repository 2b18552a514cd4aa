"""Answers Ctrl-C while the command line is being loaded: with one line and exit status 130, as later on."""
import os
import signal
import sys
from pathlib import Path
from typing import Any


def _is_command() -> bool:
    """Whether this process is gyrostat, or python -m gyrostat, and not a program that imports the library."""
    if sys.argv[:1] == ["-m"]:                             # the module is still looked for
        return sys.orig_argv[sys.orig_argv.index("-m") + 1] == "gyrostat" if "-m" in sys.orig_argv else False
    return bool(sys.argv) and Path(sys.argv[0]).stem == "gyrostat"


def _quit(*_: Any) -> None:
    os.write(2, b"gyrostat: interrupted before anything was done\n")
    os._exit(130)


if _is_command() and signal.getsignal(signal.SIGINT) is signal.default_int_handler:
    signal.signal(signal.SIGINT, _quit)                    # until main takes over
