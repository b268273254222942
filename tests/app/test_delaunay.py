# SPDX-License-Identifier: GPL-3.0-or-later
"""`geomesh delaunay`: the same file whatever the threads, the algorithm and the cluster distance; equal and deferred points; refusals."""
import filecmp
import os
import random
import shutil

from geomesh_program import BAD_INPUT, CANNOT_MESH, USAGE, ProgramTest, main


def lines(points):
    return "".join("%.17g %.17g %.17g\n" % p for p in points)


def cube(n, seed, scale=1.0):
    generator = random.Random(seed)
    return [tuple(scale * generator.random() for _ in range(3)) for _ in range(n)]


class Delaunay(ProgramTest):
    def assert_same_file(self, a, b):
        self.assertTrue(filecmp.cmp(self.path(a), self.path(b), shallow=False), "%s and %s differ" % (a, b))

    def test_threads_algorithm_and_distance_leave_the_file_as_it_is(self):
        # Enough points for insertion in parts side by side; some equal, some crowded.
        points = cube(60000, 1) + cube(20000, 2, 1e-6)
        points += random.Random(3).sample(points, 100)
        self.write("points.xyz", lines(points))
        runs = {"1": ["--threads", 1], "2": ["--threads", 2], "flip": ["--algorithm", "flip"], "far": ["--cluster-distance", "0.01"]}
        for name, options in runs.items():
            self.run_program("delaunay", "points.xyz", "-o", name + "/mesh.vtu", "--quiet", *options, status=None)
        for name in runs:
            self.assert_same_file("1/mesh.vtu", name + "/mesh.vtu")
        self.assertGreater(self.report(self.path("far", "mesh.report.json"))["points_deferred"], 1000)
        self.assertEqual(self.check(self.path("1", "mesh.vtu"), "--delaunay")["faults"], [])

    def test_a_lattice_is_the_same_by_flips(self):
        self.write("points.xyz", lines([(x, y, z) for x in range(9) for y in range(7) for z in range(8)]))
        for algorithm in ("cavity", "flip"):
            self.run_program("delaunay", "points.xyz", "-o", algorithm + "/mesh.vtu", "--algorithm", algorithm)
        self.assert_same_file("cavity/mesh.vtu", "flip/mesh.vtu")

    def test_equal_points_are_reported_with_their_rows(self):
        corners = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
        self.write("points.xyz", lines(corners + [corners[5], (-0.0, 0, -0.0), corners[5]]))
        printed = self.run_program("delaunay", "points.xyz", "-o", "mesh.vtu")
        self.assertIn("8 = 5, 9 = 0, 10 = 5", printed)
        report = self.report(self.path("mesh.report.json"))
        self.assertEqual(report["input"]["equal_points"], [[8, 5], [9, 0], [10, 5]])
        self.assertTrue(any("8 = 5" in str(warning) for warning in report["warnings"]))

    def test_no_volume(self):
        generator = random.Random(4)
        inputs = {
            "in one plane": [(generator.random(), generator.random(), 0.25) for _ in range(1000)],
            "on one line": [(float(generator.randrange(10000)), 2, 3) for _ in range(1000)],
            "at one place": [(1, 2, 3)] * 10,
        }
        for where, points in inputs.items():
            self.write("points.xyz", lines(points))
            self.assertIn("all points lie " + where, self.run_program("delaunay", "points.xyz", "-o", "mesh.vtu", status=CANNOT_MESH))
        self.assert_nothing_written()

    def test_on_a_sphere(self):
        points = []
        for p in cube(5000, 5):
            x, y, z = (2 * c - 1 for c in p)
            r = (x * x + y * y + z * z) ** 0.5
            points.append((x / r, y / r, z / r))
        self.write("points.xyz", lines(points))
        for algorithm in ("cavity", "flip"):
            self.run_program("delaunay", "points.xyz", "-o", algorithm + "/mesh.vtu", "--algorithm", algorithm)
        self.assert_same_file("cavity/mesh.vtu", "flip/mesh.vtu")

    def test_exponents_out_of_range_are_refused(self):
        for bad in ("1e-300", "1e300", "nan", "inf"):
            self.write("points.xyz", lines(cube(20, 6)) + "0.5 %s 0.5\n" % bad)
            printed = self.run_program("delaunay", "points.xyz", "-o", "mesh.vtu", status=BAD_INPUT)
            self.assertIn("20" if bad.startswith("1e") else "", printed)
        self.assert_nothing_written()

    def test_a_wrong_distance(self):
        self.write("points.xyz", lines(cube(20, 7)))
        self.run_program("delaunay", "points.xyz", "-o", "mesh.vtu", "--cluster-distance", "-1", status=USAGE)
        self.run_program("delaunay", "points.xyz", "-o", "mesh.vtu", "--cluster-distance", "near", status=USAGE)


class ClusterDistanceOfAProject(ProgramTest):
    def test_points_wait_and_the_mesh_is_the_same(self):
        """In the main job too: a sample with and without a distance."""
        reports = {}
        for name, mesh in (("none", "cluster_distance: 0"), ("auto", "cluster_distance: auto"), ("far", "cluster_distance: 300")):
            project = self.copy_of_sample("faulted-layers", "{refine: none, " + mesh + "}")
            self.run_program(project, "-o", self.path("out_" + name), "--quiet")
            report = self.report(self.path("out_" + name, "faulted_layers.report.json"))
            reports[name] = report
            self.assertEqual(self.check(self.path("out_" + name, "faulted_layers.vtu"))["faults"], [])
        self.assertEqual(reports["none"]["points_deferred"], 0)
        self.assertGreater(reports["far"]["points_deferred"], 0)
        for name in ("auto", "far"):
            self.assertEqual(reports["none"]["recovery"], reports[name]["recovery"])
            self.assertEqual(reports["none"]["regions"], reports[name]["regions"])


if __name__ == "__main__":
    main()
