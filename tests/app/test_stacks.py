# SPDX-License-Identifier: GPL-3.0-or-later
"""Stacks of grids that touch, cross and thin out by noise: few named regions, a mesh that passes, and what was changed in the report."""
import os
import re
import subprocess
import sys

from geomesh_program import SOURCE, ProgramTest, main


class Stacks(ProgramTest):
    timeout = 600

    def mesh(self, name, *arguments):
        """Makes the sample anew by its script, meshes it and has the mesh checked."""
        folder = self.path("project")
        subprocess.run([sys.executable, os.path.join(SOURCE, "samples", name, "make_surfaces.py"), "--output", folder, *arguments],
                       check=True, timeout=120)
        self.run_program(os.path.join(folder, "project.yaml"), "-o", self.folder)
        stem = self.path(name.replace("-", "_"))
        return self.report(stem + ".report.json"), self.check(stem + ".vtu")

    def assert_settled(self, report, check, units):
        """Regions are units or units in fault blocks; volumes of units are those between the settled horizons."""
        volumes = {}
        for region in check["regions"]:
            unit = re.sub(r"__B\d+$", "", region["name"])
            volumes[unit] = volumes.get(unit, 0) + region["volume"]
        self.assertEqual(sorted(volumes), sorted(units))
        rest = (1 - report["stack"]["share_of_tolerance"]) * report["stack"]["tolerance"]
        for unit in report["stack"]["units"]:  # remeshed surfaces are off to both sides: in the mean by little
            self.assertAlmostEqual(volumes[unit["name"]], unit["volume"], delta=0.2 * rest * unit["area"], msg=unit["name"])
        share = report["stack"]["share_of_tolerance"] * report["stack"]["tolerance"]
        for horizon in report["stack"]["horizons"]:
            self.assertLess(horizon["triangles"], horizon["triangles_given"], horizon["name"])
            self.assertLessEqual(horizon["largest_off_elsewhere"], share * (1 + 1e-6), horizon["name"])

    def test_a_basin_of_grids_that_touch_and_cross_over_half_of_the_area_has_one_region_a_unit(self):
        report, check = self.mesh("basin", "--nodes", "80")  # denser than the size asks for: triangles become fewer
        self.assert_settled(report, check, ["quaternary", "tertiary", "jurassic", "basement"])
        self.assertEqual(len(check["regions"]), 4)
        for unit in report["stack"]["units"]:
            self.assertGreater(unit["area_merged"], 0, unit["name"])

    def test_grids_with_undefined_nodes_are_filled_continued_and_settled(self):
        report, check = self.mesh("blank-grids")
        self.assert_settled(report, check, ["overburden", "shale", "sand", "coal", "underburden"])
        self.assertEqual(len(check["regions"]), 5)
        wells = {curve["name"]: curve["length"] for curve in report["curves"] if curve["kind"] == "well"}
        self.assertEqual(sorted(wells), ["A1", "A2", "A3"])
        for name, length in wells.items():
            self.assertAlmostEqual(length, 1700, delta=1e-6, msg=name)

    def test_a_faulted_reservoir_of_smeared_grids_has_one_region_a_unit_and_fault_block(self):
        report, check = self.mesh("reservoir")
        names = {region["name"] for region in check["regions"]}
        self.assertEqual(len(names), len(check["regions"]))
        self.assertLessEqual(len(names), 20)
        units = {re.sub(r"__B\d+$", "", name) for name in names}
        self.assertEqual(units, {"overburden", "upper", "middle", "lower", "underburden"})
        self.assertTrue(all(re.search(r"__B\d+$", name) for name in names), names)

    def test_the_top_of_a_granite_and_an_isotherm_across_it_are_meshed_with_few_elements(self):
        report, check = self.mesh("exploration")
        self.assertLessEqual(len(check["regions"]), 20)
        self.assertLess(check["tetrahedra"] if "tetrahedra" in check else report["tetrahedra"], 200000)
        self.assertEqual({h["name"] for h in report["stack"]["horizons"]}, {"granite_top", "isotherm_150"})


if __name__ == "__main__":
    main()
