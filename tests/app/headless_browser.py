# SPDX-License-Identifier: GPL-3.0-or-later
"""Chromium without a window, driven through two pipes by the DevTools protocol, with Python's standard library alone."""
import base64
import json
import os
import select
import shutil
import subprocess
import time

BROWSER = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
# Draws WebGL without a graphics card.
WITH_WEBGL = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
WITHOUT_WEBGL = ["--disable-gpu", "--disable-3d-apis"]


class Browser:
    """One page. `commands` go in through file descriptor 3 of the browser, answers and events come out of 4."""

    def __init__(self, profile, webgl=True, patience=120):
        self.patience, self.number, self.events, self.rest = patience, 0, [], b""
        in_, self.commands = os.pipe()
        self.answers, out = os.pipe()
        # The browser reads from 3 and writes to 4: a shell puts the pipes there.
        words = [BROWSER, "--headless=new", "--no-sandbox", "--no-first-run", "--hide-scrollbars", "--user-data-dir=" + profile,
                 "--remote-debugging-pipe"] + (WITH_WEBGL if webgl else WITHOUT_WEBGL)
        script = 'exec "$@" 3<&%d 4>&%d' % (in_, out)
        self.process = subprocess.Popen(["bash", "-c", script, "bash"] + words, pass_fds=(in_, out), stdout=subprocess.DEVNULL,
                                        stderr=subprocess.DEVNULL)
        os.close(in_)
        os.close(out)
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(domain + ".enable")

    session = None

    def call(self, method, **parameters):
        """The result of a command. Events that come before it are kept."""
        self.number += 1
        command = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            command["sessionId"] = self.session
        self._write(command)
        end = time.monotonic() + self.patience
        while True:
            message = self._next(end)
            if message.get("id") == self.number:
                if "error" in message:
                    raise RuntimeError("%s: %s" % (method, message["error"]))
                return message["result"]
            self.events.append(message)

    def _write(self, command):
        data = json.dumps(command).encode() + b"\0"
        while data:
            data = data[os.write(self.commands, data):]

    def _next(self, end):
        while b"\0" not in self.rest:
            ready, _, _ = select.select([self.answers], [], [], max(0, end - time.monotonic()))
            if not ready:
                raise TimeoutError("the browser did not answer within %d s" % self.patience)
            part = os.read(self.answers, 1 << 20)
            if not part:
                raise RuntimeError("the browser ended")
            self.rest += part
        message, self.rest = self.rest.split(b"\0", 1)
        return json.loads(message)

    def evaluate(self, script):
        """The value of an expression in the page; promises are waited for."""
        answer = self.call("Runtime.evaluate", expression=script, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in answer:
            details = answer["exceptionDetails"]
            raise RuntimeError(details.get("exception", {}).get("description", details["text"]))
        return answer["result"].get("value")

    def open(self, path, width, height, dark=False):
        """A file in a window of this size; below 500 pixels as a phone shows it."""
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=width < 500)
        self.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": "dark" if dark else "light"}])
        self.events.clear()
        self.call("Page.navigate", url="file://" + path)
        end = time.monotonic() + self.patience
        while self.evaluate("document.readyState") != "complete":
            if time.monotonic() > end:
                raise TimeoutError(path + " was not loaded")
            time.sleep(0.1)
        self.settle()

    def settle(self):
        """Two frames later everything that was asked for is drawn."""
        self.evaluate("new Promise(r => requestAnimationFrame(() => requestAnimationFrame(() => r(true))))")

    def click(self, x, y, count=1):
        for kind in ("mousePressed", "mouseReleased"):
            self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=count)
        self.settle()

    def drag(self, x, y, dx, dy):
        self.call("Input.dispatchMouseEvent", type="mousePressed", x=x, y=y, button="left", clickCount=1)
        for step in range(1, 6):
            self.call("Input.dispatchMouseEvent", type="mouseMoved", x=x + dx * step / 5, y=y + dy * step / 5, button="left", buttons=1)
        self.call("Input.dispatchMouseEvent", type="mouseReleased", x=x + dx, y=y + dy, button="left", clickCount=1)
        self.settle()

    def screenshot(self, box, scale=1.0):
        """A part of the page (x, y, width, height) as PNG, smaller by `scale`."""
        clip = dict(zip(("x", "y", "width", "height"), box), scale=scale)
        return base64.b64decode(self.call("Page.captureScreenshot", format="png", clip=clip)["data"])

    def errors(self):
        """What the console was told, and exceptions."""
        bad = []
        for event in self.events:
            if event.get("method") == "Runtime.exceptionThrown":
                details = event["params"]["exceptionDetails"]
                bad.append(details.get("exception", {}).get("description", details["text"]))
            if event.get("method") == "Log.entryAdded" and event["params"]["entry"]["level"] == "error":
                bad.append(event["params"]["entry"]["text"])
        return bad

    def requests(self):
        """Addresses that were asked for, without the page itself and what it carries."""
        return [e["params"]["request"]["url"] for e in self.events if e.get("method") == "Network.requestWillBeSent"
                and not e["params"]["request"]["url"].startswith(("data:", "blob:")) and e["params"].get("type") != "Document"]

    def close(self):
        try:
            self.session = None
            self.call("Browser.close")
        except (OSError, RuntimeError, TimeoutError):
            self.process.kill()
        os.close(self.commands)
        os.close(self.answers)
        try:
            self.process.wait(timeout=30)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
