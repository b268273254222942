#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Modules that are loaded at need: where they are sought, and what is said where there is none."""
import os
import shutil
import struct
import subprocess
import unittest

from geomesh_program import DONE, PROGRAM, SLOWNESS, USAGE, ProgramTest

MODULE = os.path.join(os.path.dirname(PROGRAM), "geomesh-gdal.so")

CUBE = ("OFF\n8 12 0\n0 0 0\n10 0 0\n10 10 0\n0 10 0\n0 0 10\n10 0 10\n10 10 10\n0 10 10\n3 0 2 1\n3 0 3 2\n3 4 5 6\n3 4 6 7\n3 0 1 5\n3 0 5 4\n"
        "3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n3 3 0 4\n3 3 4 7\n")


def geotiff(heights, x, y, step):
    """A TIFF of one strip of doubles from the north, its first cell's corner at (x, y), without a system."""
    rows, columns = len(heights), len(heights[0])
    data = struct.pack("<3d", step, step, 0) + struct.pack("<6d", 0, 0, 0, x, y, 0)
    at = 8 + 2 + 12 * 10 + 4
    tags = [(256, 3, 1, columns), (257, 3, 1, rows), (258, 3, 1, 64), (259, 3, 1, 1), (262, 3, 1, 1), (273, 4, 1, at + len(data)),
            (279, 4, 1, 8 * rows * columns), (339, 3, 1, 3), (33550, 12, 3, at), (33922, 12, 6, at + 24)]
    directory = struct.pack("<H", len(tags)) + b"".join(struct.pack("<HHII", *tag) for tag in tags) + struct.pack("<I", 0)
    return b"II*\0" + struct.pack("<I", 8) + directory + data + b"".join(struct.pack("<%dd" % columns, *row) for row in heights)


@unittest.skipUnless(os.path.exists(MODULE), "skipped: built without GDAL")
class Plugins(ProgramTest):
    def setUp(self):
        super().setUp()
        self.raster = self.write("top.tif", geotiff([[10 * i + j for j in range(4)] for i in range(3)], 500, 900, 100))
        self.alone = self.path("alone", "geomesh")
        os.makedirs(os.path.dirname(self.alone))
        shutil.copy2(PROGRAM, self.alone)

    def info(self, program, **environment):
        done = subprocess.run([program, "info", self.raster], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                              env={**os.environ, **environment}, timeout=self.timeout)
        return done.returncode, done.stdout

    def test_a_module_beside_the_program_reads_a_geotiff(self):
        status, said = self.info(PROGRAM)
        self.assertEqual(status, DONE, said)
        self.assertIn("GeoTIFF", said)
        self.assertIn("12 points", said)

    def test_a_module_in_a_folder_of_the_environment_is_found(self):
        status, said = self.info(self.alone, GEOMESH_PLUGINS=self.path("nowhere") + ":" + os.path.dirname(MODULE))
        self.assertEqual(status, DONE, said)
        self.assertIn("GeoTIFF", said)

    def test_a_module_in_the_libraries_of_the_same_prefix_is_found(self):
        folder = os.path.dirname(os.path.dirname(self.alone))
        for lib in ("lib", "lib64", os.path.join("lib", "x86_64-linux-gnu")):
            os.makedirs(os.path.join(folder, lib, "geomesh"), exist_ok=True)
            shutil.copy2(MODULE, os.path.join(folder, lib, "geomesh"))
        status, said = self.info(self.alone)
        self.assertEqual(status, DONE, said)

    def test_without_the_module_the_message_names_the_package_and_where_it_was_sought(self):
        status, said = self.info(self.alone, GEOMESH_PLUGINS=self.path("nowhere"))
        if status == DONE:
            self.skipTest("skipped: a module of an installed geomesh is found")
        self.assertEqual(status, USAGE, said)
        self.assertIn("geomesh-gdal", said)
        self.assertIn(self.path("nowhere"), said)

    def test_a_file_that_is_no_module_is_named_with_the_reason(self):
        os.makedirs(self.path("broken"))
        self.write(os.path.join("broken", "geomesh-gdal.so"), "no library")
        status, said = self.info(self.alone, GEOMESH_PLUGINS=self.path("broken"))
        if status == DONE:
            self.skipTest("skipped: a module of an installed geomesh is found")
        self.assertEqual(status, USAGE, said)
        self.assertIn(self.path("broken", "geomesh-gdal.so") + " cannot be used", said)


