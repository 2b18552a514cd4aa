"""Gives the names of a formula at numbers, by Newton and Euler's equations or by three turns.

A counterexample is confirmed with them.
"""
from collections.abc import Callable, Sequence
from typing import Any

import mpmath
from sympy import Expr, Float, Integer, Matrix, MatrixBase, Rational, Symbol, diag

from ...notation import jet, symbol
from ..names.derived_names import FUNCTIONS, Names, with_letters
from ..names.kinematics import Later
from ..scenes import Scene
from .arnold import normal_form_names
from .counterexample import DIGITS, PI, K, Model, Values
from .frame_equations import InFrame, frame_names, model_of
from .three_turns import turning
from .torques import amended_names, cone_names

LAMDA = symbol("lamda")


def names(scene: Scene, values: Values) -> Names:
    """Return the names of a scene at numbers.

    Functions of the motion differentiate along the field of Newton and Euler.
    """
    derived = turning(scene, values) if "angles" in scene.table else _moving(scene, values)
    own = {s.name: value for s, value in values.items() if s.name in scene.letters}
    return Names(with_letters(_functions() | derived, own), {})


def _functions() -> dict[str, Callable[..., Any]]:
    """Return vector algebra, and elliptic functions and the polhode from their differential equations."""
    return {**FUNCTIONS, "inverse": lambda a: a.adjugate() / a.det(),
            "polhode_period": lambda *x: _period(x[:3], x[3:]),
            **{name: (lambda u, m, i=i: _jacobi(u, m)[i]) for i, name in enumerate(("sn", "cn", "dn"))}}


def _moving(scene: Scene, values: Values) -> dict[str, Any]:
    model = model_of(scene, values)
    x, framed = model.coordinates, isinstance(model, InFrame)
    named: dict[str, Any] = {str(s): v for s, v in model.values.items() if s not in x and not jet(s.name)}
    named |= {str(s): s for s in x} | {f"omega{i}": model.omega[i - 1] for i in (1, 2, 3)}
    named |= {f"vector_{str(x[n])[:-1]}": Matrix(x[n:n + 3]) for n in range(0, len(x), 3)}
    named |= dict(zip(("C1", "C2", "C3") if x[3:] else ("C",), model.casimirs))
    named |= {"vector_l": model.rotor, "vector_M": PI + model.rotor, "vector_omega": model.omega,
              "h": model.energy, "U": model.U, "field": model.field, "state": Matrix(x)}
    if not framed:
        named |= {"T": model.energy - model.U}
    if len(x) == 6:
        slope = model.U.diff(K[2])
        named |= {"dU": slope, "d2U": slope.diff(K[2]), "d3U": slope.diff(K[2], 2)}
        named |= {f"dU_{i}": model.U.diff(K[i - 1]) for i in (1, 2, 3)}
    if not model.label:
        return named | ({"dt": _along(x, model.field)} if framed else _in_motion(model, scene))
    for name, value in named.items():
        if isinstance(value, (Expr, MatrixBase)):
            named[name] = Later(lambda value=value: value.subs(model.place))  # type: ignore[misc]
    named |= {"jacobian": Later(lambda: model.jacobian), "lamda": model.values.get(LAMDA, LAMDA),
              "polynomial": Later(lambda: model.polynomial.subs(model.values))}
    return named | (frame_names(model) if isinstance(model, InFrame) else _at_equilibrium(model))


def _at_equilibrium(model: Model) -> dict[str, Any]:
    found: dict[str, Any] = {"q": Later(lambda: model.polynomial.coeff(LAMDA, 0))}
    six = len(model.coordinates) == 6
    if not model.claimed:                                  # a basis of the orbit, known by the axis
        basis = [0, 1, 3, 4] if six else [n for n in range(3) if n + 1 != int(str(model.label)[-1])]
        found |= {"linearization": Later(lambda: model.jacobian.extract(basis, basis)),
                  "identity": diag(*[1] * len(basis))}
    if six and all(e.is_Rational for e in model.point):
        found |= {f"nu{n + 1}": Later(lambda n=n: model.multipliers()[n])  # type: ignore[misc]
                  for n in (0, 1)}
    if six:
        found |= {**amended_names(model), **normal_form_names(model),
                  "p": Later(lambda: model.polynomial.coeff(LAMDA, 2))}
    return found


def _along(x: Sequence[Expr], direction: Matrix) -> Callable[[Any], Any]:
    """Return the derivative in a direction, as a function."""
    def one(f: Expr) -> Expr:
        return sum((f.diff(s) * rate for s, rate in zip(x, direction)), Integer(0))
    return lambda f: f.applyfunc(one) if isinstance(f, MatrixBase) else one(f)


