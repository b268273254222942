#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Where a file cannot be written: status, message, and no half file, for every format."""
import os
import re
import resource
import signal
import subprocess
import unittest

from geomesh_program import PROGRAM, SLOWNESS, USAGE, has_module, main
from test_formats import FormatTest, all_formats

EXTENSIONS = {"vtu": ".vtu", "msh": ".msh", "msh-binary": ".msh", "msh22": ".msh", "msh22-binary": ".msh", "inp": ".inp", "exodus": ".e", "med": ".med",
              "xdmf": ".xdmf", "ogs": ".ogs.vtu", "openfoam": ".foam", "mfem": ".mesh", "pflotran": ".ugi", "pflotran-explicit": ".uge", "tough": ".tough",
              "geos": ".vtm", "tetgen": ".ele", "flac3d": ".f3grid", "feflow": ".fem", "comsol": ".mphtxt", "avs": ".avs", "medit": ".mesh",
              "medit-binary": ".meshb", "tsolid": ".so", "tsurf": ".ts", "glb": ".glb", "obj": ".obj", "stl": ".stl", "seissol": ".puml", "vtkhdf": ".vtkhdf"}
NEED_DELAUNAY = {"pflotran-explicit", "tough"}  # of a box, below


class Failures(FormatTest):
    def setUp(self):
        super().setUp()
        self.formats = all_formats()
        self.assertGreaterEqual(len(self.formats), 13)
        self.formats = [name for name in self.formats if has_module(name)]
        self.assertLessEqual(set(self.formats), set(EXTENSIONS), "a format without a test")

    def mesh_for(self, name):
        """A cube in eight is Delaunay with all circumcentres inside."""
        if name not in NEED_DELAUNAY:
            return self.stem + ".vtu"
        cube = self.path("cube")
        if not os.path.exists(cube):
            os.makedirs(cube)
            lines = [" ".join(map(str, (x, y, z))) for x in range(5) for y in range(5) for z in range(5)]
            with open(os.path.join(cube, "points.xyz"), "w") as file:
                file.write("\n".join(lines) + "\n")
            self.run_program("delaunay", os.path.join(cube, "points.xyz"), "-o", os.path.join(cube, "cube.vtu"))
        return os.path.join(cube, "cube.vtu")

    def convert_badly(self, name, folder, preexec, cwd=None):
        out = os.path.join(folder, "m" + EXTENSIONS[name])
        done = subprocess.run([PROGRAM, "convert", self.mesh_for(name), "-o", out, "--format", name], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                              timeout=100 * SLOWNESS, preexec_fn=preexec, restore_signals=False, cwd=cwd)
        return done

    def files_in(self, folder):
        return sorted(os.path.join(where, name) for where, _, names in os.walk(folder) for name in names)

    def test_a_disk_that_is_full_at_any_moment(self):
        """No file may grow beyond a limit, which the system tells as it tells a full disk: at the write."""
        for name in self.formats:
            whole = self.path("whole_" + name)
            os.makedirs(whole)
            self.assertEqual(self.convert_badly(name, whole, None).returncode, 0, name)
            largest = max(os.path.getsize(f) for f in self.files_in(whole))
            for share in (0.02, 0.5, 0.99):
                folder = self.path("full_%s_%g" % (name, share))
                os.makedirs(folder)
                limit = int(largest * share)

                def fill():
                    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
                    resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))
                done = self.convert_badly(name, folder, fill)
                self.assertEqual(done.returncode, USAGE, "%s at %g: %s" % (name, share, done.stdout))
                self.assertIn("cannot write", done.stdout, name)
                self.assertEqual(self.files_in(folder), [], name)

    def test_a_folder_without_permission(self):
        for name in self.formats:
            mesh = self.mesh_for(name)
            folder = self.path("closed_" + name)
            os.makedirs(folder)
            os.chmod(folder, 0o555)

            def demote():
                if os.geteuid() == 0:
                    os.setgroups([])
                    os.setgid(65534)
                    os.setuid(65534)
            try:
                readable = subprocess.run(["cat", mesh], preexec_fn=demote, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode == 0
                if not readable:
                    self.skipTest("skipped: the build folder is not readable for a user without rights")
                done = self.convert_badly(name, folder, demote)
                self.assertEqual(done.returncode, USAGE, name + ": " + done.stdout)
                self.assertIn("cannot write", done.stdout, name)
                self.assertEqual(self.files_in(folder), [], name)
            finally:
                os.chmod(folder, 0o755)

    def test_a_folder_that_has_vanished(self):
        for name in self.formats:
            mesh = self.mesh_for(name)
            self.assertTrue(os.path.isabs(mesh))
            folder = self.path("gone_" + name)
            os.makedirs(folder)
            done = self.convert_badly(name, "", lambda: os.rmdir(folder), cwd=folder)
            self.assertNotIn(done.returncode, (0, 1), name + ": " + done.stdout)
            self.assertGreater(len(done.stdout), 10, name)
            self.assertFalse(os.path.exists(folder), name)

    def test_a_page_is_not_made_from_a_mesh_file(self):
        done = subprocess.run([PROGRAM, "convert", self.stem + ".vtu", "-o", self.path("m.html")], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                              timeout=100 * SLOWNESS)
        self.assertEqual(done.returncode, USAGE, done.stdout)
        self.assertIn(".html", done.stdout)

    def test_in_parts_too(self):
        for name, ending in (("vtu", ".pvtu"), ("exodus", ".e"), ("msh22", ".msh")):
            folder = self.path("parts_" + name)
            os.makedirs(folder)

            def fill():
                signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
                resource.setrlimit(resource.RLIMIT_FSIZE, (20000, 20000))
            done = subprocess.run([PROGRAM, "convert", self.stem + ".vtu", "-o", os.path.join(folder, "m" + ending), "--format", name, "--partitions", "3"],
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=100 * SLOWNESS, preexec_fn=fill, restore_signals=False)
            if "without METIS" in done.stdout:
                self.skipTest("skipped: built without METIS")
            self.assertEqual(done.returncode, USAGE, done.stdout)
            self.assertEqual(self.files_in(folder), [], name)


if __name__ == "__main__":
    main()
