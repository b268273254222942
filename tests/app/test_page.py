#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The report as a page, in a browser without a window: its script runs, and what it shows can be told without seeing it."""
import html.parser
import re
import shutil
import subprocess
import unittest

from geomesh_program import ProgramTest, level, main

BROWSER = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")


class Elements(html.parser.HTMLParser):
    """Tags with their attributes, and the text of labels."""

    def __init__(self, text):
        super().__init__()
        self.tags, self.open, self.text = [], [], {}
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        self.tags.append((tag, dict(attributes), list(self.open)))
        if tag not in ("input", "meta", "br", "img", "path", "rect", "link"):
            self.open.append(tag)

    def handle_endtag(self, tag):
        while tag in self.open and self.open.pop() != tag:
            pass

    def handle_data(self, data):
        for tag in self.open:
            self.text[tag] = self.text.get(tag, "") + data


class Page(ProgramTest):
    def page(self):
        self.write("upper.ts", level("upper", 5))
        self.write("project.yaml", "name: model\nbox: {min: [0, 0, 0], max: [10, 10, 10]}\nsurfaces:\n  - {name: upper, kind: horizon, file: upper.ts}\n"
                   "column: [top, upper, bottom]\nmesh: {size: 3}\noutput: {directory: ., formats: [html]}\n")
        self.run_program("project.yaml")
        return self.path("model.html")

    @unittest.skipUnless(BROWSER, "skipped: chromium is not installed")
    def test_the_script_runs_in_a_browser_and_lists_units_surfaces_and_curves(self):
        done = subprocess.run([BROWSER, "--headless", "--no-sandbox", "--disable-gpu", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
                               "--user-data-dir=" + self.path("profile"), "--virtual-time-budget=4000", "--dump-dom", "file://" + self.page()],
                              stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, timeout=200)
        self.assertEqual(done.returncode, 0)
        if "has no WebGL 2" in done.stdout.split("<script")[0]:
            self.skipTest("skipped: this browser draws no WebGL 2 here")
        found = Elements(done.stdout)
        labels = found.text.get("label", "")
        for name in ("top", "bottom", "upper", "xmin", "zmax", "upper*xmin"):
            self.assertIn(name, labels)
        self.assertEqual([t for t in ("Units", "Surfaces", "Wells and curves") if t not in found.text["legend"]], [])
        self.assertIn("Nothing is cut away.", done.stdout)

    def test_everything_that_can_be_worked_has_a_name(self):
        with open(self.page()) as file:
            text = file.read()
        found = Elements(text)
        self.assertIn('<html lang="en">', text)
        self.assertEqual(sum(tag == "main" for tag, _, _ in found.tags), 1)
        for tag, attributes, inside in found.tags:
            if tag in ("input", "select"):
                self.assertIn("label", inside, attributes)
            if tag == "svg":
                self.assertEqual(attributes.get("role"), "img")
                self.assertGreater(len(attributes.get("aria-label", "")), 5)
            if tag == "canvas" and attributes.get("aria-hidden") != "true":
                self.assertTrue(attributes.get("aria-label") and attributes.get("tabindex") == "0", attributes)
        self.assertIn("prefers-color-scheme: dark", text)
        self.assertIn("SPDX-License-Identifier: MIT", text)
        self.assertIsNone(re.search(r"https?:", text))  # nothing is asked of a network


if __name__ == "__main__":
    main()
