"""The public surface: names, signatures, and docstrings a reference can be made from."""
import ast
import builtins
import doctest
import enum
import inspect
import json
import re
import textwrap
from functools import cached_property
from pathlib import Path

import pytest

import gyrostat as gs

NAMESPACES = ("charts", "derivation", "mechanics", "plotting", "published", "questions", "trajectories")
LIST = Path(__file__).with_name("surface.txt")                 # python tests/test_surface.py writes it
SECTIONS = ("Parameters", "Returns", "Raises", "Notes", "References", "Examples")   # numpydoc's, in its order


def public():
    """(name as a user writes it, object) of everything public, without namespaces."""
    for prefix, home in (("gs", gs), *((f"gs.{name}", getattr(gs, name)) for name in NAMESPACES)):
        for name in home.__all__:
            if name not in (*NAMESPACES, "errors"):
                yield f"{prefix}.{name}", getattr(home, name)


def function_of(member):
    """What a method, a property, a cached property or a cached function runs."""
    if isinstance(member, property):
        return member.fget
    if isinstance(member, cached_property):
        return member.func
    return inspect.unwrap(getattr(member, "__func__", member))


def methods(cls):
    """(name, member) of what a class defines in public, or a base of it, its fields left out."""
    ours = [base for base in reversed(cls.__mro__) if base.__module__.startswith("gyrostat.")
            and base.__module__ != "gyrostat._display"]
    for name, member in (pair for base in ours for pair in vars(base).items()):
        if not name.startswith("_") and inspect.isfunction(function_of(member)):
            yield name, member


def signature(what):
    """Names, kinds and defaults, without types, which have a checker of their own."""
    given = inspect.signature(what)
    bare = [p.replace(annotation=p.empty) for p in given.parameters.values()]
    return str(given.replace(parameters=bare, return_annotation=given.empty))


def surface():
    """A line for each public name, with what can be called or asked of it."""
    for name, what in public():
        if inspect.isclass(what) and issubclass(what, enum.Enum):
            yield f"{name}: {', '.join(member.name for member in what)}"
        elif callable(what):
            yield name + signature(what)
        else:
            yield name
        if inspect.isclass(what):
            for attribute, member in methods(what):
                asked = isinstance(member, property | cached_property)
                yield f"{name}.{attribute}" + ("" if asked else signature(function_of(member)))


def test_the_surface_is_the_one_that_is_written_down():
    """Names, order of arguments and defaults change on purpose only, with a line in CHANGELOG."""
    assert list(surface()) == LIST.read_text(encoding="utf-8").splitlines()


def test_dir_and_all_are_the_surface():
    """What Tab offers is what is there, each under one name; at the top 81 at most."""
    assert set(dir(gs)) == set(gs.__all__) and len(gs.__all__) <= 81
    for home in (gs, *(getattr(gs, name) for name in NAMESPACES)):
        assert len(set(home.__all__)) == len(home.__all__)
        assert all(hasattr(home, name) for name in home.__all__)
    found = [what for name, what in public() if name != "gs.__version__"]
    assert len({id(what) for what in found}) == len(found)


def test_values_come_last():
    """Subject, name, values: where a verb takes a name and values, the name is first."""
    for name, what in public():
        order = list(inspect.signature(what).parameters) if inspect.isfunction(what) else []
        if "values" in order and {"name", "parameter"} & set(order):
            assert "name" in order and order.index("name") < order.index("values"), name


def documented():
    """(name, object, what is documented) of everything that has a docstring of its own."""
    for name, what in public():
        if callable(what):
            yield name, what, inspect.unwrap(what)
        if inspect.isclass(what):
            for attribute, member in methods(what):
                yield f"{name}.{attribute}", member, function_of(member)


EVERYTHING = [pytest.param(*rest, id=name) for name, *rest in documented()]


def sections(docstring):
    """The text before the first section, and each section by name."""
    parts = re.split(r"^(\w[\w ]*)\n(-{3,})\n", inspect.cleandoc(docstring), flags=re.MULTILINE)
    found = dict(zip(parts[1::3], parts[3::3]))
    assert len(found) == len(parts) // 3, "a section comes twice"
    assert all(len(title) == len(line) for title, line in zip(parts[1::3], parts[2::3]))
    return parts[0], found


def entries(section):
    """(names, type, meaning) of each entry of a section of parameters or results."""
    for entry in re.split(r"\n(?=\S)", section.strip()):
        head, _, meaning = entry.partition("\n")
        names, _, kind = head.partition(" : ")
        yield [name.strip() for name in names.split(",")], kind, meaning


def parameters(what):
    """The names of the parameters as numpydoc writes them."""
    stars = {inspect.Parameter.VAR_KEYWORD: "**", inspect.Parameter.VAR_POSITIONAL: "*"}
    given = inspect.signature(what).parameters.values()
    return [stars.get(p.kind, "") + p.name for p in given if p.name not in ("self", "cls")]


def prose(docstring):
    """Without the examples, which are code."""
    return inspect.cleandoc(docstring).partition("\nExamples\n--------\n")[0]


def summary_is_a_sentence_on_one_line(member, what):
    """One line, then a blank one; a reference shows it in tables."""
    first, *rest = inspect.cleandoc(what.__doc__).splitlines()
    assert first.endswith(".") and not (rest and rest[0])


def sections_are_those_of_numpydoc_in_its_order(member, what):
    """A section of another name is dropped from the rendered page."""
    names = list(sections(what.__doc__)[1])
    assert names == [name for name in SECTIONS if name in names]


