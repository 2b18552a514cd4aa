"""Published formulas in a file of one's own: the language, what is refused, how it is typeset."""
import pytest
from published.written_sources import written
from sympy import Rational

from gyrostat.errors import ExpressionError, GyrostatError, PublishedError, ValuesError
from gyrostat.notation import symbol
from gyrostat.printing.formats.latex_names import Names
from gyrostat.published import check, load
from gyrostat.published.checks.comparisons import comparisons
from gyrostat.published.language import decimal, read
from gyrostat.published.printed_latex import formula_of


def test_language():
    """Chains, absolute values, decimals; nothing is evaluated, and shapes have to fit."""
    a = symbol("a")
    assert comparisons("0 < a < 2 and abs(a) < 3", {"a": a}) == [
        (a, True),
        (2, True),
        (2 - a, True),
        (9 - a**2, True),
    ]
    assert decimal("-0.70") == (Rational(-7, 10), Rational(1, 200))
    for text, why in (("__import__('os')", "cannot read"), ("a.real", "grammar"), ("a < ", "too early"),
                      ("b", "not a name"),
                      ("f(a)", "not a"), ("dot", "no argument"), ("dot(a", "parenthesis"),
                      ("dot(a, a)", "do not fit"),
                      ("9**9**9", "exponent")):
        with pytest.raises(ExpressionError, match=why):
            read(text.replace("<", "+"), {"a": a, "dot": lambda x, y: (x.T * y)[0]})
    for text, why in (("a", "as a condition"), ("0 < a > 2", "one way")):
        with pytest.raises(ExpressionError, match=why):
            comparisons(text, {"a": a})
    with pytest.raises(ValuesError, match="decimal"):
        decimal("1,2")
    with pytest.raises(ExpressionError, match="one length"):
        read([["a", "a"], ["a"]], {"a": a})
    with pytest.raises(ExpressionError, match="texts"):
        read([1], {})


GOOD = """
[source]
name = "mine"
title = "A paper"

[scene.top]
inertia = ["I1", "I1", "I3"]
potential = "m0*k3"
equilibrium = "E1"
"""
FORMULA = ('[[formula]]\nkey = "a"\nwhere = "(1)"\nquantity = "p"\nprinted = "{}"\n'
           'kind = "identity"\nscene = "top"\n')


@pytest.mark.parametrize(("text", "why"), [
    ("x = [", "is not TOML"), ("[source]\nname = 1", "no \\[source\\]"),
    (GOOD + "[extra]\n", "unknown tables"),
    (GOOD + "[scene.b]\nmass = 1\n", "scene.b: a scene has no entry mass"),
    (GOOD + '[[formula]]\nkey = "a"\n', "a: lacks where"),
    (GOOD + FORMULA.format("p") + "colour = 1\n", "unknown entry colour"),
    (GOOD + FORMULA.format("p").replace('"p"', "1", 1), "quantity = 1 is an int"),
    (GOOD + FORMULA.format("p").replace("identity", "guess"), "kind = 'guess'"),
    (GOOD + FORMULA.format("p") * 2, "occur twice"),
    (GOOD + FORMULA.format("p").replace('"top"', '"bottom"'), "scene = 'bottom'"),
    (GOOD + FORMULA.format("p*"), "a: cannot read"),
    (GOOD + FORMULA.format("mass"), "unknown names: mass in a: a statement has"),
    (GOOD + FORMULA.format("vector_k"), "a: printed is a 3×1 matrix, the quantity a number"),
    (GOOD + FORMULA.format("p > 0").replace("identity", "condition"), "a condition is necessary for"),
    (GOOD + FORMULA.format("p").replace("identity", "statement"), "a statement is about"),
    (GOOD + FORMULA.format("1").replace("identity", "number"), "still contains"),
    (GOOD + FORMULA.format("p").replace("identity", "solution"), "the list omega1"),
    (GOOD + FORMULA.format("p").replace("identity", "equilibrium"), "6 coordinates"),
    (GOOD.replace('["I1", "I1", "I3"]', "[1, true, 3]") + FORMULA.format("p"),
     "scene.top: inertia = .*in quotation marks"),
    (GOOD.replace('"m0*k3"', "5") + FORMULA.format("p"), "scene.top: potential = 5"),
    ("scene = 5\n" + GOOD.split("[scene")[0], "\\[scene.NAME"),
    (GOOD + FORMULA.format("p").replace("[[formula]]", "[formula]"), "\\[\\[formula\\]\\]"),
    (GOOD + "[expected]\nmisprint = 'a'", "lists of keys"),
    (GOOD + FORMULA.format("p") + 'at = { zz = "1" }\n', "unknown names: zz in a"),
    (GOOD + FORMULA.format("p") + 'at = { I1 = "2*m0", m0 = "1" }\n', "at gives I1 by m0, and m0 too"),
    (GOOD + FORMULA.format("p") + 'at = { I1 = "0" }\n', "are positive"),
    (GOOD + FORMULA.format("p") + 'given = "m0 >= 0"\n', "write > or <"),
    (GOOD + FORMULA.format("entry(jacobian, 0, 1)"), "no entry 0, 1"),
    (GOOD + '[expected]\nmisprint = [["a"]]', "lists of keys"),
    (GOOD + FORMULA.format("sn(vector_pi, 1)"), "sn takes numbers"),
    (GOOD + FORMULA.format("sqrt(jacobian)"), "takes one number"),
    (GOOD + FORMULA.format("entry(jacobian**9, 1, 1)"), "powers 2 and 3"),
    (GOOD + FORMULA.format("pi1/B"), "; B is the matrix of the bracket here"),
    (GOOD + FORMULA.format("(p + 1)**100"), "of others to 12"),
    (GOOD + FORMULA.format("round").replace('"p"', '"stability"').replace("identity", "statement"),
     "orbitally stable"),
    (GOOD.replace('"E1"', '"E4"') + FORMULA.format("p"), "equilibrium = 'E4'"),
    (GOOD + '[expected]\nmisprint = ["b"]\n', "no such key"),
    (GOOD.replace('"E1"', '"permanent-rotation"') + FORMULA.format("p"), "about one direction"),
    (GOOD.replace('"m0*k3"', '"m0*"') + FORMULA.format("p"), "a: cannot read 'm0\\*'")])
