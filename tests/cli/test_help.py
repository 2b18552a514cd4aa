"""What the help says, in the width of the terminal."""
import re
import shlex

import pytest

from gyrostat.cli.help import KINDS, VERBS, examples
from gyrostat.cli.parser import _values_joined, main, parser

ASKED = [[], *([verb] for verb in VERBS), *(["plot", kind] for kind in KINDS)]


def helped(capsys, monkeypatch, arguments, width):
    """The lines of a help in a terminal of that width."""
    monkeypatch.setenv("COLUMNS", str(width))
    with pytest.raises(SystemExit):
        main([*arguments, "--help"])
    return capsys.readouterr().out


@pytest.mark.parametrize("width", [60, 80, 100, 140])
@pytest.mark.parametrize("arguments", ASKED, ids=" ".join)
def test_no_line_is_wider_than_the_terminal(capsys, monkeypatch, arguments, width):
    """Nor than a text is read; in a narrow one a line of the usage holds at least an option."""
    usage, *others = helped(capsys, monkeypatch, arguments, width).split("\n\n")
    lines = "\n".join([*others, usage] if width > 60 else others).splitlines()
    assert max(map(len, lines)) <= min(width, 100)


@pytest.mark.parametrize("arguments", ASKED[1:], ids=" ".join)
def test_help_begins_with_a_sentence_on_the_verb(capsys, monkeypatch, arguments):
    """It says what the verb does, in full sentences, before the options."""
    _, sentences, *_ = helped(capsys, monkeypatch, arguments, 80).split("\n\n")
    sentences = " ".join(sentences.split())
    assert re.match(r"(De|Gi|Dr|Fo)\w+s ", sentences) and sentences.endswith(".")


@pytest.mark.parametrize("width", [60, 80, 140])
@pytest.mark.parametrize("name", ["gyrostat", *VERBS])
def test_examples_can_be_typed(capsys, monkeypatch, name, width):
    """However they are broken; each is understood by the parser."""
    whole = helped(capsys, monkeypatch, [name] if name in VERBS else [], width)
    said = whole.split("\nexamples:\n")[1].split("\n\n")[0]
    typed = [line for line in said.replace(" \\\n", " ").split("\n") if line.startswith("  gyrostat")]
    assert len(typed) == examples(name).split("\n\n")[0].count("\n  gyrostat")
    for line in typed:
        command = shlex.split(re.split(r"(?<=\S) {3,}(?=\S)(?!-|\w+=)", line)[0].split(" > ")[0])
        assert command[0] == "gyrostat" and command[1] == name or name == "gyrostat"
        assert parser().parse_args(_values_joined(command[1:])).verb == command[1]
