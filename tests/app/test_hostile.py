# SPDX-License-Identifier: GPL-3.0-or-later
"""Input, names, folders and signals that a program meets outside the laboratory: a message and the right exit status, no crash, no
hang, nothing half written."""
import os
import random
import resource
import shutil
import signal
import subprocess
import time

from geomesh_program import BAD_INPUT, CANNOT_MESH, PROGRAM, USAGE, ProgramTest, box_surface, level, main, off

PROJECT = """box: {min: [0, 0, 0], max: [10, 10, 10]}
surfaces:
  - {name: top, kind: horizon, file: top.ts}
"""


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
            self.assertFalse(any(line.startswith(("delaunay", "mesh")) for line in printed.splitlines()), printed)
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

    def test_the_next_run_removes_what_a_killed_one_left(self):
        """Of this file's stem, and where the process that wrote it is gone."""
        self.write("cube.off", CUBE)
        gone = subprocess.Popen(["true"])
        gone.wait()
        left = ["out.vtu.%d.part" % gone.pid, "out.faces.vtp.%d.part" % gone.pid]
        kept = ["out.vtu.%d.part" % os.getpid(), "other.vtu.%d.part" % gone.pid, "out.part", "out.x.part"]
        for name in left + kept:
            self.write(name, "half")
        self.run_program("mesh", "cube.off", "-o", "out.vtu")
        found = os.listdir(self.folder)
        self.assertEqual([name for name in left if name in found], [])
        self.assertEqual([name for name in kept if name in found], kept)


if __name__ == "__main__":
    main()
