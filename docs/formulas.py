"""Find the formulas that a docstring writes in Unicode, and write them in LaTeX for the site.

A terminal shows ``π̇ = (π + l) × ω + k × ∇U`` as it stands; the site typesets it. A formula is a run of
letters, numbers, operators and brackets between words that contains what no prose has: a Greek letter, a
letter with an index or a power, or an operator beside a letter.
"""
import re
from collections.abc import Iterator
from unicodedata import normalize

GREEK = {"α": "alpha", "β": "beta", "γ": "gamma", "δ": "delta", "ε": "varepsilon", "ζ": "zeta", "η": "eta",
         "θ": "theta", "κ": "kappa", "λ": "lambda", "μ": "mu", "ν": "nu", "ξ": "xi", "π": "pi", "ρ": "rho",
         "σ": "sigma", "τ": "tau", "φ": "varphi", "χ": "chi", "ψ": "psi", "ω": "omega", "Γ": "Gamma",
         "Δ": "Delta", "Θ": "Theta", "Λ": "Lambda", "Σ": "Sigma", "Φ": "Phi", "Ψ": "Psi", "Ω": "Omega",
         "∇": "nabla", "∂": "partial", "∞": "infty"}
OPERATORS = {"×": r"\times", "·": r"\cdot", "≤": r"\le", "≥": r"\ge", "≠": r"\ne", "≈": r"\approx",
             "±": r"\pm", "→": r"\to", "∈": r"\in", "−": "-", "…": r"\dots",
             **{sign: sign for sign in "+-=<>/"}, "*": r"\,"}
WEAK = set("-/…*")                                     # prose has them, too
SIGNS, RELATIONS = set("-−+±"), set("=<>≤≥≠≈→∈")
ACCENTS = {"\u0307": r"\dot", "\u0308": r"\ddot", "\u0302": r"\hat", "\u0303": r"\tilde"}
HIGH = dict(zip("⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺ⁿᵀᵈᴺ⁽⁾", "0123456789-+nTdN()")) | {
    prime: " ".join([r"\prime"] * n) for n, prime in enumerate("′″‴", 1)} | {"'": r"\prime"}
LOW = dict(zip("₀₁₂₃₄₅₆₇₈₉ᵢⱼₖₙ₊₋", "0123456789ijkn+-"))
FUNCTIONS = {"sin": r"\sin", "cos": r"\cos", "tan": r"\tan", "log": r"\log", "exp": r"\exp", "det": r"\det",
             "rank": r"\operatorname{rank}", "tr": r"\operatorname{tr}"}
MARKS = "".join((*ACCENTS, *HIGH, *LOW))
HALF = {"½": r"\tfrac12", "¼": r"\tfrac14", "⅓": r"\tfrac13"}
WORDS = "omega", "sigma"                               # names of the code beside letters
LETTERS = "".join(GREEK)
END = "(?![A-Za-z_])"                                  # a word or a name of the code is no letter
INDEX = rf"(?:_[{LETTERS}A-Za-z]{END})?[{MARKS}]*(?:\d{{1,2}}(?!\d))?[{MARKS}]*"
TOKEN = re.compile("|".join((
    rf"(?P<function>(?:abs|sqrt)(?=\()|(?:{'|'.join(FUNCTIONS)})[{''.join(HIGH)}]*(?=\(|\s(?:[{LETTERS}√(]|[A-Z]\b)))",
    r"(?P<root>√)", r"(?P<power>\^|\*\*)", rf"(?P<letter>[{LETTERS}]{INDEX}(?![A-Za-z_]{{2}})"
    rf"|(?!E\d)(?:(?:[A-Za-z]|{'|'.join(WORDS)})(?!['’]?[A-Za-z]){INDEX}{END}|I(?=k{END})))",
    rf"(?P<number>(?:\d+(?:\.\d+)?|[{''.join(HALF)}])[{MARKS}]*)(?![A-Za-z_]{{2}})",
    rf"(?P<operator>[{re.escape(''.join(OPERATORS))}])", r"(?P<open>[(\[{])",
    rf"(?P<close>[)\]}}][{MARKS}]*)", r"(?P<comma>,)")))
STARTS = re.compile(r"(?<![\w.'’/§-])(?=\S)")


def formulas(text: str) -> Iterator[tuple[int, int, str]]:
    r"""Where each formula of a text begins and ends, and the formula in LaTeX.

    >>> list(formulas("The rate is ω = σ/I3 there."))
    [(12, 20, '\\\\omega = \\\\sigma / I_{3}')]
    """
    letters = [(n, part) for n, c in enumerate(text)               # an accent is a character of its own
               for part in (c if c in OPERATORS else normalize("NFD", c))]
    apart, place = "".join(part for _, part in letters), 0
    while start := STARTS.search(apart, place):
        tokens = run(apart, start.end())
        place = start.end() + 1
        if tokens and strong(tokens):
            begin, place = tokens[0].start(), tokens[-1].end()
            yield letters[begin][0], letters[place - 1][0] + 1, latex(tokens)


