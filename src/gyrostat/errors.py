"""Every exception that gyrostat raises on purpose; each is also a builtin."""
import re
from collections.abc import Mapping
from importlib import import_module
from importlib.util import find_spec
from types import ModuleType
from unicodedata import category

# controls, marks of direction, halves of pairs, separators of lines
_STEERING = ("Cc", "Cf", "Cs", "Zl", "Zp")
# an exact number, of which no message quotes more than 60 characters
_LONG = re.compile(r"(?<![\w.])(?=[\d(-]|sqrt|pi|CRootOf)(?:CRootOf\([^()]*\)|sqrt|pi|[\d.*/()+\- ])+")
_WHOLE, _KEPT = 60, 57                                 # characters of one that is quoted, and of a part


class GyrostatError(Exception):
    """The base of all: ``except GyrostatError`` catches what the library refuses, and nothing else."""

    def __str__(self) -> str:
        return _LONG.sub(_cut, printable(super().__str__()))


def printable(text: str) -> str:
    r"""Return the text with what would steer a terminal escaped; lines and tabs stay.

    Examples
    --------
    >>> print(printable("top\x1b[2J"))
    top\u001b[2J
    """
    return text if text.isprintable() else "".join(map(_escaped, text))


def _cut(number: re.Match[str]) -> str:
    """Return the beginning of a long number; what follows it stays apart."""
    whole = number[0]
    if len(whole.strip()) <= _WHOLE:
        return whole
    return f"{whole[:_KEPT].rstrip()}…{' ' if whole.endswith(' ') else ''}"


def _escaped(c: str) -> str:
    if category(c) not in _STEERING or c in "\n\t":
        return c
    return f"\\u{ord(c):04x}" if ord(c) < 0x10000 else f"\\U{ord(c):08x}"


def brief(value: object) -> str:
    """Return a value as a message quotes it, at most 60 characters long."""
    if isinstance(value, str):
        return repr(value if len(value) <= 60 else value[:57] + "...")
    try:
        text = repr(value)
    except ValueError:                                 # an int of more than 4300 digits
        return f"a {type(value).__name__}"
    return text if len(text) <= 60 else text[:57] + "..."


class ArgumentError(GyrostatError, TypeError):
    """An argument is of another kind than the verb takes, such as a scene where an equilibrium is wanted."""


def require(value: object, kind: type, what: str) -> None:
    """Raise ArgumentError unless the value is of the kind wanted."""
    if not isinstance(value, kind):
        raise ArgumentError(f"{what} is {article(type(value))}, not {article(kind)}: check the order and "
                            "kind of the arguments")


def article(kind: type) -> str:
    """Return the name of a kind with its article."""
    return f"a{'n' if kind.__name__[0] in 'AEIOUaeiou' else ''} {kind.__name__}"


class BodyError(GyrostatError, ValueError):
    """The moments of inertia or the gyrostatic momentum cannot belong to a body."""


class PotentialError(GyrostatError, ValueError):
    """The potential does not depend on the direction k, or depends on what it may not."""


class StructureError(GyrostatError, ValueError):
    """A tensor is not a Poisson tensor, or a function is not one of its Casimirs, or not an integral."""


class ScopeError(GyrostatError, NotImplementedError):
    """The verb exists only for a smaller class of scenes than the one given."""


class EquilibriumError(GyrostatError, ValueError):
    """The field does not vanish at the point claimed, or the claim cannot be parametrised as asked."""


class SingularOrbitError(GyrostatError, ValueError):
    """The differentials of the Casimirs are dependent: the coadjoint orbit has a lower dimension there."""


class ExpressionError(GyrostatError, ValueError):
    """A text is not an expression of the grammar, or is one that is made to be slow."""


class ValuesError(GyrostatError, ValueError):
    """The numbers given do not name a point of the family: missing, unknown, not exact or off the family."""


class PublishedError(GyrostatError, ValueError):
    """A file of scenes or of published formulas, or one of its entries, cannot be read.

    The message names the file and the key.
    """


class AccuracyError(GyrostatError, ArithmeticError):
    """A motion is not known to the accuracy asked for: too chaotic, too long, or too many nodes."""


class ResolutionError(AccuracyError):
    """A series is not exhausted by as many nodes as are taken.

    Something else is too close to the motion for it.
    """


class StoreError(GyrostatError, ValueError):
    """A path holds something else than the chart that is to be written to it, or resumed there."""


class MissingExtraError(GyrostatError, ImportError):
    """A package that only an extra of gyrostat brings is not installed; the message has the pip command."""


_EXTRAS = {
    "fast": ("numba",), "charts": ("xarray", "dask", "distributed", "zarr", "netCDF4"),
    "plot": ("matplotlib",),
    "interactive": ("plotly",), "trajectories": ("scipy",), "heyoka": ("heyoka",),
    "completion": ("shtab",)}


def optional(module: str, extra: str) -> ModuleType:
    """Return a module that the extra brings, imported when it is first used."""
    needed({module: extra})
    return import_module(module)


def needed(extras: Mapping[str, str]) -> None:
    """Raise MissingExtraError if one of the modules is missing, each of which its extra brings.

    All that is missing of these extras is named at once.
    """
    missing, failed, reason = list[str](), list[str](), None
    for module, extra in extras.items():
        try:
            import_module(module)
        except ImportError as error:
            reason = reason or error
            failed += [extra] if extra not in failed else []
            missing += [name for name in _EXTRAS[extra] if find_spec(name) is None] or [module]
    if reason is not None:
        missing = list(dict.fromkeys(missing))
        several = len(missing) > 1
        raise MissingExtraError(f"{', '.join(missing)} cannot be imported ({reason}): "
                                f"{'they are' if several else 'it is an'} optional "
                                f'package{"s" if several else ""}; install {"them" if several else "it"} '
                                f'with pip install "gyrostat[{",".join(failed)}]"') from reason
