"""The house: packages that import downwards only, and what importing the library loads."""
import ast
import importlib
import subprocess
import sys
from collections import defaultdict
from functools import cache
from graphlib import TopologicalSorter
from pathlib import Path

import pytest

import gyrostat

SRC = Path(gyrostat.__file__).parent
FLOORS = ("version _lazy _cached _display errors notation typesetting registry arguments algebra mechanics "
          "stability derivation equilibria parameters printing charts trajectories plotting published "
          "questions cli __main__").split()
OPTIONAL = {"matplotlib", "xarray", "dask", "distributed", "zarr", "numba", "llvmlite", "scipy", "heyoka",
            "contourpy", "plotly"}


@cache
def parsed(path):
    """The tree of a file."""
    return ast.parse(path.read_text(encoding="utf-8"))


def statements(block, inside=False):
    """(statement, whether it stands inside a function) of a block and of the blocks in it.

    What an expression holds is no statement.
    """
    for one in block:
        yield one, inside
        within = inside or isinstance(one, ast.FunctionDef)
        for name in ("body", "orelse", "finalbody", "handlers", "cases"):
            yield from statements(getattr(one, name, ()), within)


@cache
def imports(path):
    """(module, inside a function) of every import of ours or of others in a file.

    Ours as paths below the package.
    """
    here, found = path.relative_to(SRC).with_suffix("").parts, []
    for node, inside in statements(parsed(path).body):
        if isinstance(node, ast.ImportFrom) and node.level:
            module = (*here[:len(here) - node.level], *(node.module or "").split("."))
            for alias in node.names:
                inner = (*filter(None, module), alias.name)
                ours = (
                    inner
                    if SRC.joinpath(*inner).with_suffix(".py").exists() or SRC.joinpath(*inner).is_dir()
                    else inner[:-1]
                )
                found.append((ours, inside))
        elif isinstance(node, ast.Import | ast.ImportFrom):
            for name in (
                [node.module] if isinstance(node, ast.ImportFrom) else [alias.name for alias in node.names]
            ):
                found.append((name, inside))
    return found


@pytest.mark.slow
def test_imports_point_downwards_and_in_no_circle():
    """A package uses those below it only, imports inside functions counted.

    Within it no module needs itself.
    """
    graph = {}
    for path in SRC.rglob("*.py"):
        here = path.relative_to(SRC).with_suffix("").parts
        graph[here] = {module for module, _ in imports(path) if isinstance(module, tuple)}
        if here != ("__init__",):
            assert all(FLOORS.index(module[0]) <= FLOORS.index(here[0])
                       for module in graph[here]), (path, graph[here])
    list(TopologicalSorter(graph).static_order())


@pytest.mark.slow
def test_folders_of_a_package_import_downwards():
    """No two folders of a package import each other, directly or by way of others."""
    graph = defaultdict(set)
    for path in SRC.rglob("*.py"):
        here = path.relative_to(SRC).parts[:-1]
        graph[here[:2]] |= {there[:2] for there, _ in imports(path)
                            if here[1:] and there[0] == here[0] and there[1:2] not in ((), here[1:2])
                            and SRC.joinpath(*there[:2]).is_dir()}
    list(TopologicalSorter(graph).static_order())


@pytest.mark.slow
def test_only_optional_packages_are_imported_inside_functions():
    """What is always there stands at the top."""
    for path in SRC.rglob("*.py"):
        for module, inside in imports(path):
            assert not inside or isinstance(module, str) and module.split(".")[0] in OPTIONAL, (path, module)


def loaded(code):
    """Names of all modules loaded after running code in a new process."""
    run = subprocess.run([sys.executable, "-c", f"{code}\nimport sys; print(*sys.modules)"],
                         capture_output=True, text=True, check=True)
    return set(run.stdout.split())


def above(modules):
    """Those among the modules that stand above stability, but for what answers Ctrl-C while the rest is
    loaded.
    """
    floors = FLOORS[FLOORS.index("printing"):]
    return {m for m in modules if m.startswith("gyrostat.") and m.split(".")[1] in floors} - {
        "gyrostat.cli",
        "gyrostat.cli.start",
    }


def heavy(modules):
    """The packages among the modules that take long to load."""
    return {"sympy", "flint", "numpy", "scipy", "matplotlib", "rich"} & {m.split(".")[0] for m in modules}


