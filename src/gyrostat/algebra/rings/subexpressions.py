"""Lists the parts of one kind in an expression, in an order that does not change from run to run."""
from sympy import Expr, preorder_traversal


def occurring(expression: Expr, *kinds: type) -> list[Expr]:
    """Return the different parts of these kinds, in the order in which they stand.

    SymPy's own atoms and free_symbols are sets of texts and objects: PYTHONHASHSEED changes their order.

    Examples
    --------
    >>> from sympy import Pow, Symbol, sqrt
    >>> a, b = Symbol("a"), Symbol("b")
    >>> occurring(sqrt(a) + b * sqrt(a + sqrt(b)), Pow)
    [sqrt(a), sqrt(a + sqrt(b)), sqrt(b)]
    """
    return list(dict.fromkeys(part for part in preorder_traversal(expression) if isinstance(part, kinds)))
