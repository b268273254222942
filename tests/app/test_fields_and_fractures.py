# SPDX-License-Identifier: GPL-3.0-or-later
"""Projects whose surfaces are fields, and networks of fractures: volumes and areas that are known, units at places, messages."""
import json
import math
import os
import unittest

from geomesh_program import BAD_INPUT, USAGE, ProgramTest, main

try:
    import numpy
except ImportError:
    numpy = None
try:
    import meshio
except ImportError:
    meshio = None
try:
    import netCDF4
except ImportError:
    netCDF4 = None
try:
    from osgeo import ogr
except ImportError:
    ogr = None


def units_at(file, places):
    """Names of the units of a .vtu file in which the places lie; a place in no tetrahedron has the name ''."""
    mesh = meshio.read(file)
    with open(file + ".json") as sidecar:
        names = {g["id"]: g["name"] for g in json.load(sidecar)["groups"] if g["dimension"] == 3}
    corners = mesh.points[mesh.cells_dict["tetra"]]
    units = numpy.array([names[i] for i in mesh.cell_data_dict["region"]["tetra"]])
    low, high = corners.min(axis=1), corners.max(axis=1)
    inverse = numpy.linalg.inv((corners[:, 1:] - corners[:, :1]).transpose(0, 2, 1))
    order = numpy.argsort(places[:, 0], kind="stable")
    begin, end = (numpy.searchsorted(places[order, 0], x) for x in (low[:, 0], high[:, 0]))
    found = numpy.full(len(places), "", dtype=units.dtype)
    for t in range(len(corners)):
        rows = order[begin[t]:end[t]]
        rows = rows[((places[rows, 1:] >= low[t, 1:]) & (places[rows, 1:] <= high[t, 1:])).all(axis=1)]
        shares = (places[rows] - corners[t, 0]) @ inverse[t].T
        found[rows[(shares >= 0).all(axis=1) & (shares.sum(axis=1) <= 1)]] = units[t]
    return found


class FieldTest(ProgramTest):
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


@unittest.skipIf(numpy is None, "skipped: the Python package numpy is not installed")
class Fields(FieldTest):
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

    @unittest.skipIf(netCDF4 is None, "skipped: the Python package netCDF4 is not installed")
    def test_a_netcdf_field_gives_the_mesh_of_the_same_array(self):
        def f(x, y, z):
            return z - 80 * numpy.sin(x / 300) - 20 * numpy.cos(y / 400)
        expected, _ = self.volumes(self.project([self.field("fold.npy", f, n=20) + ", name: top, kind: horizon, value: 30"]))
        at = numpy.linspace(-500, 500, 21)
        with netCDF4.Dataset(self.path("fold.nc"), "w") as file:  # axes in the order of CF, north first
            for name, values in (("depth", at), ("northing", at[::-1]), ("easting", at)):
                file.createDimension(name, 21)
                file.createVariable(name, "f8", (name,))[:] = values
            x, y, z = numpy.meshgrid(at, at, at, indexing="ij")
            file.createVariable("strata", "f8", ("depth", "northing", "easting"))[:] = f(x, y, z).transpose(2, 1, 0)[:, ::-1]
            file.createVariable("other", "f4", ("depth", "northing", "easting"))[:] = 0
        entry = "{field: fold.nc, array: %s, name: top, kind: horizon, value: 30"
        found, _ = self.volumes(self.project([entry % "strata"]))
        self.assertEqual(found, expected)
        for name, words in (("starta", "holds strata, other"), ('""', "array")):
            self.assertIn(words, self.run_program(self.project([entry % name]), status=(BAD_INPUT if name == "starta" else USAGE)))

    def test_keys_that_do_not_go_with_a_field_are_reported(self):
        fold = self.field("fold.npy", lambda x, y, z: z)
        printed = self.run_program(self.project([fold + ", name: top, kind: horizon, smooth: 3"]), status=USAGE)
        self.assertIn("surfaces[1].smooth", printed)
        self.assertIn("'value'", printed.replace('"', "'"))


