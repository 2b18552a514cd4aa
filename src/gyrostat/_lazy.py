"""Loads what is used for the first time: the names of a package, a theorem."""
import sys
from collections.abc import Callable, Mapping
from importlib import import_module
from typing import Any


def later(package: str, homes: Mapping[str, str]) -> tuple[Callable[[str], Any], Callable[[], list[str]]]:
    """Return what a package has for __getattr__ and __dir__.

    Parameters
    ----------
    package : str
        its name
    homes : mapping
        the modules, each with the names that are taken from it, separated by blanks; one without names is
        itself what is taken
    """
    home = {name: module for module, names in homes.items() for name in names.split() or [module]}

    def found(name: str) -> Any:
        if name not in home:
            raise AttributeError(f"{package} has no {name}: dir({package}) lists what there is")
        module = import_module(f"{package}.{home[name]}")
        value = getattr(module, name) if homes[home[name]] else module
        setattr(sys.modules[package], name, value)         # next time it is there
        return value

    def listed() -> list[str]:
        return list(sys.modules[package].__all__)

    return found, listed


def loaded(home: str) -> Any:
    """Return what is named module:name, below the package; the module is loaded when this is asked.

    Examples
    --------
    >>> loaded("errors:ValuesError").__name__
    'ValuesError'
    """
    module, name = home.split(":")
    return getattr(import_module(f"{__package__}.{module}"), name)
