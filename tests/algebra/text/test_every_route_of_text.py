"""Every route of text into the library.

What would hang, break or run is a clear error at once, whatever way it comes.
"""

import random
import sys
from pathlib import Path

import numpy as np
import pytest
import sympy
from sympy import Rational

import gyrostat as gs
from gyrostat.algebra.text.grammar import parse
from gyrostat.algebra.text.inputs import json_object
from gyrostat.algebra.text.numbers import exact_number, shown
from gyrostat.cli.parser import main
from gyrostat.errors import (
    EquilibriumError,
    ExpressionError,
    GyrostatError,
    MissingExtraError,
    PotentialError,
    PublishedError,
    ValuesError,
    optional,
)
from gyrostat.notation import symbol
from gyrostat.published import check, load

sys.path.insert(0, str(Path(__file__).parents[3] / "benchmarks"))


def toml(tmp_path, formula="", text=None):
    path = tmp_path / "a.toml"
    path.write_text(
        text
        if text is not None
        else f'[source]\nname = "n"\ntitle = "t"\n[scene.s]\npotential = "m0*k3"\nparameters = ["x"]\n'
        f'[[formula]]\nkey = "a"\nwhere = "w"\nquantity = "x"\nkind = "identity"\nscene = "s"\n{formula}\n',
        encoding="utf-8",
    )
    return [path]


@pytest.mark.parametrize(
    "formula",
    [
        'printed = "c"\nlet = {a = "9**100", b = "a**100", c = "b**100"}',
        'printed = "c"\nlet = {a = "exp(1e3)", b = "exp(a)", c = "tan(b)"}',
        'printed = "c"\nlet = {a = "x**12", b = "a**12", c = "b**12"}',
        'printed = "b"\nlet = {a = "dot(state, state)**3", b = "dt(a)**12"}',
        'printed = "tan(x)"\nat = {x = "exp(1e9)"}',
        'printed = "sn(1e300, 1/2)"',
        'printed = "sn(x, 1/2)"\nat = {x = "1e300"}',
        'printed = "1/((x + 1)**2 - x**2 - 2*x - 1)"',
        'printed = "' + "(" * 3000 + '"',
        'printed = "x"\nlet = {' + ", ".join(f'a{i} = "x"' for i in range(1500)) + "}",
        'printed = "' + "1" * 5000 + '"\nkind = "number"'.replace("kind", "note"),
    ],
)
def test_formulas_are_bounded_through_their_abbreviations(tmp_path, formula):
    """A name of let, at or a function costs what it stands for."""
    with pytest.raises(PublishedError, match=r"a\.toml: a: "):
        check(toml(tmp_path, formula))


@pytest.mark.parametrize(
    "text",
    [
        "a = " + "[" * 2000 + "]" * 2000,
        "a = " + "{b = " * 500 + "1" + "}" * 500,
        "a = " + "1" * 5000,
        ".".join("a" * 3000) + " = 1",
        "[" + ".".join("a" * 500) + "]",
        "a = 0x" + "f" * 10000,
        "# it's\n" + ".".join("a" * 500) + " = 1",
        "a = 1\n" * 100_001,
        "\0",
        'a = "\\u001b[2J"',
        '"\\u009b2J" = 1',
        '[source]\nname = "n"\ntitle = "\\u202e"',
        "a = 1979-99-99",
        "a = [" + "[], " * 9 + "[" * 100,
    ],
)
def test_files_are_bounded_before_they_are_parsed(tmp_path, text):
    """Depth, digits, dots, size and control characters."""
    with pytest.raises(PublishedError) as error:
        load(*toml(tmp_path, text=text))
    assert str(error.value).isprintable() and len(str(error.value)) < 500


@pytest.mark.parametrize(
    "line",
    [
        b"[" * 3000,
        b'{"a":' * 3000,
        b'{"l": ' + b"1" * 200_000 + b"}",
        b'{"l": 1e999}',
        b'{"l": "tan(exp(1e8))"}',
        b'{"\\u001b[2J": 1}',
        b'{"l": "\\ud800"}',
        b'{"l": [[1]]}',
        b'{"l": Infinity}',
        b"\xff",
        b"{}{}",
        b"1",
        b'{"l": null}',
        b'{"l": 1, "l": 2}',
        b'{"l": "' + b"(" * 9000 + b'"}',
    ],
)
def test_lines_are_bounded_before_they_are_parsed(line):
    """A line of a batch is an object of numbers, or a GyrostatError that a terminal can show."""
    with pytest.raises(GyrostatError) as error:
        for name, value in json_object(line).items():
            gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(),
                                              gs.uniform_field()))).verdict({name: exact_number(value, name)})
    assert str(error.value).isprintable() and len(str(error.value)) < 500


def test_numbers_that_blow_up_a_potential_are_refused():
    """U = tan(exp(a k3)) is one thing, a = 10⁸ another: for a verdict, a motion and all equilibria."""
    scene = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(parse("tan(exp(m0*k3))")))
    numbers = {"I1": 1, "I3": 1, "l": 0, "m0": 10**8}
    from gyrostat.equilibria.search import relative_equilibria
    from gyrostat.trajectories.models import motion

    for ask in (
        lambda: gs.analyze(gs.upright(scene)).verdict({**numbers, "pi3_0": 1}),
        lambda: relative_equilibria(scene, {**numbers, "omega": 1}),
        lambda: motion(scene, (0, 0, 1, 0, 0, 1), numbers),
    ):
        with pytest.raises(ValuesError, match="more than 4000 bits"):
            ask()


