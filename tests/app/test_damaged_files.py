# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes and other files that are damaged, or lie about what they hold: a message and the right exit status, no crash, no hang, no memory taken."""
import json
import os
import struct
import zlib

from geomesh_program import BAD_INPUT, SOURCE, USAGE, ProgramTest, box_surface, main, off


CUBE = off(*box_surface((0, 0, 0), (1, 1, 1)))


class DamagedMeshes(ProgramTest):
    """geomesh's own meshes, damaged where VTK's readers crash or ask for all memory."""
    timeout = 60

    def setUp(self):
        super().setUp()
        self.run_program("mesh", self.write("cube.off", CUBE), "-o", "out.vtu")

    def damage(self, name, change):
        with open(self.path(name), "rb") as file:
            content = file.read()
        self.assertNotEqual(change(content), content)
        self.write(name, change(content))
        self.assertIn(name, self.run_program("check", "out.vtu", status=BAD_INPUT))
        self.write(name, content)

    def test_array_without_a_type(self):
        for name in ("out.vtu", "out.faces.vtp"):
            self.damage(name, lambda content: content.replace(b'<DataArray type="Int32"', b'<DataArray tpe="Int32"', 1))

    def test_counts_that_lie(self):
        self.damage("out.vtu", lambda content: content.replace(b'NumberOfPoints="8"', b'NumberOfPoints="99999999999"', 1))

    def test_sizes_of_compressed_blocks_that_lie(self):
        if "address" in os.environ.get("GEOMESH_SANITIZE", ""):
            self.skipTest("skipped: AddressSanitizer ends the program where memory for a block is refused, which is what this test is about")
        def enlarge(content):
            at = content.index(b"_", content.index(b"<AppendedData")) + 1
            return content[:at] + b"\xff" * 7 + content[at + 7:]
        for name in ("out.vtu", "out.faces.vtp"):
            self.damage(name, enlarge)

    def test_truncated_anywhere(self):
        for part in (0.02, 0.3, 0.7):
            self.damage("out.vtu", lambda content: content[:int(part * len(content))])

    def test_surfaces_of_another_mesh(self):
        self.run_program("mesh", self.write("other.off", off(*box_surface((0, 0, 0), (1, 1, 2)))), "-o", "other.vtu")
        for part in (".faces.vtp", ".curves.vtp"):
            with open(self.path("other" + part), "rb") as file:
                other = file.read()
            with open(self.path("out" + part), "rb") as file:
                own = file.read()
            self.write("out" + part, other)
            if own != other:  # a file without points belongs to any mesh
                said = self.run_program("convert", "out.vtu", "-o", "out.msh", status=BAD_INPUT)
                self.assertIn("out" + part, said)
                self.assertIn("not of one run", said)
            self.write("out" + part, own)
        self.run_program("convert", "out.vtu", "-o", "out.msh")

    def test_cells_of_a_legacy_file_that_run_beyond_their_block(self):
        """VTK's reader, which was ours once, wrote beyond its memory (found by fuzz.replay_meshes)."""
        with open(os.path.join(SOURCE, "tests", "corpus", "bytes", "mesh_two_tetrahedra.vtk")) as file:
            whole = file.read()
        self.run_program("check", self.write("whole.vtk", whole))
        for old, new in (("4 0 1 2 3", "40 0 1 2 3"), ("CELLS 2 10", "CELLS 2 9"), ("CELLS 2 10", "CELLS 3 10"), ("CELL_TYPES 2", "CELL_TYPES 1"),
                         ("4 0 2 1 4", "-4 0 2 1 4")):
            self.assertIn(old, whole)
            self.assertIn("damaged", self.run_program("check", self.write("bad.vtk", whole.replace(old, new)), status=BAD_INPUT))
        cells, types = whole[whole.index("CELLS"):whole.index("CELL_TYPES")], whole[whole.index("CELL_TYPES"):whole.index("CELL_DATA")]
        for text in (whole.replace("CELLS 2 10\n4 0", "CELLSx 2 10\n40 0"), whole.replace(types, types + cells.replace("4 0", "40 0")),
                     whole.replace(cells + types, "CELL_TYPES 1\n10\n" + cells), whole.replace("POINTS 5", "POINTS 6148914691236517206"),
                     whole.replace("POINTS", "FIELD f 1\na 1 2 int\n1 x\nPOINTS"), whole.replace("POINTS", "FIELD f 1\na 1 2 what\n1 2\nPOINTS"),
                     whole.replace("POINTS", "FIELD f\nPOINTS"), whole[:whole.index("POINTS")] + "FIELD f 1\na 1 1 short\n99999\n" + whole[whole.index("POINTS"):],
                     whole.replace("SCALARS", "FIELD f 1\na 4 4611686018427387904 double\n" + 200 * "1 " + "SCALARS")):
            self.assertIn("damaged", self.run_program("check", self.write("bad.vtk", text), status=BAD_INPUT))

    def test_legacy_file_that_ends_early(self):
        """What VTK's reader had not read stayed as memory was, and was checked."""
        with open(os.path.join(SOURCE, "tests", "corpus", "bytes", "mesh_two_tetrahedra.vtk")) as file:
            whole = file.read()
        for text in (whole.replace("0 0 -1", "0 0 x"), whole.replace("1 1\n", "1 x\n"), whole.rstrip()[:-1]):
            self.assertNotEqual(text, whole)
            self.assertRegex(self.run_program("check", self.write("bad.vtk", text), status=BAD_INPUT), "damaged")
        # VTK takes what follows the last number that it can read for a keyword, and follows a null pointer.
        early = whole[:whole.index("0 0 -1")] + "0FieldData 2\nkind 1 5 int\n"
        self.assertIn("where a number of its type was expected", self.run_program("check", self.write("bad.vtk", early), status=BAD_INPUT))
        field = "FIELD FieldData 2\ncell_ids 1 2 int\n1 2\nMETADATA\nINFORMATION 0\n\ncells 1 2 string\na b\nc\n"
        self.run_program("check", self.write("good.vtk", whole.replace("POINTS", field + "POINTS")))
        for text in (whole.replace("Version 3.0", "Version 5.1"), whole.replace("Version 3.0", "Version x"), whole.replace("Version 3.0", "Version 7.1"),
                     whole.replace("Version 3.0", "Version 3.x"), whole[2:]):
            self.run_program("check", self.write("bad.vtk", text), status=BAD_INPUT)
        for name in ("mesh_fields_42.vtk", "mesh_fields_binary_51.vtk"):
            self.assertEqual(self.check(os.path.join(SOURCE, "tests", "corpus", "bytes", name))["volume"], 1 / 3)

    def test_element_that_names_no_node(self):
        self.run_program("mesh", "cube.off", "-o", "out.inp")
        with open(self.path("out.inp")) as file:
            lines = file.read().split("\n")
        first = next(i for i, line in enumerate(lines) if "C3D4" in line) + 1
        for word in ("-1", "nan", "1e300", "1.5", "999"):
            fields = lines[first].split(",")
            fields[2] = " " + word
            self.run_program("check", self.write("bad.inp", "\n".join(lines[:first] + [",".join(fields)] + lines[first + 1:])), status=BAD_INPUT)


