"""How many one-symbol misprints does the check of published formulas find?

    python benchmarks/mutate_published.py [SOURCE ...] [--show]

Each confirmed formula is changed in one place: a sign, an index, an exponent, a prime, a coefficient, a relation, a verdict.
Every mutant has to be reported as a misprint, with a counterexample, or a point at which it is not sharp;
those that are true as well are listed, with the reason.
"""
import argparse
import re
import sys
import time
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace

from gyrostat.errors import GyrostatError
from gyrostat.published import SOURCES, load, outcome_of

# Mutants that are as true as the original: a pattern of source:key: mutant, and why.
EQUIVALENT = (
    (r"AR:2K-rate-5: ", "the sum in parentheses is 0, whatever multiplies it"),
    (r"AR:2K-rate-1: -", "both sides are 0"),
    (r"AR:norm-rate(-cross)?: (3|-)", "M·(dM/dt) is 0, whatever multiplies it"),
    (r"AR:stationary-\d|EA:axis-3-point", "every momentum along a principal axis is at rest"),
    (r"VV2003:(E1|E2|Rumiantsev-point|Cavas-Viguera-point): ", "every spin about the vertical is an equilibrium, up or down"),
    (r"VV2003:symmetric-", "the source has I2 = I1 here"),
    (r"VV2003:(involution|Casimir-2|integrals-2): ", "k² is a Casimir: its bracket with everything is 0"),
    (r"VV2003:(heavy-existence|newtonian-existence|k3-inside): .*<=", "at equality the point is E1 or E2, an equilibrium too"),
    (r"VV2003:(E1-instability|E3-p): [ab] = ", "the name enters squared"),
    (r"VV2003:E3-polynomial: ", "q is 0 on the family"),
    (r"VV2003:E3-necessary: (p >= 0 and q >= 0 and p.*>= 0$|q = |p = I1\*\*3|.*q <= 0)", "q is 0 on the family: the sign of p is left"),
    (r"N2025:semi-axis-order: ", "true wherever I1 < I2 < I3"),
    (r"N2025:(omega-x1|symmetric-second-order): \w+ = -", "the name enters squared"),
    (r"N2025:(omega-constant|amplitude): ", "Ω3 is constant, and cos² + sin² = 1, whatever ω"),
    (r"EA:angle-constant: ", "ω3 and ω1² + ω2² are constant, and with them every function of them"),
    (r"(EA:rotation-rate|literature:(S1-E[12]|S8-\w+|F1)): \w+ = -\(", "the name enters squared"),
    (r"literature:F2(-sphere)?: \w+ = -\(", "another sign of a root: F2 has all four, σ = sign(ac)"),
    (r"literature:F2: [xy] = sqrt\(1/I(\d) - 1/I\1\)", "μ = 0 and the motion is a rotation about an axis, a solution too"),
    (r"literature:F3-solution: [uvrs] = -\(", "two components or the time change sign: a solution too"),
    (r"literature:A1-Energy-Casimir: .*>=", "at equality the form is semidefinite: nothing is known there, and it is not confirmed"),
)
INDEX = re.compile(r"(?<![A-Za-z0-9_])([A-Za-z]+(?:_[a-z]+)?)([123])(?=(?:_0)?(?![A-Za-z0-9_]))")
NEXT = {"1": "2", "2": "3", "3": "1"}


def mutants_of(text):
    """(kind, mutant) for every single change of a printed text."""
    if text in ("stable", "orbitally stable", "unstable", "never"):
        yield from [("verdict", "stable" if text == "unstable" else "unstable")] if text != "never" else []
        return
    for match in re.finditer(r"(?<![eE*/(,<>=])\s*([-+])\s*(?=[^\s])", text):
        place = match.start(1)
        if text[:place].strip():
            yield "sign", text[:place] + "+-"[text[place] == "+"] + text[place + 1:]
    if not re.search("[<>]", text):
        yield "sign", text[1:] if text.startswith("-") else f"-{text}" if re.fullmatch(r"[\w.]+", text) else f"-({text})"
    for match in INDEX.finditer(text):
        yield "index", text[:match.start(2)] + NEXT[match[2]] + text[match.end(2):]
    for match in re.finditer(r"\*\*(\d+)", text):
        yield "exponent", f"{text[:match.start(1)]}{int(match[1]) + 1}{text[match.end(1):]}"
    for match in re.finditer(r"\bd(\d?)U\b", text):
        yield "prime", f"{text[:match.start()]}d{2 if not match[1] else 3 if match[1] == '2' else ''}U{text[match.end():]}"
    for match in re.finditer(r"(?<![A-Za-z0-9_.*])(\d+)(?![.\d])(?=\*[^*]|/)", text):
        yield "coefficient", f"{text[:match.start()]}{int(match[1]) + 1}{text[match.end():]}"
    for match in re.finditer(r"(?<![A-Za-z0-9_])\d*\.\d+", text):
        last = str((int(match[0][-1]) + 2) % 10)
        yield "digit", text[:match.end() - 1] + last + text[match.end():]
    for match in re.finditer(r"[<>]=?", text):
        flipped = match[0].translate(str.maketrans("<>", "><"))
        yield "relation", text[:match.start()] + flipped + text[match.end():]
        yield "relation", text[:match.start()] + (match[0][0] if match[0].endswith("=") else match[0] + "=") + text[match.end():]


