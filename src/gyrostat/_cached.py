"""Provides functools.cached_property as Python 3.12 has it: without a lock."""
import sys
from functools import cached_property as _locked
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING or sys.version_info >= (3, 12):
    from functools import cached_property
else:
    class cached_property(_locked):
        """A property that is computed when it is first asked for, and kept; two threads may compute it twice.

        In Python 3.11 one lock serves a property of all objects. A thread that holds it and waits for the
        enclosures, which another thread has, waits for ever if that one asks for the same property.
        """

        def __get__(self, instance: Any, owner: type | None = None) -> Any:
            """Return the value; this is called only if none is kept."""
            if instance is None:
                return self
            value = instance.__dict__[self.attrname] = self.func(instance)
            return value

__all__ = ["cached_property"]
