"""The names of a formula at numbers, from Newton and Euler's equations and from three turns.

What confirms a counterexample.
"""
from collections.abc import Callable
from typing import Any

import mpmath
from sympy import Expr, Float, Integer, Matrix, MatrixBase, Rational, Symbol, diag

from ...notation import jet, symbol
from ..names.derived_names import FUNCTIONS, Names, with_letters
from ..names.kinematics import Later
from ..scenes import Scene
from .arnold import normal_form_names
from .counterexample import DIGITS, PI, K, Values
from .frame_equations import InFrame, frame_names_at_numbers, model_of
from .three_turns import turning
from .torques import amended_names, cone_names


def names(scene: Scene, values: Values) -> Names:
    """The names of a scene at numbers.

    Functions of the motion differentiate along the field of Newton and Euler.
    """
    derived = turning(scene, values) if "angles" in scene.table else _moving(scene, values)
    own = {s.name: value for s, value in values.items() if s.name in scene.letters}
    return Names(with_letters(_functions() | derived, own), {})


def _functions() -> dict[str, Callable[..., Any]]:
    """Vector algebra as everywhere; elliptic functions and the polhode from their differential equations."""
    return {**FUNCTIONS, "inverse": lambda a: a.adjugate() / a.det(),
            "polhode_period": lambda *x: _period(x[:3], x[3:]),
            **{name: (lambda u, m, i=i: _jacobi(u, m)[i]) for i, name in enumerate(("sn", "cn", "dn"))}}


def _moving(scene: Scene, values: Values) -> dict[str, Any]:
    model = model_of(scene, values)
    if isinstance(model, InFrame):
        return frame_names_at_numbers(model, scene)
    x, field = model.coordinates, model.field
    h = sum(p**2 / moment for p, moment in zip(PI, model.inertia)) / 2 + model.U
    named: dict[str, Any] = {str(s): v for s, v in model.values.items() if s not in x and not jet(s.name)}
    named |= {str(s): s for s in x}
    M = PI + model.rotor
    named |= {f"omega{i}": model.omega[i - 1] for i in (1, 2, 3)}
    named |= {"vector_pi": PI, "vector_k": K, "vector_l": model.rotor, "vector_M": M,
              "vector_omega": model.omega, "h": h, "U": model.U,
              "T": h - model.U, "C": M.dot(M), "C1": M.dot(K), "C2": K.dot(K), "field": field,
              "state": Matrix(x)}
    if len(x) == 6:
        slope = model.U.diff(K[2])
        named |= {"dU": slope, "d2U": slope.diff(K[2]), "d3U": slope.diff(K[2], 2)}
        named |= {f"dU_{i}": model.U.diff(K[i - 1]) for i in (1, 2, 3)}
        if not model.label:
            named |= cone_names(model, any(scene.body.gyrostatic_momentum))
    if model.label:
        place = dict(zip(x, model.point))
        for name, value in named.items():
            if isinstance(value, (Expr, MatrixBase)):
                named[name] = Later(lambda value=value: value.subs(place))  # type: ignore[misc]
        lamda = symbol("lamda")
        named |= {"jacobian": Later(lambda: model.jacobian),
                  "polynomial": Later(lambda: model.polynomial.subs(model.values)),
                  "lamda": model.values.get(lamda, lamda),
                  "q": Later(lambda: model.polynomial.coeff(lamda, 0))}
        if not model.claimed:                              # a basis of the orbit, known by the axis
            basis = [0, 1, 3, 4] if len(x) == 6 else [n for n in range(3)
                                                      if n + 1 != int(str(model.label)[-1])]
            named |= {"linearization": Later(lambda: model.jacobian.extract(basis, basis)),
                      "identity": diag(*[1] * len(basis))}
        if len(x) == 6 and all(e.is_Rational for e in model.point):
            named |= {f"nu{n + 1}": Later(lambda n=n: model.multipliers[n])  # type: ignore[misc]
                      for n in (0, 1)}
        if len(x) == 6:
            named |= {**amended_names(model), **normal_form_names(model)}
        return named | ({"p": Later(lambda: model.polynomial.coeff(lamda, 2))} if len(x) == 6 else {})

    def along(direction: Matrix) -> Callable[[Any], Any]:
        def one(f: Expr) -> Expr:
            return sum((f.diff(s) * rate for s, rate in zip(x, direction)), Integer(0))
        return lambda f: f.applyfunc(one) if isinstance(f, MatrixBase) else one(f)

    def bracket(f: Any, g: Expr) -> Any:
        """{f, g} = ∇f · (M × ∂πg + k × ∂kg, k × ∂πg)."""
        c, d = (Matrix([g.diff(s) for s in part]) for part in (PI, K))
        return along(Matrix([*(M.cross(c) + K.cross(d)), *K.cross(c)]))(f)

    named["B"] = Later(lambda: Matrix([[bracket(a, b) for b in x] for a in x]))
    delta = Matrix([model.values.get(symbol(f"delta_{s}"), Integer(0)) for s in x])
    named |= {"delta_pi": Matrix(delta[:3]), "delta_k": Matrix(delta[3:]), "dt": along(field),
              "variation": along(delta),
              "bracket": bracket, "gradient_pi": lambda f: Matrix([f.diff(s) for s in PI]),
              "gradient_k": lambda f: Matrix([f.diff(s) for s in K])}
    named |= {f: sum((model.values.get(symbol(scene.derived(f"{f}{i}")), Integer(0)) * s
                      for i, s in enumerate(x, 1)), Integer(0)) for f in "FG"}
    return named


def _period(inertia: tuple[Expr, ...], momentum: tuple[Expr, ...]) -> Expr:
    """4 ∫ dM2/abs(Ṁ2) over a quarter of the polhode, the other two components from the two conserved
    quantities.
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
    """y(u) of y1' = y2 y3, y2' = −y1 y3, y3' = −m y1 y2, y(0) = (0, 1, 1), by Taylor steps."""
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
    """A value of these names at the instant of the counterexample.

    Exact where it is rational, else to 30 digits.
    """
    place = (
        {Symbol("t"): Integer(0)}
        if "angles" in scene.table
        else {s: v for s, v in values.items() if s in {*PI, *K, *scene.system.space.coordinates}}
    )
    at = value.subs(place)
    return at if isinstance(at, Rational) or at.free_symbols else at.evalf(30)
