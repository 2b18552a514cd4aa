"""Debian's Firefox, driven by WebDriver BiDi; Playwright drives only a Firefox of its own.

Source: https://w3c.github.io/webdriver-bidi/
"""
import contextlib
import json
import re
import shutil
import subprocess
import tempfile
import time
from typing import Any

from websockets.sync.client import connect

FIREFOX = shutil.which("firefox-esr") or shutil.which("firefox")


class Tab:
    """One tab: what is called in it, and what it shows."""

    def __init__(self, socket):
        self.socket, self.count, self.context = socket, 0, ""
        self.call("session.new", capabilities={})
        self.context = self.call("browsingContext.getTree")["contexts"][0]["context"]

    def call(self, method: str, **given: Any) -> dict[str, Any]:
        """The result of a command; events on the way to it are passed over."""
        self.count += 1
        self.socket.send(json.dumps({"id": self.count, "method": method, "params": given}))
        while (found := json.loads(self.socket.recv(timeout=60))).get("id") != self.count:
            pass
        assert found["type"] == "success", found
        return found["result"]

    def goto(self, address: str) -> None:
        """A page, with what it loads at once."""
        self.call("browsingContext.navigate", context=self.context, url=address, wait="complete")

    def value(self, expression: str) -> Any:
        """What an expression of JavaScript is, awaited, as JSON."""
        found = self.call("script.evaluate", target={"context": self.context}, awaitPromise=True,
                          expression=f"(async () => JSON.stringify((await ({expression})) ?? null))()")
        assert found["type"] == "success", found
        return json.loads(found["result"]["value"])

    def until(self, expression: str, seconds: float = 60) -> None:
        """Wait for something to be true."""
        end = time.monotonic() + seconds
        while not self.value(f"Boolean({expression})"):
            assert time.monotonic() < end, expression
            time.sleep(0.05)

    def resize(self, width: int, height: int) -> None:
        """The inside of the window, in pixels."""
        self.call("browsingContext.setViewport", context=self.context,
                  viewport={"width": width, "height": height})

    def act(self, kind: str, *actions: dict[str, Any], **parameters: Any) -> None:
        """Keys, a mouse or a finger."""
        source = {"type": kind, "id": json.dumps([kind, parameters]), "actions": list(actions)}
        if parameters:
            source["parameters"] = parameters
        self.call("input.performActions", context=self.context, actions=[source])
        self.call("input.releaseActions", context=self.context)

    def press(self, *keys: str) -> None:
        """Keys, one after another."""
        self.act("key", *({"type": kind, "value": key} for key in keys for kind in ("keyDown", "keyUp")))


@contextlib.contextmanager
def firefox(**preferences: Any):
    """A Firefox that has never been anywhere, with one tab."""
    with tempfile.TemporaryDirectory() as folder:
        with open(f"{folder}/user.js", "w", encoding="utf-8") as file:
            file.writelines(f"user_pref({json.dumps(name)}, {json.dumps(value)});\n"
                            for name, value in preferences.items())
        command = [FIREFOX, "--headless", "--no-remote", "--profile", folder, "--remote-debugging-port", "0"]
        quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.PIPE, "text": True}
        with subprocess.Popen(command, **quiet) as process:
            try:
                said = next(line for line in process.stderr if "WebDriver BiDi listening" in line)
                with connect(re.search(r"ws://\S+", said)[0] + "/session", max_size=None) as socket:
                    tab = Tab(socket)
                    yield tab
                    tab.call("browser.close")
            finally:
                process.terminate()
