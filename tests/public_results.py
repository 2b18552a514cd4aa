"""One of each kind of scene and of result that is public, made once."""
import tempfile
from functools import cache
from types import SimpleNamespace

from matplotlib.figure import Figure

import gyrostat as gs


def flat():
    """Axes of a plane."""
    return Figure(figsize=(2, 2)).subplots()


def space():
    """Axes of space."""
    return Figure(figsize=(2, 2)).add_subplot(projection="3d")


@cache
def folder():
    """Where files are written."""
    return tempfile.mkdtemp()


@cache
def known():
    """Scenes of each kind, and what is derived from them."""
    s = gs.symbol
    top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    field = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
    heavy = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)),
                        gs.general_potential(lambda k1, k2, k3: k1 + k2 + k3))
    gyrostat = gs.assemble(gs.Gyrostat((1, 2, 3), (0, "1/2", 1)),
                           gs.general_potential(lambda k1, k2, k3: k1 + k2 + k3))
    free = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)))
    spun = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, s("l"))))
    satellite = gs.assemble(gs.Gyrostat((1, "5/4", "8/5"), (0, 0, 0)), gs.circular_orbit(1))
    spinning = gs.assemble(gs.Gyrostat((1, "5/4", "8/5"), (0, s("s"), 0)), gs.circular_orbit(1))
    letters = gs.assemble(gs.Gyrostat(gyrostatic_momentum=(0, s("l"), 0)), gs.circular_orbit())
    round_one = gs.assemble(gs.symmetric_gyrostat(), gs.circular_orbit())
    vehicle = gs.underwater_vehicle(weight=(0, 0, s("m0")))
    upright = gs.upright(top)
    report = gs.analyze(upright)
    values = {"I1": 1, "I3": 1, "l": 0, "m0": 1, "pi3_0": 3}
    motion = gs.trajectories.motion(top, (0, 0, 3, "0.6", 0, "0.8"), {"I1": 1, "I3": 1, "l": 0, "m0": 1})
    chart = gs.charts.stability_chart(report, x=("pi3_0", [1, 2]), y=("l", [0, 1]),
                                      fixed={"I1": 1, "m0": 1})
    wheel = gs.Rotor((0, 0, 1), "40 kg m^2", rate="60 rpm")
    dual = gs.gyrostat_with_rotors(["1000 kg m^2", "1000 kg m^2", "200 kg m^2"], [wheel], lumped=True)
    wheeled = gs.analyze(gs.earth_pointing(gs.assemble(gs.Gyrostat((60, 70, 35), (0, s("l"), 0)),
                                                       gs.circular_orbit())))
    kicked = gs.charts.stability_chart(wheeled, x=("l", [0, 1]), y=("omega0", [1, 2]))
    return SimpleNamespace(**{name: value for name, value in locals().items() if name != "s"})


@cache
def results():
    """One of each kind of result, by the name of its class."""
    k = known()
    solution = gs.stabilizing_set(k.report, "l", {"I1": 1, "m0": 1, "pi3_0": 5})
    (first, *_), boundary = solution.parts, gs.charts.certify_box(
        k.report, {"I1": 1, "m0": 1, "l": 0, "pi3_0": (3, 4)})
    region = {"I1": 1, "m0": 1, "l": 0, "pi3_0": (0, 4)}
    finding = gs.published.check(["AR"])[0]
    wrong = next(f for f in gs.published.check(["AR"]) if f.statement.key == "2K-dot")
    spin = gs.equilibrium(gs.assemble(gs.Gyrostat((3, 5, 4), (0, 0, 0)),
                                      gs.general_potential(lambda k1, k2, k3: 2 * (k2 + k3) / 3)),
                          (-2, "-5/3", "-8/3", "2/3", "1/3", "2/3"))
    numbers = {"I1": 2, "I3": 1, "l": 0, "m0": 3, "omega": 2}
    hanging = gs.hanging(k.top)
    window = gs.analyze(gs.upright(gs.assemble(gs.Gyrostat((5, 4, 3), (0, 0, 0)),
                                               gs.general_potential(lambda k1, k2, k3: k3)))).window()
    found = {
        "AmendedPotential": gs.amended_potential(k.gyrostat), "Arc": gs.staude_cone(k.gyrostat).arcs({})[4],
        "Bifurcation": gs.bifurcations(k.top)[0],
        "Case": first.cases[0],
        "Condition": k.report.sufficient.alternatives[0][0],
        "Continuation": gs.continuation(k.top, "omega", (1, 3), {"I1": 2, "I3": 1, "l": 0, "m0": 1}),
        "CoupledPotential": gs.circular_orbit(), "Criterion": k.report.sufficient,
        "CriticalPoint": gs.amended_potential(k.heavy).critical_points({"C1": 0})[0],
        "Decision": k.report.verdict({"I1": 1, "l": 0, "m0": 1, "pi3_0": 3}), "Equilibrium": k.upright,
        "Gyrostat": k.free.body,
        "Interval": first.cases[0].intervals[0], "LiePoisson": k.top.space,
        "Mark": gs.bifurcation_points(k.top, "pi3_0", {"I1": 1, "l": 0, "m0": 1})[0],
        "Linearization": gs.derivation.linearize(k.upright), "NormalForm": gs.analyze(spin).normal_form({}),
        "Potential": k.top.potential, "RelativeEquilibrium": gs.relative_equilibria(k.top, numbers)[0],
        "Piece": gs.continuation(k.heavy, "omega", (1, 2), {}).pieces[0], "Report": k.report,
        "Rotor": k.wheel, "SecondVariation": gs.derivation.second_variation(k.upright), "Solution": solution,
        "SolvedCondition": first, "System": k.top,
        "Spectrum": gs.spectrum(hanging, "pi3_0", (0, 1), {"I1": 1, "I3": 1, "l": 0, "m0": 1}),
        "StaudeCone": gs.staude_cone(k.heavy),
        "Window": window, "charts.BoxDecision": boundary,
        "charts.CertifiedChart": gs.charts.certified_chart(k.report, region, resolution="1/64"),
        "charts.CompiledMargin": gs.charts.compile_margin(k.report.sufficient.alternatives[0][0]),
        "mechanics.FreePrecession": gs.mechanics.free_precession((1, 2), 3, 3),
        "mechanics.Reduction": gs.mechanics.reduce(k.top),
        "published.Counterexample": wrong.outcome.counterexample,
        "published.Finding": finding, "published.Outcome": finding.outcome,
        "published.Source": gs.published.load("AR"), "published.Statement": finding.statement,
        "trajectories.Confirmation": gs.trajectories.confirm(
            k.report, {"I1": 1, "I3": 1, "l": 0, "m0": 1, "pi3_0": 1}, (1e-3, 1e-4, 1e-5)),
        "trajectories.Motion": k.motion}
    return {name: found[name] for name in sorted(found)}
