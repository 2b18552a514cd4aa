"""Every route of text into the library.

What would hang, break or run is a clear error at once, whatever way it comes.
"""

import json
import random
import sys
from pathlib import Path

import mpmath
import numpy as np
import pytest
import sympy
from sympy import Rational

import gyrostat as gs
from gyrostat.algebra.grammar import parse
from gyrostat.algebra.inputs import json_object
from gyrostat.algebra.numbers import exact_number, shown
from gyrostat.cli.parser import main
from gyrostat.errors import (
    ArgumentError,
    BodyError,
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

sys.path.insert(0, str(Path(__file__).parents[2] / "benchmarks"))
TOWERS = [
    "tan(exp(1e8))",
    "log(cos(exp(1e50)))",
    "k3*tanh(exp(1e50))",
    "exp(exp(exp(exp(9))))+I1",
    "exp(-1e9)",
    "sin(exp(sinh(30)))",
    "exp(10**6*log(2) + k3)",
    "exp(1e300*log(k3))",
    "exp(100*log((1 + k3)**100))",
    "cos(exp(exp(exp(2))))*k3",
    "cosh(cosh(cosh(5)))",
    "exp(3**80*k3)",
    "1/(exp(-3e3)*k3)",
    "(k3*exp(1e4))**2",
    "exp(40)**100*exp(40)**100",
    "exp(1/10**400)**(10**50)",
]


@pytest.mark.parametrize("text", TOWERS)
def test_towers_are_refused_before_they_are_computed(text):
    """SymPy would look for digits of these numbers, some of them for ever."""
    with pytest.raises(ExpressionError, match="too large|real number|limits|told from 0"):
        parse(text)


@pytest.mark.parametrize(
    "text",
    [
        "1/(cos(1)**2 + sin(1)**2 - 1)",
        "1/(sqrt(2)*sqrt(3) - sqrt(6))",
        "k3/(exp(50) - exp(50))",
        "1/(k3*(cos(1)**2 + sin(1)**2 - 1))",
        "sqrt(sqrt(2) + sqrt(3) - sqrt(5 + 2*sqrt(6)))",
        "(cos(2)**2 + sin(2)**2 - 1)**(-3)",
    ],
)
def test_what_is_not_proved_to_differ_from_zero_divides_nothing(text):
    """A division by it would make a number of anything."""
    with pytest.raises(ExpressionError, match="cannot be told from 0|divides by zero"):
        parse(text)


@pytest.mark.parametrize(
    "text",
    [
        "acos(cos(10**99*10**99))",
        "asin(sin(exp(1000)))",
        "log(log(1/2))",
        "asin(2)",
        "tan(pi/2)",
        "sqrt(-I1)",
        "tanh(acosh(l)**-99)",
        "asin(tanh(acosh(3/5*l)**-99) + tanh(acosh(3/5*l)**-99) - 99)",
    ],
)
def test_what_sympy_stumbles_over_is_refused(text):
    """Numbers that are not real, and comparisons that SymPy raises at, or does not come back from."""
    with pytest.raises(ExpressionError, match="cannot read"):
        parse(text)


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("(1e300)**(1/7)", 1e300 ** (1 / 7)),
        ("exp(log(2)*300)", 2.0**300),
        ("log(exp(700))", 700),
        ("tan(pi/2 + 1)", mpmath.tan(mpmath.pi / 2 + 1)),
        ("2**(1/12)*3**(1/12)", 6 ** (1 / 12)),
        ("tan(exp(5))", mpmath.tan(mpmath.exp(5))),
        ("1e-300", 1e-300),
        ("exp(exp(5))", mpmath.exp(mpmath.exp(5))),
        ("sqrt(sqrt(sqrt(5)))", 5**0.125),
        ("pi - 3.14159265358979", mpmath.pi - mpmath.mpf("3.14159265358979")),
    ],
)
def test_ordinary_towers_are_read(text, value):
    """The bounds leave what a person types."""
    # the doubles of the second column
    assert mpmath.almosteq(mpmath.mpf(str(parse(text).evalf(30))), value, 1e-9)


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
    from gyrostat.stability.branches import relative_equilibria
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


@pytest.mark.parametrize("value", [1 << 2**18, Rational(1, 1 << 2**18), mpmath.ldexp(1, 10**9),
                                   sympy.Float(2) ** -(2**18)], ids=range(4))
