#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Inputs as other programs write them: grids in netCDF and HDF5."""
import math
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


if __name__ == "__main__":
    main()
