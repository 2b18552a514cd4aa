"""The command line, called in this process."""
import json

from gyrostat.cli.parser import main


def in_toml(value):
    """A value of a scene file as it is written there."""
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{name} = {in_toml(x)}" for name, x in value.items()) + " }"
    return "[" + ", ".join(map(in_toml, value)) + "]" if isinstance(value, list) else json.dumps(value)


def scene_file(case, path):
    """Write a case of scene_kinds as the only scene of a file."""
    table = case.table | {"values": case.values}
    path.write_text("[scene.one]\n" + "\n".join(f"{name} = {in_toml(x)}" for name, x in table.items()))
    return path


def run(capsys, *arguments, verb="report"):
    status = main([verb, *arguments])
    captured = capsys.readouterr()
    return status, captured.out, captured.err


def decide(capsys, *arguments):
    return run(capsys, *arguments, verb="decide")