class DamagedFormats(ProgramTest):
    """What other readers met: sizes that lie, lists that repeat themselves, data out of their order."""
    timeout = 60

    def kept(self, name):
        with open(os.path.join(SOURCE, "tests", "corpus", "bytes", name)) as file:
            return file.read()

    def convert(self, name, text, status=0):
        return self.run_program("convert", self.write(name, text), "-o", "back.msh", status=status)

    def test_pieces_without_an_end(self):
        """The search for names of pieces called itself at each letter, and overran its stack."""
        head = '<VTKFile type="PUnstructuredGrid"><PUnstructuredGrid>'
        for piece in ("<Piece " + "a" * 3000000, '<Piece Source="' + "a" * 300000 + '"/>', "<Piece" * 500000, '<Piece Source="' * 200000):
            self.write("m.pvtu", head + piece + "</PUnstructuredGrid></VTKFile>")
            self.run_program("check", "m.pvtu", status=None)
            self.assertIn(self.last_status, (USAGE, BAD_INPUT), piece[:20])

    def piece(self, name, point, cell, array=""):
        """A tetrahedron whose last point and whose cell have these global numbers."""
        def values(kind, title, text, width=1):
            return '<DataArray type="%s" Name="%s" NumberOfComponents="%d" format="ascii">%s</DataArray>' % (kind, title, width, text)
        self.write(name, '<VTKFile type="UnstructuredGrid" version="0.1"><UnstructuredGrid><Piece NumberOfPoints="4" NumberOfCells="1">'
                   "<PointData>" + values("Int64", "GlobalPointIds", "0 1 2 %d" % point) + "</PointData><CellData>"
                   + values("Int64", "GlobalCellIds", str(cell)) + array + "</CellData><Points>"
                   + values("Float64", "Points", "0 0 0 1 0 0 0 1 0 0 0 %d" % (1 if point == 3 else -1), 3) + "</Points><Cells>"
                   + values("Int64", "connectivity", "0 1 2 3" if point == 3 else "0 2 1 3") + values("Int64", "offsets", "4")
                   + values("UInt8", "types", "10") + "</Cells></Piece></UnstructuredGrid></VTKFile>")

    def pieces(self, *names):
        self.write("m.pvtu", '<VTKFile type="PUnstructuredGrid"><PUnstructuredGrid>%s</PUnstructuredGrid></VTKFile>'
                   % "".join('<Piece Source="%s"/>' % name for name in names))
        return "m.pvtu"

    def test_pieces_with_arrays_of_their_own(self):
        """What one piece has and another lacks was written beyond its end."""
        region = '<DataArray type="Int32" Name="region" format="ascii">1</DataArray>'
        self.piece("b.vtu", 3, 0, region + region.replace("region", "heat"))
        self.piece("a.vtu", 4, 1)
        for names in (("a.vtu", "b.vtu"), ("b.vtu", "a.vtu")):
            self.run_program("convert", self.pieces(*names), "-o", "back.msh")
            self.check(self.path("back.msh"))
        self.assertIn("twice", self.run_program("check", self.pieces("a.vtu", "a.vtu"), status=BAD_INPUT))

    def test_pieces_without_global_numbers_are_put_together_by_place(self):
        """As ParaView writes them; a tetrahedron that is a ghost in one piece is counted in the other alone."""
        ghost = '<DataArray type="UInt8" Name="vtkGhostType" format="ascii">%d</DataArray>'
        for name, point, level in (("a.vtu", 3, 0), ("b.vtu", 4, 0), ("c.vtu", 4, 1)):
            self.piece(name, point, 0, ghost % level)
            with open(self.path(name)) as file:
                text = file.read()
            self.write(name, text.replace("GlobalPointIds", "number").replace("GlobalCellIds", "own"))
        report = self.check(self.path(self.pieces("a.vtu", "b.vtu", "c.vtu")), status=None)
        self.assertEqual((report["tetrahedra"], report["points"]), (2, 5))
        self.assertAlmostEqual(report["volume"], 1 / 3)

    def test_global_numbers_ask_for_no_more_than_there_is(self):
        for point, cell in ((4000000000, 0), (3, 4000000000), (3, -1), (3, 1)):
            self.piece("a.vtu", point, cell)
            self.assertIn("gaps", self.run_program("check", self.pieces("a.vtu"), status=BAD_INPUT))

    def test_data_before_the_cells_they_are_of(self):
        """Arrays shorter than the mesh were read beyond their end."""
        whole = self.kept("mesh_two_tetrahedra.msh")
        for kind in ("Node", "Element"):
            data = '$%sData\n1\n"a"\n1\n0\n3\n0\n1\n0\n$End%sData\n' % (kind, kind)
            self.convert("data.msh", whole.replace("$Nodes", data + "$Nodes", 1))
            with open(self.path("back.msh")) as file:
                self.assertIn("$%sData" % kind, file.read())

    def test_names_beside_a_mesh_that_are_no_names(self):
        for text in ('{"mesh": 5}', '{"mesh": "a.msh", "regions": 7}', '{"mesh": "a.msh", "regions": [{"name": "a", "groups": 3}]}', "[[[["):
            self.write("a.msh.json", text)
            self.convert("a.msh", self.kept("mesh_two_tetrahedra.msh"))

    def test_element_that_breaks_after_two_nodes(self):
        """The first line was read beyond its end (found by scripts/fuzz convert)."""
        places = [(0, 0, 0), (2, 0, 0), (0, 2, 0), (0, 0, 2), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (0, 1, 1)]
        text = "*NODE\n" + "".join("%d, %g, %g, %g\n" % (i + 1, *p) for i, p in enumerate(places)) + "*ELEMENT, TYPE=C3D10, ELSET=rock\n"
        for cut in (1, 3, 6, 10):
            numbers = [str(i) for i in (7, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10)]
            self.convert("broken.inp", text + ", ".join(numbers[:cut]) + ",\n" + ", ".join(numbers[cut:]) + "\n")
            self.assertEqual(self.check(self.path("back.msh"))["regions"][0]["tetrahedra"], 1)

    def test_json_nested_a_million_deep(self):
        """Values are copied and printed by functions that call themselves, which overran their stack."""
        deep = b"[" * 1000000 + b"]" * 1000000
        self.write("a.msh.json", b'{"mesh": "a.msh", "fields": ' + deep + b"}")
        self.convert("a.msh", self.kept("mesh_two_tetrahedra.msh"))
        with open(os.path.join(SOURCE, "tests", "corpus", "bytes", "surface_plane_a.omf"), "rb") as file:
            whole = file.read()
        self.run_program("info", self.write("whole.omf", whole))
        self.run_program("info", self.write("deep.omf", whole.replace(b'"<f8"', deep)), status=None)
        self.assertIn(self.last_status, (0, BAD_INPUT))
        self.run_program("convert", "a.msh", "-o", "a.vtu")
        for text in (b'{"regions": ' + deep + b"}", deep, b'{"regions": [{"name": 5, "volume_of_input": 1}]}'):
            self.write("a.report.json", text)
            self.run_program("check", "a.vtu", status=None)
            self.assertIn(self.last_status, (0, BAD_INPUT))

    def test_sets_of_more_than_there_is(self):
        """Lists of 9e15 elements, and sets that name themselves, each time doubled."""
        whole = self.kept("mesh_two_tetrahedra.inp")
        self.convert("far.inp", whole + "*ELSET, ELSET=far, GENERATE\n2, 9000000000000000\n")
        with open(self.path("back.msh")) as file:
            self.assertIn('"far"', file.read())
        self.convert("own.inp", whole + "*ELSET, ELSET=own\n1\n" + "own\n" * 60)
        self.convert("nodes.inp", whole + "*NSET, NSET=own\n1\n" + "own, own\n" * 60)

    def test_coordinates_that_are_no_numbers(self):
        """`convert` wrote them on. It names the point now; `check` counts them as it did."""
        for name, old, news in (("mesh_two_tetrahedra.inp", "4, 0, 0, 1", ("4, 0, 0, nan", "4, 0, -inf, 1", "4, 1e300, 0, 1")),
                                ("mesh_two_tetrahedra.msh", "4 0 0 1", ("4 0 0 nan", "4 inf 0 1")), ("mesh_tetrahedron.mesh", "\n0 0 1", ("\n0 0 nan", "\n0 1e-300 1"))):
            whole = self.kept(name)
            self.assertIn(old, whole)
            for new in news:
                bad = "bad" + os.path.splitext(name)[1]
                self.write(bad, whole.replace(old, new, 1))
                printed = self.run_program("convert", bad, "-o", "back.msh", status=BAD_INPUT)
                self.assertIn("exact arithmetic" if "e" in new else "finite", printed)
                self.assertIn(bad + ": point 3 of tetrahedron 0", printed)
                self.assertFalse(os.path.exists(self.path("back.msh")))
                if "e" not in new:
                    self.assertIn("not_finite", [fault["id"] for fault in self.check(self.path(bad), status=BAD_INPUT)["faults"]])
        middle = "*NODE\n" + "".join("%d, %s, 0, 0\n" % (i, "nan" if i == 10 else i) for i in range(1, 11)) + "*ELEMENT, TYPE=C3D10\n1, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10\n"
        self.assertIn("point 9 of tetrahedron 0", self.convert("middle.inp", middle, status=BAD_INPUT))

    def test_sets_that_are_named_without_measure(self):
        """A short file that names long sets many times asked for all memory."""
        n, times = 2000, 8000
        whole = self.kept("mesh_two_tetrahedra.inp")
        many = whole + "".join("%d, 1, 2, 3, 4\n" % (i + 3) for i in range(n))
        for lines in ("rock, S1\n" * times, "".join("*SURFACE, NAME=s%d\nrock, S2\n" % i for i in range(times))):
            self.assertIn("ten for each byte", self.convert("sides.inp", many + "*SURFACE, NAME=s\n" + lines, status=BAD_INPUT))
        for lines in ("*ELSET, ELSET=%d\nrock\n", "*NSET, NSET=%d\nall" + ", all" * 400 + "\n", "*NSET, NSET=%d, GENERATE\n" + "1, 5\n" * 400):
            self.convert("sets.inp", many + "".join(lines % i for i in range(20)))
        self.assertIn("ten for each byte", self.convert("sets.inp", many + "".join("*ELSET, ELSET=a%d\nrock\n" % i for i in range(times)), status=BAD_INPUT))
        whole = self.kept("mesh_tetrahedron_41.msh")
        groups, last = " ".join(map(str, range(2, times + 2))), "3 1 4 1\n2 1 2 3 4\n"
        for old in ("1 0 0 0 1 1 1 1 1 1 2", "2 2 1 2\n", last):
            self.assertIn(old, whole)
        whole = whole.replace("1 0 0 0 1 1 1 1 1 1 2", "1 0 0 0 1 1 1 %d %s 1 2" % (times, groups)).replace("2 2 1 2\n", "2 %d 1 %d\n" % (n + 1, n + 1))
        whole = whole.replace(last, "3 1 4 %d\n" % n + "".join("%d 1 2 3 4\n" % (i + 2) for i in range(n)))
        self.assertIn("ten for each byte", self.convert("groups.msh", whole, status=BAD_INPUT))
        self.write("sets.inp.json", json.dumps({"mesh": "sets.inp", "regions": [{"name": "r%d" % i, "id": i, "groups": ["rock"]} for i in range(times)]}))
        self.assertIn("too many times", self.convert("sets.inp", many, status=BAD_INPUT))

    def test_arrays_that_are_named_without_measure(self):
        """One array of 8 MB in 8 kB, as the vertices of one surface after another."""
        array = zlib.compress(bytes(8000000))
        own = "01020304-0506-0708-090a-0b0c0d0e0f10"
        for times, status in ((3, BAD_INPUT), (40, BAD_INPUT)):
            objects = {own: {"__class__": "Project", "elements": ["e"] * times, "origin": [0, 0, 0], "units": "m"},
                       "e": {"__class__": "PointSetElement", "name": "points", "geometry": "g"}, "g": {"__class__": "PointSetGeometry", "vertices": "v"},
                       "v": {"__class__": "Vector3Array", "array": {"start": 60, "length": len(array), "dtype": "<f8"}}}
            head = b"\x84\x83\x82\x81" + b"OMF-v0.9.0".ljust(32, b"\0") + bytes(range(1, 17)) + struct.pack("<Q", 60 + len(array))
            self.write("points.omf", head + array + json.dumps(objects).encode())
            printed = self.run_program("info", "points.omf", status=None)
            self.assertEqual("a hundred times the file's size" in printed, times == 40, printed)


if __name__ == "__main__":
    main()
