"""The routes that bench_derivation.py compares.

Each derives what it can and says whether the result is the printed one.
"""
import sympy as sp
from flint_route import flint_route  # noqa: F401 (the route of that name)

I1, I3 = sp.symbols("I1 I3", positive=True)
l, dU, d2U, w, p0, m0, lam = sp.symbols("l dU d2U omega pi3_0 m0 lamda", real=True)
PI, K = sp.symbols("pi1:4", real=True), sp.symbols("k1:4", real=True)
X = (*PI, *K)
U = sp.Function("U")

E1_MARGIN = (p0 + l) ** 2 - 4 * I1 * dU                # VV2003 §4.1
E3_MARGIN = (I1 * (1 - K[2]**2) * d2U - 2 * I1 * K[2] * (w * l - w**2 * K[2] * (I1 - I3)) + I1**2 * w**2
             + ((I1 - I3) * w * K[2] - l) ** 2)        # VV2003 §5, on the family
PRINTED = [str(sp.expand(E1_MARGIN)), str(sp.expand(E3_MARGIN))]


def _hat(v):
    return sp.Matrix([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def _scene(potential):
    M = (PI[0], PI[1], PI[2] + l)
    tensor = sp.Matrix(sp.BlockMatrix([[_hat(M), _hat(K)], [_hat(K), sp.zeros(3)]]))
    h = PI[0]**2 / (2 * I1) + PI[1]**2 / (2 * I1) + PI[2]**2 / (2 * I3) + potential
    return tensor, h, (sum(m * k for m, k in zip(M, K)), sum(k**2 for k in K))


def _jacobi(tensor):
    n = len(X)
    return all(sp.expand(sum(tensor[a, m] * tensor[b, c].diff(X[m])
                             for a, b, c in ((i, j, k), (j, k, i), (k, i, j))
                             for m in range(n))) == 0 for i in range(n) for j in range(i) for k in range(j))


def gyrostat_route():
    """Bracket with its Jacobi check, E1, E2, E3, polynomials, spectral and formal criteria, with the Casimirs
    alone too.
    """
    import gyrostat as gs
    scene = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
    reports = [gs.analyze(make(scene)) for make in (gs.upright, gs.hanging, gs.inclined)]
    for report in reports:
        _ = report.necessary, report.sufficient, report.casimirs_only
    ours = [str(report.sufficient.alternatives[0][0].margin) for report in (reports[0], reports[2])]
    return ours == PRINTED


def careful_route():
    """The same by a user who knows SymPy.

    Symbols for U', U'', rows picked for the left inverse, on shell before the polynomial.
    """
    tensor, h, casimirs = _scene(0)
    ok = _jacobi(tensor)
    gradient = sp.Matrix([h.diff(x) for x in X]) + sp.Matrix([0, 0, 0, 0, 0, dU])
    field = (tensor * gradient).expand()
    jacobian = field.jacobian(X) + field.diff(dU) * sp.Matrix([[0, 0, 0, 0, 0, d2U]])
    hessian = sp.hessian(h, X) + sp.diag(0, 0, 0, 0, 0, d2U)
    forms = [sp.hessian(c, X) for c in casimirs]
    for s in (1, -1):
        at = dict(zip(X, (0, 0, p0, 0, 0, s)))
        matrix = jacobian.subs(at).extract([0, 1, 3, 4], [0, 1, 3, 4])
        c = matrix.charpoly(lam).all_coeffs()
        discriminant = sp.factor(c[2]**2 - 4 * c[4])
        ok &= discriminant.has(sp.expand(E1_MARGIN if s == 1 else E1_MARGIN.subs(dU, -dU)),
                               -sp.expand(E1_MARGIN.subs(dU, s * dU)))
        # the Casimirs alone, then with the free multiplier of π3
        for n1 in (-s * p0 / I3, sp.Symbol("nu")):
            n2 = -s * (dU + n1 * (p0 + l)) / 2
            form = (hessian + n1 * forms[0] + n2 * forms[1]).subs(at).extract([0, 1, 3, 4], [0, 1, 3, 4])
            _ = sp.factor(form[:3, :3].det())          # the only minor with a sign of its own
    k1 = sp.Symbol("k1", positive=True)
    at = dict(zip(X, (I1 * w * k1, 0, I3 * w * K[2], k1, 0, K[2])))
    shell = {dU: w * l - w**2 * K[2] * (I1 - I3)}
    J = jacobian.subs(at).subs(shell)
    M1, M3 = I1 * w * k1, I3 * w * K[2] + l
    basis = sp.Matrix([[0, -K[2] / k1, 0, (M1 * K[2] / k1 - M3) / k1], [1, 0, 0, 0], [0, 1, 0, 0],
                       [0, 0, 0, -K[2] / k1],
                       [0, 0, 1, 0], [0, 0, 0, 1]])
    matrix = (J * basis).extract([1, 2, 4, 5], [0, 1, 2, 3]).applyfunc(sp.cancel)
    c = [sp.cancel(x.subs(k1, sp.sqrt(1 - K[2]**2))) for x in matrix.charpoly(lam).all_coeffs()]
    form = (hessian - w * forms[0] + I1 * w**2 / 2 * forms[1]).subs(at)
    sliced = basis.extract(range(6), [0, 3])
    sliced = (sliced.T * form
              * sliced).applyfunc(lambda e: sp.cancel(sp.expand(e).subs(k1, sp.sqrt(1 - K[2]**2))))
    ok &= sp.expand(sp.cancel(c[2] * I1**2) - E3_MARGIN) == 0 and c[4] == 0
    return bool(ok and sp.cancel(sliced.det() * I1**2 * (1 - K[2]**2) / E3_MARGIN).free_symbols == set())


def naive_steps():
    """What one writes first: jacobian, subs, charpoly, simplify, solve, with U undefined."""
    tensor, h, casimirs = _scene(U(K[2]))
    field = tensor * sp.Matrix([h.diff(x) for x in X])
    on_e1 = dict(zip(X, (0, 0, p0, 0, 0, 1)))
    on_e3 = {PI[0]: I1 * w * K[0], PI[1]: I1 * w * K[1], PI[2]: I3 * w * K[2]}

    def restricted(point):
        J = field.jacobian(X).subs(point)
        N = sp.Matrix([[c.diff(x) for x in X] for c in casimirs]).subs(point).nullspace()
        N = sp.Matrix.hstack(*N)
        return (N.T * N).inv() * N.T * J * N

    def e1():
        q = restricted(on_e1).charpoly(lam).all_coeffs()
        return sp.factor(sp.simplify(q[2]**2 - 4 * q[4])).has(p0)

    def solve():
        heavy = field.subs(U(K[2]), m0 * K[2]).doit()
        return len(sp.solve([*heavy, casimirs[1] - 1], X, dict=True)) >= 2  # E1 and E2 solve it

    return {
        "Jacobi identity": lambda: sp.simplify(_jacobi(tensor)),
        "equations of motion": lambda: sp.simplify(field) is not None,
        "equilibria by solve (U = m0 k3)": solve,
        "E1: restrict, charpoly, simplify": e1,
        "E3: restrict, charpoly": lambda: restricted(on_e3).charpoly(lam) is not None,
        "inequality by reduce_inequalities": lambda: (
            sp.reduce_inequalities([E1_MARGIN >= 0], [p0]) is not None
        ),
    }


def poissongeometry_steps():
    """PoissonGeometry, where it has the feature.

    Jacobi, Hamiltonian vector field, Casimirs (text in, text out).
    """
    from poisson.poisson import PoissonGeometry
    geometry = PoissonGeometry(6)
    tensor, h, casimirs = _scene(m0 * K[2])
    rename = dict(zip(X, sp.symbols("x1:7")))
    bivector = {(i + 1, j + 1): str(tensor[i, j].subs(rename)) for i in range(6)
                for j in range(i + 1, 6) if tensor[i, j] != 0}
    return {"Jacobi identity": lambda: geometry.is_poisson_bivector(bivector),
            "equations of motion": lambda: bool(geometry.hamiltonian_vf(bivector, str(h.subs(rename)))),
            "Casimirs": lambda: all(geometry.is_casimir(bivector, str(c.subs(rename))) for c in casimirs)}
