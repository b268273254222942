# SPDX-License-Identifier: GPL-3.0-or-later
"""Projects whose surfaces are fields, and networks of fractures: volumes and areas that are known, units at places, messages."""
import math
import os
import unittest

from geomesh_program import BAD_INPUT, USAGE, ProgramTest, main

try:
    import numpy
except ImportError:
    numpy = None


@unittest.skipIf(numpy is None, "skipped: the Python package numpy is not installed")
class Fields(ProgramTest):
    def field(self, name, function, n=50):
        """A field on a grid over the cube from -500 to 500."""
        at = numpy.linspace(-500, 500, n + 1)
        x, y, z = numpy.meshgrid(at, at, at, indexing="ij")
        numpy.save(self.path(name), numpy.broadcast_to(function(x, y, z), x.shape))
        return "{field: %s, origin: [-500, -500, -500], spacing: %g" % (name, 1000 / n)

    def project(self, surfaces, rest=""):
        return self.write("model.yaml", "box: {min: [-500, -500, -500], max: [500, 500, 500]}\nsurfaces:\n" +
                          "".join("  - %s}\n" % s for s in surfaces) + rest)

    def volumes(self, project):
        out = self.path("out")
        self.run_program(project, "-o", out)
        report = self.report(os.path.join(out, "model.report.json"))
        return {r["name"]: r["volume"] for r in report["regions"]}, report

    def test_a_ball_has_its_volume(self):
        ball = self.field("ball.npy", lambda x, y, z: numpy.sqrt(x * x + y * y + z * z) - 300)
        volumes, _ = self.volumes(self.project([ball + ", name: ball, kind: body, value: 0"]))
        self.assertAlmostEqual(volumes["ball"] / (4 / 3 * math.pi * 27e6), 1, delta=0.01)

    def test_a_sequence_of_one_field_keeps_its_order(self):
        fold = self.field("fold.npy", lambda x, y, z: z - 80 * numpy.sin(x / 300) - 20 * numpy.cos(y / 400), n=25)
        surfaces = [fold + ", name: h%d, kind: horizon, value: %g" % (i, v) for i, v in enumerate((30, 29, -60))]
        volumes, _ = self.volumes(self.project(surfaces, "column: [a, h0, b, h1, c, h2, d]\n"))
        self.assertEqual(sorted(volumes), ["a", "b", "c", "d"])
        self.assertAlmostEqual(volumes["b"] / 1e6, 1, delta=0.05)
        self.assertAlmostEqual(volumes["c"] / 89e6, 1, delta=0.005)

    def test_a_field_without_the_value_is_refused(self):
        fold = self.field("fold.npy", lambda x, y, z: z)
        printed = self.run_program(self.project([fold + ", name: top, kind: horizon, value: 900"]), status=BAD_INPUT)
        self.assertIn("surface top", printed)
        self.assertIn("from -500 to 500", printed)

    def test_a_node_without_value_is_refused_with_its_place(self):
        def f(x, y, z):
            z = z.copy()
            z[3, 0, 0] = math.nan
            return z
        fold = self.field("holes.npy", f)
        printed = self.run_program(self.project([fold + ", name: top, kind: horizon, value: 0"]), status=BAD_INPUT)
        self.assertIn("(-440, -500, -500)", printed)

    def test_keys_that_do_not_go_with_a_field_are_reported(self):
        fold = self.field("fold.npy", lambda x, y, z: z)
        printed = self.run_program(self.project([fold + ", name: top, kind: horizon, smooth: 3"]), status=USAGE)
        self.assertIn("surfaces[1].smooth", printed)
        self.assertIn("'value'", printed.replace('"', "'"))


