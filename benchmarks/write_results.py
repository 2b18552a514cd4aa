"""Run benchmarks and write what they print into RESULTS.md, MOTION.md and the pages of docs.

    python benchmarks/write_results.py                          all of them, some hours
    python benchmarks/write_results.py bench_charts guard       some
    python benchmarks/write_results.py "bench_page build/site"  with its arguments

Exit status 1 if a benchmark fails; its sections stay as they were.
"""
import shlex
import subprocess
import sys
from pathlib import Path

import sections

COMMANDS = ("guard --write", "growth", "bench_derivation", "bench_orbit", "bench_verify", "bench_verdict",
            "bench_charts", "speed_against_error", "scale", "motion_rows",
            "motion_speed_against_error --limit 25")


def main(commands: list[str]) -> int:
    known = {command.split()[0]: command for command in COMMANDS}
    failed = 0
    for command in commands or COMMANDS:
        name, *arguments = shlex.split(known.get(command, command))
        done = subprocess.run([sys.executable, Path(__file__).with_name(f"{name}.py"), *arguments],
                              stdout=subprocess.PIPE, text=True)
        print(f"{name}: {'failed' if done.returncode else 'written'}", flush=True)
        failed += bool(done.returncode)
        if not done.returncode:
            sections.write(name, done.stdout)
    return 1 if failed else 0


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