def placed(value, path=()):
    """Every text in a printed value, with its place."""
    if isinstance(value, str):
        yield path, value
    else:
        for i, part in enumerate(value):
            yield from placed(part, (*path, i))


def put(value, path, text):
    """The value with the text at the place."""
    return text if not path else [put(part, path[1:], text) if i == path[0] else part for i, part in enumerate(value)]


def mutants(statement):
    """(kind, label, mutated statement)."""
    nothing = set(re.findall(r"\w+", str(statement.quantity))) == {"0"}
    for path, text in placed(statement.printed):
        for kind, changed in mutants_of(text):
            whole = kind == "sign" and changed.strip("-()") == text.strip("-()")
            if not (whole and (nothing or text == "0")):   # −0 is 0
                yield kind, changed, replace(statement, printed=put(statement.printed, path, changed))
    for name, text in statement.let.items():
        for kind, changed in mutants_of(text):
            yield kind, f"{name} = {changed}", replace(statement, let={**statement.let, name: changed})


def reason(result):
    """Why a mutant is as true as the original, or None."""
    name = f"{result[0]}:{result[1]}: {result[3]}"
    return next((why for pattern, why in EQUIVALENT if re.match(pattern, name)), None)


def tried(task):
    """killed, survived, refused (an index that the scene does not have, a division by zero), or stuck (another error)."""
    source, key = task
    (statement,) = (s for s in load(source).statements if s.key == key)
    if outcome_of(statement).agrees is not True:
        return []
    results = []
    for kind, label, mutant in mutants(statement):
        start = time.perf_counter()
        try:
            outcome = outcome_of(mutant)
            result = "killed" if outcome.agrees is False and (outcome.counterexample or outcome.not_sharp) else "survived"
        except GyrostatError as error:                     # anything else is a defect, and stops the run
            quoted = re.search(r"cannot read (?:the chain )?'(.*?)(?:\.\.\.)?'", str(error))
            texts = [t for _, t in placed(mutant.printed)] + list(mutant.let.values())
            refused = quoted and any(quoted[1].strip() in t for t in texts)
            result = "refused" if refused else f"stuck: {error}"
        results.append((source, key, kind, label, result, time.perf_counter() - start))
    return results


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("sources", nargs="*", default=SOURCES)
    parser.add_argument("--show", action="store_true", help="every mutant")
    given = parser.parse_args()
    tasks = [(source, s.key) for source in given.sources for s in load(source).statements]
    results = []
    with ProcessPoolExecutor() as pool:
        for found in pool.map(tried, tasks):
            results += found
            for source, key, kind, label, result, seconds in found if given.show else ():
                print(f"{source}:{key}: {kind}: {label}: {result} ({seconds:.2f} s)", flush=True)
    read = [r for r in results if r[4] != "refused"]
    killed = [r for r in read if r[4] == "killed"]
    equivalent = [(r, why) for r in read if r[4] == "survived" for why in [reason(r)] if why]
    left = [r for r in read if r not in killed and r not in [e for e, _ in equivalent]]
    kinds = ", ".join(f"{n} {kind}" for kind, n in Counter(r[2] for r in read).most_common())
    print(f"{len(results)} mutants, {len(results) - len(read)} refused as no formula of their scene; the others: {len(read)} ({kinds})")
    print(f"{len(killed)} reported as misprints, {len(equivalent)} equivalent, {len(left)} neither: "
          f"kill rate {100 * len(killed) / max(1, len(read) - len(equivalent)):.1f} %")
    for (source, key, _, label, _, _), why in equivalent:
        print(f"  equivalent: {source}:{key}: {label}: {why}")
    for source, key, kind, label, result, _ in left:
        print(f"  NOT REPORTED: {source}:{key}: {kind}: {label}: {result}")
    return 1 if left else 0


if __name__ == "__main__":
    sys.exit(main())
