"""Does any text hang, break or execute? Random texts through every route into the library, each with its CPU
time and memory measured.

    python benchmarks/fuzz_texts.py                  1 000 000 texts through the gate
    python benchmarks/fuzz_texts.py --verbs          20 000 accepted ones through the verbs of the command
        line, --timeout 2
    python benchmarks/fuzz_texts.py --quick          a part of both, in less than 30 s

A tenth of the texts are towers, tan(exp(1e50)) and chains of abbreviations; the others are drawn from the
grammar, mutated, or random characters. A worker that does not come back is ended, its text counted as a hang,
and the next one goes on. Printed are the counts of texts accepted and refused, of hangs, slow texts,
exceptions that are no GyrostatError, and executions that an audit hook has seen; the exit status is 1 if one
of the last four is not 0.
"""

import argparse
import json
import mmap
import multiprocessing
import os
import platform
import random
import resource
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

TEXTS, QUICK, HANG, SLOW, MEMORY = 1_000_000, 12_000, 5.0, 0.5, 500 * 2**20
VERBS, QUICK_VERBS, TIMEOUT, ENDED = 20_000, 60, 2, 3.0
NAMES = ["k3", "m0", "m1", "I1", "I3", "l", "a", "b", "omega", "x", "k1", "k2", "pi"]
FUNCTIONS = ["sqrt", "exp", "log", "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh",
             "asinh", "acosh", "atanh"]
STRANGE = [
    "nan",
    "inf",
    "oo",
    "I",
    "E",
    "zoo",
    "__import__('os').system('true')",
    "lambda: 0",
    "eval",
    "exec",
    "{}",
    "[1]",
    "''",
    "k3.__class__",
    "1if 1else 2",
    "sn(1e300,1/2)",
    "f'{1}'",
    "0x10",
    "1_000",
    "1j",
    "∞",
    "π",
    "²",
    "\x00",
    "\x1b[2J",
    "\u202e",
    "\ud800",
    "#",
    ";",
    "\n",
]
LOADED = ("compile", "exec")  # what importing a module does too
FORBIDDEN = (
    "os.system",
    "os.exec",
    "os.posix_spawn",
    "os.spawn",
    "os.fork",
    "subprocess.Popen",
    "socket.connect",
    "ctypes.dlopen",
    "os.remove",
    "os.rename",
    "os.mkdir",
    "shutil.rmtree",
)


def number(chance):
    """A number: ordinary, long, huge or tiny."""
    kind = chance.random()
    if kind < 0.5:
        return chance.choice(["0", "1", "2", "3", "7", "1/2", "0.1", "1.6", "3/5", "12", "100", "0.25",
                              "1e-3", ".5"])
    if kind < 0.8:
        return f"{chance.randint(0, 10 ** chance.randint(1, 6))}{chance.choice(['', '.5', 'e2', 'e-7'])}"
    if kind < 0.95:
        exponent = chance.choice([8, 50, 99, 300, 400, 401, 999, 10**9, 10**30])
        return f"{chance.choice(['', '-'])}{chance.randint(1, 9)}e{chance.choice(['', '-'])}{exponent}"
    return "".join(chance.choice("0123456789")
                   for _ in range(chance.choice([20, 100, 399, 400, 401, 4400, 5000])))


def grown(chance, depth):
    """An expression of the grammar."""
    kind = chance.random()
    if depth <= 0 or kind < 0.2:
        return chance.choice(NAMES) if chance.random() < 0.5 else number(chance)
    inner = grown(chance, depth - 1)
    if kind < 0.6:
        return f"({inner} {chance.choice('+-*/')} {grown(chance, depth - 1)})"
    if kind < 0.7:
        return f"-{inner}"
    if kind < 0.85:
        powers = ["2", "3", "-1", "(1/2)", "0.5", "(-2/3)", "12", "100", "101", "(1/7)", number(chance)]
        return f"({inner})**{chance.choice(powers)}"
    return f"{chance.choice(FUNCTIONS)}({inner})"