def _in_motion(model: Model, scene: Scene) -> dict[str, Any]:
    x, M = model.coordinates, PI + model.rotor

    def bracket(f: Any, g: Expr) -> Any:
        """Return {f, g} = ∇f · (M × ∂πg + k × ∂kg, k × ∂πg)."""
        c, d = (Matrix([g.diff(s) for s in part]) for part in (PI, K))
        return _along(x, Matrix([*(M.cross(c) + K.cross(d)), *K.cross(c)]))(f)

    delta = Matrix([model.values.get(symbol(f"delta_{s}"), Integer(0)) for s in x])
    found = {"B": Later(lambda: Matrix([[bracket(a, b) for b in x] for a in x])),
             "delta_pi": Matrix(delta[:3]), "delta_k": Matrix(delta[3:]), "dt": _along(x, model.field),
             "variation": _along(x, delta),
             "bracket": bracket, "gradient_pi": lambda f: Matrix([f.diff(s) for s in PI]),
             "gradient_k": lambda f: Matrix([f.diff(s) for s in K])}
    found |= {f: sum((model.values.get(symbol(scene.derived(f"{f}{i}")), Integer(0)) * s
                      for i, s in enumerate(x, 1)), Integer(0)) for f in "FG"}
    return {**found, **(cone_names(model, any(scene.body.gyrostatic_momentum)) if len(x) == 6 else {})}


def _period(inertia: tuple[Expr, ...], momentum: tuple[Expr, ...]) -> Expr:
    """Return the period 4 ∫ dM2/abs(Ṁ2), the integral taken over a quarter of the polhode.

    The two conserved quantities give the other two components.
    """
    with mpmath.workdps(DIGITS):
        pairs = sorted((mpmath.mpf(Float(i, DIGITS)._mpf_), mpmath.mpf(Float(m, DIGITS)._mpf_))
                       for i, m in zip(inertia, momentum))
        (I1, M1), (I2, M2), (I3, M3) = pairs
        # about axis 1: the same with 1 and 3 exchanged
        if M3**2 * (1 - I2 / I3) < M1**2 * (I2 / I1 - 1):
            (I1, M1), (I3, M3) = (I3, M3), (I1, M1)
        top = M2**2 + M1**2 * I2 * (I3 - I1) / (I1 * (I3 - I2))            # M2² where M1 = 0
        third = M3**2 + M2**2 * (1 - I1 / I2) / (1 - I1 / I3)              # M3² where M2 = 0
        first = top * I1 * (I3 - I2) / (I2 * (I3 - I1))                    # M1² there

        def slope(angle: Any) -> Any:
            other = mpmath.sqrt(third - top * mpmath.sin(angle) ** 2 * (1 - I1 / I2) / (1 - I1 / I3))
            return mpmath.sqrt(top / first) / (other * abs(1 / I1 - 1 / I3))

        return Float(4 * mpmath.quad(slope, [0, mpmath.pi / 4, mpmath.pi / 2]), 30)


def _jacobi(u: Expr, m: Expr) -> list[Expr]:
    """Integrate y1' = y2 y3, y2' = −y1 y3, y3' = −m y1 y2 from y(0) = (0, 1, 1) to u by Taylor steps."""
    with mpmath.workdps(30):
        step, m = (mpmath.mpf(Float(x, 30)._mpf_) for x in (u / 48, m))
        y = [mpmath.mpf(x) for x in (0, 1, 1)]
        for _ in range(48):
            c = [[x] for x in y]
            for n in range(45):
                product = [sum(c[i][j] * c[k][n - j] for j in range(n + 1))
                           for i, k in ((1, 2), (0, 2), (0, 1))]
                for series, sign, p in zip(c, (1, -1, -m), product):
                    series.append(sign * p / (n + 1))
            y = [mpmath.polyval(series[::-1], step) for series in c]
        return [Float(x, 25) for x in y]


def number(value: Expr, scene: Scene, values: Values) -> Any:
    """Return a value of these names at the instant of the counterexample.

    It is exact if it is rational, otherwise it has 30 digits.
    """
    place = (
        {Symbol("t"): Integer(0)}
        if "angles" in scene.table
        else {s: v for s, v in values.items() if s in {*PI, *K, *scene.system.space.coordinates}}
    )
    at = value.subs(place)
    return at if isinstance(at, Rational) or at.free_symbols else at.evalf(30)
