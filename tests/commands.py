"""The command line, called in this process."""
from gyrostat.cli.parser import main


def run(capsys, *arguments, verb="report"):
    status = main([verb, *arguments])
    captured = capsys.readouterr()
    return status, captured.out, captured.err


def decide(capsys, *arguments):
    return run(capsys, *arguments, verb="decide")
