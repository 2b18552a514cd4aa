"""How many one-symbol misprints does the check of published formulas find?

    python benchmarks/mutate_published.py [SOURCE ...] [--count N | --quick] [--jobs N] [--show]

Each confirmed formula is changed in one place: a sign, an index, an exponent, a prime, a coefficient, a
relation, a verdict. Every mutant has to be reported as a misprint, with a counterexample, or a point at which
it is not sharp; those that are true as well are listed, with the reason. The numbers shown are read again,
from the JSON output, by tests/published/read_again.py: the evidence is false if they do not show what they
are shown for. --count takes a seeded sample.
"""
import argparse
import platform
import random
import re
import sys
import time
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from importlib.metadata import version
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "tests"))
from published.read_again import is_shown  # noqa: E402

from gyrostat.errors import GyrostatError
from gyrostat.published import SOURCES, Finding, load
from gyrostat.published.checks.findings import outcome_of

# Mutants that are as true as the original: a pattern of source:key: mutant, and why.
EQUIVALENT = (
    (r"AR:2K-rate-5: ", "the sum in parentheses is 0, whatever multiplies it"),
    (r"AR:2K-rate-1: -", "both sides are 0"),
    (r"AR:norm-rate(-cross)?: (3|-)", "M·(dM/dt) is 0, whatever multiplies it"),
    (r"AR:stationary-\d|EA:axis-3-point", "every momentum along a principal axis is at rest"),
    (r"VV2003:(E1|E2|Rumiantsev-point|Cavas-Viguera-point): ",
     "every spin about the vertical is an equilibrium, up or down"),
    (r"VV2003:symmetric-", "the source has I2 = I1 here"),
    (r"VV2003:(involution|Casimir-2|integrals-2): ", "k² is a Casimir: its bracket with everything is 0"),
    (r"VV2003:(heavy-existence|newtonian-existence|k3-inside): .*<=",
     "at equality the point is E1 or E2, an equilibrium too"),
    (r"VV2003:(E1-instability|E3-p): [ab] = ", "the name enters squared"),
    (r"VV2003:E3-polynomial: ", "q is 0 on the family"),
    (r"VV2003:E3-necessary: (p >= 0 and q >= 0 and p.*>= 0$|q = |p = I1\*\*3|.*q <= 0)",
     "q is 0 on the family: the sign of p is left"),
    (r"N2025:semi-axis-order: ", "true wherever I1 < I2 < I3"),
    (r"N2025:(omega-x1|symmetric-second-order): \w+ = -", "the name enters squared"),
    (r"N2025:(omega-constant|amplitude): ", "Ω3 is constant, and cos² + sin² = 1, whatever ω"),
    (r"EA:angle-constant: ", "ω3 and ω1² + ω2² are constant, and with them every function of them"),
    (r"(EA:rotation-rate|literature:(S1-E[12]|S8-\w+|F1|Kharlamov-(curve|on-curve|field)|routh-p)): "
     r"\w+ = -\(", "the name enters squared"),
    (r"literature:F2(-sphere)?: \w+ = -\(", "another sign of a root: F2 has all four, σ = sign(ac)"),
    (r"literature:F2: [xy] = sqrt\(1/I(\d) - 1/I\1\)",
     "μ = 0 and the motion is a rotation about an axis, a solution too"),
    (r"literature:F3-solution: [uvrs] = -\(", "two components or the time change sign: a solution too"),
    (r"literature:(A1-(Energy-Casimir|uniform|damped)|L8|L8-damped|L12|L12-still|major-axis|"
     r"Volterra-off-plane-\w+): .*[<>]=",
     "at equality the form is semidefinite: nothing is known there, and it is not confirmed"),
    (r"literature:L6-despun: .*>=", "true wherever l > 0"),
    (r"literature:sleeping-damped-critical: .*>=", "at equality the energy is least, by its fourth order"),
    (r"windows:sleeping-1-3: -|satellites:(DeBra-Delp-\w+|rotor-limit-\w+|conical-window): -0.0+$",
     "−0 is 0"),
    (r"satellites:\w+-polynomial: ([GP] = -|G = P$)", "the name enters squared"),
    (r"satellites:held-tensor-point: -1", "r and −r are one vertical"),
    (r"satellites:drag-(pitch|yaw)-stable: ", "two of the conditions order the moments: the third holds"),
    (r"satellites:tilted-vertical-stable: \(I1 \+ I3\)", "another positive factor"),
    (r"satellites:(Lagrange(-\w+)?|rotor-(stable|damped)(-numbers)?|tilted-\w+-stable|cylindrical-stable|"
     r"hyperbolic-stable|conical-(stable|damped)|two-fields-stable|level-stable(-numbers)?|"
     r"rising-(stable|upside-down)|drag-(stable|damped)|magnet-stable|asteroid-\w+-stable): .*[<>]=",
     "at equality the form is semidefinite: nothing is known there, and it is not confirmed"),
)
# the check says "unchecked": it differs from what is derived, and nowhere is it seen to fail
UNCHECKED = (
    (r"satellites:DeBra-Delp(: .*1 \+ 3\*kR \+ kR\*kY > 4|-ratios: kR > kY)",
     "at equality no rational point was found"),
    (r"satellites:DeBra-Delp: kY = \(I2 - I1\)/I1", "differs in a narrow region, no point was found"),
    (r"literature:(F1: rate = .*\(I1 - I2\)\*\(I2 - I1\)|F2-sphere: .*I3)", "a root that is real nowhere"),
    (r"literature:F2-sphere: .*2/I3", "no real point was found"),
    (r"\w+:(inverse-rate|M-rate-1): ", "a rate of the inverse of R"),
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
        yield (
            "sign",
            text[1:]
            if text.startswith("-")
            else f"-{text}"
            if re.fullmatch(r"[\w.]+", text)
            else f"-({text})",
        )
    for match in INDEX.finditer(text):
        yield "index", text[:match.start(2)] + NEXT[match[2]] + text[match.end(2):]
    for match in re.finditer(r"\*\*(\d+)", text):
        yield "exponent", f"{text[:match.start(1)]}{int(match[1]) + 1}{text[match.end(1):]}"
    for match in re.finditer(r"\bd(\d?)U\b", text):
        following = {"": "2", "2": "3"}.get(match[1], "")
        yield "prime", f"{text[:match.start()]}d{following}U{text[match.end():]}"
    for match in re.finditer(r"(?<![A-Za-z0-9_.*])(\d+)(?![.\d])(?=\*[^*]|/)", text):
        yield "coefficient", f"{text[:match.start()]}{int(match[1]) + 1}{text[match.end():]}"
    for match in re.finditer(r"(?<![A-Za-z0-9_])\d*\.\d+", text):
        last = str((int(match[0][-1]) + 2) % 10)
        yield "digit", text[:match.end() - 1] + last + text[match.end():]
    for match in re.finditer(r"[<>]=?", text):
        flipped = match[0].translate(str.maketrans("<>", "><"))
        yield "relation", text[:match.start()] + flipped + text[match.end():]
        yield (
            "relation",
            text[: match.start()]
            + (match[0][0] if match[0].endswith("=") else match[0] + "=")
            + text[match.end() :],
        )


def other_counts(text):
    """(kind, mutant) for a count that is four more, or one more."""
    yield from (("count", str(int(text) + n)) for n in (1, 4))


def placed(value, path=()):
    """Every text in a printed value, with its place."""
    if isinstance(value, str):
        yield path, value
    else:
        for i, part in enumerate(value):
            yield from placed(part, (*path, i))


def put(value, path, text):
    """The value with the text at the place."""
    return text if not path else [put(part, path[1:], text) if i == path[0] else part
                                  for i, part in enumerate(value)]


def mutants(statement):
    """(kind, label, mutated statement)."""
    nothing = set(re.findall(r"\w+", str(statement.quantity))) == {"0"}
    for path, text in placed(statement.printed):
        for kind, changed in (other_counts if statement.kind == "count" else mutants_of)(text):
            whole = kind == "sign" and changed.strip("-()") == text.strip("-()")
            if not (whole and (nothing or text == "0")):   # −0 is 0
                yield kind, changed, replace(statement, printed=put(statement.printed, path, changed))
    for name, text in statement.let.items():
        for kind, changed in mutants_of(text):
            yield kind, f"{name} = {changed}", replace(statement, let={**statement.let, name: changed})


def reason(result, reasons):
    """Why a mutant is none of those that are reported, or None."""
    name = f"{result[0]}:{result[1]}: {result[3]}"
    return next((why for pattern, why in reasons if re.match(pattern, name)), None)


def evidence(mutant, outcome):
    """What is shown: true, false, unread (of a kind that nothing here reads again) or none; and numbers."""
    finding = Finding(mutant, "misprint", "confirmed", outcome)
    example = outcome.counterexample or outcome.not_sharp
    if not example:
        return "none", ""
    try:
        answer = is_shown(finding)
    except (ArithmeticError, AssertionError, IndexError, LookupError, TypeError, ValueError) as error:
        return "unread", f"{type(error).__name__}: {error}"
    return {True: "true", False: "false", None: "unread"}[answer], "" if answer else str(example)


def tried(task):
    """killed, weaker, survived, refused (an index the scene does not have, a division by zero), or stuck
    (another error); the evidence.
    """
    source, key, kind, label, mutant = task
    start, seen = time.process_time(), ("none", "")
    try:
        outcome = outcome_of(mutant)
        result = "survived"
        if outcome.agrees is False:
            result = "killed" if outcome.counterexample else "weaker" if outcome.not_sharp else "survived"
        seconds = time.process_time() - start
        seen = evidence(mutant, outcome)
    except GyrostatError as error:                         # anything else is a defect, and stops the run
        quoted = re.search(r"cannot read (?:the chain )?'(.*?)(?:\.\.\.)?'", str(error))
        texts = [t for _, t in placed(mutant.printed)] + list(mutant.let.values())
        refused = quoted and any(quoted[1].strip() in t for t in texts)
        result, seconds = "refused" if refused else f"stuck: {error}", time.process_time() - start
    return source, key, kind, label, result, seconds, *seen


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("sources", nargs="*", default=SOURCES)
    parser.add_argument("--count", type=int, help="a seeded sample of so many mutants")
    parser.add_argument("--quick", action="store_true", help="a sample of 60")
    parser.add_argument("--jobs", type=int, help="processes")
    parser.add_argument("--show", action="store_true", help="every mutant")
    given, start = parser.parse_args(), time.perf_counter()
    statements = [s for source in given.sources for s in load(source).statements]
    expected = {source: load(source).expected for source in given.sources}
    tasks = [(s.source, s.key, *mutant) for s in statements
             if expected[s.source].get(s.key, "confirmed") == "confirmed"
             for mutant in mutants(s)]
    whole, count = len(tasks), 60 if given.quick else given.count
    if count and count < whole:
        tasks = random.Random(1).sample(tasks, count)
    results = []
    with ProcessPoolExecutor(given.jobs) as pool:
        for found in pool.map(tried, tasks, chunksize=4):
            results.append(found)
            if given.show:
                source, key, kind, label, result, seconds, proof, _ = found
                print(f"{source}:{key}: {kind}: {label}: {result}, evidence {proof} ({seconds:.2f} s)",
                      flush=True)
    return report(results, whole, time.perf_counter() - start)


def report(results, whole, seconds):
    """Print the counts; 1 if a mutant is not reported and nothing says why, or evidence is false."""
    read = [r for r in results if r[4] != "refused"]
    counted, proofs = Counter(r[4] for r in read), Counter(r[6] for r in read)
    equivalent = [(r, why) for r in read if r[4] == "survived" if (why := reason(r, EQUIVALENT))]
    unchecked = [(r, why) for r in read if r[4] == "survived" and not reason(r, EQUIVALENT)
                 if (why := reason(r, UNCHECKED))]
    known = [r for r, _ in equivalent + unchecked]
    left = [r for r in read if r[4] not in ("killed", "weaker") and r not in known]
    kinds = ", ".join(f"{n} {kind}" for kind, n in Counter(r[2] for r in read).most_common())
    reported = counted["killed"] + counted["weaker"]
    print(f"{platform.machine()}, Python {platform.python_version()}, sympy {version('sympy')}, "
          f"python-flint {version('python-flint')}; "
          f"{seconds:.0f} s; of CPU for each mutant at most {max(r[5] for r in results):.1f} s, in the mean "
          f"{sum(r[5] for r in results) / len(results):.2f} s")
    print(f"{len(results)} mutants of {whole}, {len(results) - len(read)} refused as no formula of their "
          "scene; "
          f"the others: {len(read)} ({kinds})")
    print(f"{reported} reported as misprints, {counted['killed']} with a counterexample, "
          f"{counted['weaker']} not sharp; "
          f"{len(equivalent)} equivalent, {len(unchecked)} unchecked, {len(left)} none of these: kill rate "
          f"{100 * reported / max(1, len(read) - len(equivalent)):.1f} %")
    print(f"evidence read again: {proofs['true']} true, {proofs['false']} false; {proofs['unread']} not "
          "read again, "
          f"{proofs['none']} without numbers")
    for name, found in (("equivalent", equivalent), ("unchecked", unchecked)):
        for (source, key, _, label, *_), why in found:
            print(f"  {name}: {source}:{key}: {label}: {why}")
    for source, key, kind, label, result, *_ in left:
        print(f"  NOT REPORTED: {source}:{key}: {kind}: {label}: {result}")
    for source, key, kind, label, _, _, proof, why in read:
        if proof in ("false", "unread"):
            print(f"  {'FALSE EVIDENCE' if proof == 'false' else 'not read again'}: {source}:{key}: "
                  f"{kind}: {label}: {why}")
    return 1 if left or proofs["false"] else 0


if __name__ == "__main__":
    sys.exit(main())
