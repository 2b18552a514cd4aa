"""How long the page of the site takes to its first verdict, cold and warm, and to that of another number.

Usage: bench_page.py SITE, the folder that docs/try/build.py has filled; it needs Playwright and Chromium.
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

from playwright.sync_api import sync_playwright

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")
NO_OTHER_HOST = "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1"


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
    with sync_playwright() as playwright, served(given.site) as address:
        for _ in range(1 if given.quick else 5):
            with profile(playwright) as context:
                context.on("request", lambda request: sent.add(urlsplit(request.url).path))
                cold.append(first_verdict(context, address)[0])
                seconds, milliseconds = first_verdict(context, address)
                warm.append(seconds)
                changed.append(milliseconds)
    print(f"first verdict: {statistics.median(cold):.2f} s cold, {statistics.median(warm):.2f} s warm; "
          f"another number: {statistics.median(changed):.0f} ms (medians of {len(cold)})")
    files = [Path(given.site, path.lstrip("/")) for path in sent if path.startswith("/")]
    print(f"transfer, each file as it is or as gzip has it: {sum(map(compressed, files)) / 1e6:.1f} MB")


if __name__ == "__main__":
    main()
