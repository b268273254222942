#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""`geomesh picture` draws what it is asked for. Skipped, saying so, where the drawing program or a display is absent."""
import os
import re
import shutil
import struct
import unittest
import zlib

from geomesh_program import BAD_INPUT, PROGRAM, SOURCE, USAGE, ProgramTest


def kept_mesh():
    with open(os.path.join(SOURCE, "tests", "corpus", "bytes", "mesh_two_tetrahedra.vtu")) as file:
        return file.read()


def pixels(path):
    """Width, height and the set of colours of an 8-bit RGB picture."""
    with open(path, "rb") as file:
        data = file.read()
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    at, packed, width, height = 8, b"", 0, 0
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, depth, colour = struct.unpack(">IIBB", body[:10])
            assert (depth, colour) == (8, 2)
        if kind == b"IDAT":
            packed += body
        at += 12 + length
    rows, stride, last, out = zlib.decompress(packed), 3 * width, bytes(3 * width), []
    for y in range(height):
        kind, row = rows[y * (stride + 1)], bytearray(rows[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride):
            left, up, corner = (row[i - 3] if i >= 3 else 0), last[i], (last[i - 3] if i >= 3 else 0)
            if kind == 1:
                add = left
            elif kind == 2:
                add = up
            elif kind == 3:
                add = (left + up) // 2
            elif kind == 4:
                guess = left + up - corner
                add = min((left, up, corner), key=lambda v: abs(guess - v))
            else:
                add = 0
            row[i] = (row[i] + add) & 255
        last = bytes(row)
        out.append(last)
    return width, height, out


def share_of_background(rows):
    n = white = 0
    for row in rows:
        for i in range(0, len(row), 3):
            n += 1
            white += row[i:i + 3] == b"\xff\xff\xff"
    return white / n


class Picture(ProgramTest):
    def setUp(self):
        super().setUp()
        if not os.path.exists(os.path.join(os.path.dirname(PROGRAM), "geomesh-picture")):
            self.skipTest("skipped: no geomesh-picture beside the program (VTK without rendering)")

    def needs_display(self):
        if not os.environ.get("DISPLAY") and not shutil.which("xvfb-run"):
            self.skipTest("skipped: no display and no xvfb-run")

    def test_every_view_of_a_project_fills_a_good_part_of_the_picture_in_the_size_asked_for(self):
        self.needs_display()
        self.run_program(self.sample("salt-dome"), "-o", self.path("out"), "--quiet")
        seen = {}
        for view in ("regions", "cut", "elements", "exploded", "surfaces", "quality"):
            file = self.path(view + ".png")
            self.run_program("picture", self.path("out", "salt_dome.vtu"), "-o", file, "--view", view, "--size", "320x240", "--no-legend")
            width, height, rows = pixels(file)
            self.assertEqual((width, height), (320, 240))
            self.assertLess(share_of_background(rows), 0.9, view)
            self.assertGreater(share_of_background(rows), 0.1, view)
            seen[view] = b"".join(rows)
        self.assertEqual(len(set(seen.values())), 6, "each view shows something else")

    def test_a_project_is_meshed_for_its_picture_and_leaves_nothing_else(self):
        self.needs_display()
        self.run_program("picture", self.sample("layer-cake"), "-o", self.path("cake.png"), "--size=200x150", "--no-edges")
        self.assertEqual(os.listdir(self.folder), ["cake.png"])

    def flat_model(self, more=""):
        """Two units in a box of 1000 by 1000 by 60."""
        rows = "".join("VRTX %d %d %d -30\n" % (1 + 2 * j + i, 1000 * i, 1000 * j) for j in range(2) for i in range(2))
        self.write("mid.ts", "GOCAD TSurf 1\nHEADER {\nname:mid\n}\nTFACE\n" + rows + "TRGL 1 2 4\nTRGL 1 4 3\nEND\n")
        self.write("flat.yaml", "box: {min: [0, 0, -60], max: [1000, 1000, 0]}\nsurfaces: [{name: mid, kind: horizon, file: mid.ts}]\n"
                   "column: [upper, mid, lower]\noutput: {directory: ., formats: [vtu]}\n" + more)
        self.run_program("flat.yaml", "--quiet")
        return self.path("flat.vtu")

    def test_heights_of_a_flat_model_are_drawn_larger_and_told(self):
        self.needs_display()
        mesh, shares = self.flat_model(), []
        for options, told in (([], True), (["--scale-z", "1"], False)):
            printed = self.run_program("picture", mesh, "-o", "flat.png", "--size=320x240", "--no-legend", "--view=regions", "--elevation=10", *options)
            self.assertEqual("heights are drawn 5 times" in printed, told, printed)
            shares.append(1 - share_of_background(pixels(self.path("flat.png"))[2]))
        self.assertGreater(shares[0], 1.5 * shares[1])

    def test_colours_of_the_project_are_those_of_the_picture(self):
        self.needs_display()
        mesh = self.flat_model('colours: {upper: "#ff0000"}\n')
        self.run_program("picture", mesh, "-o", "red.png", "--size=320x240", "--no-legend", "--no-edges", "--view=regions")
        rows = pixels(self.path("red.png"))[2]
        red = sum(row[i] > 80 and row[i + 1] < 20 and row[i + 2] < 20 for row in rows for i in range(0, len(row), 3))
        self.assertGreater(red / sum(len(row) / 3 for row in rows), 0.05)

    def test_a_wrong_view_and_a_missing_mesh_are_refused_by_name(self):
        self.needs_display()
        self.write("good.vtu", kept_mesh())
        self.assertIn("--view", self.run_program("picture", "good.vtu", "-o", "x.png", "--view", "inside", status=USAGE))
        self.assertIn("no such file", self.run_program("picture", "nothing.vtu", "-o", "x.png", status=USAGE))

    def test_damaged_files_are_refused_before_anything_is_drawn(self):
        """VTK followed a null pointer, or the rows of points that are not there."""
        self.needs_display()
        whole = kept_mesh()
        cells = '<CellData><DataArray type="Int32" Name="a" format="ascii">%s</DataArray></CellData></Piece>'
        self.run_program("picture", self.write("good.vtu", whole), "-o", "x.png", "--size=100x100")
        for bad in (whole.replace("0 1 2 3", "0 1 2 99"), re.sub("<CellData>.*</CellData>", "", whole, flags=re.S).replace("</Piece>", cells % "q 1"), ""):
            self.assertNotEqual(bad, whole)
            self.run_program("picture", self.write("bad.vtu", bad), "-o", "bad.png", status=BAD_INPUT)
        self.write("good.faces.vtp", "<VTKFile")
        self.run_program("picture", "good.vtu", "-o", "bad.png", status=BAD_INPUT)
        self.assertFalse(os.path.exists(self.path("bad.png")))

    def test_help_needs_no_display(self):
        self.assertIn("exploded", self.run_program("picture", "--help"))


if __name__ == "__main__":
    unittest.main()
