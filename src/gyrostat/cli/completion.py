"""gyrostat --print-completion SHELL: a script by which the shell completes what is typed, without Python."""
import argparse
from typing import Any

from ..errors import MissingExtraError, optional
from .output import printed, told

SHELLS = ("bash", "zsh", "fish", "tcsh")


class PrintCompletion(argparse.Action):
    """Print the script of a shell and end, as --version does."""

    def __call__(self, parser: argparse.ArgumentParser, namespace: argparse.Namespace, shell: Any,
                 option_string: str | None = None) -> None:
        """Print it; exit status 2 where shtab is missing."""
        try:
            shtab = optional("shtab", "completion")
        except MissingExtraError as error:
            told(str(error))
            parser.exit(2)
        with_files(parser, shtab.FILE)
        printed(shtab.complete(parser, shell))
        parser.exit()


def with_files(parser: argparse.ArgumentParser, file: Any) -> None:
    """Say what is the name of a file: what is shown as FILE, and the sources of verify."""
    for action in parser._actions:
        if isinstance(action, argparse._SubParsersAction):
            for inner in action.choices.values():
                with_files(inner, file)
        elif str(action.metavar).startswith(("FILE", "SOURCE")):
            action.complete = file  # type: ignore[attr-defined]
