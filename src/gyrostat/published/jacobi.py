"""Jacobi's elliptic functions of formulas: sn, cn, dn of (u, m), m = κ², with their derivatives along u and their values."""
from typing import Any

import mpmath
from sympy import Expr, Float, Function


class _Jacobi(Function):
    nargs = 2
    letters = ""

    def _eval_evalf(self, prec: int) -> Expr | None:
        u, m = (a.evalf(int(prec / 3.3) + 10) for a in self.args)
        if not (u.is_Float or u.is_Integer) or not (m.is_Float or m.is_Integer):
            return None
        with mpmath.workprec(prec + 20):
            return Float._new(mpmath.ellipfun(self.letters, mpmath.mpf(u._mpf_), m=mpmath.mpf(m._mpf_))._mpf_, prec)

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
