# SPDX-License-Identifier: GPL-3.0-or-later
"""Volumes of units of settled stacks against an integration of the generators' own grids, written apart from the program
(samples/generator/settled_volumes.py)."""
import os
import re
import subprocess
import sys

from geomesh_program import PROGRAM, SOURCE, ProgramTest, main

sys.path.insert(0, os.path.join(SOURCE, "samples", "generator"))
from settled_volumes import MODELS  # noqa: E402


class StackVolumes(ProgramTest):
    timeout = 800

    def assert_volumes(self, name, within=0.005, without_keys=""):
        """`without_keys`: a pattern of what is taken out of the project."""
        folder = self.path("project")
        subprocess.run([sys.executable, os.path.join(SOURCE, "samples", name, "make_surfaces.py"), "--output", folder], check=True,
                       timeout=120)
        project = os.path.join(folder, "project.yaml")
        if without_keys:
            with open(project, encoding="utf-8") as file:
                text = re.sub(without_keys, "", file.read())
            self.assertNotRegex(text, "fill_holes|extend|mesh:")
            with open(project, "w", encoding="utf-8") as file:
                file.write(text)
        self.run_program(project, "-o", self.folder)
        meshed = {}
        for region in self.report(self.path(name.replace("-", "_") + ".report.json"))["regions"]:
            unit = re.sub(r"__B?\d+$", "", region["name"])
            meshed[unit] = meshed.get(unit, 0) + region["volume"]
        for unit, volume in MODELS[name]().volumes().items():
            self.assertAlmostEqual(meshed[unit] / volume, 1, delta=within, msg=unit)

    def test_units_of_the_basin_have_the_volumes_that_its_grids_have_by_the_rules(self):
        self.assert_volumes("basin")

    def test_units_of_the_reservoir_have_the_volumes_that_its_grids_have_by_the_rules(self):
        self.assert_volumes("reservoir")

    def test_throw_of_the_reservoir_restored_keeps_its_volumes_and_suits_solvers(self):
        script = os.path.join(SOURCE, "scripts", "stacks-in-full")
        run = subprocess.run([sys.executable, script, "--small", "--throw"], env={**os.environ, "GEOMESH_PROGRAM": PROGRAM},
                             capture_output=True, text=True, timeout=self.timeout)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)

    def test_units_of_grids_with_undefined_nodes_have_the_volumes_that_the_grids_have_by_the_rules(self):
        """The sand is 11 m thick in the mean: settling alone makes it 0.5 % thicker, 6 cm at a tolerance of 8 m."""
        self.assert_volumes("blank-grids", 0.006)

    def test_holes_and_rims_of_grids_need_no_keys(self):
        """By default, with surfaces alone. Straight lines across holes of up to 840 m change the coal, 10 m thick, by a fortieth."""
        self.assert_volumes("blank-grids", 0.04, r", *fill_holes: all, extend: nearest|\nmesh:.*")

    def test_units_of_the_exploration_model_have_the_volumes_that_its_grids_have(self):
        self.assert_volumes("exploration")


if __name__ == "__main__":
    main()