def test_bad_files(tmp_path, text, why):
    """A clear error with file and key."""
    path = written(tmp_path, text)
    with pytest.raises(PublishedError, match=why) as error:
        check([path])
    assert str(path) in str(error.value)


def test_all_faults_of_a_file_are_named_at_once(tmp_path):
    """Those of scenes and formulas, several of one formula; of very many the first twenty."""
    faulty = FORMULA.format("p").replace("identity", "guess").replace('where = "(1)"\n', "")
    path = written(tmp_path, GOOD + "[scene.b]\nmass = 1\n" + faulty + "colour = 1\n"
                   + faulty.replace('"a"', '"z"').replace('"top"', '"bottom"'))
    with pytest.raises(PublishedError) as error:
        load(path)
    said = str(error.value)
    assert said.startswith(f"{path}: scene.b: a scene has no entry mass") and said.count(str(path)) == 1
    for fault in ("a: lacks where:", "a: has the unknown entry colour:", "a: kind = 'guess':",
                  "z: lacks where:", "z: kind = 'guess':",
                  "z: scene = 'bottom' is not in the file: its scenes are top, b"):
        assert f"; {fault}" in said
    with pytest.raises(PublishedError, match="; and 5 more$") as error:
        load(written(tmp_path, GOOD + 25 * FORMULA.format("p").replace("identity", "guess")))
    assert str(error.value).count("kind = ") == 20


def test_no_such_source(tmp_path):
    """Neither a source of ours nor a file."""
    for source in ("VV2004", tmp_path / "missing.toml"):
        with pytest.raises(PublishedError):
            load(source)


def test_a_file_of_ones_own(tmp_path):
    """The same format; a status that differs from the expected one is seen."""
    text = (
        GOOD
        + FORMULA.format("((omega3 - (pi3 + l)/I1)**2)").replace("l)", "0)")
        + '[expected]\nmisprint = ["a"]\n'
    )
    (finding,) = check([written(tmp_path, text)])
    assert (finding.status, finding.expected) == ("misprint", "misprint") and finding.outcome.counterexample
    assert "I1" in dict(finding.outcome.counterexample.values)


def test_errors_are_of_one_family():
    """except GyrostatError catches what verify refuses."""
    assert issubclass(PublishedError, GyrostatError) and issubclass(PublishedError, ValueError)


@pytest.mark.parametrize(("printed", "tex"), [
    ("-omega2*omega3*(I3 - I1)", r"- \omega_{2} \omega_{3} \left(I_3 - I_1\right)"),
    ("-(a + b)/c**2", r"- \frac{a + b}{c^{2}}"),
    ("z - b - (c + d)", r"z - b - \left(c + d\right)"), ("2*(a/b)**2", r"2 \left(\frac{a}{b}\right)^{2}"),
    ("a*-b", r"a \left(- b\right)"),
    ("1 <= pi3*k3 < 2", r"1 \leq \pi_3 k_3 < 2"),
    ("cross(vector_k, vector_l + vector_k)", r"\mathbf{k} \times \left(\boldsymbol{l} + \mathbf{k}\right)")])
def test_printed_formulas_keep_their_order(printed, tex):
    """The errata show terms and factors as they are printed, not as a computer algebra sorts them."""
    assert formula_of(printed, Names()) == tex


def test_a_file_with_a_byte_order_mark(tmp_path):
    """As some editors write them."""
    path = tmp_path / "mine.toml"
    path.write_bytes(b"\xef\xbb\xbf" + (GOOD + FORMULA.format("p")).encode())
    assert check([path])[0].status == "confirmed"
