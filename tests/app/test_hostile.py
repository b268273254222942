# SPDX-License-Identifier: GPL-3.0-or-later
"""Input, names, folders and signals that a program meets outside the laboratory: a message and the right exit status, no crash, no
hang, nothing half written."""
import json
import os
import random
import resource
import shutil
import signal
import struct
import subprocess
import time
import zlib

from geomesh_program import BAD_INPUT, CANNOT_MESH, PROGRAM, SOURCE, USAGE, ProgramTest, box_surface, level, main

PROJECT = """box: {min: [0, 0, 0], max: [10, 10, 10]}
surfaces:
  - {name: top, kind: horizon, file: top.ts}
"""


def off(points, faces):
    lines = ["OFF", "%d %d 0" % (len(points), len(faces))] + ["%s %s %s" % p for p in points]
    return "\n".join(lines + ["%d " % len(f) + " ".join(map(str, f)) for f in faces] + [""])


CUBE = off(*box_surface((0, 0, 0), (1, 1, 1)))


class Files(ProgramTest):
    timeout = 60

    def test_pipes_and_devices_are_refused_at_once(self):
        os.mkfifo(self.path("pipe.ts"))
        for file in ("pipe.ts", "/dev/zero"):
            for command in (["mesh", file, "-o", "out.vtu"], ["info", file], ["check", file], ["delaunay", file, "-o", "out.vtu"], [file]):
                self.assertIn("pipe or a device", self.run_program(*command, status=USAGE))
        self.write("model.yaml", PROJECT.replace("top.ts", "pipe.ts"))
        self.assertIn("pipe.ts", self.run_program("model.yaml", status=USAGE))

    def test_output_that_cannot_be_written_is_found_before_meshing(self):
        self.write("cube.off", CUBE)
        self.write("file", "")
        os.mkdir(self.path("folder.vtu"))
        for output in ("file/out.vtu", "folder.vtu"):
            printed = self.run_program("mesh", "cube.off", "-o", output, status=USAGE)
            self.assertIn("cannot write", printed)
            self.assertFalse(any(line.startswith("delaunay") for line in printed.splitlines()), printed)
        self.assertIn("own name", self.run_program("mesh", "cube.off", "-o", "out.vtu", "--report", "out.vtu", status=USAGE))
        self.assert_nothing_written()

    def test_files_that_belong_together_are_written_all_or_none(self):
        self.write("cube.off", CUBE)
        os.mkdir(self.path("out.curves.vtp"))
        self.assertIn("out.curves.vtp", self.run_program("mesh", "cube.off", "-o", "out.vtu", status=USAGE))
        self.assertEqual(sorted(os.listdir(self.folder)), ["cube.off", "out.curves.vtp"])

    def test_file_that_outgrows_the_allowed_size(self):
        self.write("cube.off", CUBE)
        done = subprocess.run([PROGRAM, "mesh", "cube.off", "-o", "out.vtu"], cwd=self.folder, timeout=self.timeout,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (500, 500)))
        self.assertEqual(done.returncode, USAGE, done.stdout)
        self.assertIn("out.vtu", done.stdout)
        self.assertEqual(os.listdir(self.folder), ["cube.off"])

    def test_a_link_is_written_through_and_a_device_is_not_replaced(self):
        self.write("cube.off", CUBE)
        self.write("real.vtu", "")
        os.symlink("real.vtu", self.path("link.vtu"))
        printed = self.run_program("mesh", "cube.off", "-o", "link.vtu", "--report", "/dev/stdout")
        self.assertIn('"stages"', printed)
        self.assertTrue(os.path.islink(self.path("link.vtu")))
        self.check(self.path("real.vtu"))

    def test_closed_standard_streams_do_not_end_up_in_the_mesh(self):
        self.write("cube.off", CUBE)
        command = '"%s" mesh cube.off -o out.vtu --verbose <&- >&- 2>&-' % PROGRAM
        self.assertEqual(subprocess.run(command, shell=True, cwd=self.folder, timeout=self.timeout).returncode, 0)
        self.check(self.path("out.vtu"))

    def test_full_standard_output_is_told(self):
        self.write("cube.off", CUBE)
        if not os.path.exists("/dev/full"):
            self.skipTest("skipped: no /dev/full")
        with open("/dev/full", "w") as full:
            done = subprocess.run([PROGRAM, "info", "cube.off"], cwd=self.folder, stdout=full, stderr=subprocess.PIPE, timeout=self.timeout)
        self.assertEqual(done.returncode, USAGE)

    def test_full_disk_is_told_and_leaves_nothing(self):
        """The report goes to a device that is full; the mesh beside it is written whole or not at all."""
        self.write("cube.off", CUBE)
        if not os.path.exists("/dev/full"):
            self.skipTest("skipped: no /dev/full")
        printed = self.run_program("mesh", "cube.off", "-o", "out.vtu", "--report", "/dev/full", status=None)
        self.assertEqual(self.last_status, USAGE, printed)
        self.assertIn("/dev/full", printed)
        if os.path.exists(self.path("out.vtu")):
            self.check(self.path("out.vtu"))
        self.assertEqual([name for name in os.listdir(self.folder) if name.endswith(".part")], [])

    def test_folder_that_is_removed_while_meshing(self):
        """Whatever the moment: the folder made again and all in it, or status 2 and a message; never a part of the files."""
        self.write("cube.off", CUBE)
        for after in (0.0, 0.02, 0.05, 0.1):
            os.makedirs(self.path("gone"), exist_ok=True)
            program = subprocess.Popen([PROGRAM, "mesh", "cube.off", "-o", "gone/out.vtu"], cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            time.sleep(after)
            shutil.rmtree(self.path("gone"), ignore_errors=True)
            printed = program.communicate(timeout=self.timeout)[0].decode()
            self.assertIn(program.returncode, (0, USAGE), printed)
            if program.returncode == USAGE:
                self.assertIn("out", printed)
            shutil.rmtree(self.path("gone"), ignore_errors=True)

    def test_input_that_changes_while_it_is_read(self):
        """Each run sees one state or a broken one: a mesh of it that passes, or a refusal."""
        whole = CUBE.encode()
        file = self.write("cube.off", CUBE)
        for k in range(6):
            program = subprocess.Popen([PROGRAM, "mesh", "cube.off", "-o", "out.vtu"], cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            for cut in range(20):
                with open(file, "r+b") as stream:
                    stream.truncate(len(whole) * ((cut * 7 + k) % 20) // 20)
                with open(file, "wb") as stream:
                    stream.write(whole)
            printed = program.communicate(timeout=self.timeout)[0].decode()
            self.assertIn(program.returncode, (0, BAD_INPUT, CANNOT_MESH, USAGE), printed)
            if program.returncode == 0:
                self.check(self.path("out.vtu"))

    def test_two_runs_into_one_folder_at_once(self):
        """Both end well, and what is there is whole: files are renamed into place."""
        self.write("cube.off", CUBE)
        runs = [subprocess.Popen([PROGRAM, "mesh", "cube.off", "-o", "both/out.vtu"], cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
                for _ in range(3)]
        for run in runs:
            printed = run.communicate(timeout=self.timeout)[0].decode()
            self.assertEqual(run.returncode, 0, printed)
        self.check(self.path("both", "out.vtu"))
        self.assertEqual([name for name in os.listdir(self.path("both")) if ".part" in name], [])

    def test_a_locale_with_a_decimal_comma_changes_nothing(self):
        known = subprocess.run(["locale", "-a"], stdout=subprocess.PIPE, text=True).stdout.split()
        commas = [name for name in known if name.startswith(("de_", "fr_", "pt_", "it_"))]
        if not commas:
            self.skipTest("skipped: no locale with a decimal comma is installed")
        self.write("cube.off", CUBE.replace("\n1 ", "\n1.25 "))
        written = []
        for language in ("C", commas[0]):
            environment = dict(os.environ, LC_ALL=language, LANG=language)
            for ending in ("msh", "inp"):
                done = subprocess.run([PROGRAM, "mesh", "cube.off", "-o", "%s.%s" % (language, ending)], cwd=self.folder, env=environment, timeout=self.timeout,
                                      stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
                self.assertEqual(done.returncode, 0, done.stdout)
            with open(self.path(language + ".msh"), "rb") as file:
                written.append(file.read())
        self.assertEqual(len(set(written)), 1)

    def test_names_that_are_not_utf8(self):
        name = os.fsdecode(b"caf\xe9.off")
        self.write(name, CUBE)
        self.run_program("mesh", name, "-o", "out.vtu", "--report", "report.json")
        self.run_program("check", "out.vtu", "--report", "check.json")


class Projects(ProgramTest):
    timeout = 60

    def refused(self, text, *words):
        self.write("top.ts", level("top", 5))
        printed = self.run_program(self.write("model.yaml", text), status=USAGE)
        for word in words:
            self.assertIn(word, printed)
        self.assertLess(len(printed), 10000)
        self.assert_nothing_written()

    def test_letters_that_are_not_utf8(self):
        self.refused(PROJECT.replace("name: top", "name: t\xf6p").encode("latin-1"), "model.yaml:3:", "UTF-8")

    def test_other_encodings_and_line_ends_are_read(self):
        self.write("top.ts", level("top", 5))
        for text in (PROJECT.encode("utf-16"), b"\xef\xbb\xbf" + PROJECT.encode(), PROJECT.replace("\n", "\r\n").encode()):
            self.run_program(self.write("model.yaml", text))

    def test_name_too_long_for_a_file(self):
        self.refused("name: " + "x" * 100000 + "\n" + PROJECT, "model.yaml:1:7", "100000 bytes")

    def test_deep_nesting_and_bombs(self):
        self.refused("surfaces: " + "[" * 100000)
        bomb = "a: &a [x, x, x, x, x, x, x, x, x, x]\n"
        for before, key in zip("abcdefgh", "bcdefghi"):
            bomb += "%s: &%s [%s]\n" % (key, key, ", ".join(["*" + before] * 10))
        self.refused(bomb.replace("i: &i", "column: &i") + PROJECT, "unknown key 'a'")
        self.refused("&r\nbox: *r\nsurfaces: *r\n")


    def test_documents_without_end(self):
        """yaml-cpp finds empty documents for ever where a comma begins one (found by scripts/fuzz project)."""
        self.refused(",a\n", "several YAML documents")
        self.refused(PROJECT + "---\n" + PROJECT, "several YAML documents")

    def test_names_that_lead_out_of_the_output_folder(self):
        """A project's name is a file's name: no folder, no way up."""
        folders = (self.folder, os.path.dirname(self.folder), "/tmp")
        before = {folder: set(os.listdir(folder)) for folder in folders}  # others may have such files there
        for name in ("../escaped", "/tmp/escaped", "a/b", ".."):
            self.write("top.ts", level("top", 5))
            self.write("model.yaml", "name: %s\n" % name + PROJECT)
            self.run_program("model.yaml", "-o", "out", status=None)
            self.assertIn(self.last_status, (0, USAGE), name)
            for folder in folders:
                made = set(os.listdir(folder)) - before[folder]
                self.assertEqual([f for f in made if f.startswith("escaped") or f.startswith("b.")], [], name)


class Numbers(ProgramTest):
    timeout = 60

    def test_magnitudes_beyond_the_exact_arithmetic(self):
        for scale in ("1e300", "1e-300", "5e-324"):
            self.write("cube.off", CUBE.replace(" 1", " " + scale).replace("\n1 ", "\n" + scale + " "))
            self.run_program("mesh", "cube.off", "-o", "out.vtu", status=BAD_INPUT)
        self.assert_nothing_written()

    def test_counts_that_lie(self):
        for count in ("-5", "1000000000", "9223372036854775807", "18446744073709551616"):
            for first, text in (("out.off", CUBE.replace("8 12 0", count + " 12 0")), ("out.off", CUBE.replace("8 12 0", "8 %s 0" % count)),
                                ("out.poly", count + " 3 0 0\n1 0 0 0\n"),
                                ("out.ply", "ply\nformat binary_little_endian 1.0\nelement vertex " + count +
                                 "\nproperty double x\nproperty double y\nproperty double z\nend_header\n")):
                self.run_program("mesh", self.write(first, text), "-o", "out.vtu", status=BAD_INPUT)

    def test_minus_zero_is_zero(self):
        points, faces = box_surface((0, 0, 0), (1, 1, 1))
        points = points + [("-0", "0", "-0")]
        faces = [tuple(8 if v == 0 and i % 2 else v for v in face) for i, face in enumerate(faces)]
        self.run_program("mesh", self.write("cube.off", off(points, faces)), "-o", "out.vtu")
        self.assertEqual(self.check(self.path("out.vtu"))["volume"], 1)

    def test_offset_that_leaves_no_digits(self):
        points, faces = box_surface((1e17, 1e17, 1e17), (1e17 + 1, 1e17 + 1, 1e17 + 1))
        self.run_program("mesh", self.write("cube.off", off(points, faces)), "-o", "out.vtu", status=CANNOT_MESH)
        self.assert_nothing_written()


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

    def test_cells_of_a_legacy_file_that_run_beyond_their_block(self):
        """VTK's reader wrote beyond its memory (found by fuzz.replay_meshes)."""
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
        """What VTK's reader had not read stayed as memory was, and was judged."""
        with open(os.path.join(SOURCE, "tests", "corpus", "bytes", "mesh_two_tetrahedra.vtk")) as file:
            whole = file.read()
        for text in (whole.replace("0 0 -1", "0 0 x"), whole.replace("1 1\n", "1 x\n"), whole.rstrip()[:-1]):
            self.assertNotEqual(text, whole)
            self.assertRegex(self.run_program("check", self.write("bad.vtk", text), status=BAD_INPUT), "VTK cannot read it: |damaged")
        # VTK took what follows the last number that it can read for a keyword, and followed a null pointer.
        early = whole[:whole.index("0 0 -1")] + "0FieldData 2\nkind 1 5 int\n"
        self.assertIn("has points that do not fill", self.run_program("check", self.write("bad.vtk", early), status=BAD_INPUT))
        field = "FIELD FieldData 2\ncell_ids 1 2 int\n1 2\nMETADATA\nINFORMATION 0\n\ncells 1 2 string\na b\nc\n"
        self.run_program("check", self.write("good.vtk", whole.replace("POINTS", field + "POINTS")))
        for text in (whole.replace("Version 3.0", "Version 5.1"), whole.replace("Version 3.0", "Version x"), whole.replace("Version 3.0", "Version 3"),
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


class Signals(ProgramTest):
    timeout = 60

    def points_file(self):
        number = random.Random(1)
        return self.write("points.xyz", "".join("%r %r %r\n" % (number.random(), number.random(), number.random()) for _ in range(200000)))

    def interrupt(self, number, after, *arguments):
        program = subprocess.Popen([PROGRAM, *arguments], cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        time.sleep(after)
        program.send_signal(number)
        return program.wait(timeout=self.timeout)

    def test_interrupted_runs_leave_nothing(self):
        """Whatever the moment: ended by the signal with nothing written, or done with everything written."""
        points = self.points_file()
        expected = {signal.SIGINT: 130, signal.SIGTERM: 143}
        ended = 0
        for number in expected:
            for after in (0.05, 0.2, 0.5):
                status = self.interrupt(number, after, "delaunay", points, "-o", "out.msh", "--threads", "1")
                self.assertIn(status, (0, expected[number], -number))  # -number: before the program had begun
                if status != 0:
                    ended += 1
                    self.assert_nothing_written()
                elif os.path.exists(self.path("out.msh")):
                    os.remove(self.path("out.msh"))
        self.assertGreater(ended, 0)

    def test_killed_runs_leave_no_half_file_under_a_final_name(self):
        """SIGKILL cannot be caught: what has its final name is whole, whatever is left beside it ends in .part."""
        points = self.points_file()
        for after in (0.1, 0.4, 0.8, 1.2):
            status = self.interrupt(signal.SIGKILL, after, "delaunay", points, "-o", "out.msh", "--threads", "1")
            self.assertIn(status, (0, -signal.SIGKILL))
            if os.path.exists(self.path("out.msh")):
                with open(self.path("out.msh"), "rb") as file:
                    file.seek(-20, os.SEEK_END)
                    self.assertIn(b"$EndElements", file.read())
                os.remove(self.path("out.msh"))
            for name in os.listdir(self.folder):
                if ".part" in name:
                    os.remove(self.path(name))


if __name__ == "__main__":
    main()