def run(text: str, place: int) -> list[re.Match[str]]:
    """The longest formula that begins at a place, empty if none does."""
    tokens: list[re.Match[str]] = []
    depth, whole, spaced = 0, 0, False                 # the tokens up to here close every bracket
    while found := TOKEN.match(text, place):
        kind, last = found.lastgroup, tokens[-1] if tokens else None
        if not fits(found, last) or kind in ("comma", "close") and not depth:
            break
        if last and spaced and {kind, last.lastgroup} == {"letter"} and (
                "a" in (found[0], last[0]) or len(tokens) == 1 and last[0] in ("A", "I")):
            break                                      # an article
        depth += (kind == "open") - (kind == "close")
        tokens.append(found)
        if not depth and (kind in ("letter", "number", "close") or found[0] == "…"):
            whole = len(tokens)
        spaced = text[found.end():found.end() + 1].isspace()
        place = found.end() + spaced
    return tokens[:whole]


def fits(token: re.Match[str], before: re.Match[str] | None) -> bool:
    """Whether a token can follow another; None is the beginning."""
    kind, last = token.lastgroup, before and before.lastgroup
    if last in (None, "open", "comma"):
        return kind in ("letter", "number", "open", "function", "root") or token[0] in SIGNS
    if last in ("operator", "root", "power"):
        return kind in ("letter", "number", "open", "function", "root") or token[0] == "…" or (
            token[0] in SIGNS and before is not None and before[0] in RELATIONS)
    if last == "function":
        return kind in ("open", "letter", "number", "root")
    return True


def strong(tokens: list[re.Match[str]]) -> bool:
    """Whether tokens contain what prose does not."""
    letters = [token[0] for token in tokens if token.lastgroup == "letter"]
    indexed = any(letter[0] in GREEK or len(letter) > 1 and letter not in WORDS for letter in letters)
    related = any(token.lastgroup == "operator" and token[0] not in WEAK for token in tokens)
    return indexed or related and bool(letters) and len(tokens) > 2


def latex(tokens: list[re.Match[str]]) -> str:
    """Write a formula in LaTeX."""
    parts, place = [], 0
    while place < len(tokens):
        text, place = operand(tokens, place)
        parts.append(text)
    return " ".join(parts)


def operand(tokens: list[re.Match[str]], place: int) -> tuple[str, int]:
    """Write a token with what belongs to it, and say where the next one is."""
    token = tokens[place]
    kind, text = token.lastgroup, token[0]
    if kind == "operator":
        return OPERATORS[text], place + 1
    if kind == "power":
        inner, after = group(tokens, place + 1)
        return f"^{{{inner}}}", after
    if kind == "root" or kind == "function" and text in ("sqrt", "abs"):
        inner, after = group(tokens, place + 1)
        return (rf"\lvert {inner} \rvert" if text == "abs" else rf"\sqrt{{{inner}}}"), after
    if kind == "function":
        name = text.rstrip("".join(HIGH))
        return FUNCTIONS[name] + marked(f"x{text[len(name):]}")[1:], place + 1
    return marked(text), place + 1


def group(tokens: list[re.Match[str]], place: int) -> tuple[str, int]:
    """Write what a root or a power is of: one operand, or what stands in brackets, without them."""
    if tokens[place].lastgroup != "open":
        return operand(tokens, place)
    depth = 0
    for end in range(place, len(tokens)):
        depth += (tokens[end].lastgroup == "open") - (tokens[end].lastgroup == "close")
        if not depth:
            break
    rest = marked(tokens[end][0])[1:]                  # √(x)²
    return latex(tokens[place + 1:end]) + (f"}}{rest}{{" if rest else ""), end + 1


def marked(text: str) -> str:
    """Write a letter, number or bracket with its accents, indices and powers."""
    base, index, marks = re.fullmatch(                                # type: ignore[union-attr]
        rf"(\d+(?:\.\d+)?|{'|'.join(WORDS)}|.)(?:_(.))?([{MARKS}\d]*)", text, re.DOTALL).groups()
    known = {**{letter: f"\\{name}" for letter, name in GREEK.items()}, **HALF, "{": r"\{", "}": r"\}",
             **{word: rf"\mathtt{{{word}}}" for word in WORDS}}
    made = known.get(base, base)
    low = (f"\\{GREEK[index]} " if index in GREEK else index or "") + "".join(
        LOW.get(x, x) for x in marks if x in LOW or x in "0123456789")
    high = " ".join(HIGH[x] for x in marks if x in HIGH)
    for accent in filter(ACCENTS.get, marks):
        made = f"{ACCENTS[accent]}{{{made}}}"
    return made + (f"_{{{low}}}" if low else "") + (f"^{{{high}}}" if high else "")
