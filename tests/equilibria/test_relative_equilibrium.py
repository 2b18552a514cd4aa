"""One relative equilibrium of every kind: every attribute answers, by hand, by its report and by spectra."""
import pickle

import numpy as np
import oracle
import pytest
from listed_scenes import LISTS, listed
from oracle.equilibria import cross
from sympy import Expr, Integer, Matrix, expand, hessian, lambdify, total_degree
from two_directions import Scene

import gyrostat as gs
from gyrostat.errors import SingularOrbitError
from gyrostat.mechanics.equilibrium.equilibrium import Equilibrium
from gyrostat.mechanics.families.circular_orbit import by_gradient_alone
from gyrostat.mechanics.scenes.potential import DIRECTIONS

FREE, FIELD, REVOLUTION, ORBIT = "free", "in a field", "of revolution", "in orbit"


@pytest.fixture(params=LISTS)
def found(request):
    """All of a kind of scene."""
    return listed(request.param)


def kind(e):
    """What e is of, by what turns."""
    if "sigma" in e.rates:
        return REVOLUTION
    return {0: FREE, 1: FIELD, 2: ORBIT}[len(e.directions)]


def doubles(numbers):
    return np.array([float(x) for x in numbers])


def body_of(e):
    """Inertia tensor and rotor."""
    return np.array(e.scene.body.tensor, float), doubles(e.scene.body.gyrostatic_momentum)


def axis_of(e):
    """Of a body of revolution the unit vector along its axis."""
    along, _ = e.form.described[0]
    return doubles(along.coeff(k) for k in DIRECTIONS)


def velocity(e):
    """ω, from rates and directions."""
    rate = {name: float(x) for name, x in e.rates.items()}
    if kind(e) == FREE:
        M = doubles(e.momentum)
        return rate["omega"] * M / np.linalg.norm(M)
    if kind(e) == ORBIT:
        return rate["omega0"] * doubles(e.directions[0])
    spin = rate["sigma"] * axis_of(e) if kind(e) == REVOLUTION else 0
    return rate["omega"] * doubles(e.directions[0]) + spin


@pytest.mark.few(2)
def test_every_attribute_answers(found):
    """Or is None where there is no such thing."""
    for e in found:
        size = {FREE: 0, ORBIT: 2}.get(kind(e), 1)
        assert {"E1": REVOLUTION, "E2": REVOLUTION, "E3": REVOLUTION, "precession": REVOLUTION,
                "equilibrium in orbit": ORBIT}.get(e.label, kind(e)) == kind(e)
        assert len(e.point) == 3 + 3 * size == len(e.scene.space.coordinates)
        assert len(e.momentum) == 3 and len(e.directions) == size and isinstance(e.locus, str)
        assert all(isinstance(x, Expr) and not x.free_symbols for x in (*e.point, *e.momentum, e.energy))
        assert list(e.rates) == {FREE: ["omega"], FIELD: ["omega"], REVOLUTION: ["omega", "sigma"],
                                 ORBIT: ["omega0"]}[kind(e)]
        assert (e.attitude is None) == (kind(e) != ORBIT)
        assert isinstance(e.equilibrium, Equilibrium) and isinstance(e.decision, gs.Decision)
        assert (e.damped is None) == (e.label == "precession")
        assert (e.itself is None) == (not e.decision.modulo or e.label == "precession")
        assert list(e.frequencies) == sorted(e.frequencies) and all(x > 0 for x in e.frequencies)
        assert e.growth_rate is None or e.growth_rate > 0
        assert e.form.index is None or 0 <= e.form.index <= {FREE: 2, ORBIT: 3}.get(kind(e), 2)


@pytest.mark.few(2)
def test_what_tells_them_apart(found):
    """Place: each by its numbers, of which a continuum has none."""
    places = [tuple(e.place.items()) for e in found]
    assert len(set(places)) == len(found)
    for e in found:
        varies = e.locus.startswith("every ")
        assert (None in e.place.values()) == varies
        own = {str(x): value for x, value in zip(e.scene.space.coordinates, e.point)}
        assert varies or all(value == (own | e.rates)[name] for name, value in e.place.items())


@pytest.mark.few(7)
def test_rates_and_directions_give_the_momentum(found):
    """M = Iω + l, and unit vectors; of the attitude rows t = n × r, n, r of a rotation."""
    for e in found:
        inertia, rotor = body_of(e)
        np.testing.assert_allclose(inertia @ velocity(e) + rotor, doubles(e.momentum), atol=1e-12)
        np.testing.assert_allclose([np.linalg.norm(doubles(k)) for k in e.directions], 1, rtol=1e-14)
        if e.attitude is not None:
            n, r = map(doubles, e.directions)
            near = np.array(e.attitude.matrix)
            np.testing.assert_allclose(near, [np.cross(n, r), n, r], atol=1e-14)
            np.testing.assert_allclose(near @ near.T, np.eye(3), atol=1e-14)
            assert np.linalg.det(near) == pytest.approx(1, abs=1e-14)


@pytest.mark.few(25)
def test_the_energy_is_the_hamiltonian(found):
    """½ ω·Iω + U; in orbit ½ ω·Iω − ω0 n·(Iω + l) + 3 ω0² r·Ir/2, in the frame that turns."""
    for e in found:
        inertia, rotor = body_of(e)
        omega = velocity(e)
        expected = omega @ inertia @ omega / 2
        if kind(e) == ORBIT:
            (n, r), rate = map(doubles, e.directions), float(e.rates["omega0"])
            expected += 3 * rate**2 * r @ inertia @ r / 2 - rate * n @ (inertia @ omega + rotor)
            expected += float(beside(e).subs(dict(zip(N_R, (*n, *r)))))
        elif kind(e) != FREE:
            expected += float(e.scene.potential.expression.subs(dict(zip(DIRECTIONS, e.directions[0]))))
        assert float(e.energy) == pytest.approx(expected, rel=1e-13, abs=1e-13)


