# SPDX-License-Identifier: GPL-3.0-or-later
"""Coordinates through the whole program: units, depth, scaled z, systems, and the messages for what cannot be right."""
from geomesh_program import BAD_INPUT, USAGE, ProgramTest, has_module, level, main, triangles_ts


class Coordinates(ProgramTest):
    def project(self, crs="{}", top="", mesh="{}", extra="", box="{min: [0, 0, -10], max: [10, 10, 0]}"):
        return self.write("p.yaml", "name: p\ncrs: %s\nbox: %s\nsurfaces:\n  - {name: top, kind: horizon, file: top.ts%s}\n"
                          "column: [upper, top, lower]\nmesh: %s\n%s" % (crs, box, top, mesh, extra))

    def volumes(self, project, *arguments):
        self.run_program(project, "-o", self.folder, *arguments)
        check = self.check(self.path("p.vtu"), "--project", project)
        return {region["name"]: region["volume"] for region in check["regions"]}

    def assert_volumes(self, found, **wanted):
        self.assertEqual(sorted(found), sorted(wanted))
        for name, volume in wanted.items():
            self.assertAlmostEqual(found[name] / volume, 1, delta=1e-12, msg=name)

    def test_a_project_in_feet_of_depth(self):
        """The mesh is in feet with elevation up; a file that says nothing is in feet of depth."""
        self.write("top.ts", level("top", 4))
        project = self.project("{z: depth, unit: ft}", box="{min: [0, 0, 0], max: [10, 10, 10]}")
        self.assert_volumes(self.volumes(project), upper=400, lower=600)
        self.assertIn("400 ft3", self.run_program(project, "-o", self.folder))

    def test_an_entry_says_what_its_file_is(self):
        self.write("top.ts", level("top", 0.004, 0.01, 0.001))
        self.assert_volumes(self.volumes(self.project(top=", unit: km, z: depth")), upper=400, lower=600)
        self.assert_volumes(self.volumes(self.project(top=", unit: km, z: depth, z_datum: 1")), upper=300, lower=700)

    def test_scaled_z_is_undone(self):
        self.write("top.ts", level("top", -4))
        plain = self.volumes(self.project())
        self.assertEqual(self.volumes(self.project("{z_scale: 16}")), plain)
        report = self.report(self.path("p.report.json"))
        self.assertTrue(any("z was scaled by 16" in note for note in report["notes"]), report["notes"])
        self.assertEqual(report["input"]["box"]["min"], [0, 0, -10])
        self.assertIn("conforming", self.run_program(self.project("{z_scale: 16}", mesh="{mode: conforming}"), status=USAGE))
        self.assertIn("scaled space", self.run_program(self.project("{z_scale: 16}", mesh="{refine: default}"), status=USAGE))
        for mesh in ("{size: 2}", "{quality: fast}", "{honour: tolerance, tolerance: 0.1}"):  # a tolerance would be stretched when z is scaled back
            self.assertIn("scaled space", self.run_program(self.project("{z_scale: 0.5}", mesh=mesh), status=USAGE))
        self.assertIn("between 1e-6 and 1e6", self.run_program(self.project("{z_scale: 0}"), status=USAGE))

    def test_any_factor_of_z(self):
        """Heights as given come back bit for bit, at a northing of six million: the mesh passes the exact check against its project."""
        x0, y0 = 500000.1, 6000000.3
        self.write("top.ts", triangles_ts("top", [(x0 + x, y0 + y, -4.1 - 0.37 * x + 0.11 * y) for x, y in ((-1, -1), (11, -1), (11, 11), (-1, 11))],
                                          [(0, 1, 2), (0, 2, 3)]))
        box = "{min: [%r, %r, -10.7], max: [%r, %r, 0.3]}" % (x0, y0, x0 + 10, y0 + 10)
        plain = self.volumes(self.project(box=box))
        for factor in ("3", "10", "0.7", "1234.5"):
            project = self.project("{z_scale: %s}" % factor, box=box)
            for name, volume in self.volumes(project).items():
                self.assertAlmostEqual(volume / plain[name], 1, delta=1e-12)
            self.check(self.path("p.vtu"), "--project", project)

    def test_time_is_refused(self):
        self.write("top.ts", level("top", -4))
        for crs, top in (("{}", ", unit: ms"), ("{}", ", z: time"), ("{unit: ms}", "")):
            self.assertIn("a surface in time (ms, s) cannot be meshed", self.run_program(self.project(crs, top), status=USAGE))

    def test_degrees_in_a_utm_project(self):
        self.write("top.ts", level("top", -4))
        printed = self.run_program(self.project("{horizontal: utm 32N}"), status=BAD_INPUT)
        self.assertIn("look like longitude and latitude", printed)
        self.assertIn("add 'crs: geographic' to this entry", printed)

    def test_a_system_that_no_register_knows(self):
        self.write("top.ts", level("top", -4))
        printed = self.run_program(self.project("{horizontal: epsg:99999}", top=", crs: epsg:32632"), status=USAGE)
        self.assertIn("epsg:99999 is no system that PROJ knows" if has_module("proj") else "apt install geomesh-proj", printed)
        self.run_program(self.project("{horizontal: mars}"), status=USAGE)

    def test_a_unit_that_was_forgotten(self):
        self.write("top.ts", level("top", -20))
        box = "{min: [0, 0, -10], max: [10, 10, -5]}"
        self.assertIn("if so, give 'z_unit'", self.run_program(self.project(box=box), "-o", self.folder, status=None))

    def test_a_geographic_project(self):
        """Horizon and box in degrees; the mesh is in the zone that they lie in."""
        self.write("top.ts", level("top", -400, 1, 1))
        project = self.project("{horizontal: geographic}", box="{min: [0.2, 0.2, -1000], max: [0.3, 0.3, 0]}")
        self.run_program(project, "-o", self.folder)
        report = self.report(self.path("p.report.json"))
        self.assertEqual(report["input"]["crs"]["mesh"], "utm 31N")
        low, high = report["input"]["box"]["min"], report["input"]["box"]["max"]
        self.assertAlmostEqual((high[0] - low[0]) / 11132, 1, delta=0.01)
        volumes = {region["name"]: region["volume"] for region in report["regions"]}
        area = (high[0] - low[0]) * (high[1] - low[1])
        self.assertAlmostEqual(volumes["upper"] / (400 * area), 1, delta=1e-9)

    def test_points_become_a_surface(self):
        rows = ["x,y,z"]
        for i in range(400):
            x, y = (i * 0.618034 % 1) * 12 - 1, i / 400 * 12 - 1
            rows.append("%.9f,%.9f,%.9f" % (x, y, -4 + 0.1 * x - 0.2 * y))
        self.write("top.ts", "\n".join(rows) + "\n")  # the content decides
        project = self.project(top=", gridding: {spacing: 1, extent: box}, resample: 2, smooth: 2")
        found = self.volumes(project)
        self.assertAlmostEqual(found["upper"] / 450, 1, delta=1e-6)
        self.assertAlmostEqual(found["upper"] + found["lower"], 1000, delta=1e-9)
        notes = self.report(self.path("p.report.json"))["notes"]
        self.assertTrue(any("residual at the points: rms" in note for note in notes), notes)
        self.assertTrue(any("remade with edges of about 2" in note for note in notes), notes)
        self.assertTrue(any("smoothed in 2 passes" in note for note in notes), notes)


if __name__ == "__main__":
    main()
