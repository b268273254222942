# SPDX-License-Identifier: GPL-3.0-or-later
"""Real surfaces from the shared test data, where that stands beside the project."""
import csv
import glob
import os
import re
import time
import unittest

from geomesh_program import CANNOT_MESH, NIGHTLY, ProgramTest, main, plane_ts


class Claudius(ProgramTest):
    """Four seismic horizons of one GOCAD file: horizon_0, horizon_60, horizon_250, horizon_330."""

    def project(self, box):
        file = self.shared("claudius", "claudius_delaunay.ts")
        with open(file) as text:
            names = re.findall(r"^name:(\S+)", text.read(), re.MULTILINE)
        self.assertEqual(len(names), 4)
        order = sorted(names, key=lambda name: int(name.split("_")[1]))
        column = ["unit_1"]
        for i, name in enumerate(order):
            column += [name, "unit_%d" % (i + 2)]
        surfaces = "".join("  - {name: %s, kind: horizon, file: %s}\n" % (name, file) for name in order)
        return self.write("claudius.yaml", "name: claudius\nbox: {min: [%s], max: [%s]}\nsurfaces:\n%scolumn: [%s]\n" % (
            ", ".join(box[:3]), ", ".join(box[3:]), surfaces, ", ".join(column)))

    def test_small_box_has_five_regions(self):
        project = self.project(["549500", "7820100", "-11010", "550850", "7821750", "-8400"])
        self.run_program(project, "-o", self.folder)
        check = self.check(self.path("claudius.vtu"), "--project", project)
        self.assertEqual(self.region_names(check), ["unit_1", "unit_2", "unit_3", "unit_4", "unit_5"])
        self.assertAlmostEqual(check["volume"] / (1350.0 * 1650 * 2610), 1, delta=1e-12)

    def test_whole_box_warns_of_gaps(self):
        """In the box of claudiusbb.txt the horizons have holes and stop short: which ones, where, and which units join."""
        with open(self.shared("claudius", "claudiusbb.txt")) as file:
            low, high = [[repr(float(x)) for x in line.split()] for line in file.read().splitlines()[:2]]
        project = self.project(low + high)
        self.run_program(project, "-o", self.folder)
        self.check(self.path("claudius.vtu"), "--project", project)
        warnings = "\n".join(self.report(self.path("claudius.report.json"))["warnings"])
        for horizon in ("horizon_0", "horizon_60", "horizon_250", "horizon_330"):
            self.assertIn(horizon, warnings)
        self.assertIn("unit_", warnings)


    def completed(self, name, entry):
        """Meshes the whole box with four entries of surfaces made by `entry` of a horizon's number; its volumes by region."""
        with open(self.shared("claudius", "claudiusbb.txt")) as file:
            low, high = [[repr(float(x)) for x in line.split()] for line in file.read().splitlines()[:2]]
        surfaces = "".join("  - {name: horizon_%d, kind: horizon, %s}\n" % (number, entry(number)) for number in (0, 60, 250, 330))
        project = self.write(name + ".yaml", "name: %s\nbox: {min: [%s], max: [%s]}\nsurfaces:\n%srules: {on_crossing: clip_older}\n"
                             "column: [unit_1, horizon_0, unit_2, horizon_60, unit_3, horizon_250, unit_4, horizon_330, unit_5]\n" % (
                                 name, ", ".join(low), ", ".join(high), surfaces))
        self.run_program(project, "-o", self.folder)
        check = self.check(self.path(name + ".vtu"), "--project", project)
        self.assertEqual(self.region_names(check), ["unit_1", "unit_2", "unit_3", "unit_4", "unit_5"])
        self.assertAlmostEqual(check["volume"] / (3700.0 * 5400 * 2610), 1, delta=1e-12)
        report = self.report(self.path(name + ".report.json"))
        self.assertTrue(any("horizon_330 above horizon_250 removed" in note for note in report["notes"]), report["notes"])
        return report, {region["name"]: region["volume"] for region in check["regions"]}

    def test_whole_box_completed_by_rule(self):
        """Five units in the whole box, from the points and from the triangulated surfaces; the two ways, which have no code in common but
        for the meshing, agree, and so does the mean height of the points."""
        points, surfaces = self.shared("claudius", "claudius.csv"), self.shared("claudius", "claudius_delaunay.ts")
        report, gridded = self.completed("gridded", lambda number: 'file: %s, object: "%d.0", gridding: {spacing: 100, extent: box}' % (points, number))
        self.assertTrue(any("residual at the points: rms" in note for note in report["notes"]), report["notes"])
        report, extended = self.completed("extended", lambda number: "file: %s, extend: tangent, fill_holes: all" % surfaces)
        notes = "\n".join(report["notes"])
        self.assertIn("horizon_60: 4 holes filled", notes)
        self.assertIn("horizon_330: 2 holes filled", notes)
        for unit in gridded:
            self.assertAlmostEqual(gridded[unit] / extended[unit], 1, delta=0.015, msg=unit)
        heights = {}
        with open(points) as file:
            for row in csv.DictReader(file):
                heights.setdefault(row["val"], []).append(float(row["Z"]))
        mean = sum(heights["0.0"]) / len(heights["0.0"])
        self.assertAlmostEqual(gridded["unit_1"] / (3700.0 * 5400 * (-8400 - mean)), 1, delta=0.01)


