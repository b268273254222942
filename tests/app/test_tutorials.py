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
        path = os.pathsep.join([os.path.dirname(PROGRAM), "/usr/bin", os.environ["PATH"]])  # the system's Python has the distribution's modules
        done = subprocess.run(["bash", "-eu", "-o", "pipefail", script], cwd=self.folder, env={**os.environ, "PATH": path}, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, timeout=self.timeout)
        self.assertEqual(done.returncode, 0, done.stdout)
        return done.stdout

    def test_every_tutorial_is_run_by_a_test_of_its_own(self):
        self.assertEqual(sorted(os.listdir(os.path.join(SOURCE, "docs", "tutorials"))), ["faulted-reservoir.md", "first-mesh.md", "fracture-network.md", "gempy-arrays.ipynb", "horizons-to-calculix.md", "horizons-to-dolfinx.md", "implicit-model.md",
                          "rasters-in-degrees.md"])  # the notebook by python/tests/test_notebooks.py

    def test_every_page_of_the_site_is_there(self):
        with open(os.path.join(SOURCE, "mkdocs.yml"), encoding="utf-8") as file:
            pages = re.findall(r": ([a-z0-9/-]+\.md)$", file.read(), re.M)
        self.assertGreater(len(pages), 15)
        def source(page):  # app.site makes the pages of reference/ and those of notebooks
            return page.replace(".md", ".ipynb") if page == "tutorials/gempy-arrays.md" else page

        written = [source(page) for page in pages if not page.startswith("reference/")]
        self.assertEqual([page for page in written if not os.path.exists(os.path.join(SOURCE, "docs", page))], [])

    def test_the_first_mesh_passes_the_check_and_has_its_picture(self):
        if not shutil.which("xvfb-run") and not os.environ.get("DISPLAY"):
            self.skipTest("skipped: no display and no xvfb-run")
        if not os.path.exists(os.path.join(os.path.dirname(PROGRAM), "geomesh-picture")):
            self.skipTest("skipped: no geomesh-picture beside the program")
        self.assertIn("The mesh passes", self.run_page("first-mesh.md"))
        self.assertTrue(os.path.getsize(self.path("my-model.png")) > 0)

    @unittest.skipUnless(subprocess.run(["/usr/bin/python3", "-c", "import numpy"], stderr=subprocess.DEVNULL).returncode == 0,
                         "skipped: python3-numpy is not installed")
    def test_a_scalar_field_becomes_a_mesh_that_passes_the_check(self):
        said = self.run_page("implicit-model.md")
        self.assertIn("The mesh passes", said)
        self.assertIn("proven to be within 0.75", said)

    def test_a_network_of_fractures_becomes_a_mesh_that_passes_the_check(self):
        self.assertIn("The mesh passes", self.run_page("fracture-network.md"))

    @unittest.skipUnless(shutil.which("ccx"), "skipped: calculix-ccx is not installed")
    def test_horizons_in_csv_become_a_solved_model_with_the_temperature_of_flat_layers(self):
        said = self.run_page("horizons-to-calculix.md")
        temperature = float(re.search(r"mean temperature of top_sand: ([0-9.]+)", said).group(1))
        self.assertAlmostEqual(temperature, 10 + 60 * 400 / (400 + 75 + 450), delta=0.5)

    @unittest.skipUnless(subprocess.run(["/usr/bin/python3", "-c", "import dolfinx"], stderr=subprocess.DEVNULL).returncode == 0,
                         "skipped: python3-dolfinx is not installed")
    def test_horizons_in_csv_become_a_solved_dolfinx_model_with_the_same_temperature(self):
        said = self.run_page("horizons-to-dolfinx.md")
        temperature = float(re.search(r"mean temperature of top_sand: ([0-9.]+)", said).group(1))
        self.assertAlmostEqual(temperature, 10 + 60 * 400 / (400 + 75 + 450), delta=0.5)

    def test_a_faulted_reservoir_passes_the_check_and_has_the_pore_volumes_of_the_page(self):
        said = self.run_page("faulted-reservoir.md")
        self.assertIn("The mesh passes", said)
        for block, volume in (("B1", 1.39e8), ("B2", 1.47e8)):
            found = float(re.search(r"reservoir__%s: ([0-9.e+]+) m3 of pores" % block, said).group(1))
            self.assertAlmostEqual(found / volume, 1, delta=0.01)
        curves = {curve["name"] for curve in self.report(self.path("out", "field.report.json"))["curves"]}
        self.assertLessEqual({"injector", "producer"}, curves)

    @unittest.skipUnless(shutil.which("gdal_translate"), "skipped: gdal-bin is not installed")
    @unittest.skipUnless(os.path.exists(os.path.join(os.path.dirname(PROGRAM), "geomesh-gdal.so")), "skipped: built without GDAL")
    def test_rasters_in_degrees_are_meshed_on_a_national_grid_where_they_lie(self):
        said = self.run_page("rasters-in-degrees.md")
        self.assertIn("The mesh passes", said)
        corners = [list(map(float, line.split())) for line in said.splitlines()[-2:]]
        for found, wanted in zip(corners, ((10.03, 48.02), (10.37, 48.28))):
            self.assertAlmostEqual(found[0], wanted[0], delta=0.005)
            self.assertAlmostEqual(found[1], wanted[1], delta=0.005)
        report = self.report(self.path("out", "basin.report.json"))
        self.assertEqual(self.region_names(report), ["basement", "fill", "sand", "shale"])
        self.assertTrue(any("datum shift from" in note and "relief" in note for note in report["notes"]), report["notes"])


if __name__ == "__main__":
    unittest.main()
