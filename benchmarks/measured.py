"""How benchmarks measure, and what they say of it: CPU time, pairs in turn, spreads, where and when."""
import os
import platform
import resource
import statistics
import subprocess
import time
from collections.abc import Callable, Iterable, Sequence
from datetime import date
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
BLOCK = 0.02                                               # seconds that are timed at least at a time
# of a process: what is installed has its bytecode, as SymPy has
BYTECODE = {**os.environ, "PYTHONDONTWRITEBYTECODE": ""}


def cpu() -> float:
    """Seconds of CPU of this process, all threads, and of the processes that it has waited for."""
    children = resource.getrusage(resource.RUSAGE_CHILDREN)
    return time.process_time() + children.ru_utime + children.ru_stime


def seconds(call: Callable[[], object], times: int = 1) -> float:
    """Seconds of CPU of one call, in the mean of some."""
    begin = cpu()
    for _ in range(times):
        call()
    return (cpu() - begin) / times


def in_turn(calls: Sequence[Callable[[], object]], rounds: int) -> list[list[float]]:
    """Seconds of each call in each round; before, each is called twice, and short ones are repeated."""
    times = []
    for call in calls:
        call()
        times.append(max(1, round(BLOCK / max(seconds(call), 1e-7))))
    found: list[list[float]] = [[] for _ in calls]
    for _ in range(rounds):
        for call, n, each in zip(calls, times, found):
            each.append(seconds(call, n))
    return found


def ratios(ours: Iterable[float], theirs: Iterable[float]) -> list[float]:
    """Those of each round."""
    return [a / b for a, b in zip(ours, theirs)]


def spread(values: Sequence[float], form: str = ".3g", scale: float = 1) -> str:
    """The median, the least and the greatest value."""
    middle, low, high = (format(scale * x, form)
                         for x in (statistics.median(values), min(values), max(values)))
    return f"{middle} ({low}–{high})"


def here_and_now(*packages: str) -> str:
    """Date, commit, machine and versions, as every section of RESULTS.md begins."""
    versions = [f"Python {platform.python_version()}", *map(_installed, packages)]
    return (f"{date.today()}, commit {_commit()}, {platform.machine()} ({os.cpu_count()} cores), "
            f"{', '.join(versions)}")


def processor(file: Path = Path("/proc/cpuinfo")) -> str:
    """The processor's model by its name and numbers, since virtual machines call many models "AMD EPYC"."""
    told = {}
    if file.exists():
        for line in file.read_text(encoding="utf-8").splitlines():
            name, _, value = line.partition(":")
            told.setdefault(name.strip(), value.strip())
    if "model name" not in told:
        return platform.processor() or platform.machine()
    return f"{told['model name']}, family {told.get('cpu family', '?')}, model {told.get('model', '?')}"


def _installed(package: str) -> str:
    try:
        return f"{package} {version(package)}"
    except PackageNotFoundError:
        return f"no {package}"


def _commit() -> str:
    """The commit, and whether the library or a benchmark differs from it."""
    def git(*arguments: str) -> str:
        return subprocess.run(["git", "-C", str(ROOT), *arguments], capture_output=True, text=True).stdout

    changed = git("status", "--porcelain", "--", "src", "benchmarks/*.py").strip()
    return (git("rev-parse", "--short=7", "HEAD").strip() or "unknown") + " and changes" * bool(changed)
