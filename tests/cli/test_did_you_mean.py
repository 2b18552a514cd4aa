"""What the command line does not know, and what was meant."""
import pytest

from gyrostat.cli.parser import main


@pytest.mark.parametrize(("typed", "near"), [
    ("decide --formt json", "--format"), ("report --potental=k3", "--potential"),
    ("decide -inertia 1,2,3", "--inertia"),
    ("reprt", "report"), ("plot staude-con", "staude-cone"), ("plot smelt", "smelt-plane"),
    ("plot gyre", ""), ("report xyzzy", ""),
    ("report --format jsn", "")])
def test_what_is_near_is_named(capsys, typed, near):
    """An option for what begins as one, a verb or a picture for a word; nothing where nothing is near."""
    with pytest.raises(SystemExit) as stop:
        main(typed.split())
    assert stop.value.code == 2
    said = capsys.readouterr().err
    assert said.endswith(f"; did you mean {near}?\n") if near else "did you mean" not in said


def test_an_option_of_another_verb_is_not_asked_for_again(capsys):
    """The verb has no such option, and others have: the message says that."""
    with pytest.raises(SystemExit):
        main(["verify", "--set", "I1=1"])
    said = " ".join(capsys.readouterr().err.split())
    assert "did you mean" not in said and "--set is an option of other verbs" in said


def test_a_file_that_cannot_be_read(capsys, tmp_path):
    """In words, without the number of the system's error; what to do about it is of use."""
    (tmp_path / "latin.toml").write_bytes(b"\xe9")
    for name, why, todo in ((tmp_path / "none.toml", "No such file", "check the path"),
                            (tmp_path, "Is a directory", "check the path"),
                            (tmp_path / "latin.toml", "", "give a text file in UTF-8")):
        assert main(["decide", "--scene", str(name)]) == 2
        said = capsys.readouterr().err
        assert f"{name}: cannot be read ({why}" in said and "Errno" not in said
        assert said.endswith(f": {todo}\n")
