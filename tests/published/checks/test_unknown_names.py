"""Unknown names in a file of statements: all are refused at once, with the keys of their statements."""
import pytest
from published.written_sources import written

from gyrostat.errors import PublishedError
from gyrostat.published import SOURCES, check, load
from gyrostat.published.checks.unknown_names import refuse_unknown_names

SCENES = """[source]
name = "mine"
title = "A paper"

[scene.top]
inertia = ["I1", "I1", "I3"]
potential = "m0*k3"
equilibrium = "E1"
parameters = ["extra"]

[scene.free]
given = "I1 < I2"
"""
STATEMENT = """
[[formula]]
key = "{}"
where = "(1)"
kind = "{}"
scene = "{}"
quantity = {}
printed = {}
"""


def refused(tmp_path, *statements):
    """What is said of a file with these statements."""
    text = SCENES + "".join(STATEMENT.format(*entries) + more for *entries, more in statements)
    with pytest.raises(PublishedError) as error:
        check([written(tmp_path, text)])
    return str(error.value)


def test_every_unknown_name_is_listed_with_the_keys_of_its_statements(tmp_path):
    """Wherever it stands: in a formula, a list, a condition, an abbreviation, given or at."""
    said = refused(
        tmp_path,
        ("condition", "condition", "top", '"sufficient for stability"',
         '"abs(mass) < k_3 and wide >= 2e5*I1"', 'given = "low > 0"\n'),
        ("vector", "identity", "free", '"vector_pi"', '["mass", "sqrt(f(pi2))", "c"]',
         'let = { c = "2*d" }\n'),
        ("number", "number", "top", '"width"', '"0.5"', 'at = { zz = "yy" }\n'),
        ("fixed", "identity", "free", '"h"', '"0"', 'corrected = "tensor"\n'))
    assert "mine.toml: unknown names: low in condition; mass in condition, vector; k_3 in condition " in said
    assert "(did you mean k3?)" in said
    for name, key in (("wide", "condition"), ("f", "vector"), ("d", "vector"), ("zz", "number"),
                      ("yy", "number"), ("width", "number"), ("tensor", "fixed")):
        assert f"; {name} in {key}" in said
    assert 'let = { low = "…" }' in said and 'parameters = ["low"]' in said
    listed = said.split(": a statement has")[0]
    assert listed.count(";") == 9 and " e5 in" not in listed
    said = refused(tmp_path, ("a", "identity", "top", '"h"', '"omega_3 + wide"', ""))
    assert 'omega_3 in a (did you mean omega3?); wide in a: ' in said and 'parameters = ["wide"]' in said


def test_the_names_of_one_scene_are_offered(tmp_path):
    """If the statements with unknown names have one scene; otherwise the page that lists names."""
    faulty = ("{}", "identity", "{}", '"T"', '"mass"', "")
    one, two = (("a", *faulty[1:2], scene, *faulty[3:]) for scene in ("top", "free"))
    alone = refused(tmp_path, one)
    assert "the names of the scene are B, C1, C2" in alone and "extra, field" in alone
    assert "docs/reference/published.md" in refused(tmp_path, one, ("b", *two[1:]))


def test_an_abbreviation_is_unknown_before_it_is_read(tmp_path):
    """In given, in at, and in an abbreviation before it."""
    said = refused(tmp_path, ("early", "identity", "free", '"h"', '"b"',
                              'let = { a = "2*b", b = "T" }\ngiven = "a > 0"\n'))
    assert said.count("(an abbreviation that is read later") == 2 and "a in early" in said


def test_the_rotor_of_a_scene_without_one(tmp_path):
    """The message gives the entry of the scene, so that l is not declared as a further letter."""
    said = refused(tmp_path, ("a", "identity", "top", '"h"', '"l + mass"', ""))
    assert 'l in a (the scene has no rotor: gyrostatic_momentum = ["0", "0", "l"]); mass in a' in said
    assert 'parameters = ["mass"]' in said


def test_words_are_no_names(tmp_path):
    """A claim, a verdict, a decimal, a count and "never" have none; a function of the grammar is known."""
    text = SCENES + "".join(STATEMENT.format(*entries) for entries in (
        ("a", "condition", "top", '"necessary for stability"', '"never"'),
        ("b", "statement", "top", '"stability"', '"orbitally stable"'),
        ("c", "identity", "top", '"extra"', '"sqrt(I1)*extra/sqrt(I1)"')))
    refuse_unknown_names(load(written(tmp_path, text)))


@pytest.mark.slow
@pytest.mark.parametrize("source", SOURCES)
def test_the_sources_of_the_library_have_none(source):
    """Also where a text is not read: in an abbreviation that no formula uses."""
    refuse_unknown_names(load(source))
