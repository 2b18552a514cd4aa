"""Carries out a verb: returns the exit status, and tells an error in one line on standard error."""
import argparse
import errno
import gc
import os
from importlib import import_module
from types import ModuleType

from ..errors import GyrostatError, ValuesError
from .output import Output, internal, silenced, told
from .time_limit import watched

_WRONG_PATH = (errno.ENOENT, errno.EISDIR, errno.ENOTDIR, errno.EACCES)
# in the environment: an internal error comes with its traceback
DEBUG = "GYROSTAT_DEBUG"


def carried_out(given: argparse.Namespace, limited: bool) -> int:
    """Run the verb, limited to its time in a process of its own; the exit status."""
    try:
        with Output(given.output) as out:
            for option in ("fragment", "symbols", "label"):
                if getattr(given, option, None) and given.format != "latex":
                    raise ValuesError(f"--{option} is for LaTeX, and --format is {given.format}: "
                                      "add --format latex")
            if limited and given.timeout is not None and getattr(given, "batch", None) is None:
                watched(given.verb, given.timeout, given.output)
            status = int(_loaded(given.verb, limited).run(given, out))
        if limited:
            gc.freeze()                                # the process ends, with whatever is left
        return status
    except GyrostatError as error:
        told(str(error))
    # the reader has seen enough, as in gyrostat report | head
    except BrokenPipeError:
        silenced()
        return 0
    except OSError as error:
        silenced()
        hint = ": check the path, or name another file" if error.errno in _WRONG_PATH and given.output else ""
        told(f"cannot write {given.output or 'to standard output'}: {error.strerror or error}{hint}")
    except KeyboardInterrupt as error:
        told(f"interrupted; {getattr(error, 'kept', '') or _kept(given)}")
        return getattr(error, "status", 130)
    except MemoryError:
        told("there is not enough memory for this: ask for less")
    except Exception as error:
        if os.environ.get(DEBUG):
            raise
        told(f"{internal(error, 300)}; it is a bug, please report it with what you typed "
             f"({DEBUG}=1 shows where it is)")
    return 2


def _loaded(verb: str, own: bool) -> ModuleType:
    """Import the module of a verb; in a process of its own it is never searched for garbage."""
    if own:
        gc.disable()
    module = import_module(f".verbs.{verb}", __package__)
    if own:
        gc.freeze()
        gc.enable()
    return module


def _kept(given: argparse.Namespace) -> str:
    """Say what is left of a verb that was interrupted, and how to go on."""
    if given.output is None:
        return "nothing is kept, the same command begins anew"
    if given.output.endswith(".zarr"):
        return f"{given.output} keeps the blocks that are written, the same command goes on with the others"
    return f"{given.output} is as it was before, the same command begins anew"
