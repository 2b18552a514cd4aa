"""The exports of a library of WebAssembly that no other library imports, left out of it.

The loader enters each export of each library in a table and goes through that table for each library: half
of the start of python-flint. A module is a header of 8 bytes and sections, each a number, a length and as
many bytes; section 2 has the imports, 7 the exports.
"""
import sys
from collections.abc import Iterator, Mapping

IMPORTS, EXPORTS = 2, 7
# What the loader does again for each library, and what is enough. It looks whether all symbols are known: the
# new ones are enough. It copies the symbols of a library to each that needs it: from the second time on they
# are everybody's. It compiles: another thread has done it.
LINKING = {
    "var GOTHandler=": "var newSymbols=[];var GOTHandler=",
    'rtn=GOT[symName]=new WebAssembly.Global({value:"i32",mutable:true},-1)}':
        'rtn=GOT[symName]=new WebAssembly.Global({value:"i32",mutable:true},-1);newSymbols.push(symName)}',
    "for(var[symName,entry]of Object.entries(GOT)){if(entry.value==-1){var value=resolveGlobalSymbol":
        "for(var symName of newSymbols.splice(0)){var entry=GOT[symName];"
        "if(entry.value==-1){var value=resolveGlobalSymbol",
    "if(!flags.global){if(localScope){Object.assign(localScope,dso.exports)}}":
        "if(!flags.global){if(localScope&&!dso.global){dso.global=true;mergeLibSymbols(dso.exports,libName)}}",
    "var module=binary instanceof WebAssembly.Module?binary:new WebAssembly.Module(binary);":
        "var module=globalThis.compiled?.get(libName)??new WebAssembly.Module(binary);"}
FUNCTION, TABLE, MEMORY, GLOBAL, TAG = range(5)
OWN = "__"                                             # what the loader itself looks for begins so


def imported(module: bytes) -> set[str]:
    """The names that a module imports."""
    names: set[str] = set()
    for kind, body in _sections(module):
        if kind == IMPORTS:
            count, at = _number(body, 0)
            for _ in range(count):
                _, at = _name(body, at)
                name, at = _name(body, at)
                names.add(name)
                at = _after_type(body, at)
    return names


def with_exports(module: bytes, needed: set[str]) -> bytes:
    """The module with those of its exports that are needed."""
    kept = bytearray(module[:8])
    for kind, body in _sections(module):
        if kind == EXPORTS:
            entries = [entry for name, entry in _exports(body) if name in needed or name.startswith(OWN)]
            body = _written(len(entries)) + b"".join(entries)
        kept += bytes([kind]) + _written(len(body)) + body
    return bytes(kept)


def linked(modules: Mapping[str, bytes]) -> dict[str, bytes]:
    """Modules by their paths; libraries, which are not of Python, with the exports that are imported."""
    needed = set[str]().union(*map(imported, modules.values()))
    return {path: with_exports(module, needed) if "cpython" not in path else module
            for path, module in modules.items()}


def linking(loader: str) -> str:
    """The script of Pyodide that loads libraries, without what it does again for each of them."""
    for before, after in LINKING.items():
        if loader.count(before) != 1:
            sys.exit(f"the loader of Pyodide is not the one that was tried: {before}")
        loader = loader.replace(before, after)
    return loader


def _sections(module: bytes) -> Iterator[tuple[int, bytes]]:
    at = 8
    while at < len(module):
        kind = module[at]
        length, start = _number(module, at + 1)
        at = start + length
        yield kind, module[start:at]


def _exports(body: bytes) -> Iterator[tuple[str, bytes]]:
    """Each export: its name, and the bytes of its entry, which are the name, a kind and an index."""
    count, at = _number(body, 0)
    for _ in range(count):
        start = at
        name, at = _name(body, at)
        _, at = _number(body, at + 1)
        yield name, body[start:at]


def _after_type(body: bytes, at: int) -> int:
    """The place behind the type of an import."""
    kind = body[at]
    if kind in (FUNCTION, TAG):
        return _number(body, at + 1 + (kind == TAG))[1]
    if kind == GLOBAL:
        return at + 3
    limited = at + 1 + (kind == TABLE)                 # of a table its type stands first
    _, after = _number(body, limited + 1)
    return _number(body, after)[1] if body[limited] & 1 else after


def _name(body: bytes, at: int) -> tuple[str, int]:
    length, start = _number(body, at)
    return body[start:start + length].decode(), start + length


def _number(body: bytes, at: int) -> tuple[int, int]:
    """An unsigned LEB128, and the place behind it."""
    value = shift = 0
    while True:
        byte = body[at]
        value |= (byte & 127) << shift
        at, shift = at + 1, shift + 7
        if byte < 128:
            return value, at


def _written(number: int) -> bytes:
    """An unsigned LEB128."""
    digits = bytearray()
    while number > 127:
        digits.append(number & 127 | 128)
        number >>= 7
    return bytes([*digits, number])