@pytest.mark.slow
def test_import_loads_no_mathematics():
    """import gyrostat loads what its names need when they are used."""
    new = loaded("import gyrostat; import gyrostat.charts, gyrostat.mechanics")
    assert not heavy(new) and not above(new) - {"gyrostat.charts", "gyrostat.printing",
                                                "gyrostat.printing.files"}
    new = loaded("from gyrostat import analyze")
    assert "gyrostat.stability.report.report" in new and heavy(new) == {"sympy", "flint"} and not above(new)


@pytest.mark.parametrize("name", ["gyrostat", "gyrostat.charts", "gyrostat.mechanics",
                                  "gyrostat.questions"])
def test_what_type_checkers_read_is_what_is_loaded_later(name):
    """The names of a package, each imported for them from its home."""
    package = importlib.import_module(name)
    tree = ast.parse(Path(package.__file__).read_text(encoding="utf-8"))
    imported = {alias.name: node.module for block in tree.body if isinstance(block, ast.If)
                for node in block.body for alias in node.names}
    (call,) = (node for node in ast.walk(tree) if isinstance(node, ast.Call)
               and getattr(node.func, "id", "").endswith("later"))
    homes = ast.literal_eval(call.args[1])
    assert imported == {n: module if names else None for module, names in homes.items()
                        for n in names.split() or [module]}


@pytest.mark.slow
def test_a_name_that_is_loaded_is_kept_and_an_unknown_one_refused():
    """Its home is asked once."""
    new = loaded("import gyrostat; gyrostat.symbol; print(*vars(gyrostat))")
    assert "symbol" in new and "analyze" not in new
    with pytest.raises(AttributeError, match=r"^gyrostat\.charts has no chart_of: dir\(gyrostat\.charts\)"):
        gyrostat.charts.chart_of  # noqa: B018


@pytest.mark.slow
def test_a_verdict_loads_no_view_and_no_numpy():
    """A derivation and a verdict need neither typesetting nor floating-point arrays."""
    new = loaded("import gyrostat as g; "
                 "r = g.analyze(g.upright(g.assemble(g.symmetric_gyrostat(), g.uniform_field()))); "
                 "r.verdict({'I1': 1, 'l': 0, 'm0': 1, 'pi3_0': 3})")
    assert not above(new) and "numpy" not in new


@pytest.mark.few(4)
@pytest.mark.parametrize("arguments", ["--version", "--help", "report --help", "plot cones --help",
                                       "report --potential", "chart --axis", "--print-completion bash"])
def test_the_command_line_is_understood_without_mathematics(arguments):
    """Versions, help and bad options load nothing that a verb needs."""
    new = loaded(f"""
from contextlib import suppress
from gyrostat.cli.parser import main
with suppress(SystemExit):
    main({arguments.split()})""")
    assert not heavy(new) and "gyrostat.cli.options.scene_files" not in new


def test_files_are_short():
    """At most 250 lines each: what is longer has two themes."""
    for path in [*SRC.rglob("*.py"), *Path(__file__).parent.rglob("*.py")]:
        assert len(path.read_text(encoding="utf-8").splitlines()) <= 250, path


def test_oracles_import_nothing_of_ours():
    """They are independent."""
    for path in (Path(__file__).parent / "oracles").rglob("*.py"):
        nodes = list(ast.walk(parsed(path)))
        names = {alias.name for n in nodes if isinstance(n, ast.Import) for alias in n.names}
        names |= {n.module for n in nodes if isinstance(n, ast.ImportFrom) and not n.level}
        assert not any(name.split(".")[0] == "gyrostat" for name in names), path


@pytest.mark.slow
def test_no_property_has_a_lock():
    """That of functools has one in Python 3.11; two threads can wait for each other."""
    for path in SRC.rglob("*.py"):
        taken = {alias.name for n in ast.walk(parsed(path)) if isinstance(n, ast.ImportFrom)
                 and n.module == "functools" for alias in n.names}
        assert "cached_property" not in taken or path.name == "_cached.py", path


@pytest.mark.slow
def test_no_text_is_evaluated():
    """eval, exec and sympify, which execute text, occur nowhere in the library."""
    for path in SRC.rglob("*.py"):
        calls = {n.func.id for n in ast.walk(parsed(path))
                 if isinstance(n, ast.Call) and isinstance(n.func, ast.Name)}
        assert not calls & {"eval", "exec", "sympify", "parse_expr"}, path
