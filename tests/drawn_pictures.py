"""Pictures of every draw_ function, in fields of degree 1 to 4 and without a field."""
import numpy as np
from matplotlib.figure import Figure
from sympy import Rational

import gyrostat as gs
from gyrostat import plotting
from gyrostat.charts import stability_chart
from gyrostat.trajectories import motion

FIELDS = {"1": lambda k: k, "2": lambda k: k - k**2, "3": lambda k: k**3 - k / 2,
          "3, more marks": lambda k: -k**2 * Rational(5, 4) + k**3 * Rational(5, 4),
          "4": lambda k: k**4 - k**2 / 2 + k / 20,
          "4, more marks": lambda k: k / 4 - k**2 / 2 + 2 * k**3 - k**4 * Rational(5, 4)}
GENERAL = {1: lambda a, b, c: a + b + c, 2: lambda a, b, c: a + b**2 + 2 * c**2,
           3: lambda a, b, c: a**3 + b + c, 4: lambda a, b, c: c**4 + a * b + c}
BODY = {"I1": 2, "I3": 1, "l": "3/2"}
ORBIT = gs.circular_orbit(1)


def flat():
    return Figure().subplots()


def space():
    return Figure().add_subplot(projection="3d", elev=22, azim=40)


def of_revolution(U):
    """One picture of each function for a body of revolution in U(k3)."""
    scene = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(U))
    spinning = gs.upright(scene, spin="omega3_0")
    tilted = stability_chart(gs.analyze(gs.inclined(scene)), x=("k3", np.linspace(-0.9, 0.9, 40)),
                             y=("omega", np.linspace(-2, 2, 40)), fixed={"I1": 2, "I3": 1})
    damped = stability_chart(gs.analyze(spinning), x=("omega3_0", np.linspace(-4, 4, 40)),
                             y=("l", np.linspace(-2, 2, 40)), fixed={"I1": 2, "I3": 1}, damped=True)
    yield plotting.draw_bifurcation_diagram(scene, "omega", (-5, 5), BODY, flat())
    yield plotting.draw_effective_potential(scene, {**BODY, "p_phi": "1/10", "p_psi": "1/10"}, 2, flat())
    yield plotting.draw_energy_momentum(scene, {**BODY, "p_psi": "1/5"}, ax=flat())
    yield plotting.draw_eigenvalues(spinning, "omega3_0", np.linspace(-6, 6, 100), BODY, flat())
    yield plotting.draw_nutation(motion(scene, (0, 0, 3, "0.6", 0, "0.8"), BODY), np.linspace(0, 9, 300),
                                 space())
    yield from (plotting.draw_chart(chart, flat()) for chart in (tilted, damped))


def of_three_moments(degree):
    """The pictures of a body of three moments in U(k), without and with a rotor."""
    for rotor in ((0, 0, 0), (0, "1/2", 1)):
        scene = gs.assemble(gs.Gyrostat((1, 2, 3), rotor), gs.general_potential(GENERAL[degree]))
        yield plotting.draw_amended_potential(scene, {"C1": "5/2"}, space())
        if degree < 3:
            yield plotting.draw_well(next(e for e in gs.relative_equilibria(scene, {"C1": "5/2"})
                                          if e.well.barrier_double), space())
            yield plotting.draw_bifurcation_diagram(scene, "omega", ("1/10", 2), {}, flat())
        if degree == 1:
            yield plotting.draw_staude_cone(scene, {}, space())
            yield plotting.draw_staude_plane(scene, {}, ax=flat())


def without_a_field():
    """Free bodies and satellites."""
    free = gs.assemble(gs.Gyrostat((1, 2, 3), ("1/20", "1/10", gs.symbol("l3"))))
    satellite = gs.assemble(gs.Gyrostat((1, "5/4", "8/5"), (0, 0, 0)), ORBIT)
    moving = motion(satellite, gs.release(satellite, ("5 deg", 0, "-2 deg")))
    bodies = {"ours": (60, 52, 35), "theirs": (60, 70, 35), "third": (50, 52, 35)}
    yield plotting.draw_momentum_sphere(free, 1, {"l3": "1/2"}, ax=space())
    yield plotting.draw_bifurcation_diagram(free, "l3", ("-1/2", 2), {"M": 1}, flat())
    yield plotting.draw_rotor_set(gs.assemble(gs.Gyrostat((1, 2, 3))), {"l3": 0, "M": 1}, flat())
    yield plotting.draw_cones((2, 1), 1, 2, space())
    yield plotting.draw_well(next(e for e in gs.relative_equilibria(satellite, {}) if e.decision.stable),
                             space())
    yield plotting.draw_attitudes(satellite, ax=space())
    yield plotting.draw_librations(moving, np.linspace(0, 20, 200), flat())
    yield plotting.draw_smelt_plane("1/2", bodies, flat())