def test_numbers_of_python_are_bounded_too(value):
    """Their digits would not be printed, or not even be made."""
    with pytest.raises(ValuesError, match="too long"):
        exact_number(value, "l")


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


@pytest.mark.parametrize(
    "inertia",
    [
        np.array([1.0, 2.0, 3.0]),
        np.diag([1.0, 2.0, 3.0]),
        [[1, 0, 0], [0, 2, 0], [0, 0, 3]],
        sympy.diag(1, 2, 3),
        sympy.Matrix([1, 2, 3]),
        (np.array(1), np.float32(2), np.int64(3)),
        range(1, 4),
    ],
)
def test_arrays_and_diagonal_matrices_are_bodies(inertia):
    """Moments come from NumPy as often as from a tuple."""
    assert gs.Gyrostat(inertia, np.zeros(3)) == gs.Gyrostat((1, 2, 3), (0, 0, 0))


@pytest.mark.parametrize(
    ("inertia", "error", "hint"),
    [
        ("123", ArgumentError, "three numbers"),
        (b"123", ArgumentError, "three numbers"),
        (5, ArgumentError, "three numbers"),
        (np.array([[1, 0.1, 0], [0.1, 2, 0], [0, 0, 3]]), BodyError, "principal"),
        (np.eye(2), BodyError, "three"),
        (np.ma.array([1.0, 2.0, 3.0], mask=[0, 1, 0]), ValuesError, "not a real number"),
        ((1, 2, np.array([3])), ValuesError, "not a real number"),
    ],
)
def test_what_is_no_body_says_what_to_give(inertia, error, hint):
    """A text is no sequence of numbers; products of inertia are no moments."""
    with pytest.raises(error, match=hint):
        gs.Gyrostat(inertia)


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
    """abs(0) < 1 and 1 > 0 say nothing."""
    scene = gs.assemble(gs.Gyrostat((1, 1, 1), (0, 0, symbol("l"))), gs.axial_potential(lambda k3: k3**2 / 2))
    assert "|0| < 1" not in str(gs.analyze(gs.static_tilt(scene)))
    condition = gs.stability.conditions.Condition(sympy.S.One, True, "p", (symbol("l"),), symbol("k3"))
    assert str(condition) == "l ≠ 0" and gs.printing.latex.formula(condition) == r"l \neq 0"


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
        assert said.startswith("gyrostat: ") and said.count("\n") == 1 and said[:-1].isprintable(), (
            json.dumps(said)
        )


def test_equilibria_at_what_is_infinite_say_so():
    """Where U has a pole."""
    with pytest.raises(EquilibriumError, match="is infinite there"):
        gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(parse("1/(k3 - 1)**2"))))


@pytest.mark.parametrize("text", ["(log(atan((cos(atan(-2e-50)))**2)))**99",
                                  "log(((--I1 + ((pi - omega))**0.5) * cosh(atanh((9021 / 8e400)))))",
                                  "cosh(asinh((-1.e-8)**99))", "sqrt(2e-100)*k3*sqrt(1+4e-100)"])
def test_what_sympy_cannot_factor_is_an_error_of_ours(text):
    """Its factoring fails at squares of long numbers, and takes long for roots of them.

    Found by the campaign of 10⁶ texts.
    """
    try:
        assert parse(text).is_number or text.startswith(("log", "sqrt"))
    except ExpressionError as error:
        assert "SymPy cannot evaluate" in str(error) or "is factored" in str(error)


@pytest.mark.parametrize("text", ["exp(-log(12)*2/1e50)", "exp(k3 - 4.5*log(83741e-7)/(8056.5 + 9e50))",
                                  "(1e99 + 3)**(1/7)**(-2/3)",
                                  "((1e99 + 3)**(1/7))**(-2/3)", f"({'7' * 399}*k3)**(1/7)",
                                  f"1/(k3 + ({'7' * 399})**(1/7))"])
def test_no_long_number_is_factored(text):
    """A power of a power, and exp of a logarithm, are roots of numbers that are much longer than what is
    written.
    """
    with pytest.raises(ExpressionError, match=r"a number of \d+ bits is factored|not a rational number"):
        parse(text)


@pytest.mark.parametrize(("text", "value"), [("exp(0.35*log(12))", 2.3862362), ("exp(2*log(10))", 100),
                                             ("(1 + 1e-99)**(1/12)", 1)])
def test_powers_of_ordinary_numbers_are_read(text, value):
    """Also as the exponential of a logarithm."""
    assert abs(float(parse(text)) - value) < 1e-5
