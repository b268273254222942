#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Inputs as other programs write them: grids in netCDF and HDF5, sticks of faults, lines of map programs."""
import json
import math
import os
import shutil
import subprocess
import unittest

from geomesh_program import BAD_INPUT, ProgramTest, has_module, main

try:
    import netCDF4
    import h5py
    import numpy
except ImportError:
    netCDF4 = None

X0, Y0, NX, NY, STEP = 430000.0, 5800000.0, 13, 11, 500.0


def height(x, y):
    return -1000 + 40 * math.sin((x - X0) / 1900) + 0.01 * (y - Y0)


@unittest.skipUnless(netCDF4 and has_module("exodus"), "skipped: built without netCDF, or python3-netcdf4 and python3-h5py are not installed")
class Grids(ProgramTest):
    """One grid of 13 by 11 nodes in the forms in which programs write it."""

    def setUp(self):
        super().setUp()
        self.x, self.y = X0 + STEP * numpy.arange(NX), Y0 + STEP * numpy.arange(NY)
        self.z = numpy.array([[height(x, y) for x in self.x] for y in self.y])

    def dataset(self, name, kind="NETCDF4", x="x", y="y"):
        data = netCDF4.Dataset(self.path(name), "w", format=kind)
        data.createDimension(x, NX)
        data.createDimension(y, NY)
        for axis, values in ((x, self.x), (y, self.y)):
            data.createVariable(axis, "f8", (axis,))[:] = values
        return data

    def understood(self, name, surface, *words):
        """What `info` says, and the bounds of the one surface that it found, which are those of the grid."""
        report = self.path("info.json")
        printed = self.run_program("info", self.path(name), "--report", report)
        for word in words:
            self.assertIn(word, printed)
        found = self.report(report)["surfaces"]
        self.assertEqual([s["name"] for s in found], [surface])
        self.assertEqual((found[0]["points"], found[0]["triangles"]), (NX * NY, 2 * (NX - 1) * (NY - 1)))
        for got, wanted in zip(found[0]["bounds"]["min"] + found[0]["bounds"]["max"],
                               (X0, Y0, self.z.min(), self.x[-1], self.y[-1], self.z.max())):
            self.assertAlmostEqual(got, wanted, delta=1e-6 * abs(wanted))
        return printed

    def test_gmt_classic_and_netcdf_4(self):
        for kind in ("NETCDF3_CLASSIC", "NETCDF3_64BIT_OFFSET", "NETCDF4"):
            with self.subTest(kind), self.dataset("top.nc", kind) as data:
                data.Conventions = "CF-1.7"
                data.createVariable("z", "f8", ("y", "x"))[:] = self.z
            self.understood("top.nc", "z", "13 columns, 11 rows, spacing 500 by 500")

    def test_depth_in_feet_packed_from_the_north_with_a_time_of_one(self):
        """Everything at once that CF allows: a leading axis of one, rows from the north, scale and offset, feet, down, and a system."""
        with self.dataset("cf.nc") as data:
            data.createDimension("time", 1)
            data.variables["y"][:] = self.y[::-1]
            data.createVariable("crs", "i4").crs_wkt = 'PROJCRS["ETRS89 / UTM zone 32N",BASEGEOGCRS["ETRS89",ID["EPSG",4258]],ID["EPSG",25832]]'
            v = data.createVariable("tops", "i4", ("time", "y", "x"), fill_value=-2147483648)
            v.set_auto_maskandscale(False)
            v.setncatts({"units": "ft", "positive": "down", "scale_factor": 0.001, "add_offset": 100.0, "grid_mapping": "crs"})
            v[0] = numpy.round((-self.z[::-1] / 0.3048 - 100) * 1000)
        self.understood("cf.nc", "tops", "epsg:25832", "z is depth in the file", "from ft to m")

    def test_nodes_without_a_value(self):
        holes = self.z.copy()
        holes[4, 5:8] = -9999
        with self.dataset("holes.nc") as data:
            v = data.createVariable("z", "f4", ("y", "x"), fill_value=-9999)
            v.set_auto_mask(False)
            v[:] = holes
        self.assertIn("3 without a value", self.run_program("info", self.path("holes.nc")))

    def test_longitude_and_latitude_over_both_axes(self):
        with netCDF4.Dataset(self.path("curved.nc"), "w") as data:
            data.createDimension("i", NX)
            data.createDimension("j", NY)
            for name, unit, values in (("lon", "degrees_east", 8 + 0.01 * numpy.add.outer(numpy.arange(NY) * 0.1, numpy.arange(NX))),
                                       ("lat", "degrees_north", 52 + 0.01 * numpy.add.outer(numpy.arange(NY), numpy.arange(NX) * 0.1))):
                v = data.createVariable(name, "f8", ("j", "i"))
                v.units = unit
                v[:] = values
            v = data.createVariable("depth", "f8", ("j", "i"))
            v.setncatts({"coordinates": "lon lat", "units": "m"})
            v[:] = -self.z
        printed = self.run_program("info", self.path("curved.nc"))
        self.assertIn("x 8 to 8.13", printed)
        self.assertIn("z is depth in the file", printed)

    def test_hdf5_without_axes_takes_the_places_of_their_names(self):
        with h5py.File(self.path("plain.h5"), "w") as file:
            group = file.create_group("horizons")
            group["easting"], group["northing"] = self.x, self.y
            group.create_dataset("top", data=self.z, compression="gzip")
        self.understood("plain.h5", "horizons/top", "HDF5")

    def test_several_variables_and_those_that_are_no_heights(self):
        with self.dataset("many.nc") as data:
            for name, unit in (("top", "m"), ("base", "m"), ("temperature", "K")):
                v = data.createVariable(name, "f8", ("y", "x"))
                v.units = unit
                v[:] = self.z - (300 if name == "base" else 0)
            data.createDimension("level", 4)
            data.createVariable("cube", "f8", ("level", "y", "x"))[:] = 0
        printed = self.run_program("info", self.path("many.nc"))
        for words in ("surface top", "surface base", "passed over", "temperature (in K)", "cube (3 axes)"):
            self.assertIn(words, printed)
        project = self.write("model.yaml", "name: model\nbox: {min: [430000, 5800000, -2500], max: [436000, 5805000, 0]}\nsurfaces:\n"
                             "  - {name: a, kind: horizon, file: many.nc, object: top}\n  - {name: base, kind: horizon, file: many.nc}\n"
                             "column: [upper, a, middle, base, lower]\n")
        self.assertIn("all 3 units of the column have regions", self.run_program(project))

    def test_what_holds_no_grid_is_said_and_damage_is_refused(self):
        with h5py.File(self.path("none.h5"), "w") as file:
            file["array"] = self.z
        printed = self.run_program("info", self.path("none.h5"), status=BAD_INPUT)
        self.assertIn("holds no grid of heights", printed)
        self.assertIn("array (no variables give x and y along its axes)", printed)
        for kind in ("NETCDF3_CLASSIC", "NETCDF4"):
            with self.dataset("top.nc", kind) as data:
                data.createVariable("z", "f8", ("y", "x"))[:] = self.z
            with open(self.path("top.nc"), "rb") as file:
                bytes_there = file.read()
            self.write("cut.nc", bytes_there[:len(bytes_there) // 2])
            self.assertIn("damaged", self.run_program("info", self.path("cut.nc"), status=BAD_INPUT))


def stick(k):
    """Six points down a fault that dips to the east and swings along the strike."""
    x, y = X0 + 1500 + 60 * math.sin(k), Y0 + 600 * k
    return [(x + 180 * i, y, 100 - 450.0 * i) for i in range(6)]


STICKS = [stick(k) for k in range(9)]
SHUFFLED = [STICKS[k][::-1 if k % 2 else 1] for k in (4, 0, 8, 2, 6, 1, 7, 3, 5)]  # in any order, and either way


def pline(name, lines):
    text, n = "GOCAD PLine 1\nHEADER {\nname:%s\n}\n" % name, 0
    for line in lines:
        text += "ILINE\n" + "".join("VRTX %d %.3f %.3f %.3f\n" % (n + i + 1, *p) for i, p in enumerate(line))
        text += "".join("SEG %d %d\n" % (n + i, n + i + 1) for i in range(1, len(line)))
        n += len(line)
    return text + "END\n"


def charisma(name, lines):
    return "".join("INLINE- %7d %7d %14.3f %14.3f %12.3f %s %d\n" % (100 + k, 200 + i, *p, name, k + 1)
                   for k, line in enumerate(lines) for i, p in enumerate(line))


def table(lines, head="x,y,z,stick\n"):
    return head + "".join("%.3f,%.3f,%.3f,%d\n" % (*p, k) for k, line in enumerate(lines) for p in line)


def segments(lines):
    return "".join("> -L%d\n" % k + "".join("%.3f %.3f %.3f\n" % p for p in line) for k, line in enumerate(lines))


class Sticks(ProgramTest):
    """A fault of nine sticks, as programs write them, becomes the surface between them."""

    bare = False
    BOX = "box: {min: [430000, 5800000, -2000], max: [434000, 5804800, 0]}\n"

    def project(self, *entries, more="mesh: {refine: none}\n"):
        return self.write("model.yaml", "name: model\n" + self.BOX + "surfaces:\n" + "".join("  - {%s}\n" % e for e in entries) + more)

    def fault_of(self, entry, **more):
        """The report of the box with this fault."""
        printed = self.run_program(self.project(entry, **more), "--verbose", "-o", self.folder)
        return self.report(self.path("model.report.json")), printed

    def test_every_form_gives_the_surface_that_passes_through_all_points(self):
        forms = {"a.pl": pline("F1", SHUFFLED), "a.txt": charisma("F 1", SHUFFLED), "a.csv": table(SHUFFLED), "b.txt": segments(SHUFFLED)}
        west = sum(600 * 2000 * (1500 + 440 + 30 * (math.sin(k) + math.sin(k + 1))) for k in range(8))  # plane between two sticks
        for name, text in forms.items():
            self.write(name, text)
            with self.subTest(name):
                report, printed = self.fault_of("name: fault, kind: fault, file: %s" % name)
                self.assertIn("fault: surface made between 9 lines, which it passes through", printed)
                self.assertEqual(sorted(r["name"] for r in report["regions"]), ["region_1", "region_2"])
                self.assertNotIn("folds", printed)
                self.assertEqual(report["input"]["surfaces"][0]["triangles"], 80)
                volumes = sorted(r["volume"] for r in report["regions"])
                self.assertAlmostEqual(volumes[0] / west, 1, delta=1e-6)
                self.assertAlmostEqual(sum(volumes) / (4000 * 4800 * 2000), 1, delta=1e-9)

    def test_gridded_where_that_is_asked_for(self):
        self.write("a.csv", table(STICKS))
        _, printed = self.fault_of("name: fault, kind: fault, file: a.csv, gridding: {smoothing: 100}")
        self.assertIn("thin plate", printed)

    def test_sticks_that_cross_are_told(self):
        crossed = STICKS[:3] + [[(x, y + 1500 - 0.9 * 1500 * i / 2.5, z) for i, (x, y, z) in enumerate(STICKS[3])]] + STICKS[4:]
        self.write("a.csv", table(crossed))
        printed = self.run_program(self.project("name: fault, kind: fault, file: a.csv"), "-o", self.folder, status=None)
        self.assertRegex(printed, r"fault: its lines cross or double back near .* the surface folds at \d+ triangles; gridding: .smoothing: L.")

    def test_gaps_that_are_left_open(self):
        self.write("a.csv", table(STICKS[:4] + STICKS[6:]))
        _, printed = self.fault_of("name: fault, kind: fault, file: a.csv, gridding: {max_distance: 1000}")
        self.assertIn("1 gaps between its lines are wider than gridding.max_distance", printed)

    def test_columns_that_the_project_names_and_faults_of_one_table(self):
        rows = ["%d;%s;%d;%.2f;%.2f;%.2f\n" % (7, name, k, x + shift, y, -z) for name, shift in (("east", 1200), ("west", 0))
                for k, line in enumerate(STICKS) for x, y, z in line]
        self.write("a.csv", "survey;fault;no;R;H;T\n" + "".join(rows))
        columns = "columns: {fault: fault, stick: no, x: R, y: H, depth: T}"
        report, _ = self.fault_of('name: f, kind: fault, file: a.csv, object: "*", %s' % columns)
        self.assertEqual([s["name"] for s in report["input"]["surfaces"][:2]], ["f.east", "f.west"])
        self.assertEqual(len(report["regions"]), 3)

    def test_what_is_no_stick_is_said(self):
        self.write("one.pl", pline("F1", STICKS[:1]))
        self.assertIn("made between two lines or more", self.run_program(self.project("name: f, kind: fault, file: one.pl"), status=BAD_INPUT))
        self.write("map.pl", pline("F1", [[(x, y, 0) for x, y, _ in line] for line in STICKS]))
        self.assertIn("all lie at height 0, as traces on a map do", self.run_program(self.project("name: f, kind: fault, file: map.pl"), status=BAD_INPUT))

    def test_contours_become_a_horizon(self):
        """Lines of one height each, of a plane that falls to the east."""
        lines = [[(X0 - 500 + 1000 * k, Y0 - 500 + 500 * j, -600.0 - 100 * k) for j in range(13)] for k in range(6)]
        self.write("contours.pl", pline("top", lines))
        report, _ = self.fault_of("name: top, kind: horizon, file: contours.pl", more="column: [a, top, b]\nmesh: {refine: none}\n")
        volumes = {r["name"]: r["volume"] for r in report["regions"]}
        self.assertAlmostEqual(volumes["a"] / (4000 * 4800 * (650 + 200)), 1, delta=1e-6)


@unittest.skipUnless(has_module("gdal") and shutil.which("ogr2ogr"), "skipped: built without GDAL, or gdal-bin is not installed")
class MapPrograms(ProgramTest):
    """Shapefile, GeoPackage and GeoJSON."""

    bare = False

    def convert(self, name, features, **collection):
        """The features in all three formats: files NAME.geojson, NAME.shp, NAME.gpkg."""
        text = json.dumps({"type": "FeatureCollection", **collection, "features": [
            {"type": "Feature", "properties": properties, "geometry": {"type": kind, "coordinates": coordinates}} for kind, coordinates, properties in features]})
        source = self.write(name + ".geojson", text)
        for ending, driver in ((".shp", "ESRI Shapefile"), (".gpkg", "GPKG")):
            subprocess.run(["ogr2ogr", "-f", driver, "-a_srs", "EPSG:25832", self.path(name + ending), source], check=True, capture_output=True)
        return [name + ".shp", name + ".gpkg"]

    def test_sticks_with_heights(self):
        for file in self.convert("f", [("LineString", line, {"fault": "F1", "no": k}) for k, line in enumerate(SHUFFLED)]):
            with self.subTest(file):
                self.assertIn("epsg:25832", self.run_program("info", self.path(file)).lower())
                printed = self.run_program(self.write("model.yaml", "name: model\n" + Sticks.BOX + "surfaces:\n"
                                                      "  - {name: F1, kind: fault, file: %s}\nmesh: {refine: none}\n" % file), "-v", "-o", self.folder)
                self.assertIn("surface made between 9 lines", printed)
                self.assertEqual(len(self.report(self.path("model.report.json"))["regions"]), 2)

    def test_contours_take_their_heights_from_a_column(self):
        lines = [("LineString", [[X0 - 500 + 1000 * k, Y0 - 500 + 500 * j] for j in range(13)], {"ELEV": -600.0 - 100 * k}) for k in range(6)]
        for file in self.convert("contours", lines):
            with self.subTest(file):
                self.assertIn("heights are those of the column 'ELEV'", self.run_program("info", self.path(file)))
                self.run_program(self.write("model.yaml", "name: model\n" + Sticks.BOX + "surfaces:\n  - {name: top, kind: horizon, file: %s}\n"
                                            "column: [a, top, b]\nmesh: {refine: none}\n" % file), "-o", self.folder)
                volumes = {r["name"]: r["volume"] for r in self.report(self.path("model.report.json"))["regions"]}
                self.assertAlmostEqual(volumes["a"] / (4000 * 4800 * (650 + 200)), 1, delta=1e-6)

    def test_points_and_polygons(self):
        points = [("Point", [X0 + 500 * i, Y0 + 500 * j, -700 - 10.0 * i * j], {"horizon": "top"}) for i in range(9) for j in range(10)]
        ring = [[X0, Y0], [X0 + 100, Y0], [X0 + 100, Y0 + 900], [X0, Y0 + 900], [X0, Y0]]
        for file in self.convert("p", points):
            self.assertRegex(self.run_program("info", self.path(file)), "(points|surface) top")
        for file in self.convert("polygon", [("Polygon", [ring], {"name": "gap"})]):
            printed = self.run_program("info", self.path(file))
            self.assertIn("polyline gap: 5 points", printed)
            self.assertIn("have no heights", printed)

    def test_a_shapefile_without_its_index_names_the_files_that_belong_together(self):
        self.convert("f", [("LineString", line, {}) for line in STICKS])
        os.remove(self.path("f.shx"))
        self.assertIn("(.shp, .shx, .dbf, .prj) belong together", self.run_program("info", self.path("f.shp"), status=BAD_INPUT))

    def test_nothing_is_written_beside_the_files_and_damage_is_refused(self):
        self.convert("f", [("LineString", line, {}) for line in STICKS])
        for file in ("f.shp", "f.gpkg"):
            with open(self.path(file), "rb") as data:
                content = data.read()
            with open(self.path("cut" + os.path.splitext(file)[1]), "wb") as data:
                data.write(content[:120])
        before = sorted(os.listdir(self.folder))
        for file in ("f.shp", "f.gpkg", "f.geojson"):
            self.run_program("info", self.path(file))
        for file in ("cut.shp", "cut.gpkg"):
            self.assertRegex(self.run_program("info", self.path(file), status=BAD_INPUT), "cannot be read|holds no lines|belong together")
        self.assertEqual(sorted(os.listdir(self.folder)), before)


if __name__ == "__main__":
    main()
