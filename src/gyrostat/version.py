"""The version of the library, which data carry."""

__version__ = "0.1.0"
