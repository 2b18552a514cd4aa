"""gyrostat decide: verdicts at numbers, of the equilibrium they name or of all they allow."""
import argparse

from ..printing.data import json_text
from ..printing.normal_form import form_blocks, form_data, window_blocks, window_data
from ..printing.text import text
from ..stability.window_families import Window
from .answer_blocks import answers_blocks
from .answers import answers_at, answers_data, normal_form_of
from .arcs import arcs_at, arcs_blocks, arcs_data
from .asked import asked_of
from .batch import run as each
from .options import numbers_of
from .output import Output
from .scene_files import with_scene


def run(given: argparse.Namespace, out: Output) -> int:
    """Write the decisions; 0, whatever they are, and 2 if a line of a batch was bad."""
    if given.momentum is not None:
        given = argparse.Namespace(**{**vars(given), "values": [*given.values, f"M={given.momentum}"]})
    given = with_scene(given)
    if given.batch is not None:
        return each(given, out)
    numbers = numbers_of(given.values)
    asked = asked_of(given, numbers)
    if given.normal_form:
        form = normal_form_of(asked, given.equilibrium, numbers, given.normal_form)
        if isinstance(form, Window):
            data, blocks = window_data(form), window_blocks(form)
        else:
            data, blocks = form_data(form), form_blocks(form)
        out(json_text(data) if given.format == "json" else text(blocks, out.width))
        return 0
    if arcs := arcs_at(asked, given.equilibrium, numbers):
        out(json_text(arcs_data(arcs)) if given.format == "json" else text(arcs_blocks(arcs), out.width))
        return 0
    answers = answers_at(asked, given.equilibrium, numbers)
    if given.format == "json":
        out(json_text(answers_data(answers)))
    else:
        out(text(answers_blocks(answers), out.width))
    return 0
