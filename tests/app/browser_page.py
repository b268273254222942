# SPDX-License-Identifier: GPL-3.0-or-later
"""The page of scripts/browser in a browser without a window, used as a person would use it."""
import functools
import http.server
import json
import os
import threading
import time

from geomesh_program import SOURCE
from headless_browser import Browser

PAGE = os.environ.get("GEOMESH_PAGE") or os.path.join(SOURCE, "build", "browser", "bin", "geomesh.html")


class QuietHandler(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *words):
        pass


class BrowserPage(Browser):
    """The page as a file, or from a server on this machine: only there may a test look into the frame with the report."""

    def __init__(self, profile, size=(1400, 1000), patience=600, is_served=False):
        super().__init__(profile, patience=patience)
        self.server = None
        if is_served:
            handler = functools.partial(QuietHandler, directory=os.path.dirname(PAGE))
            self.server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler)
            threading.Thread(target=self.server.serve_forever, daemon=True).start()
        self.open(PAGE, *size)
        if is_served:
            self.events.clear()
            self.call("Page.navigate", url="http://127.0.0.1:%d/%s" % (self.server.server_address[1], os.path.basename(PAGE)))
            self.wait_for("location.protocol === 'http:' && document.readyState === 'complete'", "the page from a server")

    def close(self):
        super().close()
        if self.server:
            self.server.shutdown()
            self.server.server_close()

    def text(self, name):
        return self.evaluate("document.getElementById('%s').innerText" % name)

    def is_shown(self, name):
        return self.evaluate("!document.getElementById('%s').hidden" % name)

    def press(self, label):
        self.evaluate("[...document.querySelectorAll('button')].find(b => b.textContent === %s).click()" % json.dumps(label))

    def box_of(self, name):
        return self.evaluate("(() => { const b = document.getElementById('%s').getBoundingClientRect(); return [b.x, b.y, b.width, b.height]; })()" % name)

    def choose(self, control, paths):
        """Files, or a folder, by one of the two buttons."""
        node = self.call("Runtime.evaluate", expression="document.getElementById('%s')" % control)["result"]["objectId"]
        self.call("DOM.setFileInputFiles", files=paths, objectId=node)

    def drop(self, paths):
        """Files or folders, dragged onto the page."""
        x, y, width, height = self.box_of("drop")
        data = {"items": [], "files": paths, "dragOperationsMask": 1}
        for kind in ("dragEnter", "dragOver", "drop"):
            self.call("Input.dispatchDragEvent", type=kind, x=x + width / 2, y=y + height / 2, data=data)

    def wait_for(self, condition, what):
        end = time.monotonic() + self.patience
        while not self.evaluate(condition):
            if time.monotonic() > end:
                raise TimeoutError("%s: not within %d s; the page says: %s" % (what, self.patience, self.evaluate("document.querySelector('main').innerText")))
            time.sleep(0.1)

    def wait_for_project(self):
        self.wait_for("!document.getElementById('project').hidden || !document.getElementById('failure').hidden", "the project file")

    def wait_for_end(self):
        self.wait_for("!worker && !document.getElementById('run').disabled", "the end of the run")

    def mesh(self):
        self.press("Make the mesh")
        self.wait_for_end()

    def files(self):
        """Name: number of bytes, of what can be saved."""
        return dict(self.evaluate("made.map(f => [name_of(f.path), f.data.length])"))

    def report(self):
        return json.loads(self.evaluate("text_of(made.find(f => f.path.endsWith('.report.json')).data)"))
