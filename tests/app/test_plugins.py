#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""GeoTIFF is read by a module that is loaded at need: where it is sought, and what is said where there is none."""
import os
import shutil
import struct
import subprocess
import unittest

from geomesh_program import DONE, PROGRAM, USAGE, ProgramTest

MODULE = os.path.join(os.path.dirname(PROGRAM), "geomesh-gdal.so")


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

    def test_the_program_itself_needs_no_gdal(self):
        libraries = subprocess.run(["ldd", PROGRAM], stdout=subprocess.PIPE, text=True).stdout
        self.assertIn("libstdc++", libraries)
        self.assertNotIn("libgdal", libraries)


if __name__ == "__main__":
    unittest.main()
