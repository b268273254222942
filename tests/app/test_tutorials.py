#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The commands of each tutorial run as they are printed, one shell for the whole page."""
import os
import re
import shutil
import subprocess
import unittest

from geomesh_program import PROGRAM, SOURCE, ProgramTest


class Tutorials(ProgramTest):
    def run_page(self, name):
        with open(os.path.join(SOURCE, "docs", "tutorials", name), encoding="utf-8") as file:
            blocks = re.findall(r"^```sh\n(.*?)^```$", file.read(), re.M | re.S)
        self.assertTrue(blocks, "the page has commands")
        script = self.write("page.sh", "\n".join(blocks))
        path = os.path.dirname(PROGRAM) + os.pathsep + os.environ["PATH"]
        done = subprocess.run(["bash", "-eu", "-o", "pipefail", script], cwd=self.folder, env={**os.environ, "PATH": path}, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, timeout=self.timeout)
        self.assertEqual(done.returncode, 0, done.stdout)
        return done.stdout

    def test_every_tutorial_is_run_by_a_test_of_its_own(self):
        self.assertEqual(sorted(os.listdir(os.path.join(SOURCE, "docs", "tutorials"))), ["first-mesh.md", "horizons-to-calculix.md"])

    def test_every_page_of_the_site_is_there(self):
        with open(os.path.join(SOURCE, "mkdocs.yml"), encoding="utf-8") as file:
            pages = re.findall(r": ([a-z0-9/-]+\.md)$", file.read(), re.M)
        self.assertGreater(len(pages), 15)
        self.assertEqual([page for page in pages if not os.path.exists(os.path.join(SOURCE, "docs", page))], [])

    def test_the_first_mesh_passes_the_check_and_has_its_picture(self):
        if not shutil.which("xvfb-run") and not os.environ.get("DISPLAY"):
            self.skipTest("skipped: no display and no xvfb-run")
        if not os.path.exists(os.path.join(os.path.dirname(PROGRAM), "geomesh-picture")):
            self.skipTest("skipped: no geomesh-picture beside the program")
        self.assertIn("The mesh passes", self.run_page("first-mesh.md"))
        self.assertTrue(os.path.getsize(self.path("my-model.png")) > 0)

    @unittest.skipUnless(shutil.which("ccx"), "skipped: calculix-ccx is not installed")
    def test_horizons_in_csv_become_a_solved_model_with_the_temperature_of_flat_layers(self):
        said = self.run_page("horizons-to-calculix.md")
        temperature = float(re.search(r"mean temperature of top_sand: ([0-9.]+)", said).group(1))
        self.assertAlmostEqual(temperature, 10 + 60 * 400 / (400 + 75 + 450), delta=0.5)


if __name__ == "__main__":
    unittest.main()