def tower(chance):
    """Functions, powers and roots of one another, of huge and tiny numbers."""
    text = chance.choice(
        [number(chance), number(chance), chance.choice(NAMES), f"{number(chance)}*{chance.choice(NAMES)}",
         "pi", "sqrt(2)"]
    )
    for _ in range(chance.randint(1, 6)):
        kind = chance.random()
        if kind < 0.6:
            text = f"{chance.choice(FUNCTIONS)}({text})"
        elif kind < 0.8:
            powers = ["2", "99", "100", "(1/2)", "(1/12)", "(11/12)", "-1", "-99", number(chance)]
            text = f"({text})**{chance.choice(powers)}"
        else:
            operation = chance.choice("+-*/")
            other = chance.choice([number(chance), text, f"{chance.choice(FUNCTIONS)}({text})"])
            text = f"({text}{operation}{other})"
    return text[:6000]


def mutated(chance, text):
    """A few characters lost, doubled, exchanged or put in."""
    characters = list(text)
    for _ in range(chance.randint(1, 4)):
        place = chance.randrange(len(characters) + 1)
        kind = chance.random()
        if kind < 0.3:
            del characters[place : place + chance.randint(1, 3)]
        elif kind < 0.6:
            characters[place:place] = chance.choice([*"()+-*/.,e^ ", "**", "1e9", chance.choice(FUNCTIONS),
                                                     chance.choice(NAMES), *STRANGE])
        elif kind < 0.8:
            characters[place:place] = characters[place : place
                                                 + chance.randint(1, 30)] * chance.randint(1, 20)
        else:
            chance.shuffle(
                characters
            ) if chance.random() < 0.1 else characters.reverse() if chance.random() < 0.05 else None
    return "".join(characters)


def drawn(index, seed):
    """Text number index: a tenth of them towers."""
    chance = random.Random(f"{seed}:{index}")
    if index % 10 == 0:
        return tower(chance), chance
    kind = chance.random()
    if kind < 0.35:
        return grown(chance, chance.randint(1, 5)), chance
    if kind < 0.7:
        return mutated(chance, grown(chance, chance.randint(1, 4)) if chance.random() < 0.8
                       else tower(chance)), chance
    if kind < 0.9:
        return "".join(
            chance.choice([*"()+-*/. 0123456789", "**", "e5", "9**9", "_", *FUNCTIONS, *NAMES, *STRANGE])
            for _ in range(chance.randint(1, 40))
        ), chance
    raw = bytes(chance.getrandbits(8) for _ in range(chance.randint(1, 60)))
    return raw.decode("utf-8", "surrogateescape") if chance.random() < 0.5 else raw.decode(
        chance.choice(["latin-1", "utf-16-le"]), "replace"
    ), chance


def routes(folder):
    """The ways a text comes into the library, by name."""
    from gyrostat.algebra.text.grammar import parse
    from gyrostat.algebra.text.inputs import json_object
    from gyrostat.algebra.text.numbers import exact_number
    from gyrostat.cli.options.axis_option import axis_of
    from gyrostat.mechanics.scenes.entered_potential import axial_potential
    from gyrostat.notation import symbol
    from gyrostat.published import load
    from gyrostat.published.checks.comparisons import comparisons
    from gyrostat.published.checks.readings import _with_let
    from gyrostat.published.language import read
    from gyrostat.questions.given_numbers import numbers_of

    names = {n: symbol(n) for n in ("I1", "I2", "l", "m0", "k3", "x", "omega")}
    file = folder / f"{os.getpid()}.toml"

    def line(text, chance):
        raw = (
            json.dumps({chance.choice(["I1", "l", text[:20]]): text, "m0": 1})
            if chance.random() < 0.5
            else f'{{"I1": {text}}}'
        )
        for name, value in json_object(raw.encode("utf-8", "replace")).items():
            exact_number(value, name)

    def abbreviated(text, chance):
        let = {
            "a": text,
            "b": chance.choice(["a**100", "exp(a)", "a*a", "a+x"]),
            "c": chance.choice(["b**100", "tan(b)", "b*b*b", "1/(b-a)"]),
            "d": "c**(1/2)",
        }
        return read(chance.choice(["d", "c", "b + tan(c)", "c**12"]), _with_let(names, let))

    def toml(text, chance):
        quoted = json.dumps(text) if chance.random() < 0.7 else text
        file.write_text(
            chance.choice(
                [
                    '[source]\nname = "n"\ntitle = {0}\n[[formula]]\nkey = {0}\nwhere = "w"\nquantity = '
                    '"I1"\n'
                    'printed = {0}\nkind = "identity"\n',
                    "{0}\n",
                    "a = {0}\n",
                    '[source]\nname = "n"\ntitle = "t"\n[scene.a]\npotential = {0}\n',
                    "[a.{0}]\n",
                    "a = [{0}]\n",
                ]
            ).replace("{0}", quoted),
            encoding="utf-8",
            errors="replace",
        )
        return lambda: load(file)

    return {
        "parse": lambda text, chance: parse(text),
        "number": lambda text, chance: exact_number(text, "l"),
        "potential": lambda text, chance: axial_potential(parse(text)),
        "set": lambda text, chance: numbers_of([f"l={text}"]),
        "axis": lambda text, chance: axis_of("--x", f"l={text}:{text}:5"),
        "line": line,
        "let": abbreviated,
        "compare": lambda text, chance: comparisons(f"{text} > I1", names),
        "toml": toml,
    }


