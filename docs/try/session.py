"""What the page asks of the library: one function, JSON in, JSON out."""
import json

from gyrostat.errors import GyrostatError
from gyrostat.questions import show


def answer(question: str) -> str:
    """The answer to a question, an object with `want`, one of WANTED, and `scene`, the keys of a scene file.

    Parameters
    ----------
    question : str

    Returns
    -------
    str
        an object; with `error` where the library refuses, in its own words
    """
    try:
        asked = json.loads(question)
        return json.dumps(show(asked["scene"], asked["want"], *asked.get("more", ())))
    except GyrostatError as error:
        return json.dumps({"error": str(error)})
    except MemoryError:
        return json.dumps({"error": "this needs more memory than a page has: write it more simply, or ask "
                                    "the library on your own machine"})
    except Exception as error:                         # whatever is typed, the page goes on
        return json.dumps({"error": f"internal error, {type(error).__name__}: {str(error)[:200]}; it is a "
                                    "bug, please report it"})