class Fractures(ProgramTest):
    def mesh(self, fractures, rest=""):
        out = self.path("out")
        text = "box: {min: [0, 0, 0], max: [10, 10, 10]}\nfractures: %s\n%s" % (fractures, rest)
        self.run_program(self.write("network.yaml", text), "-o", out)
        return self.report(os.path.join(out, "network.report.json"))

    def test_crossing_fractures_keep_their_areas_and_share_a_curve(self):
        self.write("two.csv", "2,2,5,8,2,5,8,8,5,2,8,5\n5,3,2,5,7,2,5,7,8,5,3,8\n")
        report = self.mesh("{file: two.csv}", "mesh: {size: 2}\n")
        areas = {s["name"]: s["area"] for s in report["surfaces"]}
        self.assertAlmostEqual(areas["fracture_1"], 36, delta=36e-9)
        self.assertAlmostEqual(areas["fracture_2"], 24, delta=24e-9)
        lengths = {c["name"]: c["length"] for c in report["curves"]}
        both = [n for n in lengths if "fracture_1" in n and "fracture_2" in n]
        self.assertEqual(len(both), 1)
        self.assertAlmostEqual(lengths[both[0]], 4, delta=1e-9)

    def test_a_fracture_that_stops_short_of_a_side_ends_there(self):
        self.write("short.csv", "2,2,5,9.6,2,5,9.6,8,5,2,8,5\n")
        report = self.mesh("{file: short.csv}", "mesh: {refine: none}\n")
        area = next(s["area"] for s in report["surfaces"] if s["name"] == "fracture_1")
        self.assertAlmostEqual(area, 7.6 * 6, delta=1e-9)

    def test_discs_of_a_network_keep_their_areas_when_they_are_meshed_to_a_size(self):
        families = ("{seed: 3, corners: 12, families: [{name: steep, dip_direction: 70, dip: 80, kappa: 10, radius: 1.5, count: 12},"
                    " {name: flat, dip: 10, kappa: 10, radius: 1.5, count: 12}]}")
        bare = {s["name"]: s["area"] for s in self.mesh(families, "mesh: {refine: none}\n")["surfaces"]}
        meshed = self.mesh(families, "mesh: {size: 1.2}\n")
        for surface in meshed["surfaces"]:
            self.assertAlmostEqual(surface["area"] / bare[surface["name"]], 1, delta=1e-9, msg=surface["name"])
        self.assertGreater(len([c for c in meshed["curves"] if c["kind"] == "intersection" and "steep" in c["name"]]), 5)

    def test_fractures_nearer_to_each_other_than_the_tolerance_stay_apart(self):
        self.write("near.csv", "2,2,5,8,2,5,8,8,5,2,8,5\n2,5,5.004,8,5,5.004,8,5,8,2,5,8\n")
        report = self.mesh("{file: near.csv}", "mesh: {size: 2}\n")
        areas = {s["name"]: s["area"] for s in report["surfaces"]}
        self.assertAlmostEqual(areas["fracture_2"], 6 * 2.996, delta=1e-8)
        self.assertEqual([c["name"] for c in report["curves"] if "fracture_1" in c["name"] and "fracture_2" in c["name"]], [])

    def test_a_fracture_outside_is_reported(self):
        self.write("far.csv", "2,2,5,8,2,5,8,8,5\n20,2,5,28,2,5,28,8,5\n")
        printed = self.run_program(self.write("far.yaml", "box: {min: [0, 0, 0], max: [10, 10, 10]}\n"
                                              "fractures: {file: far.csv}\nmesh: {size: 3}\n"), "-o", self.path("out"))
        self.assertIn("fracture_2 lies outside the box", printed)

    def test_a_polygon_that_is_not_plane_is_refused(self):
        self.write("bent.csv", "2,2,5,8,2,5,8,8,5,2,8,7\n")
        printed = self.run_program(self.write("bent.yaml", "box: {min: [0, 0, 0], max: [10, 10, 10]}\n"
                                              "fractures: {file: bent.csv}\n"), status=BAD_INPUT)
        self.assertIn("bent.csv:1", printed)
        self.assertIn("not plane", printed)


if __name__ == "__main__":
    main()
