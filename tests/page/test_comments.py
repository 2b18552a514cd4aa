"""What is served of a script is the script without its comments."""
import re
from pathlib import Path

import build
import pytest

SCRIPTS = [*Path(build.__file__).parent.glob("*/*.js"), Path(build.__file__).with_name("sw.js")]

SCRIPT = """// A module.
/**
 * Says a number.
 * @returns {number}
 */
export const one = () => 1;  // one
const address = "http:  // not a comment";
/** @type {any} */ let two;
  // Indented.
/** Short. */
const three = /** @type {any} */ (3);
"""
LEFT = """export const one = () => 1;
const address = "http:  // not a comment";
/** @type {any} */ let two;
const three = /** @type {any} */ (3);
"""


def test_comments_are_left_out():
    """Blocks, lines, and what stands behind code; a type before it stays, and so does a text."""
    assert build.without_comments(SCRIPT) == LEFT


@pytest.mark.parametrize("path", SCRIPTS, ids=lambda path: path.name)
def test_no_text_of_a_script_is_taken_for_a_comment(path):
    """Each template that is left stands in the script as it is, and each line begins one of it, in order."""
    script = path.read_text(encoding="utf-8")
    left = build.without_comments(script)
    assert all(template in script for template in re.findall(r"`[^`]*`", left))
    lines = iter(script.splitlines())
    assert all(any(old.startswith(line) for old in lines) for line in left.splitlines())
    assert not re.search(r"^\s*//", left, re.MULTILINE)
