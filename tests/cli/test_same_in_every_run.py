"""What is printed is the same in every run, whatever PYTHONHASHSEED is."""
import os
import subprocess
import sys
from itertools import zip_longest
from pathlib import Path

import pytest
from commands import run
from sympy import Abs, Add

import gyrostat as gs

TABLE = Path(__file__).with_name("asked_documents.py")


def test_conditions_come_in_the_order_of_the_field(capsys):
    """The radicands of U, each of which has to be positive, are listed as they stand in it."""
    names = ["a", "b", "c", "d", "e", "f", "q"]
    field = " + ".join(f"{name}^(1/{n})*k3^{n}" for n, name in enumerate(names, 2))
    _, out, _ = run(capsys, "--potential", field, "--equilibrium", "E1", verb="conditions")
    lines = [line.split() for line in out.splitlines()]
    assert [line[0] for line in lines if line[1:] == [">", "0"] and line[0] in names] == names


def test_an_error_lists_what_is_refused_in_its_order():
    """Of a U that is not smooth each part that is not, as they stand in it."""
    parts = [Abs(gs.symbol(name) * gs.symbol("k3") - 1) for name in "abcdefq"]
    with pytest.raises(gs.errors.PotentialError) as refused:
        gs.axial_potential(Add(*parts))
    whole, listed = str(refused.value).split(" is not smooth, it contains ")
    assert listed.split(":")[0] == whole.removeprefix("U = ").replace(" + ", ", ")


@pytest.mark.slow
def test_every_run_prints_the_same_bytes(tmp_path):
    """The whole table of questions, as text, LaTeX and JSON, under two seeds of Python's hashes."""
    processes = []
    for seed in "01":
        with open(tmp_path / seed, "w", encoding="utf-8") as printed:
            processes.append(subprocess.Popen([sys.executable, str(TABLE)], stdout=printed,
                                              env=os.environ | {"PYTHONHASHSEED": seed}))
    assert [process.wait() for process in processes] == [0, 0]
    first, second = ((tmp_path / seed).read_text(encoding="utf-8").splitlines() for seed in "01")
    assert len(first) > 10_000
    assert [pair for pair in zip_longest(first, second) if pair[0] != pair[1]] == []
