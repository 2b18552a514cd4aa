"""A directive of the site: the command line as its parser describes it."""
import argparse
from collections.abc import Iterator
from textwrap import dedent, indent

from docutils import nodes
from docutils.parsers.rst import Directive
from sphinx.application import Sphinx

from gyrostat.cli.parser import parser

COLUMNS = 76                                           # of what the site shows as code


class CommandLine(Directive):
    """A section for each verb, and for each kind of `gyrostat plot`."""

    def run(self) -> list[nodes.Node]:
        """Return the sections, in the order of the parser, made anew in every build."""
        self.state.document.settings.env.note_reread()
        return [section(verb, self.state) for verb in verbs(parser())]


def verbs(top: argparse.ArgumentParser) -> Iterator[argparse.ArgumentParser]:
    """The parsers below one, each followed by those below it."""
    for action in top._actions:
        if isinstance(action, argparse._SubParsersAction):
            for verb in action.choices.values():
                yield verb
                yield from verbs(verb)


def section(verb: argparse.ArgumentParser, state: object) -> nodes.section:
    """Title, usage, options and examples of one verb."""
    made = nodes.section(ids=[nodes.make_id(verb.prog)], names=[verb.prog])
    made += nodes.title("", "", nodes.literal("", verb.prog))
    state.document.note_explicit_target(made)
    if verb.description:
        made += nodes.paragraph("", verb.description)
    made += console(usage(verb))
    made += options(verb)
    if verb.epilog:
        made += console(verb._get_formatter()._fill_text(verb.epilog, COLUMNS, ""))
    return made


def usage(verb: argparse.ArgumentParser) -> str:
    """The usage in lines that a telephone shows: the verb, and below it what can follow."""
    formatter = verb.formatter_class(prog="", width=42)
    formatter.add_usage(verb.usage, verb._actions, verb._mutually_exclusive_groups, prefix="")
    return f"{verb.prog}\n{indent(dedent(formatter.format_help()).strip(), '  ')}"


def options(verb: argparse.ArgumentParser) -> nodes.definition_list:
    """What can be given to a verb, and what it means."""
    formatter = verb._get_formatter()
    listed = nodes.definition_list()
    for action in verb._actions:
        if isinstance(action, argparse._HelpAction | argparse._SubParsersAction):
            continue
        name = formatter._format_action_invocation(action)
        help_text = formatter._expand_help(action) if action.help else ""
        listed += nodes.definition_list_item(
            "", nodes.term("", "", nodes.literal("", name)),
            nodes.definition("", nodes.paragraph("", help_text)))
    return listed


def console(text: str) -> nodes.literal_block:
    """A block as it is typed or printed."""
    return nodes.literal_block(text, text, language="none")


def setup(app: Sphinx) -> dict[str, bool]:
    """Make the directive known."""
    app.add_directive("command-line", CommandLine)
    return {"parallel_read_safe": True}
