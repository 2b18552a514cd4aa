"""Defines Jacobi's elliptic functions sn, cn, dn of (u, m) for formulas, where m = κ².

They have derivatives along u, and values at numbers.
"""
from functools import lru_cache
from typing import Any

import mpmath
from sympy import Expr, Float, Function, I

from ...errors import ScopeError

LARGEST = 1000


@lru_cache(maxsize=4096)
def _value(letters: str, u: Expr, m: Expr, prec: int) -> Expr:
    """Return the value at numbers; it is kept, because SymPy asks for it many times over."""
    with mpmath.workprec(prec + 20):
        if max(abs(complex(a.evalf(5))) for a in (u, m)) > LARGEST:
            raise ScopeError(f"sn, cn and dn are computed of arguments up to {LARGEST}: give smaller numbers")
        at, modulus = (mpmath.mpmathify(a.evalf(int(prec / 3.3) + 10)) for a in (u, m))
        value = mpmath.ellipfun(letters, at, m=modulus)
        parts = [Float._new(mpmath.mpf(part)._mpf_, prec) for part in (mpmath.re(value), mpmath.im(value))]
    return parts[0] if abs(parts[1]) < Float(2) ** -prec else parts[0] + I * parts[1]


class _Jacobi(Function):
    nargs = 2

    def _eval_evalf(self, prec: int) -> Expr | None:
        if any(a.free_symbols for a in self.args):
            return None
        return _value(self.func.__name__, *self.args, prec)

    def fdiff(self, argindex: int = 1) -> Any:
        u, m = self.args
        if argindex != 1:
            raise NotImplementedError(f"d{self.func.__name__}/dm is not needed by any formula")
        return {"sn": cn(u, m) * dn(u, m), "cn": -sn(u, m) * dn(u, m),
                "dn": -m * sn(u, m) * cn(u, m)}[self.func.__name__]


class sn(_Jacobi):
    """The sine of the amplitude: sn' = cn dn."""


class cn(_Jacobi):
    """The cosine of the amplitude: cn' = −sn dn."""


class dn(_Jacobi):
    """The delta of the amplitude: dn' = −m sn cn."""
