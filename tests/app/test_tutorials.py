#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The tutorials run as they are printed, and give what they promise."""
import os
import re
import shutil
import subprocess
import unittest

from document_pages import PageTest, blocks_of
from geomesh_program import SOURCE, has_module


def with_dolfinx(test):
    is_there = subprocess.run(["/usr/bin/python3", "-c", "import dolfinx"], stderr=subprocess.DEVNULL).returncode == 0
    return unittest.skipUnless(is_there, "skipped: python3-dolfinx is not installed")(
        unittest.skipUnless(has_module("xdmf"), "skipped: built without the module geomesh-xdmf")(test))


class Tutorials(PageTest):
    def test_every_tutorial_is_run_by_a_test_of_its_own(self):
        names = [name for name in sorted(os.listdir(os.path.join(SOURCE, "docs", "tutorials"))) if name.endswith((".md", ".ipynb"))]
        self.assertEqual(names, ["faulted-field.md", "fracture-network.md", "gempy-arrays.ipynb", "horizons-to-calculix.md", "horizons-to-dolfinx.md",
                                 "implicit-model.md", "rasters-in-degrees.md"])  # the notebook by python/tests/test_notebooks.py

    def test_every_tutorial_has_a_picture_of_its_result(self):
        for name in sorted(os.listdir(os.path.join(SOURCE, "docs", "tutorials"))):
            if name.endswith((".md", ".ipynb")):
                with open(os.path.join(SOURCE, "docs", "tutorials", name), encoding="utf-8") as file:
                    pictures = re.findall(r"!\[[^\]]*\]\(\.\./(pictures/[^)]+)\)", file.read())
                self.assertTrue(pictures, name)
                for picture in pictures:
                    self.assertTrue(os.path.exists(os.path.join(SOURCE, "docs", picture)), picture)

    def test_a_faulted_field_has_each_unit_in_each_block_with_the_throw_restored(self):
        said = self.run_page("docs/tutorials/faulted-field.md")
        self.assertIn("The mesh passes", said)
        report = self.report(self.path("out", "field.report.json"))
        units = ("cover", "chalk", "lower_cretaceous", "bunter")
        self.assertEqual(self.region_names(report), sorted("%s__B%d" % (unit, block) for unit in units for block in (1, 2, 3)))
        restored = re.findall(r"restored: least ([0-9.]+), mean ([0-9.]+), largest ([0-9.]+) m", said)
        self.assertEqual(len(restored), 6)  # three horizons at two faults
        for least, mean, largest in restored:
            self.assertAlmostEqual(float(mean), 60, delta=2)
            self.assertTrue(50 < float(least) and float(largest) < 70)
        self.assertLessEqual({"W1", "W2"}, {curve["name"] for curve in report["curves"]})
        self.assertEqual(len(re.findall(r"chalk__B\d: [0-9.e+]+ m3 of pores", said)), 3)

    def test_the_project_of_the_faulted_field_is_shipped_with_its_data(self):
        printed = next(block.text for block in blocks_of("docs/tutorials/faulted-field.md") if block.title == "field.yaml")
        with open(os.path.join(SOURCE, "docs", "tutorials", "data", "field", "field.yaml"), encoding="utf-8") as file:
            self.assertEqual(file.read(), printed)

    def test_the_data_are_those_that_their_script_writes(self):
        folder = os.path.join(SOURCE, "docs", "tutorials")
        shutil.copy(os.path.join(folder, "make_data.py"), self.path("make_data.py"))
        subprocess.run(["/usr/bin/python3", self.path("make_data.py")], check=True, timeout=self.timeout)
        for where, _, names in os.walk(os.path.join(folder, "data")):
            for name in names:
                made = self.path("data", os.path.relpath(os.path.join(where, name), os.path.join(folder, "data")))
                if name.endswith((".tif", ".yaml")):
                    continue  # GDAL's bytes depend on its version
                with open(os.path.join(where, name), "rb") as shipped, open(made, "rb") as file:
                    self.assertEqual(shipped.read(), file.read(), name)

    @with_dolfinx
    def test_a_faulted_scalar_field_becomes_a_mesh_that_passes_the_check_and_a_solved_model(self):
        said = self.run_page("docs/tutorials/implicit-model.md")
        self.assertIn("The mesh passes", said)
        self.assertIn("temperature from 10 to 100", said)
        report = self.report(self.path("out", "fold.report.json"))
        self.assertEqual(self.region_names(report), sorted("%s__%d" % (unit, side) for unit in ("cover", "sand", "basement") for side in (1, 2)))
        with open(self.path("out", "fold.report.json")) as file:
            self.assertIn("proven to be within 1.5", file.read())

    @with_dolfinx
    def test_a_network_of_1000_fractures_becomes_a_mesh_that_conducts(self):
        said = self.run_page("docs/tutorials/fracture-network.md")
        report = self.report(self.path("out", "network.report.json"))
        areas = [s["area"] for s in report["surfaces"] if s["kind"] == "fault"]
        self.assertEqual(len(areas), 1000)
        inflow, outflow, pressure = map(float, re.search(r"inflow (\S+), outflow (\S+), pressure at the inlet (\S+)", said).groups())
        self.assertEqual((inflow, outflow), (10000, 10000))
        # Fractures conduct at most as if all of them lay along the flow (Wiener's upper bound), and at least nothing.
        self.assertTrue(100 / (1 + 100 * sum(areas) / 100 ** 3) < pressure < 100, pressure)

    @unittest.skipUnless(shutil.which("ccx"), "skipped: calculix-ccx is not installed")
    def test_horizons_in_csv_become_a_solved_model_with_the_temperature_of_flat_layers(self):
        said = self.run_page("docs/tutorials/horizons-to-calculix.md")
        temperature = float(re.search(r"mean temperature of top_sand: ([0-9.]+)", said).group(1))
        self.assertAlmostEqual(temperature, 10 + 60 * 400 / (400 + 75 + 450), delta=0.5)

    @with_dolfinx
    def test_horizons_in_csv_become_a_solved_dolfinx_model_with_the_same_temperature(self):
        said = self.run_page("docs/tutorials/horizons-to-dolfinx.md")
        temperature = float(re.search(r"mean temperature of top_sand: ([0-9.]+)", said).group(1))
        self.assertAlmostEqual(temperature, 10 + 60 * 400 / (400 + 75 + 450), delta=0.5)

    @unittest.skipUnless(shutil.which("gdaltransform"), "skipped: gdal-bin is not installed")
    @unittest.skipUnless(has_module("gdal"), "skipped: built without the module geomesh-gdal")
    def test_rasters_in_degrees_are_meshed_on_a_national_grid_where_they_lie(self):
        said = self.run_page("docs/tutorials/rasters-in-degrees.md")
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
