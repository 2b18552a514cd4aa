"""Starts of the page of the site: bare Pyodide beside it, prepared and confirmed answers, a slow line."""
import contextlib
import functools
import http.server
import json
import lzma
import shutil
import tempfile
import threading
import time
from pathlib import Path

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")
NO_OTHER_HOST = "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1"
SLOW = 200_000                                         # bytes a second
PREPARED = "#verdict .badge"
CONFIRMED = "body[aria-busy=false]:has(#starting[hidden]):has(#early[hidden]) .badge"
BARE = """
import { loadPyodide } from "./pyodide.mjs";
const { default: createPyodideModule } = await import("./pyodide.asm.mjs");
const lockFileContents = await (await fetch("./pyodide-lock.json")).text();
const stdLibURL = new URL("python.zip", self.location).href;
await loadPyodide({ createPyodideModule, stdLibURL, lockFileContents });
postMessage("ready");
"""
PAGE = """<!DOCTYPE html><title>bare</title><script type="module">
new Worker("bare.js", { type: "module" }).onmessage = () => {
  document.body.innerHTML = "<p id=ready>ready</p>";
};
</script><body></body>"""


WATCHED = """(awaited) => {
    const came = window.came = {};
    const look = () => awaited.filter((place) => !(place in came) && document.querySelector(place))
        .forEach((place) => { came[place] = performance.timeOrigin + performance.now(); });
    new MutationObserver(look).observe(document, { subtree: true, childList: true, attributes: true });
}"""


class Quiet(http.server.SimpleHTTPRequestHandler):
    """Files, a connection kept for several, without a log."""

    protocol_version = "HTTP/1.1"

    def log_message(self, *_):
        pass


class Line:
    """A line of so many bytes a second, which all connections share."""

    def __init__(self, rate):
        self.rate, self.sent, self.free, self.lock = rate, 0, time.monotonic(), threading.Lock()

    def carry(self, size):
        with self.lock:
            self.free = max(self.free, time.monotonic()) + size / self.rate
            self.sent += size
            wait = self.free - time.monotonic()
        time.sleep(max(0, wait))


@contextlib.contextmanager
def served(folder, line=None):
    """The address of a folder; over a line, if there is one."""
    class Carried(Quiet):
        def copyfile(self, source, outputfile):
            with contextlib.suppress(ConnectionError):     # a page that is left asks no more
                while line and (data := source.read(4096)):
                    line.carry(len(data))
                    outputfile.write(data)
                if not line:
                    super().copyfile(source, outputfile)

    files = functools.partial(Carried, directory=folder)
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), files) as server:
        server.daemon_threads = True
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}/index.html"
        server.shutdown()


@contextlib.contextmanager
def profile(playwright, **options):
    """A browser that has never been anywhere."""
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        context = playwright.chromium.launch_persistent_context(
            folder, executable_path=CHROMIUM, args=["--no-sandbox", NO_OTHER_HOST], **options)
        try:
            yield context
        finally:
            context.close()


@contextlib.contextmanager
def bare(site):
    """A page that starts Pyodide and nothing else, of the same files, none of them compressed."""
    with tempfile.TemporaryDirectory() as place:
        folder, runtime = Path(place), Path(site, "runtime")
        stream = lzma.decompress((runtime / "python.xz").read_bytes())
        at = 4 + int.from_bytes(stream[:4], "little")
        for name, size in json.loads(stream[4:at]):
            (folder / name).write_bytes(stream[at:at + size])
            at += size
        shutil.copy(runtime / "pyodide.mjs", folder)
        (folder / "bare.js").write_text(BARE, encoding="utf-8")
        (folder / "index.html").write_text(PAGE, encoding="utf-8")
        yield folder


def seconds(context, address, *awaited):
    """Seconds from the address to each of several places of a page, as the page itself sees them come."""
    page = context.new_page()
    page.add_init_script(f"({WATCHED})({json.dumps(awaited)})")
    began = time.time()
    page.goto(address, wait_until="commit")
    for place in awaited:
        page.wait_for_selector(place, timeout=120_000)
    came = page.evaluate("window.came")
    page.close()
    return [came[place] / 1000 - began for place in awaited]


def kept(context, address):
    """The page has been kept by its service worker."""
    page = context.new_page()
    page.goto(address)
    page.wait_for_function("""async () => {
        await navigator.serviceWorker.ready;
        return Boolean(navigator.serviceWorker.controller);
    }""", timeout=120_000)
    page.close()


def pair(playwright, site, folder):
    """One start of each kind, in turn: bare and the page, cold and warm, and the page without the network."""
    found = {}
    with served(folder) as address, profile(playwright) as context:
        found["bare cold"], = seconds(context, address, "#ready")
        found["bare warm"], = seconds(context, address, "#ready")
    with profile(playwright) as context:
        with served(site) as address:
            found["prepared"], found["cold"] = seconds(context, address, PREPARED, CONFIRMED)
            kept(context, address)
            _, found["warm"] = seconds(context, address, PREPARED, CONFIRMED)
        found["prepared again"], found["offline"] = seconds(context, address, PREPARED, CONFIRMED)
    return found


def slowly(playwright, site):
    """Over a slow line: bytes until something is to be read, seconds until then and until it is confirmed."""
    line = Line(SLOW)
    with served(site, line) as address, profile(playwright) as context:
        page = context.new_page()
        began = time.perf_counter()
        page.goto(address, wait_until="commit")
        page.wait_for_selector(PREPARED, timeout=120_000)
        sent, first = line.sent, time.perf_counter() - began
        page.wait_for_selector(CONFIRMED, timeout=120_000)
        return sent, first, time.perf_counter() - began