def work(start, stop, step, seed, progress, pipe, folder):
    """Every step-th text from start on; the number of the one at work stands in progress."""
    from gyrostat.errors import GyrostatError

    os.environ["SYMPY_USE_CACHE"] = os.environ.get("SYMPY_USE_CACHE", "yes")
    ways, seen, inside = routes(Path(folder)), [], [False]
    import sympy.physics.units  # noqa: F401 (SymPy loads it when it meets some sums, and makes its names by exec)

    for text in ("tan(k3)+exp(2*pi)", "asin(1/3)**2", "2**(1/3)", "k3**"):  # what is loaded on first use
        for way in ways.values():
            try:
                found = way(text, random.Random(1))
                found() if callable(found) else None
            except GyrostatError:
                pass

    def watch(event, given):
        if inside[0] and (event in FORBIDDEN or event in LOADED and not _loading(given) or event == "open"
                          and _writes(given)):
            seen.append(f"{event} {str(given)[:100]}")

    sys.addaudithook(watch)
    resident = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
    resource.setrlimit(resource.RLIMIT_AS, (resident + MEMORY, resident + MEMORY))
    counts, bad, slowest = {"accepted": 0, "refused": 0}, [], (0.0, "")
    for index in range(start, stop, step):
        text, chance = drawn(index, seed)
        name = chance.choices(list(ways), (25, 10, 10, 10, 3, 15, 12, 8, 7))[0]
        progress[:8] = index.to_bytes(8, "little")
        outcome = "accepted"
        try:
            found = ways[name](text, chance) if name == "toml" else None
            inside[0], began = True, time.process_time()
            if name == "toml":
                found()
            else:
                ways[name](text, chance)
        except GyrostatError as error:
            outcome = "refused"
            str(error).encode("utf-8")  # it can be printed
        except BaseException as error:  # noqa: BLE001 (counted, and shown)
            bad.append(("foreign", index, name, text, repr(error)[:200]))
        inside[0], took = False, time.process_time() - began
        counts[outcome] += 1
        slowest = max(slowest, (took, f"{name}: {text[:200]}"))
        if took > SLOW:
            bad.append(("slow", index, name, text, f"{took:.2f} s"))
        if seen:
            bad.append(("execution", index, name, text, "; ".join(seen)))
            seen.clear()
        if index % (500 * step) < step:
            pipe.send((counts, bad, slowest))
            counts, bad, slowest = {"accepted": 0, "refused": 0}, [], (0.0, "")
    progress[:8] = stop.to_bytes(8, "little")
    pipe.send((counts, bad, slowest, resource.getrusage(resource.RUSAGE_SELF).ru_maxrss))
    pipe.close()