@unittest.skipIf(numpy is None, "skipped: the Python package numpy is not installed")
class Domains(FieldTest):
    """A fold that jumps by 80 m at a fault: two fields, each of which holds on one side of the fault, which is a field too."""
    TOP, BASE, JUMP = 30, -60, 80
    COLUMN = "column: [a, top, b, base, c]\nmesh: {size: 80}\n"

    @staticmethod
    def fold(x, y):
        return 60 * numpy.sin(x / 300) + 20 * numpy.cos(y / 400)

    def surfaces(self, west, east):
        fault = self.field("fault.npy", lambda x, y, z: x - 0.5 * z) + ", name: fault, kind: fault, value: 0"
        fields = ((self.field("west.npy", lambda x, y, z: z - self.fold(x, y)), west),
                  (self.field("east.npy", lambda x, y, z: z + self.JUMP - self.fold(x, y)), east))
        return [fault] + [field + ", name: %s, kind: horizon, value: %g, domain: %s" % (name, value, domain)
                          for name, value in (("top", self.TOP), ("base", self.BASE)) for field, domain in fields]

    def expected(self, n=1000):
        """Volumes of b and of its part west of the fault, whose plane is x = z / 2: exact along z, by midpoints in the map."""
        at = (numpy.arange(n) + 0.5) / n * 1000 - 500
        x, y = numpy.meshgrid(at, at, indexing="ij")
        fold = self.fold(x, y)
        west = numpy.maximum(fold + self.TOP, 2 * x) - numpy.maximum(fold + self.BASE, 2 * x)
        east = numpy.minimum(fold + self.TOP - self.JUMP, 2 * x) - numpy.minimum(fold + self.BASE - self.JUMP, 2 * x)
        return 1e6 * (west.mean() + east.mean()), 1e6 * west.mean()

    def unit(self, x, y, z):
        height = z - self.fold(x, y) + numpy.where(x < 0.5 * z, 0, self.JUMP)
        return numpy.where(height > self.TOP, "a", numpy.where(height > self.BASE, "b", "c"))

    def distance(self, x, y, z):
        """A lower bound of the distance to the nearest surface: the fields have slopes below 1.03."""
        height = z - self.fold(x, y) + numpy.where(x < 0.5 * z, 0, self.JUMP)
        return numpy.minimum(numpy.minimum(abs(height - self.TOP), abs(height - self.BASE)) / 1.03, abs(x - 0.5 * z) / math.sqrt(1.25))

    def verify_model(self, project):
        parts, report = self.volumes(project)
        volumes = {unit: sum(v for k, v in parts.items() if k.split("__")[0] == unit) for unit in "abc"}
        self.assertEqual(len(parts), 6)
        self.assertAlmostEqual(volumes["b"] / self.expected()[0], 1, delta=0.001)
        self.assertAlmostEqual(sum(volumes.values()) / 1e9, 1, delta=1e-9)
        out = self.path("out")
        self.run_program("check", os.path.join(out, "model.vtu"), "--project", project)
        return report

    @unittest.skipIf(meshio is None, "skipped: the Python package meshio is not installed")
    def test_a_jump_at_a_fault_has_its_volumes_and_its_units_at_20000_points(self):
        project = self.project(self.surfaces("{above: fault}", "{below: fault}"), self.COLUMN)
        self.verify_model(project)
        places = numpy.random.default_rng(5).uniform(-500, 500, (20000, 3))
        places = places[self.distance(*places.T) > 4]  # the tolerance: surfaces are within a twentieth of the size
        self.assertGreater(len(places), 19000)
        found = units_at(os.path.join(self.path("out"), "model.vtu"), places)
        wrong = numpy.array([name.split("__")[0] for name in found]) != self.unit(*places.T)
        self.assertEqual(wrong.sum(), 0, places[wrong][:3])

    def test_a_block_is_named_by_a_place(self):
        report = self.verify_model(self.project(self.surfaces("{block: [-300, 0, 0]}", "{block: [300, 0, 0]}"),
                                                self.COLUMN + "rules: {fault_blocks: true}\n"))
        self.assertEqual([w for w in report["warnings"] if "domain" in str(w)], [])

    def test_a_sequence_ends_at_an_unconformity(self):
        tilted = self.field("tilted.npy", lambda x, y, z: z - 0.4 * x)
        level = self.field("level.npy", lambda x, y, z: z)
        project = self.project([level + ", name: unconformity, kind: horizon, value: 0",
                                tilted + ", name: old, kind: horizon, value: 0, domain: {below: unconformity}"],
                               "column: [young, unconformity, middle, old, bottom]\nmesh: {size: 100}\n")
        volumes, _ = self.volumes(project)
        self.assertAlmostEqual(volumes["young"] / 5e8, 1, delta=1e-6)
        self.assertAlmostEqual(volumes["middle"] / 5e7, 1, delta=1e-3)  # a wedge: 500 x 200 / 2 x 1000

    def test_doubts_outside_of_the_domain_are_not_reported(self):
        """Two sheets 0.4 m apart, above an unconformity below which the field holds."""
        def f(x, y, z):
            return numpy.where((abs(z - 300) < 1) & (abs(x) < 30) & (abs(y) < 30), -0.01, numpy.where(z > 200, 1, (z + 300) / 300))
        kinked, level = self.field("kinked.npy", f), self.field("level.npy", lambda x, y, z: z)
        surfaces = [level + ", name: unconformity, kind: horizon, value: 50", kinked + ", name: old, kind: horizon, value: 0"]
        _, report = self.volumes(self.project(surfaces, "mesh: {refine: none}\n"))
        self.assertTrue([w for w in report["warnings"] if "sheets nearer" in str(w)])
        surfaces[1] += ", domain: {below: unconformity}"
        _, report = self.volumes(self.project(surfaces, "mesh: {refine: none}\n"))
        self.assertEqual([w for w in report["warnings"] if "sheets nearer" in str(w)], [])

    def test_mistakes_in_domains_are_refused(self):
        def refused(west, east, *words, status=USAGE):
            printed = self.run_program(self.project(self.surfaces(west, east), self.COLUMN), status=status)
            for word in words:
                self.assertIn(word, printed)
        refused("{above: falut}", "{below: fault}", "'falut'", "was 'fault' meant?")
        refused("{above: fault}", "{above: fault}", "overlap")
        refused("{above: fault, below: fault}", "{below: fault}", "both above and below 'fault'")
        refused("{abov: fault}", "{below: fault}", "was 'above' meant?")
        refused("{below: fault}", "{above: fault}, extend: flat", "belongs to the first entry of 'top'")
        refused("{block: [0, 0, 900]}", "{below: fault}", "overlap")
        refused("{block: [300, 0, 0]}", "{block: [310, 0, 0]}", "one block", status=BAD_INPUT)


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

    SQUARES = [[(2, 2, 5), (8, 2, 5), (8, 8, 5), (2, 8, 5)], [(5, 3, 2), (5, 7, 2), (5, 7, 8), (5, 3, 8)]]

    def verify_squares(self, name):
        report = self.mesh("{file: %s}" % name, "mesh: {size: 2}\n")
        areas = sorted(s["area"] for s in report["surfaces"] if s["kind"] == "fault")
        self.assertEqual(len(areas), 2, name)
        self.assertAlmostEqual(areas[0], 24, delta=24e-9, msg=name)
        self.assertAlmostEqual(areas[1], 36, delta=36e-9, msg=name)
        fractures = {s["name"] for s in report["surfaces"] if s["kind"] == "fault"}
        lengths = [c["length"] for c in report["curves"] if set(c["name"].split("*")) == fractures]
        self.assertEqual(len(lengths), 1, name)
        self.assertAlmostEqual(lengths[0], 4, delta=1e-9, msg=name)

    def test_fractures_of_other_programs_are_surfaces_and_polygons(self):
        corners = [" ".join("%g %g %g," % p for p in square + square[:1]).rstrip(",") for square in self.SQUARES]
        self.write("squares.wkt", "".join("POLYGON Z ((%s))\n" % text for text in corners))
        self.write("squares.ts", "".join(
            "GOCAD TSurf 1\nHEADER {\nname: F%d\n}\nTFACE\n%sTRGL 1 2 3\nTRGL 1 3 4\nEND\n" %
            (i, "".join("VRTX %d %g %g %g\n" % ((k + 1,) + p) for k, p in enumerate(square))) for i, square in enumerate(self.SQUARES)))
        faces = "".join("0\n3DFACE\n8\nF%d\n%s" % (i, "".join("1%d\n%g\n2%d\n%g\n3%d\n%g\n" % (k, p[0], k, p[1], k, p[2])
                                                          for k, p in enumerate(square))) for i, square in enumerate(self.SQUARES))
        self.write("squares.dxf", "0\nSECTION\n2\nENTITIES\n%s0\nENDSEC\n0\nEOF\n" % faces)
        for name in ("squares.wkt", "squares.ts", "squares.dxf"):
            self.verify_squares(name)

    @unittest.skipIf(ogr is None, "skipped: the Python package osgeo is not installed")
    def test_fractures_come_from_a_shapefile(self):
        out = ogr.GetDriverByName("ESRI Shapefile").CreateDataSource(self.path("squares.shp"))
        layer = out.CreateLayer("squares", geom_type=ogr.wkbPolygon25D)
        for square in self.SQUARES:
            feature = ogr.Feature(layer.GetLayerDefn())
            feature.SetGeometry(ogr.CreateGeometryFromWkt("POLYGON Z ((%s))" % ", ".join("%g %g %g" % p for p in square + square[:1])))
            layer.CreateFeature(feature)
        del layer, out
        self.verify_squares("squares.shp")

    def test_surfaces_that_are_no_fractures_are_refused(self):
        bent = "GOCAD TSurf 1\nHEADER {\nname: bent\n}\nTFACE\nVRTX 1 2 2 5\nVRTX 2 8 2 5\nVRTX 3 8 8 7\nVRTX 4 2 8 5\nTRGL 1 2 3\nTRGL 1 3 4\nEND\n"
        self.write("bent.ts", bent)
        self.write("line.pl", "GOCAD PLine 1\nHEADER {\nname: open\n}\nILINE\nVRTX 1 2 2 5\nVRTX 2 8 2 5\nVRTX 3 8 8 5\nSEG 1 2\nSEG 2 3\nEND\n")
        for name, words in (("bent.ts", ("fracture bent", "not plane")), ("line.pl", ("fracture open", "not closed"))):
            printed = self.run_program(self.write("bad.yaml", "box: {min: [0, 0, 0], max: [10, 10, 10]}\n"
                                                  "fractures: {file: %s}\n" % name), status=BAD_INPUT)
            for word in words:
                self.assertIn(word, printed)

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
