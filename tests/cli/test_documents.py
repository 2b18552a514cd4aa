"""What the verbs write with --format json, held against the schemas that are published."""
import json
from copy import deepcopy
from pathlib import Path

import pytest
from commands import run
from jsonschema import Draft202012Validator
from referencing import Registry, Resource
from slow import slow

FOLDER = Path(__file__).parents[2] / "docs" / "reference" / "schema"
SCHEMAS = {path.stem: json.loads(path.read_text(encoding="utf-8")) for path in FOLDER.glob("*.json")}
KNOWN = Registry().with_resources((f"{name}.json", Resource.from_contents(schema))
                                  for name, schema in SCHEMAS.items())
HEAVY = ("--potential", "m0*k3")
TOP = (*HEAVY, "--set", "I1=1", "--set", "I3=1.6", "--set", "l=0")
WELLS = ("--potential", "k3**4 - k3**2/2")
# their keys are names, not those of the document
MAPS = {"margins", "relations", "values", "definitions", "windows"}
OPTIONAL = {"definitions", "windows", "drift", "decision", "itself", "k3", "omega", "sigma", "pi1", "pi2",
            "pi3", "Delta", "frequency", "frequency_1", "frequency_2", "growth_rate"}

DOCUMENTS = [
    ("report", "report", ()),
    ("report", "report", (*TOP, "--set", "m0=1", "--set", "omega3_0=1.3")),
    ("report", "report", ("--potential", "none")),
    ("report", "report", ("--potential", "exp(a*k3)", "--equilibrium", "E3")),
    ("report", "report", ("--potential", "U(k1,k2,k3)", "--equilibrium", "permanent-rotation")),
    ("conditions", "conditions", ()),
    ("conditions", "conditions", ("--potential", "U(k1,k2,k3)", "--equilibrium", "permanent-rotation")),
    ("conditions", "conditions", ("--potential", "none")),
    ("conditions", "conditions", (*HEAVY, "--inertia", "5,4,3", "--equilibrium", "E2", "--windows")),
    ("solution", "conditions", (*HEAVY, "--equilibrium", "E1", "--solve-for", "l")),
    ("solution", "conditions", (*HEAVY, "--solve-for", "omega")),
    ("decide", "decide", (*WELLS, "--set", "I1=2", "--set", "I3=1", "--set", "l=0", "--set", "omega=1/2")),
    ("decide", "decide", (*TOP, "--equilibrium", "E1", "--set", "m0=1", "--set", "omega3_0=1.25")),
    ("decide", "decide", ("--potential", "none", "--set", "I1=1", "I2=2", "I3=3", "l=1", "--momentum", "2")),
    ("decide", "decide", ("--potential", "k1 + 2*k2", "--set", "I1=1", "I2=2", "I3=3", "l=1", "omega=1")),
    ("verify", "verify", ("AR",)),
]


def faults(name, document):
    """Why a document is none of that schema."""
    return [error.message for error in
            Draft202012Validator(SCHEMAS[name], registry=KNOWN).iter_errors(document)]


def described(schema):
    """Every key of a document that a schema, or a part of it, describes."""
    if isinstance(schema, list):
        return set().union(*map(described, schema))
    if not isinstance(schema, dict):
        return set()
    return set(schema.get("properties", ())).union(*map(described, schema.values()))


def places(document):
    """(object or list, key) of everything that is in a document."""
    for key, value in document.items() if isinstance(document, dict) else enumerate(document):
        yield document, key
        if isinstance(value, dict | list) and key not in MAPS:
            yield from places(value)


def changed(document):
    """Copies of a document, each with one key gone or one value of another kind, and where."""
    for n, (_, key) in enumerate(places(document)):
        if isinstance(key, str) and key not in OPTIONAL:
            copy = deepcopy(document)
            home, _ = list(places(copy))[n]
            del home[key]
            yield f"without {key}", copy
        copy = deepcopy(document)
        home, _ = list(places(copy))[n]
        home[key] = {"neither": 0.5}
        yield f"another {key}", copy


@pytest.mark.parametrize("name", SCHEMAS)
def test_each_schema_is_one(name):
    """Of draft 2020-12, and in its form."""
    assert SCHEMAS[name]["$schema"] == "https://json-schema.org/draft/2020-12/schema"
    Draft202012Validator.check_schema(SCHEMAS[name])


@pytest.mark.few(2)
@pytest.mark.parametrize(("name", "verb", "arguments"), DOCUMENTS)
def test_what_a_verb_writes_is_described(capsys, name, verb, arguments):
    """It validates, and has no key that its schema leaves out."""
    _, out, _ = run(capsys, *arguments, "--format", "json", verb=verb)
    document = json.loads(out)
    assert not faults(name, document)
    keys = {key for _, key in places(document) if isinstance(key, str)}
    assert keys <= described(SCHEMAS[name]) | described(SCHEMAS["parts"])


@pytest.mark.slow
@pytest.mark.parametrize(("name", "verb", "arguments"),
                         [DOCUMENTS[2], *slow(*(DOCUMENTS[i] for i in (4, 7, 9)))])
def test_a_changed_document_is_refused(capsys, name, verb, arguments):
    """Whatever key goes, and whatever value becomes another kind of thing."""
    document = json.loads(run(capsys, *arguments, "--format", "json", verb=verb)[1])
    for what, copy in changed(document):
        assert faults(name, copy), what


def test_the_lines_of_a_batch(capsys, tmp_path):
    """What is read and what is written, an error too."""
    lines = [{"m0": 1, "omega3_0": 1.25}, {"m0": "x"}, {"equilibrium": "E2", "omega3_0": "1/3", "m0": 2}]
    path = tmp_path / "tops.jsonl"
    path.write_text("".join(json.dumps(line) + "\n" for line in lines), encoding="utf-8")
    _, out, _ = run(capsys, *TOP, "--equilibrium", "E1", "--batch", str(path), verb="decide")
    written = [json.loads(line) for line in out.splitlines()]
    assert [set(line) for line in written] == [
        {"line", "equilibria"}, {"line", "error"}, {"line", "equilibria"}]
    assert not any(faults("batch-input", line) for line in lines)
    assert not any(faults("batch-line", line) for line in written)
    assert faults("batch-input", {"m0": [1]}) and faults("batch-line", {"line": 0, "error": "no"})
    assert faults("batch-line", {"equilibria": []})