@pytest.mark.parametrize(
    "text", ["1/((k3 + 1)**2 - k3**2 - 2*k3 - 1)", "k3/((m0 + 1)**2 - m0**2 - 2*m0 - 1)",
             "k3/(sin(k3)**2 + cos(k3)**2 - 1)"]
)
def test_a_denominator_that_is_zero_identically_is_refused(text):
    """It shows only when it is expanded."""
    with pytest.raises(PotentialError, match="identically"):
        gs.axial_potential(parse(text))


def test_degrees_add_up_in_a_product():
    """Neither factor is too high, the product is."""
    assert parse("a**60 + k3**60").is_Add
    with pytest.raises(ExpressionError, match="degree 120"):
        parse("a**60*k3**60")


def test_a_seeded_part_of_the_campaign():
    """No text raises anything but a GyrostatError."""
    from fuzz_texts import drawn

    for index in random.Random(5).sample(range(10**6), 250):
        text, _ = drawn(index, 2)
        try:
            exact_number(text)
        except GyrostatError as error:
            str(error).encode()


def test_symbols_are_kept_but_not_for_ever():
    """A second symbol of one name is the same to SymPy; names from a million lines are not remembered."""
    assert symbol.cache_info().maxsize and symbol("l") is symbol("l") == sympy.Symbol("l", real=True)


def test_decimals_are_shown_beside_the_fractions_that_they_are():
    """In text, in LaTeX and in messages; short fractions stay alone."""
    body = gs.Gyrostat((0.1, 0.5, 0.3), (0, 0, -0.7))
    assert "0.1 (3602879701896397/36028797018963968), 1/2, 0.3 (" in str(body) and "−0.7 (−" in str(body)
    assert "(0.1)" in body._repr_latex_()
    assert "(-0.7)" in body._repr_latex_()
    assert "(0.5)" not in body._repr_latex_()
    assert shown(Rational(1, 3)) == "1/3"
    assert shown(Rational(0.1)).startswith("0.1 (")
    assert shown(sympy.zoo) == "infinite"


def test_messages_name_what_was_meant():
    """Guesses, articles, and no class of SymPy as a word."""
    field = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    top, numbers = gs.analyze(gs.upright(field)), {"I1": 1, "I3": 1, "l": 0, "m0": 1}
    for ask, words in (
        (lambda: top.verdict({**numbers, "omega3_0": 1}), "did you mean pi3_0"),
        (lambda: top.verdict({**numbers, "pi3_0": "1,6"}), "decimal point, 1.6"),
        (lambda: top.verdict({**numbers, "pi3_0": "nan"}), "not finite"),
        (lambda: gs.analyze(gs.inclined(field)).verdict({"I1": 1, "I3": 1, "m0": 1, "omega": 1, "k3": 1.5}),
         "−1 < k3 < 1"),
        (lambda: gs.axial_potential(np.cos), "sympy.cos"),
        (lambda: gs.axial_potential(parse("m0*z")), "k3 for z, as in U = k3*m0"),
        (lambda: gs.axial_potential(parse("m0*cos(theta)")), "k3 for cos(theta)"),
        (lambda: gs.axial_potential(parse("m0*K3")), "k3 for K3"),
        (lambda: gs.analyze(field), "upright(scene)"),
        (lambda: gs.analyze(gs.Gyrostat()), "not an Equilibrium"),
        (lambda: parse("arctan(k3)"), "did you mean atan?"),
        (lambda: parse("ln(k3)"), "did you mean log?"),
        (lambda: gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(parse("1/(k3 - 1)")))),
         "infinite"),
    ):
        with pytest.raises(GyrostatError) as error:
            ask()
        assert words in str(error.value) and "zoo" not in str(error.value)


def test_all_missing_packages_are_named_at_once(monkeypatch):
    """One installation, not one after the other."""
    for name in ("xarray", "zarr", "netCDF4"):
        monkeypatch.setitem(sys.modules, name, None)
    with pytest.raises(MissingExtraError,
                       match=r'xarray, zarr, netCDF4 cannot.*they are optional packages; '
                             r'.*"gyrostat\[charts\]"'):
        optional("xarray", "charts")


def test_trivial_conditions_are_not_shown():
    """Of conditions that always hold, |0| < 1 and 1 > 0, nothing is printed."""
    scene = gs.assemble(gs.Gyrostat((1, 1, 1), (0, 0, symbol("l"))), gs.axial_potential(lambda k3: k3**2 / 2))
    assert "|0| < 1" not in str(gs.analyze(gs.static_tilt(scene)))
    condition = gs.stability.criteria.conditions.Condition(sympy.S.One, True, "p", (symbol("l"),),
                                                           symbol("k3"))
    assert str(condition) == "l ≠ 0" and gs.printing.formats.latex.formula(condition) == r"l \neq 0"


def test_the_command_line_ends_with_a_sentence(capsys):
    """The same gate for --set, --potential, --x and --state."""
    scene = ["--potential", "m0*k3", "--set", "I1=1", "--set", "I3=1", "--set", "m0=1"]
    for arguments in (
        ["decide", *scene, "--set", "l=tan(exp(1e8))"],
        ["decide", "--potential", "tan(exp(1e8))*k3"],
        ["decide", *scene, "--set", "l\x1b=1"],
        ["motion", *scene, "--set", "l=0", "--state", "0,0,log(cos(exp(1e50))),0,0,1", "--until", "1"],
        ["chart", *scene, "--equilibrium", "E1", "--x", "l=0:1:" + "9" * 5000, "--y", "pi3_0=0:1:3"],
    ):
        assert main(arguments) == 2
        said = capsys.readouterr().err
        assert said.startswith("gyrostat: ") and said.count("\n") == 1 and said[:-1].isprintable(), repr(said)


def test_equilibria_at_what_is_infinite_say_so():
    """Where U has a pole."""
    with pytest.raises(EquilibriumError, match="is infinite there"):
        gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(parse("1/(k3 - 1)**2"))))
