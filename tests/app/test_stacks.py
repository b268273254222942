# SPDX-License-Identifier: GPL-3.0-or-later
"""Stacks of grids that touch, cross and thin out by noise: few named regions, a mesh that passes, and what was changed in the report."""
import math
import os
import re
import subprocess
import sys

from geomesh_program import SOURCE, ProgramTest, main, triangles_ts


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

    def test_a_ground_that_the_column_does_not_name_and_that_crosses_its_first_horizon_in_small_islands(self):
        """It is put in order with the column, and the warning names the key; left as given, it cost forty times the elements, some too flat."""
        def mid(x, y):
            return -100 + 50 * math.sin(x / 2500)
        heights = {"mid": mid, "base": lambda x, y: -900 + 50 * math.sin(y / 2000),
                   "relief": lambda x, y: mid(x, y) + 10 + 25 * math.sin((0.9 * x - 0.43 * y) / 111 + 1) * math.sin((0.43 * x + 0.9 * y) / 111 + 2)}
        n = 100
        triangles = [t for i in range(n) for j in range(n) for a in [i * (n + 1) + j] for t in ((a, a + n + 1, a + n + 2), (a, a + n + 2, a + 1))]
        for name, height in heights.items():
            places = [(-200 + 104 * i, -200 + 104 * j) for i in range(n + 1) for j in range(n + 1)]
            self.write(name + ".ts", triangles_ts(name, [(x, y, height(x, y)) for x, y in places], triangles))
        project = self.write("ground.yaml", """name: ground
box: {min: [0, 0, -2000], max: [10000, 10000, 300]}
surfaces:
  - {name: relief, kind: horizon, file: relief.ts}
  - {name: mid, kind: horizon, file: mid.ts}
  - {name: base, kind: horizon, file: base.ts}
column: [sand, mid, shale, base, deep]
mesh: {size: 500}
""")
        self.run_program(project, "-o", self.folder)
        report = self.report(self.path("ground.report.json"))
        self.assertTrue(report["solver"]["passes"])
        self.assertLess(report["tetrahedra"], 150000)
        self.assertTrue(any("rules: {topography: relief}" in warning for warning in report["warnings"]))

    def test_the_top_of_a_granite_and_an_isotherm_across_it_are_meshed_with_few_elements(self):
        report, check = self.mesh("exploration")
        self.assertLessEqual(len(check["regions"]), 20)
        self.assertLess(check["tetrahedra"] if "tetrahedra" in check else report["tetrahedra"], 200000)
        self.assertEqual({h["name"] for h in report["stack"]["horizons"]}, {"granite_top", "isotherm_150"})


if __name__ == "__main__":
    main()
