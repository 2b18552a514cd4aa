"""What is served: scripts without their comments, a page that asks for all of its modules at once."""
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


def test_every_module_that_the_page_needs_is_preloaded(tmp_path):
    """Those that a module of a module imports too, each once, in one line or in several."""
    for name, text in {"app/main.js": 'import { a } from "../views/one.js";\nimport "./two.js";\n',
                       "app/two.js": '// import "./not.js";\nimport {\n  a,\n  b } from "../views/one.js";\n',
                       "views/one.js": 'import { c } from "./three.js";\n', "views/three.js": ""}.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    found = build.needed(tmp_path, "app/main.js")
    assert found == ["app/main.js", "views/one.js", "app/two.js", "views/three.js"]
    page = build.preloading('<head>\n<script id="formulas" async></script>\n</head>', found)
    assert re.findall(r'rel="modulepreload" href="([^"]*)"', page) == found
    assert page.index("modulepreload") < page.index("<script")


def test_every_script_of_the_page_is_preloaded_or_a_thread():
    """None is forgotten, and none is there that nothing loads."""
    home = Path(build.__file__).parent
    threads = {"app/worker.js", "app/unpacker.js", "numerics/chart-worker.js"}
    known = {name for script in ("app/main.js", *threads) for name in build.needed(home, script)}
    assert known == {path.relative_to(home).as_posix() for path in home.glob("*/*.js")}
