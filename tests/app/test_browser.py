#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The page that meshes in a browser (scripts/browser): the same meshes as the program's, and nothing is fetched."""
import base64
import json
import os
import re
import time
import unittest

from geomesh_program import NIGHTLY, SOURCE, ProgramTest, main, with_mesh
from headless_browser import BROWSER, Browser

PAGE = os.environ.get("GEOMESH_BROWSER_PAGE") or os.path.join(SOURCE, "build", "browser", "page", "index.html")
LARGEST = 15e6
# Puts files onto the page as if they were dropped.
GIVE = """(texts => { const packed = texts.map(([path, text]) => [path, Uint8Array.from(atob(text), c => c.charCodeAt(0))]); take(packed); return files.length; })(%s)"""
RESULT = """(() => { const run = window.last_run; if (!run) return null;
  const texts = (run.results || []).map(([path, bytes]) => { let s = ''; for (let i = 0; i < bytes.length; i += 32768) s += String.fromCharCode(...bytes.subarray(i, i + 32768)); return [path, btoa(s)]; });
  return {status: run.status, failure: run.failure || null, seconds: run.seconds, memory: run.memory, files: texts, error: document.getElementById('error').textContent}; })()"""


@unittest.skipUnless(BROWSER, "skipped: Chromium is not installed")
@unittest.skipUnless(os.path.exists(PAGE), "skipped: the page is not built (scripts/browser)")
class InTheBrowser(ProgramTest):
    timeout = 800

    def setUp(self):
        super().setUp()
        self.browser = Browser(self.path("profile"), patience=300)
        self.addCleanup(self.browser.close)
        self.browser.open(PAGE, 1200, 900)

    def run_page(self):
        """Presses the button, and returns what the run gave: files are {name: bytes}."""
        self.browser.evaluate("document.getElementById('start').click()")
        end = time.monotonic() + self.timeout
        while True:
            result = self.browser.evaluate(RESULT)
            if result:
                break
            self.assertLess(time.monotonic(), end, "no answer of the page")
            time.sleep(0.5)
        self.assertIsNone(result["failure"])
        result["files"] = {os.path.basename(path): base64.b64decode(text) for path, text in result["files"]}
        return result

    def give_sample(self, name, kept):
        """The project and its files, as a dropped folder gives them; `kept`: all surfaces are kept as they are."""
        folder, given = os.path.join(SOURCE, "samples", name), []
        for where, folders, names in os.walk(folder):
            folders[:] = [f for f in folders if f != "out"]
            for file in names:
                with open(os.path.join(where, file), "rb") as data:
                    content = data.read()
                if file == "project.yaml" and kept:
                    content = with_mesh(re.sub(r"(?m)^mesh:.*\n(?:[ \t].*\n)*", "", content.decode()), None).encode()
                path = os.path.relpath(os.path.join(where, file), os.path.dirname(folder))
                os.makedirs(os.path.dirname(self.path(path)), exist_ok=True)
                with open(self.path(path), "wb") as copy:
                    copy.write(content)
                given.append([path, base64.b64encode(content).decode()])
        self.assertEqual(self.browser.evaluate(GIVE % json.dumps(given)), len(given))

    def regions_of(self, name, data):
        """Volumes by region of a VTU, by the program's own check."""
        with open(self.path(name), "wb") as file:
            file.write(data)
        self.run_program("check", self.path(name), "--report", self.path("check.json"), "-q")
        with open(self.path("check.json"), encoding="utf-8") as file:
            return {region["name"]: region["volume"] for region in json.load(file)["regions"]}

    def both(self, sample):
        """The files of the page's run and those of the program's, by name, of the sample that was given."""
        result = self.run_page()
        self.assertEqual(result["status"], 0, result["error"])
        self.run_program(self.path(sample, "project.yaml"), "-o", self.path("native", sample), "-q")
        native = {}
        for name in os.listdir(self.path("native", sample)):
            with open(self.path("native", sample, name), "rb") as file:
                native[name] = file.read()
        self.assertEqual(sorted(result["files"]), sorted(native))
        return result, native

    def test_kept_surfaces_give_the_same_bytes(self):
        """Intersections, Delaunay and recovery are exact, whatever the processor, its rounding modes and the length of a pointer."""
        for sample in ["salt-dome", "layer-cake", "faulted-layers"] + (["turned-box", "normal-fault", "unconformity", "wells"] if NIGHTLY else []):
            with self.subTest(sample):
                self.browser.open(PAGE, 1200, 900)
                self.give_sample(sample, kept=True)
                result, native = self.both(sample)
                for name, data in native.items():
                    if not name.endswith((".report.json", ".html")):  # which hold times
                        self.assertEqual(result["files"][name], data, name)

    def test_salt_dome_remeshed(self):
        """The sample of the page: its regions and volumes, the page of the report beside it, and not one request. Cosines of two C
        libraries differ in their last digit, so that surfaces that may move are not the same to the byte."""
        self.browser.evaluate("take_sample()")
        self.give_sample("salt-dome", kept=False)
        result, native = self.both("salt-dome")
        found, wanted = (self.regions_of("mesh.vtu", files["salt_dome.vtu"]) for files in (result["files"], native))
        self.assertEqual(sorted(found), sorted(wanted))
        for region, volume in wanted.items():
            self.assertAlmostEqual(found[region] / volume, 1, delta=1e-4, msg=region)
        self.assertIn(b"</html>", result["files"]["salt_dome.html"])
        self.browser.evaluate("document.getElementById('report').scrollIntoView()")
        self.browser.settle()
        self.assertFalse(self.browser.evaluate("document.getElementById('report').hidden"))
        time.sleep(2)  # the page of the report draws its model
        with open(self.path("salt-dome.png"), "wb") as file:
            file.write(self.browser.screenshot((0, self.browser.evaluate("window.scrollY"), 1200, 900)))
        self.assertEqual(self.browser.requests(), [])
        self.assertEqual(self.browser.errors(), [])
        print("salt dome in the browser: %.1f s, %.0f MB of memory" % (result["seconds"], result["memory"] / 1e6))

    def test_surfaces(self):
        """Two closed surfaces: the mesh and its page, of regions of known volume."""
        cube = lambda low, high: "OFF\n8 6 0\n" + "".join("%g %g %g\n" % (x, y, z) for z in (low, high) for y in (low, high) for x in (low, high)) + \
            "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n"  # noqa: E731
        given = [[name, base64.b64encode(text.encode()).decode()] for name, text in (("outer.off", cube(0, 3)), ("inner.off", cube(1, 2)))]
        self.browser.evaluate(GIVE % json.dumps(given))
        result = self.run_page()
        self.assertEqual(result["status"], 0, result["error"])
        volumes = sorted(self.regions_of("mesh.vtu", result["files"]["mesh.vtu"]).values())
        self.assertEqual(len(volumes), 2)
        for volume, wanted in zip(volumes, (1, 26)):
            self.assertAlmostEqual(volume / wanted, 1, delta=1e-12)
        self.assertIn(b"</html>", result["files"]["mesh.html"])

    def test_errors_are_the_programs(self):
        text = "name: model\nsurfaces: [{name: a, kind: horizon, file: gone.ts}]\n"
        self.browser.evaluate(GIVE % json.dumps([["model/project.yaml", base64.b64encode(text.encode()).decode()]]))
        result = self.run_page()
        os.makedirs(self.path("model"))
        with open(self.path("model", "project.yaml"), "w", encoding="utf-8") as file:
            file.write(text)
        said = self.run_program(self.path("model", "project.yaml"), "-o", self.path("out"), status=result["status"])
        self.assertNotEqual(result["status"], 0)
        self.assertIn("gone.ts", said)
        places = lambda words: re.sub(r"(/[^\s/:]+)+/", "", words).strip()  # noqa: E731  names without their folders
        self.assertEqual(places(result["error"]), places(said))

    def test_page_is_small(self):
        self.assertLess(os.path.getsize(PAGE), LARGEST)


if __name__ == "__main__":
    main()
