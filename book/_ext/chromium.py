"""Drive one headless Chromium over a pipe: open pages from file://, ask them questions, take their picture.

The DevTools protocol over ``--remote-debugging-pipe`` is JSON ended by a zero byte, so the standard library
is enough, and one browser serves all pages.
"""

from __future__ import annotations

import base64
import json
import os
import select
import subprocess
import tempfile
import time
from pathlib import Path
from typing import Any, Self

FLAGS = (
    "--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking",
    "--disable-component-update", "--disable-sync", "--disable-default-apps", "--hide-scrollbars",
    "--enable-unsafe-swiftshader",  # WebGL without a graphics card, for the interactive figures
    "--host-resolver-rules=MAP * ~NOTFOUND",  # no other machine can be reached
    "--remote-debugging-pipe",
)
PAGE_TIMEOUT = 60.0
TYPESET = """
new Promise(resolve => {
  const settled = () => requestAnimationFrame(() => setTimeout(resolve, 50));
  window.MathJax?.startup?.promise ? MathJax.startup.promise.then(settled, settled) : settled();
})
"""


class BrowserError(RuntimeError):
    """Chromium did not start, did not answer in time or refused a command."""


class Chromium:
    """A headless Chromium with one tab; use it as a context manager."""

    def __init__(self, executable: str, *, timeout: float = PAGE_TIMEOUT) -> None:
        self._timeout = timeout
        self._profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        read_commands, self._commands = os.pipe()
        self._answers, write_answers = os.pipe()
        # Chromium reads from descriptor 3 and writes to descriptor 4; the shell puts our pipes there.
        redirect = f'exec "$0" "$@" 3<&{read_commands} 4>&{write_answers}'
        self._process = subprocess.Popen(
            ["bash", "-c", redirect, executable, *FLAGS, f"--user-data-dir={self._profile.name}"],
            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
            pass_fds=(read_commands, write_answers))
        os.close(read_commands)
        os.close(write_answers)
        self._pending = b""
        self._count = 0
        self._session: str | None = None
        self.events: list[dict[str, Any]] = []
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self._session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(f"{domain}.enable")
        self.call("Page.setLifecycleEventsEnabled", enabled=True)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_reason: object) -> None:
        self._process.terminate()
        self._process.wait(timeout=20)
        os.close(self._commands)
        os.close(self._answers)
        self._profile.cleanup()

    def call(self, method: str, **parameters: Any) -> dict[str, Any]:
        """Send one command and return its answer; what happens meanwhile is kept in ``events``."""
        self._count += 1
        message: dict[str, Any] = {"id": self._count, "method": method, "params": parameters}
        if self._session is not None:
            message["sessionId"] = self._session
        os.write(self._commands, json.dumps(message).encode() + b"\0")
        deadline = time.monotonic() + self._timeout
        while (answer := self._next_message(deadline, waiting_for=method)).get("id") != self._count:
            self.events.append(answer)
        if "error" in answer:
            raise BrowserError(f"{method}: {answer['error']['message']}")
        result: dict[str, Any] = answer["result"]
        return result

    def _next_message(self, deadline: float, *, waiting_for: str) -> dict[str, Any]:
        while b"\0" not in self._pending:
            ready, _, _ = select.select([self._answers], [], [], max(0.0, deadline - time.monotonic()))
            if not ready:
                raise BrowserError(f"no answer to {waiting_for} within {self._timeout:.0f} s")
            chunk = os.read(self._answers, 1 << 20)
            if not chunk:
                raise BrowserError(f"Chromium ended while it was asked for {waiting_for}")
            self._pending += chunk
        message, _, self._pending = self._pending.partition(b"\0")
        answer: dict[str, Any] = json.loads(message)
        return answer

    def open(self, page: Path, *, width: int, height: int = 900, dark: bool = False, media: str = "") -> None:
        """Load a page at a width [px], as on a screen or for other ``media``, and wait until its formulas are typeset.

        ``events`` starts afresh.
        """
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1,
                  mobile=False)
        scheme = {"name": "prefers-color-scheme", "value": "dark" if dark else "light"}
        self.call("Emulation.setEmulatedMedia", media=media, features=[scheme])
        self.events.clear()
        loader = self.call("Page.navigate", url=page.resolve().as_uri())["loaderId"]
        deadline = time.monotonic() + self._timeout
        while not any(_says_loaded(event, loader) for event in self.events):
            self.events.append(self._next_message(deadline, waiting_for=f"the load of {page.name}"))
        self.ask(TYPESET)

    def ask(self, expression: str) -> Any:
        """Evaluate JavaScript in the page, wait for it when it is a promise, and return its value."""
        answer = self.call("Runtime.evaluate", expression=expression, awaitPromise=True, returnByValue=True)
        if "exceptionDetails" in answer:
            raise BrowserError(f"the page could not evaluate: {answer['exceptionDetails']['text']}")
        return answer["result"].get("value")

    def picture(self, destination: Path, *, width: int, height: int | None = None) -> None:
        """Save what the page shows as PNG, whole or down to a height [px]."""
        full = height or int(self.ask("document.documentElement.scrollHeight"))
        whole = {"x": 0, "y": 0, "width": width, "height": full, "scale": 1}
        answer = self.call("Page.captureScreenshot", format="png", clip=whole)
        destination.write_bytes(base64.b64decode(answer["data"]))


def _says_loaded(event: dict[str, Any], loader: str) -> bool:
    if event.get("method") != "Page.lifecycleEvent":
        return False
    return bool(event["params"]["loaderId"] == loader and event["params"]["name"] == "load")
