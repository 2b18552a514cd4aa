"""How long the page of the site takes to its first verdict, cold and warm, and to that of another number; how
many pictures of a chart it draws in a second.

Usage: bench_page.py SITE, the folder that docs/try/build.py has filled; it prints a section of RESULTS.md,
and needs Playwright and Chromium.
"""
import argparse
import contextlib
import functools
import gzip
import http.server
import shutil
import statistics
import tempfile
import threading
import time
from pathlib import Path
from urllib.parse import urlsplit

from measured import here_and_now
from playwright.sync_api import sync_playwright

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")
NO_OTHER_HOST = "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1"
CHARTS = {"heavy gyrostat upright, one margin": (0, ("m0", "omega3_0")),      # of examples.json
          "heavy asymmetric body upright, five margins": (7, ("I2", "omega3_0"))}


class Quiet(http.server.SimpleHTTPRequestHandler):
    """Files, a connection kept for several, without a log."""

    protocol_version = "HTTP/1.1"

    def log_message(self, *_):
        pass


@contextlib.contextmanager
def served(folder):
    """The address of a folder."""
    files = functools.partial(Quiet, directory=folder)
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), files) as server:
        server.daemon_threads = True
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}/index.html"
        server.shutdown()


@contextlib.contextmanager
def profile(playwright, **options):
    """A browser that has never been anywhere."""
    with tempfile.TemporaryDirectory() as folder:
        context = playwright.chromium.launch_persistent_context(
            folder, executable_path=CHROMIUM, args=["--no-sandbox", NO_OTHER_HOST], **options)
        try:
            yield context
        finally:
            context.close()


def first_verdict(context, address):
    """Seconds from the address to the first verdict, and milliseconds to that of another number."""
    page = context.new_page()
    began = time.perf_counter()
    page.goto(address)
    page.wait_for_selector("body[aria-busy=false] .badge", timeout=60_000)
    seconds = time.perf_counter() - began
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
    return seconds, changed


def pictures(context, address, example, axes):
    """Pictures of a chart in a second, while I3 moves with every frame of the screen for three seconds."""
    page = context.new_page()
    page.goto(address)
    page.wait_for_selector("body[aria-busy=false] .badge", timeout=60_000)
    page.select_option("#example", str(example))
    page.wait_for_selector("body[aria-busy=false]")
    for place, name in zip(("#across", "#upwards"), axes):
        page.select_option(place, name)
    page.wait_for_timeout(1000)
    found = page.evaluate("""async () => {
        const pen = CanvasRenderingContext2D.prototype, put = pen.putImageData;
        const slider = document.querySelector(".value:has(#value-I3) [type=range]");
        const start = performance.now();
        let count = 0;
        pen.putImageData = function (...given) { count++; put.apply(this, given); };
        for (let n = 0; performance.now() - start < 3000; n++) {
            slider.value = 200 + n % 100;
            slider.dispatchEvent(new Event("input"));
            await new Promise(requestAnimationFrame);
        }
        return count * 1000 / (performance.now() - start);
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
    cold, warm, changed, sent = [], [], [], set()
    drawn = {each: [] for each in CHARTS}
    with sync_playwright() as playwright, served(given.site) as address:
        for _ in range(1 if given.quick else 5):
            with profile(playwright) as context:
                context.on("request", lambda request: sent.add(urlsplit(request.url).path))
                cold.append(first_verdict(context, address)[0])
                seconds, milliseconds = first_verdict(context, address)
                warm.append(seconds)
                changed.append(milliseconds)
                for each, (example, axes) in CHARTS.items():
                    drawn[each].append(pictures(context, address, example, axes))
    files = [Path(given.site, path.lstrip("/")) for path in sent if path.startswith("/")]
    print(f"{here_and_now('playwright')}; medians of {len(cold)}.\n")
    print("| first verdict | cold | warm | another number | transfer, what gzip makes smaller compressed |")
    print("|---|---|---|---|---|")
    print(f"| seconds | {statistics.median(cold):.2f} | {statistics.median(warm):.2f} | "
          f"{statistics.median(changed) / 1e3:.3f} | {sum(map(compressed, files)) / 1e6:.1f} MB |\n")
    print("| chart of 400 × 400 | pictures a second |\n|---|---|")
    for each, found in drawn.items():
        print(f"| {each} | {statistics.median(found):.0f} |")


if __name__ == "__main__":
    main()
