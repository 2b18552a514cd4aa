"""How long the page of the site takes to its first verdict, cold and warm, and to that of another number; how
many pictures of a chart it draws in a second, and how many frames of chart and body.

Usage: bench_page.py SITE, the folder that docs/try/build.py has filled; it prints a section of RESULTS.md,
and needs Playwright and Chromium.
"""
import argparse
import gzip
import statistics
from pathlib import Path
from urllib.parse import urlsplit

from measured import here_and_now
from page_starts import CHROMIUM, CONFIRMED, NO_OTHER_HOST, bare, pair, profile, served, slowly
from playwright.sync_api import sync_playwright

__all__ = ["CHROMIUM", "NO_OTHER_HOST", "profile", "served"]      # of the tests too
RATIOS = {"prepared": ("prepared", "cold", 0.2), "cold": ("cold", "bare cold", 3.8),
          "warm": ("warm", "bare warm", 2.6), "offline": ("offline", "warm", 1)}
CHARTS = {"heavy gyrostat upright, one margin": (0, ("m0", "omega3_0")),      # of examples.json
          "heavy asymmetric body upright, five margins": (7, ("I2", "omega3_0"))}


def another(context, address):
    """Milliseconds to the verdict of another number."""
    page = context.new_page()
    page.goto(address)
    page.wait_for_selector(CONFIRMED, timeout=60_000)
    changed = page.evaluate("""async () => {
        const times = [];
        for (let n = 0; n < 20; n++) {
            const start = performance.now();
            const input = document.getElementById("value-l");
            input.value = `0.${n + 1}`;
            input.dispatchEvent(new Event("input"));
            while (document.body.ariaBusy === "true") await new Promise((next) => setTimeout(next));
            times.push(performance.now() - start);
        }
        return times.sort((a, b) => a - b)[10];
    }""")
    page.close()
    return changed


def pictures(context, address, example, axes):
    """Pictures of a chart in a second, frames in a second, and the median of their slowest tenth.

    I3 moves with every frame of the screen for three seconds.
    """
    page = context.new_page()
    page.goto(address)
    page.wait_for_selector(CONFIRMED, timeout=60_000)
    page.select_option("#example", str(example))
    page.wait_for_selector("body[aria-busy=false]")
    for place, name in zip(("#across", "#upwards"), axes):
        page.select_option(place, name)
    page.wait_for_timeout(1000)
    found = page.evaluate("""async () => {
        const pen = CanvasRenderingContext2D.prototype, put = pen.putImageData;
        const slider = document.querySelector(".value:has(#value-I3) [type=range]");
        const start = performance.now(), times = [];
        let count = 0, last = start;
        pen.putImageData = function (...given) { count++; put.apply(this, given); };
        for (let n = 0; performance.now() - start < 3000; n++) {
            slider.value = 200 + n % 100;
            slider.dispatchEvent(new Event("input"));
            await new Promise(requestAnimationFrame);
            times.push(performance.now() - last);
            last += times.at(-1);
        }
        const slowest = times.toSorted((a, b) => b - a).at(times.length / 20), all = (last - start) / 1000;
        return [count / all, times.length / all, 1000 / slowest];
    }""")
    page.close()
    return found


def compressed(path):
    """Bytes of a file from a server that compresses what that makes smaller."""
    data = path.read_bytes()
    return min(len(data), len(gzip.compress(data)))


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("site")
    parser.add_argument("--quick", action="store_true")
    given = parser.parse_args()
    starts, changed, slow, sent = [], [], [], set()
    drawn = {each: [] for each in CHARTS}
    with sync_playwright() as playwright, served(given.site) as address, bare(given.site) as folder:
        for _ in range(1 if given.quick else 9):
            starts.append(pair(playwright, given.site, folder))
        for _ in range(1 if given.quick else 3):
            slow.append(slowly(playwright, given.site))
            with profile(playwright) as context:
                context.on("request", lambda request: sent.add(urlsplit(request.url).path))
                changed.append(another(context, address))
                for each, (example, axes) in CHARTS.items():
                    drawn[each].append(pictures(context, address, example, axes))
    files = [Path(given.site, path.lstrip("/")) for path in sent if path.startswith("/")]
    print(f"{here_and_now('playwright')}; medians of {len(starts)}.\n")
    told(starts)
    received, first, last = (statistics.median(each) for each in zip(*slow, strict=True))
    print(f"\nAt 200 kB/s the prepared verdict is there after {received / 1e3:.0f} kB and {first:.1f} s, the "
          f"confirmed one after {last:.0f} s. Another number takes {statistics.median(changed) / 1e3:.3f} s.")
    print(f"Transfer, what gzip makes smaller compressed: {sum(map(compressed, files)) / 1e6:.1f} MB.\n")
    print("| chart of 400 × 400 | pictures a second | frames, with the body | of the slowest tenth |")
    print("|---|---|---|---|")
    for each, found in drawn.items():
        rates = [statistics.median(rate) for rate in zip(*found, strict=True)]
        print(f"| {each} | {' | '.join(f'{rate:.0f}' for rate in rates)} |")


def told(starts):
    """The seconds of each start, and the ratios with what they are to reach."""
    print(f"| {' | '.join(starts[0])} |\n|{'---|' * len(starts[0])}")
    medians = [statistics.median(each[name] for each in starts) for name in starts[0]]
    print(f"| {' | '.join(f'{seconds:.2f}' for seconds in medians)} |\n")
    print("| ratio | median | at most |\n|---|---|---|")
    for name, (one, other, most) in RATIOS.items():
        ratio = statistics.median(each[one] / each[other] for each in starts)
        print(f"| {name}: {one} / {other} | {ratio:.2f} | {most} |")


if __name__ == "__main__":
    main()
