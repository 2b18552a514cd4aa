"""What the shell completes, in bash itself."""
import shutil
import subprocess
import sys
from contextlib import redirect_stdout, suppress
from io import StringIO

import pytest

from gyrostat.cli.completion import SHELLS
from gyrostat.cli.help import KINDS, VERBS
from gyrostat.cli.parser import main

# what bash does when TAB is pressed after the words that are given
PRESSED = """
source "$1"; shift
COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1))
$(complete -p gyrostat | sed 's/.*-F \\([^ ]*\\).*/\\1/') gyrostat "${COMP_WORDS[COMP_CWORD]}"
printf '%s\\n' "${COMPREPLY[@]}"
"""


@pytest.fixture(scope="module")
def script(tmp_path_factory):
    """The script for bash, in a folder with one file."""
    pytest.importorskip("shtab")
    if shutil.which("bash") is None:
        pytest.skip("there is no bash")
    folder = tmp_path_factory.mktemp("typed")
    (folder / "spins.jsonl").touch()
    with redirect_stdout(StringIO()) as made, suppress(SystemExit):
        main(["--print-completion", "bash"])
    (folder / "gyrostat.bash").write_text(made.getvalue())
    return folder / "gyrostat.bash"


@pytest.mark.parametrize(("words", "found"), [
    ([""], [*VERBS]), (["de"], ["decide"]), (["plot", ""], [*KINDS]), (["plot", "co"], ["cones"]),
    (["report", "--eq"], ["--equilibrium"]), (["report", "--equilibrium", "u"], ["upright"]),
    (["decide", "--set", "I1=1", "I3=2", "--equilibrium", "E"], ["E1", "E2", "E3"]),
    (["report", "--format", ""], ["text", "latex", "json"]), (["decide", "--batch", "sp"], ["spins.jsonl"]),
    (["motion", "--output", "sp"], ["spins.jsonl"]), (["verify", "--format", "json", "sp"], ["spins.jsonl"]),
    (["--print-completion", ""], [*SHELLS]), (["conditions", "--solve-for", "sp"], [])])
def test_bash_completes(script, words, found):
    """Verbs, kinds, options, their choices, names of files, and nothing else."""
    said = subprocess.run(["bash", "-c", PRESSED, "bash", script.name, "gyrostat", *words], cwd=script.parent,
                          check=True, capture_output=True, text=True)
    assert said.stdout.split() == found and said.stderr == ""


@pytest.mark.parametrize("shell", SHELLS)
def test_every_shell_has_a_script(capsys, shell):
    """It knows every verb; the exit status is 0."""
    pytest.importorskip("shtab")
    with pytest.raises(SystemExit) as stop:
        main(["--print-completion", shell])
    out, err = capsys.readouterr()
    assert stop.value.code == 0 and err == "" and all(verb in out for verb in VERBS)


def test_the_extra_is_named_where_it_is_missing(capsys, monkeypatch):
    """In one line; the exit status is 2."""
    monkeypatch.setitem(sys.modules, "shtab", None)
    with pytest.raises(SystemExit) as stop:
        main(["--print-completion", "bash"])
    out, err = capsys.readouterr()
    assert (stop.value.code, out) == (2, "") and err.startswith("gyrostat: shtab cannot be imported")
    assert err.count("\n") == 1 and 'pip install "gyrostat[completion]"' in err
