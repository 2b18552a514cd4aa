"""Statements by key, and sources that tests write."""
from gyrostat.published import SOURCES, check, load

STATEMENTS = [s for source in SOURCES for s in load(source).statements]
BY_KEY = {(s.source, s.key): s for s in STATEMENTS}
# each takes as long as some hundred others
LONG = {("N2025", key) for key in ("Euler-tensor", "Euler-epsilon", "Euler-tensor-two-dots",
                                   "transport-L")} | {
    ("EA", key) for key in ("4.29", "4.30", "4.31")} | {("literature", "S4-slow")}


def written(tmp_path, text):
    path = tmp_path / "mine.toml"
    path.write_text(text, encoding="utf-8")
    return path


CLAIM = """[[formula]]
key = "{key}"
where = "(1)"
quantity = "{quantity}"
printed = "{printed}"
kind = "{kind}"
scene = "s"
"""


def status(tmp_path, scene, quantity, printed, kind="condition", given="", at="{}"):
    """What check says of one claim in a scene of its own."""
    text = '[source]\nname = "mine"\ntitle = "t"\n[scene.s]\n' + scene + "\n"
    text += CLAIM.format(key="a", quantity=quantity, printed=printed, kind=kind)
    text += f"at = {at}\n"
    (finding,) = check([written(tmp_path, text + (f'given = "{given}"\n' if given else ""))])
    return finding.status
