"""The chain of modules, and what importing the library loads."""
import ast
import subprocess
import sys
from pathlib import Path

import pytest

import gyrostat

SRC = Path(gyrostat.__file__).parent
CHAIN = ("version start errors precision floats notation inputs magnitudes parts scanner grammar expressions algebra matrices "
         "algebraic quotients transcendental exact signs body potential fields liepoisson system equilibria families orbit "
         "linearization energy_casimir implication conditions reduction spherical recognition standard boundary sphere drift "
         "roots forms amended torquefree values notes stability branch branches elimination planecurves stations bifurcations "
         "critical intervals cases solve cells stabilizing attitude freebody presentation order progress straightline rounding "
         "labels grids pieces continuation tiles kernels numeric energymomentum spectra arraysigns enclosures regions proofs "
         "coverings boxes certify blocks results document unicode references files linebreaks latex article twofold contours "
         "datasets marks layout stores charts periods elliptic levels profiles turning nutation spectral spinors precession "
         "axialmotion steady polhodes loops freemotion integrators integration columns motions turned routes confirmation "
         "trajectories plotting published cli").split()
PLOTTING = ("looks globe charts scenes levels momentum nutation potentials diagrams energies spectra cones solids animation interactive "
            "__init__").split()
VIEWS = CHAIN[CHAIN.index("branch"):]
PUBLISHED = ("jacobi language scenes kinematics names criteria sampling independent independent_kinematics independent_names statements "
             "evidence search formulas claims __init__ listing typesetting errata").split()


def imported(path, package):
    """Modules of ours that a file imports at its top level."""
    for node in ast.parse(path.read_text(encoding="utf-8")).body:
        if isinstance(node, ast.ImportFrom) and node.level == package:
            yield from [node.module.split(".")[0]] if node.module else [alias.name for alias in node.names]


def test_every_module_is_in_the_chain():
    """The chain names every module of the package."""
    assert {p.stem for p in SRC.glob("*.py")} - {"__init__", "__main__"} | {"cli", "published", "plotting"} == set(CHAIN)
    assert {p.stem for p in (SRC / "published").glob("*.py")} == set(PUBLISHED)
    assert {p.stem for p in (SRC / "plotting").glob("*.py")} == set(PLOTTING)


@pytest.mark.parametrize("name", [n for n in CHAIN if n not in ("cli", "published", "plotting")])
def test_modules_import_only_from_above(name):
    """Reading the chain top to bottom is reading the theory: nothing is used before it is defined."""
    assert set(imported(SRC / f"{name}.py", 1)) <= set(CHAIN[:CHAIN.index(name)])


@pytest.mark.parametrize("name", PUBLISHED)
def test_modules_of_published_import_only_from_above(name):
    """The package of published formulas is a chain of its own, on top of the library."""
    path = SRC / "published" / f"{name}.py"
    top = {"Finding", "source_of"} if name in ("listing", "errata") else set()
    assert set(imported(path, 1)) <= set(PUBLISHED[:PUBLISHED.index(name)]) | top
    assert set(imported(path, 2)) <= set(CHAIN[:CHAIN.index("published")])


@pytest.mark.parametrize("name", PLOTTING)
def test_modules_of_plotting_import_only_from_above(name):
    """So are the pictures."""
    path = SRC / "plotting" / f"{name}.py"
    assert set(imported(path, 1)) <= set(PLOTTING[:PLOTTING.index(name)])
    assert set(imported(path, 2)) <= set(CHAIN[:CHAIN.index("plotting")])


def loaded(code):
    """Names of all modules loaded after running code in a new process."""
    run = subprocess.run([sys.executable, "-c", f"{code}; import sys; print(*sys.modules)"], capture_output=True, text=True, check=True)
    return set(run.stdout.split())


def test_import_loads_sympy_and_nothing_heavier():
    """import gyrostat loads no numpy, scipy or matplotlib, and no view."""
    new = loaded("import gyrostat")
    assert "sympy" in new and "gyrostat.stability" in new
    assert not {"numpy", "scipy", "matplotlib", "rich"} & {m.split(".")[0] for m in new}
    assert not {f"gyrostat.{view}" for view in VIEWS} & new


def test_a_verdict_loads_no_view_and_no_numpy():
    """A derivation and a verdict need neither typesetting nor floating-point arrays."""
    new = loaded("import gyrostat as g; "
                 "r = g.analyze(g.upright(g.assemble(g.symmetric_gyrostat(), g.uniform_field()))); "
                 "r.verdict({'I1': 1, 'l': 0, 'm0': 1, 'pi3_0': 3})")
    assert not {f"gyrostat.{view}" for view in VIEWS} & new and "numpy" not in new


def test_help_does_not_load_the_derivation_views():
    """The command line understands its arguments before it loads what typesets."""
    new = loaded("import gyrostat.cli; gyrostat.cli.parser()")
    assert "gyrostat.document" not in new and "gyrostat.published" not in new


def test_oracle_imports_nothing_of_ours():
    """The oracle is independent."""
    tree = ast.parse((Path(__file__).parent / "oracle.py").read_text(encoding="utf-8"))
    names = {alias.name for n in ast.walk(tree) if isinstance(n, ast.Import) for alias in n.names}
    names |= {n.module for n in ast.walk(tree) if isinstance(n, ast.ImportFrom)}
    assert names == {"fractions", "mpmath", "numpy"}


def test_no_text_is_evaluated():
    """eval, exec and sympify, which execute text, occur nowhere in the library."""
    for path in SRC.rglob("*.py"):
        calls = {n.func.id for n in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
                 if isinstance(n, ast.Call) and isinstance(n.func, ast.Name)}
        assert not calls & {"eval", "exec", "sympify", "parse_expr"}, path