def _spent(pid):
    """Seconds of CPU that a process has had."""
    try:
        fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    except OSError:
        return 0.0
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def _loading(given):
    """Whether code comes from a file, as that of a module does, is SymPy's own for monomials, or Cython's for
    the frame of an error.
    """
    if given[0] == b"_getframe()" and str(given[1]).endswith(".pyx"):
        return True
    if (
        isinstance(given[0], bytes)
        and given[0].startswith(b"def monomial_")
        or all(n.startswith("monomial_") for n in getattr(given[0], "co_names", [""]))
    ):
        return True
    name = getattr(given[0], "co_filename", None) or (given[1] if len(given) > 1 else "")
    name = name.decode() if isinstance(name, bytes) else str(name)
    return name.startswith("<frozen") or os.path.exists(name)


def _writes(given):
    mode, flags = given[1], given[2]
    return (
        any(c in str(mode or "") for c in "wax+") or bool(flags & (os.O_WRONLY | os.O_RDWR))
        if isinstance(flags, int)
        else False
    )


def gate(count, seed, processes):
    """The texts through the gate; the number of those that are bad."""
    context, totals, bad, slowest, largest = (
        multiprocessing.get_context("fork"),
        {"accepted": 0, "refused": 0},
        [],
        (0.0, ""),
        0,
    )
    began = time.time()
    with tempfile.TemporaryDirectory() as folder:
        running = {}

        def launch(lane, start):
            shared, (near, far) = mmap.mmap(-1, 8), context.Pipe(False)
            shared[:8] = start.to_bytes(8, "little")
            process = context.Process(target=work, args=(start, count, processes, seed, shared, far, folder),
                                      daemon=True)
            process.start()
            far.close()
            running[lane] = [process, shared, near, start, 0.0]

        for lane in range(processes):
            launch(lane, lane)
        while running:
            time.sleep(0.05)
            for lane, (process, shared, near, last, since) in list(running.items()):
                try:
                    while near.poll():
                        part, worse, slow, *rest = near.recv()
                        totals = {name: totals[name] + n for name, n in part.items()}
                        bad += worse
                        slowest, largest = max(slowest, slow), max([largest, *rest])
                except EOFError:
                    pass
                index = int.from_bytes(shared[:8], "little")
                if index != last:
                    running[lane][3:] = [index, _spent(process.pid)]
                elif (
                    process.is_alive()
                    and index < count
                    and _spent(process.pid) - since > HANG + 5 * (index == lane)
                ):
                    process.kill()
                if not process.is_alive():
                    del running[lane]
                    if index < count:  # ended in the middle: a hang, or out of memory
                        bad.append(("hang", index, "?", drawn(index, seed)[0], f"exit {process.exitcode}"))
                        launch(lane, index + processes)
    for kind, index, name, text, why in bad:
        print(f"{kind} at {index} ({name}): {text[:300]!r}: {why}")
    kinds = {kind: sum(b[0] == kind for b in bad) for kind in ("hang", "slow", "foreign", "execution")}
    print(
        f"gate: {count} texts, seed {seed}: {totals['accepted']} accepted, {totals['refused']} refused; "
        f"{kinds['hang']} hangs, "
        f"{kinds['slow']} over {SLOW} s, {kinds['foreign']} foreign exceptions, {kinds['execution']} "
        "executions; slowest "
        f"{slowest[0]:.3f} s ({slowest[1][:80]!r}); largest process {largest // 1024} MB; "
        f"{time.time() - began:.0f} s"
    )
    return len(bad)


