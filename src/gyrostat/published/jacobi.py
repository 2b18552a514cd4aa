"""Jacobi's elliptic functions of formulas: sn, cn, dn of (u, m), m = κ², with their derivatives along u and their values."""
from typing import Any

import mpmath
from sympy import Expr, Float, Function


class _Jacobi(Function):
    nargs = 2
    letters = ""

    def _eval_evalf(self, prec: int) -> Expr | None:
        if any(a.free_symbols for a in self.args):
            return None
        values = [a.evalf(int(prec / 3.3) + 10) for a in self.args]
        if not all(v.is_real for v in values):
            return None
        with mpmath.workprec(prec + 20):
            u, m = (mpmath.mpf(Float(v)._mpf_) for v in values)
            value = mpmath.ellipfun(self.letters, u, m=m)
            if abs(mpmath.im(value)) > mpmath.mpf(2) ** -prec:             # as for some m > 1
                return None
            return Float._new(mpmath.re(value)._mpf_, prec)

    def fdiff(self, argindex: int = 1) -> Any:
        u, m = self.args
        if argindex != 1:
            raise NotImplementedError(f"d{self.letters}/dm is not needed by any formula")
        return {"sn": cn(u, m) * dn(u, m), "cn": -sn(u, m) * dn(u, m), "dn": -m * sn(u, m) * cn(u, m)}[self.letters]


class sn(_Jacobi):
    """sn' = cn dn."""

    letters = "sn"


class cn(_Jacobi):
    """cn' = −sn dn."""

    letters = "cn"


class dn(_Jacobi):
    """dn' = −m sn cn."""

    letters = "dn"