N_R = [gs.symbol(f"{name}{i}") for name in "nr" for i in (1, 2, 3)]


def beside(e):
    """What acts beside the gravity gradient; the field of this alone is of the oracle."""
    if by_gradient_alone(e.scene):
        return Integer(0)
    n, r, rate = N_R[:3], N_R[3:], e.rates["omega0"]
    gravity = 3 * rate**2 / 2 * (Matrix(r).T * e.scene.body.tensor * Matrix(r))[0]
    rotor = sum(x * y for x, y in zip(n, e.scene.body.gyrostatic_momentum))
    return expand(e.scene.potential.expression - gravity + rate * rotor)


def eigenvalues(e):
    """Of the equations of motion, linearised by differences; of a precession in axes that turn with it."""
    inertia, rotor = body_of(e)
    x = doubles(e.point)
    if kind(e) == ORBIT:
        rate, U, none = float(e.rates["omega0"]), beside(e), np.zeros((3, 3))
        curved = np.array(hessian(U, N_R), float) + np.block([[none, none], [none, 3 * rate**2 * inertia]])
        sloped = [float(U.diff(a).subs(dict.fromkeys(N_R, 0))) for a in N_R]
        scene = Scene(np.linalg.inv(inertia), rotor, -rate * np.eye(3, 6), curved,
                      np.array(sloped) - rate * np.array([*rotor, 0, 0, 0]))
        return np.linalg.eigvals(np.array(scene.jacobian(x), float))
    inverse = np.linalg.inv(inertia)
    if kind(e) == FREE:
        return np.linalg.eigvals(oracle.jacobian(lambda pi: cross(pi + rotor, inverse @ pi), x).astype(float))
    slope = lambdify(DIRECTIONS, [e.scene.potential.expression.diff(k) for k in DIRECTIONS])
    spin = float(e.rates["sigma"]) * axis_of(e) if kind(e) == REVOLUTION else np.zeros(3)

    def field(y):
        pi, k, omega = y[:3], y[3:], inverse @ y[:3] - spin
        return np.concatenate([cross(pi + rotor, omega) + cross(k, slope(*k)),
                               cross(k, omega)])

    assert np.abs(field(x)).max() < 1e-12
    quadratic = total_degree(e.scene.potential.expression, *DIRECTIONS) < 3    # 1 is an exact step there
    return np.linalg.eigvals(oracle.jacobian(field, x, 1 if quadratic else 2**-16).astype(float))


@pytest.mark.few(5)
def test_frequencies_and_growth_rates_are_those_of_the_motion(found):
    """Every eigenvalue but 0 of the differenced equations; two that meet are apart by 1e-8 in doubles."""
    for e in found:
        theirs = eigenvalues(e)
        growth = theirs.real.max()
        slow = sorted(x.imag for x in theirs if x.imag > 1e-4 and abs(x.real) < 1e-6)
        assert [float(x) for x in e.frequencies] == pytest.approx(slow, abs=1e-7), e
        assert float(e.growth_rate or 0) == pytest.approx(growth if growth > 1e-4 else 0, abs=1e-7), e


@pytest.mark.few(2)
def test_the_report_of_its_equilibrium_says_the_same(found):
    """Verdict, notion and growing modes; the rung too, where it stands alone: a set is decided as one."""
    for e in found:
        report = gs.analyze(e.equilibrium)
        here = report.verdict({})
        assert (here.verdict, here.notion) == (e.decision.verdict, e.decision.notion)
        assert e.locus or here.rung is e.decision.rung
        if e.damped is not None:
            damped = report.verdict({}, damped=True)
            assert (damped.verdict, damped.growing) == (e.damped.verdict, e.damped.growing)


@pytest.mark.few(16)
def test_as_many_modes_grow_as_the_index_says(found):
    """Under damping that reaches every motion, where the form is not degenerate."""
    for e in found:
        if e.damped is not None and e.form.index is not None and e.form.reached:
            assert e.damped.growing == e.form.index, e


@pytest.mark.few(2)
def test_it_is_compared_hashed_and_pickled(found):
    """Equal to its copy alone, before and after it was asked."""
    for asked in (False, True):
        if asked:
            for e in found:
                e.decision, e.damped, e.frequencies, e.energy, e.equilibrium  # noqa: B018
        again = pickle.loads(pickle.dumps(found))
        assert again == found and [hash(e) for e in again] == [hash(e) for e in found]
        assert len({*found, *again}) == len(found) and [str(e) for e in again] == [str(e) for e in found]
        assert [(e.decision, e.damped) for e in again] == [(e.decision, e.damped) for e in found]


def test_without_momentum():
    """M = 0: a point that is its orbit, stable, which no report takes."""
    (rest,) = gs.relative_equilibria(gs.assemble(gs.Gyrostat((1, 2, 3), (1, 0, "1/2"))), {"M": 0})
    assert rest.momentum == (0, 0, 0) and rest.rates == {} and rest.frequencies == ()
    assert rest.growth_rate is rest.attitude is rest.itself is rest.form.index is None
    assert rest.decision.stable and rest.damped.stable and rest.damped.growing == 0
    with pytest.raises(SingularOrbitError):
        gs.analyze(rest.equilibrium).verdict({})
