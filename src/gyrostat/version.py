"""The version of the library, and those of what it writes."""

__version__ = "0.1.0"
DOCUMENT_FORMAT = 3                     # of every JSON document that the command line prints, its "format"
STORE_FORMAT = 2                        # of a store of a chart: one of another format is not continued