class EveryModule(ProgramTest):
    def test_what_needs_a_module_names_it_and_the_package_that_brings_it(self):
        alone = self.path("alone", "geomesh")
        os.makedirs(os.path.dirname(alone))
        shutil.copy2(PROGRAM, alone)
        self.write("cube.off", CUBE)
        self.run_program("mesh", "cube.off", "-o", "cube.vtu")
        self.write("project.yaml", "name: m\ncrs: {horizontal: 'epsg:31467'}\nbox: {min: [0, 0, 0], max: [10, 10, 10]}\n"
                   "surfaces: [{name: top, kind: horizon, file: cube.off, crs: 'epsg:4326'}]\noutput: {directory: ., formats: [vtu]}\n")
        for module, headers, arguments in (("exodus", "libnetcdf-dev", ["convert", "cube.vtu", "-o", "cube.e"]), ("exodus", "libnetcdf-dev", ["check", "is.e"]),
                                           ("med", "libmedc-dev", ["convert", "cube.vtu", "-o", "cube.med"]), ("med", "libmedc-dev", ["check", "is.med"]),
                                           ("xdmf", "libhdf5-dev", ["convert", "cube.vtu", "-o", "cube.xdmf"]),
                                           ("seissol", "libhdf5-dev", ["convert", "cube.vtu", "-o", "cube.puml"]),
                                           ("vtkhdf", "libhdf5-dev", ["convert", "cube.vtu", "-o", "cube.vtkhdf"]), ("proj", "libproj-dev", ["project.yaml"])):
            if arguments[-1].startswith("is."):
                self.write(arguments[-1], "no mesh")
            done = subprocess.run([alone, *arguments], cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=self.timeout)
            if done.returncode == DONE:
                self.skipTest("skipped: a module of an installed geomesh is found")
            self.assertEqual(done.returncode, USAGE, done.stdout)
            self.assertIn("geomesh-%s.so" % module, done.stdout)
            self.assertIn("apt install geomesh-" + module, done.stdout)
            self.assertIn(headers, done.stdout)

    def test_the_program_itself_maps_few_libraries(self):
        """A start is mostly the loader's work: of 86 libraries it took 25 ms."""
        libraries = subprocess.run(["ldd", PROGRAM], stdout=subprocess.PIPE, text=True).stdout
        self.assertIn("libstdc++", libraries)
        for name in ("libgdal", "libvtk", "libproj", "libhdf5", "libnetcdf", "libmed", "libmpi"):
            self.assertNotIn(name, libraries)
        self.assertLessEqual(len(libraries.splitlines()), 20, libraries)

    @unittest.skipIf(SLOWNESS > 1, "skipped: sanitizers start slowly")
    def test_the_program_starts_within_eight_milliseconds(self):
        """Time of the processor, the least of many starts: what else runs on the machine would add to the time on the clock."""
        def start():
            child = os.posix_spawn(PROGRAM, [PROGRAM, "--version"], os.environ, file_actions=[(os.POSIX_SPAWN_OPEN, 1, os.devnull, os.O_WRONLY, 0)])
            _, status, use = os.wait4(child, 0)
            self.assertEqual(status, 0)
            return use.ru_utime + use.ru_stime
        self.assertLess(min(start() for _ in range(50)), 0.008)


if __name__ == "__main__":
    unittest.main()
