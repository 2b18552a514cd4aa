"""What no other library imports is left out of the exports of a library of WebAssembly."""
import pytest
from linked import LINKING, imported, linked, linking, with_exports

HEADER = b"\0asm\1\0\0\0"
LONG = "n" * 200                                       # its length takes two bytes


def name(text):
    """A name as it stands in a module."""
    size = len(text)
    return (bytes([size]) if size < 128 else bytes([size & 127 | 128, size >> 7])) + text.encode()


def section(kind, entries):
    """A section of several entries, its length in two bytes."""
    body = bytes([len(entries)]) + b"".join(entries)
    return bytes([kind, len(body) & 127 | 128, len(body) >> 7]) + body


def module(imports, exports):
    """One that imports and exports functions, and has a memory, a table, a global, a section of its own."""
    others = [name("env") + name("memory") + b"\2\1\1\x80\2", name("env") + name("table") + b"\1\x70\0\1",
              name("GOT.mem") + name("there") + b"\3\x7f\1"]
    return (HEADER + section(2, [*others, *(name("env") + name(x) + b"\0\3" for x in imports)])
            + section(7, [name(x) + b"\0" + bytes([n]) for n, x in enumerate(exports)]) + b"\0\3\2xy")


def test_every_kind_of_import_is_read():
    """Functions, a memory with two limits, a table, a global."""
    assert imported(module(["f", LONG], [])) == {"memory", "table", "there", "f", LONG}


def test_exports_that_are_needed_stay_as_they_were():
    """With their numbers; and those that the loader looks for."""
    whole = module(["f"], ["a", LONG, "__wasm_call_ctors", "b"])
    kept = with_exports(whole, {LONG, "other"})
    entries = [name(LONG) + b"\0\1", name("__wasm_call_ctors") + b"\0\2"]
    assert kept.endswith(b"\2" + entries[0] + entries[1] + b"\0\3\2xy")
    assert name("a") + b"\0\0" not in kept and imported(kept) == imported(whole)


def test_a_library_keeps_what_others_import_and_a_module_of_python_all():
    """The names are those of all modules together."""
    found = linked({"libs/lib.so": module([], ["a", "b"]),
                    "p/m.cpython-314-wasm32.so": module(["b"], ["PyInit_m", "c"])})
    assert imported(found["p/m.cpython-314-wasm32.so"]) >= {"b"}
    assert found["p/m.cpython-314-wasm32.so"] == module(["b"], ["PyInit_m", "c"])
    assert name("b") + b"\0\1" in found["libs/lib.so"] and name("a") + b"\0\0" not in found["libs/lib.so"]


def test_the_loader_is_changed_where_it_is_the_one_that_was_tried():
    """Each place once; a loader without one of them, or with one twice, is refused."""
    whole = ";".join(LINKING)
    assert linking(whole) == ";".join(LINKING.values())
    for place in LINKING:
        for other in (whole.replace(place, ""), whole + place):
            with pytest.raises(SystemExit, match="not the one that was tried"):
                linking(other)
