"""A call of everything public, each as (name, callable, arguments by name), made once."""
import inspect
from functools import cache

import numpy as np
from public_results import flat, folder, known, results, space

import gyrostat as gs


def constructors():
    """The classes, each with the arguments of the object that is known."""
    for name, made in results().items():
        cls = type(made)
        taken = [p for p in inspect.signature(cls).parameters if hasattr(made, p)]
        if len(taken) == len(inspect.signature(cls).parameters):
            yield f"gs.{name}", cls, {p: getattr(made, p) for p in taken}
    yield "gs.Motion", type(known().motion), {"scene": known().top, "state": (0, 0, 3, 0.6, 0, 0.8),
                                              "route": known().motion._route, "digits": None}


def verbs():
    """The functions."""
    k, r = known(), results()
    s, m, c, p, t, d = gs.symbol, gs.mechanics, gs.charts, gs.plotting, gs.trajectories, gs.published
    top = {"potential": "k3", "equilibrium": "E1", "values": {"I1": 1, "I2": 2, "I3": 3, "pi3_0": 4}}
    satellite = {"orbit": {"rate": "omega0"}, "pointing": [1, 2, 3], "lumped": True,
                 "rotors": [{"axis": [0, 1, 0], "axial": "1/2", "momentum": "h"}]}
    return [
        (gs.questions.conditions, {"scene": satellite, "solve_for": None, "windows": False}),
        (gs.questions.decide, {"scene": {"potential": "m0*k3", "inertia": [5, 4, 3], "integrals": [],
                                         "point": [0, 0, "3*w", 0, 0, 1], "values": {"m0": 1, "w": 2}}}),
        (gs.questions.report, {"scene": top}), (gs.questions.show, {"0": top, "1": "decided"}),
        (gs.questions.decide, {"scene": top}), (gs.questions.show, {"0": top, "1": "analysed"}),
        (gs.questions.show, {"0": top, "1": "edges", "2": ["I1", "I3"], "3": [["1/2", "2"], ["1/2", "2"]]}),
        (gs.amended_potential, {"scene": k.gyrostat}), (gs.analyze, {"eq": k.upright}),
        (gs.assemble, {"body": k.free.body, "potential": gs.general_potential(0),
                       "integrals": ("M1^2 + M2^2 + M3^2",)}),
        (gs.derivation.augmented_hessian, {"eq": k.upright, "functions": k.top.space.casimirs}),
        (gs.axial_potential, {"expression": s("k3")}),
        (gs.bifurcation_points, {"scene": k.top, "name": "pi3_0", "values": {"I1": 1, "l": 0, "m0": 1}}),
        (gs.bifurcation_points, {"scene": k.spun, "name": "M", "values": {"l": 1}}),
        (gs.bifurcations, {"scene": k.top}), (gs.circular_orbit, {"rate": 1, "potential": 0}),
        (gs.circular_orbit, {"mu": 1, "radius": 2}),
        (gs.continuation, {"scene": k.top, "name": "omega", "ends": (1, 3),
                           "values": {"I1": 2, "I3": 1, "l": 0, "m0": 1}}),
        (gs.coupled_potential, {"expression": -s("k1") - 2 * s("e2"), "directions": ("k", "e"),
                                "drift": (0, 0, 0), "held": ((s("k1")**2 + s("k2")**2 + s("k3")**2, 1),)}),
        (gs.earth_pointing, {"scene": k.satellite, "roll": 1, "pitch": 2, "yaw": 3}),
        (gs.earth_pointing_gyrostat, {"body": k.satellite.body, "orbit": gs.circular_orbit(1),
                                      "roll": 1, "pitch": 2, "yaw": 3}),
        (gs.derivation.energy_sink_criterion, {
            "eq": gs.equilibrium(gs.assemble(k.dual), (0, 0, 0)), "rotor": k.wheel,
            "platform_damping": s("c_p"), "rotor_damping": s("c_r")}),
        (gs.equilibrium, {"scene": k.top, "point": (0, 0, s("pi3_0"), 0, 0, 1), "relations": (),
                          "domain": (), "label": "E"}),
        (gs.equilibrium, {"scene": k.field, "point": (0, 0, 0, "3/5", 0, "4/5"),
                          "relations": ((s("dU"), 0),), "domain": (s("I1"),), "label": "E"}),
        (gs.derivation.formal_criterion, {"variation": r["SecondVariation"]}),
        (gs.general_potential, {"expression": s("k1")}),
        (gs.Gyrostat, {"inertia": (1, 2, "5/2"), "gyrostatic_momentum": (0, 0, 1)}),
        (gs.Gyrostat, {"inertia": [[3, 1, 0], [1, 3, 0], [0, 0, 5]], "gyrostatic_momentum": (0, 0, 1)}),
        (gs.gyrostat_with_rotors, {"inertia": (3, 2, 1), "rotors": (gs.Rotor((0, 0, 1), "1/9", rate=1),),
                                   "lumped": True}),
        (gs.hanging, {"scene": k.top, "spin": "pi3_0"}), (gs.ideal_fluid, {}),
        (gs.inclined, {"scene": k.top, "eliminate": "k3"}),
        (gs.derivation.independent, {"criterion": k.report.sufficient, "eq": k.upright}),
        (gs.lie_poisson, {"directions": ("k",), "gyrostatic_momentum": (0, 0, 1)}),
        (gs.derivation.linearize, {"eq": k.upright}),
        (gs.derivation.multipliers, {"eq": k.upright, "functions": k.top.space.casimirs}),
        (gs.newtonian_field, {"order": 2}), (gs.derivation.orbit_tangent, {"eq": k.upright}),
        (gs.orbital_precession, {"scene": k.round_one, "kind": "conical"}),
        (gs.derivation.own_precision, {"bits": 100}),
        (gs.parallel_directions, {"eq": gs.steady_motion(k.vehicle, (0, 0, s("p0")), (0, 0, 1))}),
        (gs.permanent_rotation, {"scene": gs.assemble(k.free.body, gs.general_potential()),
                                 "direction": ("1/3", "2/3", "2/3")}),
        (gs.principal_rotation, {"scene": k.free, "axis": 2}), (gs.mechanics.reduce, {"scene": k.top}),
        (gs.relative_equilibria, {"scene": k.top, "values": {"I1": 2, "I3": 1, "l": 0, "m0": 3, "omega": 2}}),
        (gs.relative_equilibria, {"scene": k.free, "values": {"M": 1}}),
        (gs.relative_equilibria, {"scene": k.heavy, "values": {"omega": 2}}),
        (gs.relative_equilibria, {"scene": k.heavy, "values": {"C1": 2}}),
        (gs.relative_equilibria, {"scene": k.satellite, "values": {}}),
        (gs.release, {"scene": k.satellite, "angles": (0, "1/10", 0), "pointing": (1, 2, 3)}),
        (gs.Rotor, {"axis": (0, 3, 4), "axial": 1, "transverse": 1, "rate": 2}),
        (gs.Rotor, {"axis": (0, 3, 4), "axial": 1, "momentum": 2}),
        (gs.derivation.second_variation, {"eq": k.upright, "integrals": True}),
        (gs.derivation.secular_criterion, {"variation": gs.derivation.secular_variation(k.upright)}),
        (gs.derivation.secular_variation, {"eq": k.upright}),
        (gs.solve_condition, {"condition": r["Condition"], "name": "l", "boundary": k.report.boundary,
                              "domain": ()}),
        (gs.derivation.spectral_criterion, {"linearization": r["Linearization"]}),
        (gs.spectrum, {"eq": k.upright, "name": "pi3_0", "samples": (0, 1),
                       "values": {"I1": 1, "I3": 1, "l": 0, "m0": 1}}),
        (gs.stabilizing_set, {"report": k.report, "name": "l", "values": {"I1": 1, "m0": 1, "pi3_0": 5}}),
        (gs.static_tilt, {"scene": k.field, "eliminate": None}), (gs.staude_cone, {"scene": k.heavy}),
        (gs.steady_motion, {"0": k.vehicle, "1": (0, 0, s("p0")), "2": (0, 0, 1), "omega": (0, 0, 0),
                            "label": "E"}), (gs.derivation.symplectic_slice, {"eq": k.upright}),
        (gs.stereographic, {}), (gs.symbol, {"name": "x"}), (gs.symmetric_gyrostat, {}),
        (gs.to_latex, {"obj": k.report.sufficient, "symbols": {"I1": "A"}, "label": "gyrostat"}),
        (gs.underwater_vehicle, {"inertia": (1, 2, 3), "mass": (1, 2, 3),
                                 "coupling": [[0, 0, 0], [0, 0, 0], [0, 0, 0]], "weight": (0, 0, 1),
                                 "gyrostatic_momentum": (0, 0, 0)}),
        (gs.uniform_field, {}), (gs.upright, {"scene": k.top, "spin": "pi3_0"}),
        (c.certified_chart, {"report": k.report, "region": {"I1": 1, "m0": 1, "l": (0, 1), "pi3_0": (0, 4)},
                             "resolution": "1/8", "limit": 1000, "progress": None}),
        (c.certify_box, {"report": k.report, "box": {"I1": 1, "m0": 1, "l": (2, 3), "pi3_0": (1, 2)},
                         "depth": 12, "limit": 1000}),
        (c.compile_margin, {"what": r["Condition"], "backend": "numpy"}),
        (c.save_netcdf, {"dataset": k.chart, "path": folder() + "/a.nc"}),
        (c.stability_chart, {"report": k.report, "x": ("pi3_0", [1, 2]), "y": ("l", [0, 1]),
                             "fixed": {"I1": 1, "m0": 1}, "margins": False, "damped": False, "store": None,
                             "backend": "numpy", "threads": 1, "progress": None}),
        (c.stability_chart, {"report": k.report, "x": ("pi3_0", [1, 2]), "y": ("l", [0, 1]),
                             "fixed": {"I1": 1}, "axes": {"m0": [1, 2]}, "margins": True}),
        (c.verdicts, {"0": k.report, "1": {"I1": 1}, "m0": 1, "l": [[0.0], [0.5]], "pi3_0": [-2.0, 1.0],
                      "damped": False, "invalid": "raise", "backend": "numpy", "threads": 1, "out": None,
                      "progress": None}),
        (c.verdicts, {"0": k.report, "I1": 1, "m0": 1, "l": [[0.0], [0.5]], "pi3_0": [-2.0, 1.0],
                      "invalid": "mark", "out": np.zeros((2, 2), np.int8)}),
        (c.with_barriers, {"chart": k.kicked, "report": k.wheeled}),
        (m.angle_rates, {"omega": (s("omega1"), 0, 0), "convention": "zxz"}),
        (m.angular_momentum, {"body": k.free.body, "convention": "zxz"}),
        (m.angular_velocity, {"convention": "zxz"}),
        (m.effective_potential, {"body": gs.symmetric_gyrostat(), "potential": gs.uniform_field()}),
        (m.expansion, {"eq": k.upright, "order": 3}),
        (m.free_precession, {"inertia": (1, 2), "transverse": 3, "axial": 3}),
        (m.lagrangian, {"body": gs.symmetric_gyrostat(), "potential": gs.uniform_field(),
                        "convention": "zxz"}),
        (m.momenta, {"body": gs.symmetric_gyrostat(), "convention": "zxz"}),
        (m.momentum_limits, {"body": k.free.body, "energy": 5}),
        (m.polhode_period, {"inertia": (1, 2, 3), "momentum": ("0.3", "0.2", "0.9"), "digits": 15}),
        (m.principal_axes, {"body": gs.Gyrostat([[3, 1, 0], [1, 3, 0], [0, 0, 5]], (1, 1, 0))}),
        (m.rotation, {"convention": "zxz"}),
        (m.torque_equations, {"body": k.free.body, "torque": ("tau1", "tau2", "tau3")}),
        (p.animate_top, {"motion": k.motion, "times": [0, 1], "ax": space}),
        (p.caption, {"ax": p.draw_chart(k.chart, flat())}),
        (p.draw_amended_potential, {"scene": k.gyrostat, "values": {"C1": 5}, "ax": space}),
        (p.draw_attitudes, {"scene": k.satellite, "values": {}, "ax": space}),
        (p.draw_bifurcation_diagram, {"scene": k.top, "name": "omega", "ends": (0, 3), "values":
                                      {"I1": 2, "I3": 1, "l": 0, "m0": -1}, "ax": flat}),
        (p.draw_chart, {"ds": k.chart, "ax": flat}),
        (p.draw_cones, {"inertia": (2, 1), "transverse": 1, "axial": 2, "ax": space}),
        (p.draw_well, {"rotation": gs.relative_equilibria(k.free, {"M": 1})[0], "ax": space}),
        (p.draw_effective_potential, {"scene": k.top, "values": {"I1": 1, "I3": "1/2", "l": 0, "m0": 1,
                                      "p_phi": 2, "p_psi": 3}, "energy": 10, "ax": flat}),
        (p.draw_eigenvalues, {"eq": k.upright, "name": "pi3_0", "samples": (0, 1, 2),
                              "values": {"I1": 1, "I3": 1, "l": 0, "m0": 1}, "ax": flat}),
        (p.draw_energy_momentum, {"scene": k.top, "values": {"I1": 1, "I3": 1, "l": 0, "m0": 1, "p_psi": 1},
                                  "window": (-2, 2, -2, 2), "ax": flat}),
        (p.draw_librations, {"motion": known_libration(), "times": [0, 1, 2], "ax": flat,
                             "pointing": (1, 2, 3)}),
        (p.draw_momentum_sphere, {"scene": k.free, "momentum": 1, "values": {}, "energies": ("0.2",),
                                  "ax": space}),
        (p.draw_nutation, {"motion": k.motion, "times": [0, 1, 2], "ax": space}),
        (p.draw_rotor_set, {"scene": gs.assemble(gs.Gyrostat((1, 2, 3))), "values": {"l2": 0, "M": 1},
                            "ax": flat}),
        (p.draw_smelt_plane, {"rotor": 0, "bodies": {"pole": (60, 70, 35)}, "ax": flat}),
        (p.draw_staude_cone, {"scene": k.heavy, "values": {}, "ax": space}),
        (p.draw_staude_plane, {"scene": k.heavy, "values": {}, "omega": (-2, 2), "ax": flat}),
        (p.save_animation, {"animation": as_shown(p.animate_top(k.motion, [0, 1], space())),
                            "path": folder() + "/a.gif", "fps": 25}),
        (p.view_motion, {"motion": k.motion, "times": [0, 1]}),
        (d.check, {"sources": ("AR",), "progress": None}), (d.load, {"source": "AR"}),
        (t.confirm, {"report": k.report, "values": {"I1": 1, "I3": 1, "l": 0, "m0": 1, "pi3_0": 1},
                     "sizes": (1e-3, 1e-4, 1e-5)}),
        (t.motion, {"scene": k.top, "state": ("0.3", "-0.2", "1.5", "0.6", 0, "0.8"),
                    "values": {"I1": 1, "I3": "0.6", "l": "0.4", "m0": 1}, "precision": None,
                    "tolerance": None}),
        (t.motion, {"scene": k.free, "state": ("0.3", "0.2", "0.9"), "precision": 30}),
        (t.motion, {"scene": k.heavy, "state": (0, 0, 3, "0.6", 0, "0.8"), "tolerance": 1e-9}),
        (t.roll_pitch_yaw, {"turns": np.eye(3), "pointing": (1, 2, 3)}),
    ]


