"""Every exception that gyrostat raises on purpose; each is also a builtin."""
from importlib import import_module
from types import ModuleType


class GyrostatError(Exception):
    """Base of all of them: ``except GyrostatError`` catches what the library refuses, and nothing else."""


class ArgumentError(GyrostatError, TypeError):
    """An argument is of another kind than the verb takes, such as a scene where an equilibrium is wanted."""


def require(value: object, kind: type, what: str) -> None:
    """Raise ArgumentError unless the value is of the kind wanted."""
    if not isinstance(value, kind):
        raise ArgumentError(f"{what} is a {type(value).__name__}, not a {kind.__name__}: check the order and kind of the arguments")


class BodyError(GyrostatError, ValueError):
    """The moments of inertia or the gyrostatic momentum cannot belong to a body."""


class PotentialError(GyrostatError, ValueError):
    """The potential does not depend on the direction k, or depends on what it may not."""


class StructureError(GyrostatError, ValueError):
    """A tensor is not a Poisson tensor, or a function is not one of its Casimirs."""


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
    """A file of published formulas, or one of its formulas, cannot be read; the message names the file and the key."""


class AccuracyError(GyrostatError, ArithmeticError):
    """A motion is not known to the accuracy asked for: too chaotic, too long, or too many nodes."""


class StoreError(GyrostatError, ValueError):
    """A path holds something else than the chart that is to be written to it, or resumed there."""


class MissingExtraError(GyrostatError, ImportError):
    """A package that only an extra of gyrostat brings is not installed; the message has the pip command."""


def optional(module: str, extra: str) -> ModuleType:
    """A module that the extra brings, imported when it is first used."""
    try:
        return import_module(module)
    except ImportError as error:
        raise MissingExtraError(f"{module} cannot be imported ({error}): it is an optional package; "
                                f'install it with pip install "gyrostat[{extra}]"') from error
