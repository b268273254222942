#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The program as a page of a browser (scripts/browser): the samples come out as the program makes them, and nothing leaves the machine."""
import os
import shutil
import unittest

from browser_page import PAGE, BrowserPage
from geomesh_program import SOURCE, ProgramTest, main
from headless_browser import BROWSER
from test_page import axe_core

DESK, PHONE = (1400, 1000), (390, 844)


@unittest.skipUnless(BROWSER, "skipped: chromium is not installed")
@unittest.skipUnless(os.path.exists(PAGE), "skipped: the page is not built (scripts/browser)")
class InBrowser(ProgramTest):
    bare = False

    def browse(self, **more):
        page = BrowserPage(self.path("profile"), DESK, **more)
        self.addCleanup(page.close)
        return page

    def sample_folder(self, name):
        """A copy without what runs have left."""
        folder = self.path(name)
        shutil.copytree(os.path.join(SOURCE, "samples", name), folder, ignore=shutil.ignore_patterns("out", "*.py", "__pycache__", "study.yaml"))
        return folder

    def assert_as_program(self, page, project):
        """The same regions, in the same order, with the same volumes, as the program makes of the project."""
        self.run_program(project, "-o", self.path("program"), "--quiet")
        name = next(n for n in page.files() if n.endswith(".report.json"))
        ours, theirs = self.report(self.path("program", name)), page.report()
        self.assertEqual([r["name"] for r in theirs["regions"]], [r["name"] for r in ours["regions"]])
        for mine, there in zip(ours["regions"], theirs["regions"]):
            self.assertAlmostEqual(there["volume"] / mine["volume"], 1, delta=1e-9, msg=mine["name"])
            self.assertEqual(there["tetrahedra"], mine["tetrahedra"], mine["name"])

    def assert_kept_to_itself(self, page):
        self.assertEqual(page.errors(), [])
        self.assertEqual([address for address in page.requests() if not address.startswith("file://")], [])

    def test_a_sample_comes_out_as_by_the_program(self):
        page = self.browse(is_served=True)
        page.press("Salt dome")
        page.wait_for_project()
        self.assertIn("name: salt_dome", page.evaluate("document.getElementById('text').value"))
        page.mesh()
        self.assertFalse(page.is_shown("failure"), page.text("failure"))
        self.assertIn("tetrahedra", page.text("summary"))
        self.assert_as_program(page, self.sample("salt-dome"))
        self.assertLessEqual({"salt_dome.vtu", "salt_dome.faces.vtp", "salt_dome.curves.vtp", "salt_dome.report.json", "salt_dome.html"}, set(page.files()))
        page.wait_for("!!document.getElementById('report').contentDocument?.querySelector('canvas.model')", "the report in its frame")
        self.assert_kept_to_itself(page)

    def test_a_project_folder_is_dropped(self):
        page = self.browse()
        folder = self.sample_folder("normal-fault")
        page.drop([folder])
        page.wait_for_project()
        page.mesh()
        self.assertFalse(page.is_shown("failure"), page.text("failure"))
        self.assert_as_program(page, os.path.join(folder, "project.yaml"))
        self.assert_kept_to_itself(page)

    def test_surfaces_alone_get_a_project_file_about_them(self):
        page = self.browse()
        surfaces = os.path.join(SOURCE, "samples", "salt-dome", "surfaces")
        page.choose("files", [os.path.join(surfaces, name) for name in ("salt.ts", "base_chalk.ts")])
        page.wait_for_project()
        text = page.evaluate("document.getElementById('text').value")
        self.assertIn('{name: "salt", kind: body, file: "salt.ts"}', text)
        self.assertIn('{name: "base_chalk", kind: horizon, file: "base_chalk.ts"}', text)
        page.mesh()
        self.assertFalse(page.is_shown("failure"), page.text("failure"))
        self.assertIn("salt", [region["name"] for region in page.report()["regions"]])
        self.assert_kept_to_itself(page)

    def test_a_failure_is_reported_in_the_words_of_the_program(self):
        page = self.browse()
        project = self.write("project.yaml", "box: {min: [0, 0, 0], max: [1, 1, 1]}\nsurfaces:\n  - {name: top, kind: horizon, file: top.ts}\n")
        page.choose("files", [project])
        page.wait_for_project()
        page.mesh()
        self.assertTrue(page.is_shown("failure"))
        words = page.text("failure")
        self.assertTrue(words.startswith("error: ") and "top.ts" in words, words)
        said = self.run_program(project, status=None)
        self.assertEqual(words.split("top.ts")[1].strip(), said.split("top.ts")[1].strip())
        self.assertFalse(page.is_shown("result"))

    def test_a_run_can_be_cancelled_and_another_begun(self):
        page = self.browse()
        page.press("Salt dome")
        page.wait_for_project()
        page.press("Make the mesh")
        page.wait_for("document.getElementById('log').textContent.length > 0", "a first message")
        page.press("Cancel")
        page.wait_for_end()
        self.assertEqual(page.text("now"), "Cancelled.")
        self.assertFalse(page.is_shown("result"))
        page.evaluate("document.getElementById('text').value += 'unknown_key: 1\\n'")
        page.mesh()
        self.assertIn("unknown_key", page.text("failure"))

    def test_the_page_fits_a_phone_and_is_of_the_size_promised(self):
        self.assertLess(os.path.getsize(PAGE), 15_000_000)
        page = self.browse()
        for size in (PHONE, DESK):
            page.open(PAGE, *size)
            page.press("Horizons from well tops")
            page.wait_for_project()
            page.mesh()
            self.assertTrue(page.is_shown("result"), page.text("failure"))
            self.assertLessEqual(page.evaluate("document.documentElement.scrollWidth"), size[0])
            script = axe_core()
            if script:
                with open(script, encoding="utf-8") as file:
                    page.evaluate(file.read() + "; 1")
                found = page.evaluate("axe.run({iframes: false}).then(r => r.violations.filter(v => ['serious', 'critical'].includes(v.impact)).map(v => v.id + ': ' + v.nodes[0].html))")
                self.assertEqual(found, [])


if __name__ == "__main__":
    main()