def each_parameter_is_described(member, what):
    """All of the signature, in its order, each with its type; arrays with their shape."""
    given = [] if isinstance(member, property | cached_property) or enum_class(what) else parameters(what)
    found = list(entries(sections(what.__doc__)[1].get("Parameters", ""))) if given else []
    assert [name for names, _, _ in found for name in names] == given
    for names, kind, _ in found:
        assert kind or names[0].startswith("**"), names
        assert "shape" in kind or not re.search(r"\barray|ndarray|Matrix", kind), names


def each_result_is_described(member, what):
    """What a function returns, with the shape of arrays."""
    if inspect.isclass(what) or isinstance(member, property | cached_property):
        return
    if inspect.signature(what).return_annotation not in (None, "None"):
        one_line = len(inspect.cleandoc(what.__doc__).splitlines()) == 1 and not parameters(what)
        text = sections(what.__doc__)[1].get("Returns", "")
        assert text or one_line
        assert "shape" in text or not re.search(r"\barray\b|ndarray|Matrix", text)


def errors_are_named(member, what):
    """Each error that the function itself raises; what is named is ours, or built in."""
    named = {name.strip() for names, _, _ in entries(sections(what.__doc__)[1].get("Raises", "\n"))
             for name in names if name.strip()}
    assert all(hasattr(gs.errors, name) or hasattr(builtins, name) for name in named)
    if not inspect.isclass(what):
        tree = ast.parse(textwrap.dedent(inspect.getsource(what)))
        raised = {n.exc.func.id for n in ast.walk(tree) if isinstance(n, ast.Raise)
                  and isinstance(n.exc, ast.Call) and isinstance(n.exc.func, ast.Name)}
        assert raised <= named


def example_is_one_to_copy(member, what):
    """It starts with import gyrostat as gs; functions and classes have one (doctest runs it)."""
    lines = re.findall(r"^\s*>>> (.*)", what.__doc__, flags=re.MULTILINE)
    assert lines or member not in (value for _, value in public())
    assert not lines or lines[0] == "import gyrostat as gs" and "Examples" in sections(what.__doc__)[1]
    assert not any(re.match(r"from gyrostat|import gyrostat\.", line) for line in lines)


def no_markup_breaks(member, what):
    """Bars and a trailing underscore are references to reStructuredText; backticks come in pairs."""
    text = prose(what.__doc__)
    assert not re.search(r"\|\S", text) and not re.search(r"\w_(?!\w)", text.replace("e_z", ""))
    assert all(paragraph.count("`") % 2 == 0 for paragraph in text.split("\n\n"))


def docutils_renders_it(member, what):
    """Without a warning: what numpydoc makes of it, entry by entry."""
    core = pytest.importorskip("docutils.core")
    head, found = sections(what.__doc__)
    meanings = [textwrap.dedent(meaning) for title in ("Parameters", "Returns", "Raises")
                for _, _, meaning in entries(found.pop(title, ""))]
    for text in (head, *meanings, *found.values()):
        core.publish_string(text, settings_overrides={"halt_level": 2, "report_level": 5})


def example_brings_its_names(member, what):
    """It runs as it stands, without what its module has imported."""
    code = doctest.script_from_examples(what.__doc__)
    used = {node.id: type(node.ctx) for node in ast.walk(ast.parse(code)) if isinstance(node, ast.Name)}
    known = {name.id for name in ast.walk(ast.parse(code))
             if isinstance(name, ast.Name) and isinstance(name.ctx, ast.Store)}
    known |= {alias.asname or alias.name for node in ast.walk(ast.parse(code))
              if isinstance(node, ast.Import | ast.ImportFrom) for alias in node.names}
    known |= {node.arg for node in ast.walk(ast.parse(code)) if isinstance(node, ast.arg)}
    assert set(used) <= known | set(dir(builtins))


@pytest.mark.few(40)
@pytest.mark.parametrize(("member", "what"), EVERYTHING)
def test_docstring(member, what):
    """Every rule of the house, of each docstring."""
    for rule in (summary_is_a_sentence_on_one_line, sections_are_those_of_numpydoc_in_its_order,
                 each_parameter_is_described, each_result_is_described, errors_are_named,
                 example_is_one_to_copy, no_markup_breaks, example_brings_its_names, docutils_renders_it):
        rule(member, what)


def enum_class(what):
    """Whether it is a class of named values, which nobody calls."""
    return inspect.isclass(what) and issubclass(what, enum.Enum)


def test_imports_in_documents_are_public():
    """README, docs and notebooks import gyrostat and its namespaces only, and public names from them."""
    root = Path(__file__).parents[1]
    for path in (root / "README.md", *root.glob("docs/**/*.md"), *root.glob("notebooks/*.ipynb")):
        text = path.read_text(encoding="utf-8")
        if path.suffix == ".ipynb":
            text = "\n".join("".join(cell["source"]) for cell in json.loads(text)["cells"])
        for module, names in re.findall(r"from (gyrostat[\w.]*) import (\([^)]*\)|[^\n]+)", text):
            home = gs if module == "gyrostat" else getattr(gs, module.removeprefix("gyrostat."), None)
            assert home is not None, (path.name, module)
            imported = {name.strip() for name in names.strip("()").split(",")} - {""}
            assert imported <= set(home.__all__), (path.name, names)
        assert not re.search(r"import gyrostat\.", text), path.name


if __name__ == "__main__":
    LIST.write_text("".join(f"{line}\n" for line in surface()), encoding="utf-8")