class Faults(ProgramTest):
    def test_salt_faults_in_a_box(self):
        """Eleven faults that cross, end inside and are partly non-manifold, in a box about them all."""
        files = sorted(glob.glob(os.path.join(self.shared("faults", "SALT"), "*.ts")))
        self.assertEqual(len(files), 11)
        low, high = [1e30] * 3, [-1e30] * 3
        for name in files:
            with open(name) as file:
                for line in file:
                    if line.startswith(("VRTX", "PVRTX")):
                        point = [float(x) for x in line.split()[2:5]]
                        low, high = list(map(min, low, point)), list(map(max, high, point))
        box = [int(x) - 1000 for x in low] + [int(x) + 1000 for x in high]
        self.run_program("mesh", *files, "--box", ",".join(map(str, box)), "-o", self.path("salt.vtu"))
        check = self.check(self.path("salt.vtu"), "--surfaces", *files)
        volume = 1.0
        for i in range(3):
            volume *= box[i + 3] - box[i]
        self.assertAlmostEqual(check["volume"] / volume, 1, delta=1e-12)


class FaultAreas(ProgramTest):
    """All faults of an area, as they are, in a box by margin with a horizon through them: every fault is there, and
    none divides what it does not. About a minute for both areas on two busy cores."""

    timeout = 850

    def mesh_area(self, area, depth, n_files):
        files = sorted(glob.glob(os.path.join(self.shared("faults", area), "*.ts")))
        self.assertEqual(len(files), n_files)
        names = [os.path.basename(name)[:-3] for name in files]
        surfaces = "".join("  - {name: %s, kind: fault, file: %s}\n" % pair for pair in zip(names, files))
        self.write("sea.ts", plane_ts("sea", [(-1e6, 1e6, depth), (2e6, 1e6, depth), (2e6, 9e6, depth), (-1e6, 9e6, depth)]))
        project = self.write("area.yaml", "name: area\nbox: {center: [%s], size: [%s], bottom: -22000, top: 4000}\nsurfaces:\n"
                             "  - {name: sea, kind: horizon, file: sea.ts}\n%scolumn: [upper, sea, lower]\n" % (*self.boxes[area], surfaces))
        started = time.time()
        self.run_program(project, "-o", self.folder)
        print("%s: %d faults meshed in %.0f s" % (area, n_files, time.time() - started))
        check = self.check(self.path("area.vtu"), "--project", project)
        report = self.report(self.path("area.report.json"))
        present = {s["name"] for s in report["surfaces"] if s["area"] > 0}
        self.assertEqual(set(names) - present, set())
        self.assertTrue(all(re.match(r"(upper|lower)(__\d+)?$", name) for name in self.region_names(check)), self.region_names(check))
        width, length = (float(x) for x in self.boxes[area][1].split(","))
        self.assertAlmostEqual(check["volume"] / (width * length * 26000), 1, delta=1e-12)
        upper = sum(r["volume"] for r in check["regions"] if r["name"].startswith("upper"))
        self.assertAlmostEqual(upper / (width * length * (4000 - depth)), 1, delta=1e-9)

    boxes = {"MJVA": ("523000, 3853000", "200000, 170000"), "SNFA": ("445700, 4014000", "140000, 230000")}

    @unittest.skipUnless(NIGHTLY, "nightly")
    def test_mjva_with_a_horizon(self):
        self.mesh_area("MJVA", -3000, 44)

    @unittest.skipUnless(NIGHTLY, "nightly")
    def test_snfa_with_a_horizon(self):
        self.mesh_area("SNFA", -3000, 34)


