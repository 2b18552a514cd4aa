"""Finds the generators of the ring of an expression: symbols, roots, sines, exponentials, logarithms."""
from flint import fmpz
from sympy import Add, Expr, Integer, Mul, Pow, Rational, cos, cosh, exp, log, pi, sin, sinh, tan, tanh

_HYPERBOLIC = (sinh, cosh, tanh)
PRIMES = 2**15                                         # up to which integers in logarithms are factored


def collect(node: Expr, seen: set[Expr], plain: dict[Expr, None], squares: dict[Expr, Expr]) -> None:
    """Enter the generators of an expression: roots and sines with their squares, everything else as it is."""
    if node in seen or isinstance(node, Rational):
        return
    seen.add(node)
    parts: tuple[Expr, ...] = ()
    if isinstance(node, (Add, Mul)):
        parts = node.args
    elif isinstance(node, Pow) and isinstance(node.exp, Integer):
        parts = (node.base,)
    elif isinstance(node, _HYPERBOLIC):
        parts = (node.rewrite(exp),)
    elif (same := spelt_once(node)) is not None:
        parts = (same,)
    elif isinstance(node, Pow) and isinstance(node.exp, Rational) and node.exp.q == 2:
        collect(node.base, seen, plain, squares)
        squares.setdefault(Pow(node.base, Rational(1, 2)), node.base)
    elif isinstance(node, Pow) and isinstance(node.exp, Rational):
        plain[Pow(node.base, Rational(1, node.exp.q))] = None
    elif isinstance(node, sin) and node.free_symbols:  # at a constant the relation would hide squares
        collect(cos(node.args[0]), seen, plain, squares)
        squares.setdefault(node, 1 - cos(node.args[0]) ** 2)
    elif isinstance(node, exp):
        plain.update(dict.fromkeys(base for base, _ in exponential(node)))
    else:
        plain[node] = None
    for part in parts:
        collect(part, seen, plain, squares)


def spelt_once(node: Expr) -> Expr | None:
    """Rewrite the logarithm of a rational by those of primes, a sine or tangent of rπ by cosines.

    None if the expression is spelt in one way only.
    """
    if isinstance(node, log) and isinstance(node.args[0], Rational) and node.args[0] > 0:
        parts = [(Integer(int(p)), side * n) for side, x in ((1, node.args[0].p), (-1, node.args[0].q))
                 for p, n in fmpz(int(x)).factor(trial_limit=PRIMES)]
        return None if [n for _, n in parts] == [1] else Add(*(n * log(p) for p, n in parts))
    if isinstance(node, (sin, tan)) and isinstance(node.args[0] / pi, Rational):
        sine = cos(pi / 2 - node.args[0])
        return sine if isinstance(node, sin) else sine / cos(node.args[0])
    return None


def exponential(node: exp) -> list[tuple[Expr, int]]:
    """Return exp(a + n b) as the powers exp(a)¹ exp(b)ⁿ of generators."""
    powers = []
    for term in Add.make_args(node.args[0]):
        coefficient, rest = term.as_coeff_Mul()
        rational = isinstance(coefficient, Rational)
        powers.append((exp(rest / coefficient.q), coefficient.p) if rational else (exp(term), 1))
    return powers
