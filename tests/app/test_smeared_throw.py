# SPDX-License-Identifier: GPL-3.0-or-later
"""Horizon grids that run across their faults as ramps: with throw_at the throw is restored, told, and the blocks have their true volumes."""
import math

from geomesh_program import BAD_INPUT, USAGE, ProgramTest, main, plane_ts, triangles_ts

STEP, WIDTH, LENGTH, BOTTOM = 50.0, 4000.0, 2000.0, -2000.0
COTANGENT = 1 / math.tan(math.radians(60))


class SmearedThrow(ProgramTest):
    """Box of 3.6 by 1.6 km; a fault (or two) along y that dips to the east; the horizon h lies lower by the throw east of each."""

    def fault(self, name, at):
        off = 1000 * COTANGENT
        self.write(name + ".ts", plane_ts(name, [(at - off, 100, 0), (at - off, 1900, 0), (at + off, 1900, BOTTOM), (at + off, 100, BOTTOM)]))

    @staticmethod
    def level(x):
        return -1000 + 0.04 * (x - 2000)

    def horizon(self, faults, half_width, torn=False):
        """`faults`: (place, throw) by fault."""
        nx, ny = round(WIDTH / STEP) + 1, round(LENGTH / STEP) + 1
        points, there = [], []
        for j in range(ny):
            for i in range(nx):
                x, z, stays = STEP * i, self.level(STEP * i), True
                for at, throw in faults:
                    d = x - at + (z + 1000) * COTANGENT
                    stays = stays and (not torn or abs(d) > half_width)
                    z -= throw * (0.5 + 0.5 * max(-1.0, min(1.0, d / half_width)))
                points.append((x, STEP * j, z))
                there.append(stays)
        corners = [(j * nx + i, j * nx + i + 1) for j in range(ny - 1) for i in range(nx - 1)]
        triangles = [t for a, b in corners for t in ((a, b, b + nx), (a, b + nx, a + nx)) if all(there[v] for v in t)]
        self.write("h.ts", triangles_ts("h", points, triangles))

    def mesh(self, names, rule):
        entries = "".join(f"  - {{name: {name}, kind: fault, file: {name}.ts, extent: to_box}}\n" for name in names)
        project = self.write("model.yaml", "name: model\nbox: {min: [200, 200, -2000], max: [3800, 1800, 0]}\nsurfaces:\n"
                             f"  - {{name: h, kind: horizon, file: h.ts, {rule}}}\n" + entries +
                             "column: [upper, h, lower]\nrules: {fault_blocks: true}\noutput: {directory: out}\n")
        self.run_program(project)
        report = self.report(self.path("out", "model.report.json"))
        check = self.check(self.path("out", "model.vtu"), "--project", project)
        return report, {region["name"]: region["volume"] for region in check["regions"]}

    def lower_volumes(self, faults):
        """Of the blocks from west to east, below h: integrated over levels of the fault planes."""
        volumes, down = [], 0.0
        west = None
        for at, throw in faults + [(None, 0.0)]:
            area, n = 0.0, 4000
            for k in range(n):  # slices of z
                z = BOTTOM + (k + 0.5) * -BOTTOM / n
                low = 200.0 if west is None else west - (z + 1000) * COTANGENT
                high = 3800.0 if at is None else at - (z + 1000) * COTANGENT
                # h lies above z where level(x) - down > z
                low = max(low, 2000 + (z + down + 1000) / 0.04)
                area += max(0.0, high - low) * -BOTTOM / n
            volumes.append(1600 * area)
            west, down = at, down + throw
        return volumes

    def assert_restored(self, faults, half_width, rule, torn=False):
        names = [f"f{k + 1}" for k in range(len(faults))]
        for name, (at, _) in zip(names, faults):
            self.fault(name, at)
        self.horizon(faults, half_width, torn)
        report, volumes = self.mesh(names, rule)
        self.assertEqual(sorted(volumes), sorted(f"{unit}__B{k + 1}" for unit in ("upper", "lower") for k in range(len(names) + 1)), report["warnings"])
        found = sorted(v for name, v in volumes.items() if name.startswith("lower"))
        for one, other in zip(found, sorted(self.lower_volumes(faults))):
            self.assertAlmostEqual(one, other, delta=0.003 * 60 * 2000 * 1600)
        self.assertAlmostEqual(sum(volumes.values()), 3600 * 1600 * 2000, delta=10)
        return report

    def test_one_fault_named(self):
        report = self.assert_restored([(2000, 60)], 120, "throw_at: [f1]")
        told = [text for text in report["notes"] if "throw smeared across f1" in text]
        self.assertEqual(len(told), 1, report["notes"])
        throws = [float(told[0].split(word + " ")[1].split(",")[0].split()[0]) for word in ("least", "mean", "largest")]
        for throw in throws:
            self.assertAlmostEqual(throw, 60, delta=0.6)

    def test_two_faults_found(self):
        report = self.assert_restored([(1300, 60), (2900, 40)], 90, "throw_at: auto")
        for fault in ("f1", "f2"):
            self.assertTrue(any("throw smeared across " + fault in text for text in report["notes"]), report["notes"])

    def test_undefined_strips(self):
        self.assert_restored([(1300, 60), (2900, 40)], 90, "throw_at: auto, extend: tangent", torn=True)

    def test_a_ramp_that_is_kept(self):
        self.fault("f1", 2000)
        self.horizon([(2000, 60)], 120)
        report, volumes = self.mesh(["f1"], "throw_at: [f1], smeared_throw: keep")
        self.assertEqual(sorted(volumes), ["lower__B1", "lower__B2", "upper__B1", "upper__B2"])
        self.assertTrue(any("runs on across f1 as one sheet" in text for text in report["warnings"]), report["warnings"])
        self.assertFalse(any("smeared" in text for text in report["notes"]), report["notes"])

    def test_a_fault_that_ends_inside(self):
        """The throw is an ellipse along the strike and dies out at y = 1000, and away from the fault."""
        tip, throw = 1000.0, 60.0
        self.write("f1.ts", plane_ts("f1", [(2000, 100, 0), (2000, tip, 0), (2000, tip, BOTTOM), (2000, 100, BOTTOM)]))
        nx, ny = round(WIDTH / STEP) + 1, round(LENGTH / STEP) + 1

        def down(x, y, share):
            return throw * math.sqrt(max(0.0, 1 - (y / tip) ** 2)) * 0.5 * share * math.exp(-abs(x - 2000) / 1500)

        points = [(x, STEP * j, self.level(x) - down(x, STEP * j, max(-1.0, min(1.0, (x - 2000) / 110))))
                  for j in range(ny) for x in (STEP * i + 7 for i in range(nx))]
        corners = [(j * nx + i, j * nx + i + 1) for j in range(ny - 1) for i in range(nx - 1)]
        self.write("h.ts", triangles_ts("h", points, [t for a, b in corners for t in ((a, b, b + nx), (a, b + nx, a + nx))]))
        project = self.write("model.yaml", "name: model\nbox: {min: [200, 200, -2000], max: [3800, 1800, 0]}\nsurfaces:\n"
                             "  - {name: h, kind: horizon, file: h.ts, throw_at: auto}\n  - {name: f1, kind: fault, file: f1.ts}\n"
                             "column: [upper, h, lower]\noutput: {directory: out}\n")
        self.run_program(project)
        report = self.report(self.path("out", "model.report.json"))
        told = [text for text in report["notes"] if "throw smeared across f1" in text]
        self.assertEqual(len(told), 1, report["notes"])
        self.assertAlmostEqual(float(told[0].split("largest ")[1].split()[0]), throw, delta=0.08 * throw)
        check = self.check(self.path("out", "model.vtu"), "--project", project)
        volumes = {region["name"]: region["volume"] for region in check["regions"]}
        self.assertEqual(sorted(volumes), ["lower", "upper"], report["warnings"])
        # East of the fault the horizon lies as much lower as it lies higher west of it.
        self.assertAlmostEqual(volumes["lower"], 3600 * 1600 * 1000, delta=0.0005 * 3600 * 1600 * 1000)
        self.assertFalse(any("ramp stays" in text or "ramps stay" in text for text in report["warnings"]), report["warnings"])

    def test_a_fault_that_ends_at_another(self):
        """The branch f2 strikes along x, from f1 to the east; south of it the horizon lies lower. West of f1 it is whole."""
        self.fault("f1", 2000)
        self.write("f2.ts", plane_ts("f2", [(2700, 1000, 0), (3900, 1000, 0), (3900, 1000, BOTTOM), (2700, 1000, BOTTOM)]))
        nx, ny = round(WIDTH / STEP) + 1, round(LENGTH / STEP) + 1
        points = []
        for j in range(ny):
            for i in range(nx):
                x, y, z = STEP * i, STEP * j, self.level(STEP * i)
                east = 0.5 + 0.5 * max(-1.0, min(1.0, (x - 2000 + (z + 1000) * COTANGENT) / 110))
                south = 0.5 - 0.5 * max(-1.0, min(1.0, (y - 1000) / 110))
                points.append((x, y, z - east * (60 + 40 * south)))
        corners = [(j * nx + i, j * nx + i + 1) for j in range(ny - 1) for i in range(nx - 1)]
        self.write("h.ts", triangles_ts("h", points, [t for a, b in corners for t in ((a, b, b + nx), (a, b + nx, a + nx))]))
        project = self.write("model.yaml", "name: model\nbox: {min: [200, 200, -2000], max: [3800, 1800, 0]}\nsurfaces:\n"
                             "  - {name: h, kind: horizon, file: h.ts, throw_at: [f1, f2]}\n"
                             "  - {name: f1, kind: fault, file: f1.ts, extent: to_box}\n"
                             "  - {name: f2, kind: fault, file: f2.ts, extent: to_fault f1}\n"
                             "column: [upper, h, lower]\nrules: {fault_blocks: true}\noutput: {directory: out}\n")
        self.run_program(project)
        report = self.report(self.path("out", "model.report.json"))
        for name, throw in (("f1", 80), ("f2", 40)):
            told = [text for text in report["notes"] if "throw smeared across " + name in text]
            self.assertEqual(len(told), 1, report["notes"] + report["warnings"])
            self.assertAlmostEqual(float(told[0].split("mean ")[1].split(",")[0]), throw, delta=0.05 * throw)
        check = self.check(self.path("out", "model.vtu"), "--project", project)
        volumes = {region["name"]: region["volume"] for region in check["regions"]}
        self.assertEqual(sorted(volumes), sorted(f"{unit}__B{k}" for unit in ("upper", "lower") for k in (1, 2, 3)), report["warnings"])

    def polygon_model(self, polygons, entry="fault_polygons: {file: polygons.txt}, extend: tangent", status=0):
        """A horizon that is interpolated over 400 m on both sides of f1, too wide for a ramp that is found."""
        self.fault("f1", 2000)
        self.horizon([(2000, 60)], 400)
        self.write("polygons.txt", polygons)
        project = self.write("model.yaml", "name: model\nbox: {min: [200, 200, -2000], max: [3800, 1800, 0]}\nsurfaces:\n"
                             f"  - {{name: h, kind: horizon, file: h.ts, {entry}}}\n"
                             "  - {name: f1, kind: fault, file: f1.ts, extent: to_box}\n"
                             "column: [upper, h, lower]\nrules: {fault_blocks: true}\noutput: {directory: out}\n")
        printed = self.run_program(project, status=status)
        if status:
            return printed
        check = self.check(self.path("out", "model.vtu"), "--project", project)
        return self.report(self.path("out", "model.report.json")), {region["name"]: region["volume"] for region in check["regions"]}

    GAP = [(1570, -50), (2480, -50), (2480, 2050), (1570, 2050)]

    def test_fault_polygons_of_every_format(self):
        """Nodes between the cut-offs are no data, and the fault is found by the polygon."""
        rows = [f"{x} {y}" for x, y in self.GAP]
        ring = rows + rows[:1]
        lines = "".join(f"VRTX {k + 1} {row} 0\n" for k, row in enumerate(rows))
        for name, text in (("blanks", "\n".join(ring) + "\n\n"), ("irap", "\n".join(row + " -1000" for row in ring) + "\n999 999 999\n"),
                           ("ids", "x,y,polygon\n" + "".join(row.replace(" ", ",") + ",a\n" for row in ring)),
                           ("gocad", "GOCAD PLine 1\nHEADER {\nname: gap\n}\nILINE\n" + lines + "SEG 1 2\nSEG 2 3\nSEG 3 4\nEND\n")):
            with self.subTest(name):
                report, volumes = self.polygon_model(text)
                self.assertTrue(any("fault polygons of f1: 1;" in note for note in report["notes"]), report["notes"])
                self.assertEqual(sorted(volumes), ["lower__B1", "lower__B2", "upper__B1", "upper__B2"], report["warnings"])
                found = sorted(v for unit, v in volumes.items() if unit.startswith("lower"))
                for one, other in zip(found, sorted(self.lower_volumes([(2000, 60)]))):
                    self.assertAlmostEqual(one, other, delta=0.003 * 60 * 2000 * 1600)

    def test_fault_polygons_with_mistakes_are_told_and_change_nothing(self):
        gap = "\n".join(f"{x} {y}" for x, y in self.GAP)
        for text, words in (("\n".join(f"{x + 500000} {y + 6e6:.0f}" for x, y in self.GAP), "lie beside it"),
                            ("3000 500\n3200 500\n3200 900\n3000 900\n", "are passed by no fault at its height")):
            report, volumes = self.polygon_model(text)
            told = [warning for warning in report["warnings"] if words in warning]
            self.assertEqual(len(told), 1, report["warnings"])
            self.assertIn("the first near (", told[0])
            self.assertAlmostEqual(sum(volumes.values()), 3600 * 1600 * 2000, delta=10)
        self.assertIn("polygons.txt:2: x and y", self.polygon_model("1 2\nabc def\n", status=BAD_INPUT))
        self.assertIn("no fault polygon of three points", self.polygon_model("1 2\n3 4\n", status=BAD_INPUT))
        self.assertIn("there is no file", self.polygon_model(gap, "fault_polygons: {file: none.txt}", USAGE))
        self.assertIn("file", self.polygon_model(gap, "fault_polygons: {}", USAGE))
        report, _ = self.polygon_model(gap, "fault_polygons: {file: polygons.txt, crs: local}, throw_at: [f1]")
        self.assertFalse(any("throw_at does not name" in warning for warning in report["warnings"]))


if __name__ == "__main__":
    main()