class ModelA4(ProgramTest):
    def test_region_volumes(self):
        wanted = {}
        with open(self.shared("modelA4", "region_volumes.txt")) as file:
            for line in file:
                found = re.match(r"\s+(H\w+)\s+volume\s+(\S+)", line)
                if found:
                    wanted[found.group(1)] = float(found.group(2))
        self.assertEqual(len(wanted), 8)
        self.run_program("mesh", self.shared("modelA4", "modelA4.ml"), "-o", self.path("a4.vtu"))
        check = self.check(self.path("a4.vtu"))
        self.assertEqual(self.region_names(check), sorted(wanted))
        for region in check["regions"]:
            self.assertAlmostEqual(region["volume"] / wanted[region["name"]], 1, delta=1e-9, msg=region["name"])

    def test_short_edges_are_told_before_the_work(self):
        """Edges of 0.04 to 100 m along seams ask for most of the elements: a warning says so, unless they are not asked."""
        arguments = ("mesh", self.shared("modelA4", "modelA4.ml"), "-o", self.path("a4.vtu"), "--size", "389", "--max-elements", "1000")
        words = "for short edges of the input"
        self.assertIn(words, self.run_program(*arguments, status=CANNOT_MESH))
        self.assertNotIn(words, self.run_program(*arguments, "--no-size-on-surfaces", status=CANNOT_MESH))


class SurfacesThatCross(ProgramTest):
    """Sets that cross themselves or each other, intersected, meshed, and checked against the surfaces as given."""

    def mesh_and_check(self, files, *options):
        self.run_program("mesh", *files, "-o", "out.vtu", "--quiet", *options)
        self.check(self.path("out.vtu"), "--surfaces", *files)
        return self.report(self.path("out.report.json"))

    def test_hundred_grains_in_a_box(self):
        folder = self.shared("grains")
        grains = [os.path.join(folder, "%d.obj" % i) for i in range(100)]
        report = self.mesh_and_check(grains, "--hull")
        self.assertEqual(len(report["regions"]), 101)

    def test_a_hundred_triangles_in_a_box(self):
        report = self.mesh_and_check([self.shared("solids", "soup.stl")], "--box", "-0.1,-0.1,-0.1,1.1,1.1,1.1")
        self.assertAlmostEqual(sum(region["volume"] for region in report["regions"]), 1.2 ** 3, delta=1e-12)

    def test_spheres_that_overlap(self):
        report = self.mesh_and_check([self.shared("solids", "sphere1.obj"), self.shared("solids", "sphere2.obj")])
        self.assertEqual(sorted(len(region["inside"]) for region in report["regions"]), [1, 1, 2])


class Solids(ProgramTest):
    def test_solids(self):
        for name in ("sphere1.obj", "res.obj", "cow25k.obj", "humanoid.off"):
            file = self.shared("solids", name)
            self.run_program("mesh", file, "-o", self.path(name + ".vtu"))
            self.check(self.path(name + ".vtu"), "--surfaces", file)


if __name__ == "__main__":
    main()
