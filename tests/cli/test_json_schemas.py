"""What the verbs write with --format json, held against the schemas that are published."""
import json
from copy import deepcopy
from pathlib import Path

import pytest
from cli.asked_documents import HEAVY, QUESTIONS, words_of
from commands import run
from jsonschema import Draft202012Validator
from referencing import Registry, Resource

FOLDER = Path(__file__).parents[2] / "docs" / "reference" / "schema"
SCHEMAS = {path.stem: json.loads(path.read_text(encoding="utf-8")) for path in FOLDER.glob("*.json")}
KNOWN = Registry().with_resources((f"{name}.json", Resource.from_contents(schema))
                                  for name, schema in SCHEMAS.items())
# their keys are names, not those of the document
MAPS = {"exact", "margins", "relations", "values", "definitions", "windows", "certificate"}
OPTIONAL = {"definitions", "windows", "drift", "k1", "k2", "k3", "omega", "sigma",
            "pi1", "pi2", "pi3", "n1", "n2", "n3", "r1", "r2", "r3", "energy_sink", "stiffness", "gyroscopic",
            "D6", "exact", "wells", "well"}
ASKED = [(schema, question) for schema, questions in QUESTIONS.items() for question in questions]
# a document of each kind
CHANGED = ["report --potential none", "conditions --potential none", f"conditions {HEAVY} --windows",
           "conditions --scene {scenes}#station --platform-damping c_p --rotor-damping c_r",
           "conditions --potential m0*k3 --equilibrium E1 --solve-for l",
           "decide --potential m0*k3 --equilibrium E3 --set I1=1 I3=1.6 l=1/3 m0=1 omega=3/2",
           "decide --orbit omega0 --equilibrium earth-pointing --pointing 1,3,2 "
           "--set I1=60 I2=35 I3=70 l=0 omega0=1",
           "decide --potential 'k1 + k3' --set I1=1 I2=2 I3=3 l=0",
           "decide --potential k1 --inertia 1,2,3 --gyrostatic-momentum 0,0,1/2 --set C1=1/3 --well",
           "decide --orbit 1 --inertia 60,70,35 --gyrostatic-momentum 0,500,0 --well",
           f"decide {HEAVY} --normal-form 4 --set m0=1 l=0 pi3_0=11/2", f"decide {HEAVY} --normal-form 4"]


def faults(name, document):
    """Why a document is none of that schema."""
    return [error.message for error in
            Draft202012Validator(SCHEMAS[name], registry=KNOWN).iter_errors(document)]


def places(document):
    """(object or list, key) of everything that is in a document."""
    for key, value in document.items() if isinstance(document, dict) else enumerate(document):
        yield document, key
        if isinstance(value, dict | list) and key not in MAPS:
            yield from places(value)


def changed(document):
    """Copies of a document, each with one key gone, one too many or one value of another kind, and where."""
    for n, (_, key) in enumerate(places(document)):
        copy = deepcopy(document)
        home, _ = list(places(copy))[n]
        kept = home[key]
        if isinstance(key, str) and key not in OPTIONAL:
            del home[key]
            yield f"without {key}", copy
        if isinstance(kept, dict) and key not in MAPS:
            home[key] = kept | {"unknown": "1"}
            yield f"more in {key}", copy
        home[key] = {"neither": 0.5}
        yield f"another {key}", copy


def answer(capsys, tmp_path, question):
    """The document that is written."""
    verb, *arguments = words_of(question, tmp_path)
    return json.loads(run(capsys, *arguments, "--format", "json", verb=verb)[1])


@pytest.mark.parametrize("name", SCHEMAS)
def test_each_schema_is_one(name):
    """Of draft 2020-12, and in its form."""
    assert SCHEMAS[name]["$schema"] == "https://json-schema.org/draft/2020-12/schema"
    Draft202012Validator.check_schema(SCHEMAS[name])


@pytest.mark.few(2)
@pytest.mark.parametrize(("schema", "question"), ASKED)
def test_what_a_verb_writes_is_described(capsys, tmp_path, schema, question):
    """It validates against the schema of its verb, which refuses keys that it does not describe."""
    assert not faults(schema, answer(capsys, tmp_path, question))


@pytest.mark.parametrize("question", ["decide --potential k1 --inertia 1,2,3 --gyrostatic-momentum 0,0,0",
                                      f"decide {HEAVY} --normal-form 4",
                                      f"decide {HEAVY} --normal-form 4 --set m0=1 l=0 pi3_0=11/2"])
def test_arcs_and_normal_forms_are_described(capsys, tmp_path, question):
    """What decide writes besides equilibria, and a key too many of each is refused."""
    document = answer(capsys, tmp_path, question)
    assert not faults("decide", document) and faults("decide", document | {"unknown": 1})


@pytest.mark.slow
@pytest.mark.parametrize("question", CHANGED)
def test_a_changed_document_is_refused(capsys, tmp_path, question):
    """Whatever key goes, whatever key comes, and whatever value becomes another kind of thing."""
    (schema,) = (name for name, questions in QUESTIONS.items() if question in questions)
    document = answer(capsys, tmp_path, question)
    assert faults(schema, document | {"unknown": "1"})
    for what, copy in changed(document):
        assert faults(schema, copy), what


def test_the_lines_of_a_batch(capsys, tmp_path):
    """What is read and what is written, an error too."""
    lines = [{"m0": 1, "omega3_0": 1.25}, {"m0": "x"}, {"equilibrium": "E2", "omega3_0": "1/3", "m0": 2}]
    path = tmp_path / "tops.jsonl"
    path.write_text("".join(json.dumps(line) + "\n" for line in lines), encoding="utf-8")
    top = ["--potential", "m0*k3", "--set", "I1=1", "I3=1.6", "l=0"]
    _, out, _ = run(capsys, *top, "--equilibrium", "E1", "--batch", str(path), verb="decide")
    written = [json.loads(line) for line in out.splitlines()]
    assert [set(line) for line in written] == [
        {"line", "equilibria"}, {"line", "error"}, {"line", "equilibria"}]
    assert not any(faults("batch-input", line) for line in lines)
    assert not any(faults("batch-line", line) for line in written)
    assert faults("batch-input", {"m0": [1]}) and faults("batch-line", {"line": 0, "error": "no"})
    assert faults("batch-line", {"equilibria": []})