def verbs(count, seed):
    """Accepted texts through the verbs; the number of lines that are bad."""
    from gyrostat.algebra.text.grammar import parse
    from gyrostat.errors import GyrostatError

    accepted, index = [], 0
    while len(accepted) < count:
        text, _ = drawn(index, f"{seed}v")
        index += 1
        try:
            names = {s.name for s in parse(text).free_symbols}
        except GyrostatError:
            continue
        if names and len(names) <= 4 or index % 20 == 0:
            accepted.append((text, names))
    share = max(count // 50, 1)  # of the other verbs, a process each
    bad = _batch(accepted[:-share], seed) + _single(accepted[-share:], seed)
    for kind, text, why in bad:
        print(f"{kind}: {text[:300]!r}: {why}")
    print(
        f"verbs: {len(accepted)} accepted texts: {sum(b[0] == 'late' for b in bad)} later than {ENDED} s, "
        f"{sum(b[0] == 'foreign' for b in bad)} foreign exceptions or broken lines"
    )
    return len(bad)


def _environment():
    return os.environ | {"PYTHONUNBUFFERED": "1"}


def _batch(accepted, seed):
    """Through decide --batch: each line answered, in order and in time."""
    chance, bad, times = random.Random(seed), [], []
    command = [sys.executable, "-m", "gyrostat", "decide", "--batch", "-", "--timeout", str(TIMEOUT)]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          env=_environment()) as run:
        threading.Thread(target=lambda: [None for _ in run.stderr], daemon=True).start()
        for n, (text, names) in enumerate(accepted, 1):
            numbers = {name: chance.choice(["1", "2", "1/2", "0.3", "3", "1e8", "1e-9", "sqrt(2)"])
                       for name in names - {"k1", "k2", "k3"}}
            numbers = {"I1": "1", "I3": "1/2", "l": "1/3",
                       "equilibrium": chance.choice(["E1", "E2"])} | numbers
            line = numbers | ({"potential": text, "pi3_0": "2"} if "k3" in names
                              else {"potential": "m0*k3", "m0": "1", "pi3_0": text})
            began = time.time()
            try:
                run.stdin.write(json.dumps(line).encode() + b"\n")
                run.stdin.flush()
                answer = json.loads(run.stdout.readline())
            except (OSError, ValueError) as error:
                bad.append(("foreign", text, f"line {n} has no answer: {error}"))
                break
            times.append(time.time() - began)
            if times[-1] > ENDED and n > 1:  # the first one waits for the start
                bad.append(("late", text, f"{times[-1]:.1f} s"))
            if (
                answer.get("line") != n
                or not {"error", "equilibria"} & answer.keys()
                or "Traceback" in str(answer)
            ):
                bad.append(("foreign", text, str(answer)[:200]))
        run.stdin.close()
    print(f"decide --batch: {len(times)} lines, median {sorted(times)[len(times) // 2]:.3f} s, longest "
          f"{max(times[1:], default=0):.2f} s")
    return bad


def _single(accepted, seed):
    """Through report, conditions and motion: no traceback, and an end in time."""
    chance, bad = random.Random(seed), []
    for text, names in accepted:
        verb = chance.choice(["report", "conditions", "motion"])
        field = text if "k3" in names else f"k3*({text})"
        command = [sys.executable, "-m", "gyrostat", verb, f"--potential={field}", "--timeout", str(TIMEOUT)]
        if verb == "motion":
            command += [f"--set={name}=1" for name in {"I1", "I3", "l", *names} - {"k1", "k2", "k3"}]
            command += ["--state=0.1,0,2,0.6,0,0.8", "--until=1", "--count=5"]
        began = time.time()
        run = subprocess.run(command, capture_output=True, text=True, env=_environment(), check=False)
        took = time.time() - began
        if run.returncode not in (0, 2) or "Traceback" in run.stderr:
            bad.append(("foreign", text, f"{verb}: exit {run.returncode}: {run.stderr.strip()[-200:]}"))
        if took > ENDED + 2:  # the process starts too
            bad.append(("late", text, f"{verb}: {took:.1f} s"))
    return bad


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--verbs", action="store_true")
    parser.add_argument("--count", type=int, help="of the texts, in place of the full number")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--processes", type=int, default=len(os.sched_getaffinity(0)))
    given = parser.parse_args()
    import flint
    import sympy

    print(
        f"{platform.processor() or platform.machine()}, {given.processes} processes; Python "
        f"{platform.python_version()}, "
        f"SymPy {sympy.__version__}, python-flint {flint.__version__}"
    )
    bad = 0
    if not given.verbs:
        bad += gate(given.count or (QUICK if given.quick else TEXTS), given.seed, given.processes)
    if given.verbs or given.quick:
        bad += verbs(given.count if given.verbs and given.count else QUICK_VERBS if given.quick else VERBS,
                     given.seed)
    return int(bad > 0)


if __name__ == "__main__":
    sys.exit(main())