@cache
def known_libration():
    """The motion of a satellite."""
    scene = gs.assemble(gs.Gyrostat((60, 70, 35), (0, 0, 0)), gs.circular_orbit(1))
    return gs.trajectories.motion(scene, gs.release(scene, ("1/10", 0, 0)))


def methods():
    """Methods that take something."""
    k, r = known(), results()
    s, eq, U, space_ = gs.symbol, k.upright, k.top.potential, k.top.space
    cone, arc = r["StaudeCone"], r["Arc"]
    return [
        (r["AmendedPotential"].critical_points, {"values": {"C1": 5}}),
        (U.changed, {"change": same}), (U.check_size, {"numbers": {s("m0"): s("m0") * 0 + 1}}),
        (U.following, {"derivative": s("dU")}), (U.value, {"derivative": s("dU")}),
        (r["CoupledPotential"].changed, {"change": same}),
        (r["CoupledPotential"].following, {"derivative": s("n1")}),
        (eq.at_point, {"expression": s("pi3")}), (eq.insert, {"expression": s("dU")}),
        (eq.insert_field, {"expression": s("dU")}), (eq.derived, {"verb": gs.derivation.linearize}),
        (k.free.body.changed, {"change": same}),
        (k.free.body.kinetic_energy, {"momentum": (s("pi1"), 0, 1)}),
        (arc.rotation, {"at": 1}),
        (arc.near, {"at": 1}),
        (space_.gradient, {"f": s("pi1")}), (space_.hessian, {"f": s("pi1")**2}),
        (space_.bracket, {"f": s("pi1"), "g": s("pi2")}), (space_.jacobiator, {"i": 0, "j": 1, "k": 2}),
        (k.report.verdict, {"values": {"I1": 1, "l": 0, "m0": 1, "pi3_0": 3}, "damped": False}),
        (k.report.normal_form, {"values": {"I1": 1, "I3": 1, "l": 0, "m0": 1, "pi3_0": 3}, "degree": 4}),
        (k.report.window, {"values": {"I1": 1}}),
        (k.report.itself, {"values": {"I1": 1, "I3": 1, "l": 0, "m0": 1, "pi3_0": 3}}),
        (r["Solution"].contains, {"values": {"I1": 1, "m0": 1, "pi3_0": 5, "l": 0}}),
        (cone.arcs, {"values": {}}),
        (k.top.integrals_at, {"state": (0, 0, 3, 0, 0, 1)}),
        (gs.Verdict.of, {"stable": True}), (r["charts.CertifiedChart"].at, {"pi3_0": 3}),
        (r["charts.CompiledMargin"], {"I1": 1, "l": 0, "m0": 1, "pi3_0": [1.0, 3.0]}),
        (r["mechanics.Reduction"].square, {"U": s("k3")}),
        (k.motion, {"t": [0.0, 1.0]}), (k.motion.attitude, {"t": [0.0, 1.0]}),
        (k.motion.angles, {"t": [0.0, 1.0]}), (k.motion.drift, {"t": [0.0, 1.0]}),
        (k.motion.to_xarray, {"t": [0.0, 1.0], "pointing": (1, 2, 3)}),
        (known_libration().to_xarray, {"t": [0.0, 1.0], "pointing": (1, 2, 3)}),
        (gs.table, {"found": gs.relative_equilibria(k.free, {"M": 1}), "wells": True}),
        (gs.wheel_speeds, {"scene": k.spinning, "name": "s", "roll": 1, "directions": None, "unit": "rpm"})]


def same(x):
    """The identity."""
    return x


def called(function, given):
    """A call: what stands under a number is given by position."""
    given = {name: value() if value is flat or value is space else value for name, value in given.items()}
    positions = [value for name, value in given.items() if name.isdigit()]
    names = {name: value for name, value in given.items() if not name.isdigit()}
    if not positions and inspect.isroutine(function):
        for parameter in inspect.signature(function).parameters.values():
            if parameter.kind is parameter.POSITIONAL_ONLY:
                positions.append(names.pop(parameter.name))
    return as_shown(function(*positions, **names))


def as_shown(result):
    """An animation that is not shown warns when it is thrown away, in whatever test that is."""
    if hasattr(result, "_draw_was_started"):
        result._draw_was_started = True
    return result


def calls():
    """(name, callable, arguments) of all."""
    for function, given in [*verbs(), *methods()]:
        owner = type(getattr(function, "__self__", None)).__name__
        name = getattr(function, "__qualname__", type(function).__name__ + ".__call__")
        yield (f"{owner}.{function.__name__}" if owner not in ("NoneType", "module", "EnumType", "ABCMeta")
               and hasattr(function, "__name__") else name), function, given
    yield from constructors()
