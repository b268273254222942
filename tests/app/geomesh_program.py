# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the built program for the whole-program tests. Standard library only.

A test is a unittest.TestCase derived from ProgramTest. ctest sets GEOMESH_PROGRAM, GEOMESH_SOURCE_DIR, GEOMESH_WORK_DIR and
GEOMESH_SHARED_DATA; run by hand, a script finds build/release beside the sources.
"""
import json
import os
import re
import shutil
import subprocess
import unittest

SOURCE = os.environ.get("GEOMESH_SOURCE_DIR") or os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PROGRAM = os.environ.get("GEOMESH_PROGRAM") or os.path.join(SOURCE, "build", "release", "bin", "geomesh")
WORK = os.environ.get("GEOMESH_WORK_DIR") or os.path.join(SOURCE, "build", "release", "test_app")
SHARED_DATA = os.environ.get("GEOMESH_SHARED_DATA") or os.path.join(SOURCE, "..", "shared", "data")
NIGHTLY = os.environ.get("GEOMESH_NIGHTLY", "0") == "1"
SLOWNESS = 10 if os.environ.get("GEOMESH_SANITIZE") else 1  # of programs that sanitizers watch: limits against hangs are so much longer

DONE, BUG, USAGE, BAD_INPUT, CANNOT_MESH, INTERRUPTED = 0, 1, 2, 3, 4, 130

FORMATS_OF_MODULES = ("exodus", "med", "xdmf", "seissol", "vtkhdf")


def has_module(name):
    """Whether the module (gdal, proj, or one of a format) was built beside the program. A format that needs none: true."""
    return name not in FORMATS_OF_MODULES + ("gdal", "proj") or os.path.exists(os.path.join(os.path.dirname(PROGRAM), "geomesh-%s.so" % name))


class ProgramTest(unittest.TestCase):
    """Each test has a folder of its own, emptied first: self.folder."""

    timeout = 300
    bare = True  # projects that say nothing of their mesh are written with `refine: none`: most tests judge kept surfaces

    def setUp(self):
        self.timeout *= SLOWNESS
        self.folder = os.path.join(WORK, self.id().replace("__main__.", ""))
        shutil.rmtree(self.folder, ignore_errors=True)
        os.makedirs(self.folder)

    def path(self, *parts):
        return os.path.join(self.folder, *parts)

    def write(self, name, text):
        if self.bare and str(name).endswith(".yaml") and isinstance(text, str) and re.search(r"(?m)^surfaces:", text):
            text = with_mesh(text, None)
        mode = "wb" if isinstance(text, bytes) else "w"
        with open(self.path(name), mode) as file:
            file.write(text)
        return self.path(name)

    def run_program(self, *arguments, status=DONE):
        """Runs geomesh, expects the exit status (None: any, see self.last_status), returns everything it printed."""
        done = subprocess.run([PROGRAM, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace",
                              timeout=self.timeout, cwd=self.folder)
        self.last_status = done.returncode
        missing = re.search(r"by a module of its own, geomesh-(\w+)\.so", done.stdout)
        if missing and done.returncode == USAGE and status != USAGE and not has_module(missing.group(1)):
            self.skipTest("skipped: built without the module geomesh-" + missing.group(1))
        if status is not None:
            self.assertEqual(done.returncode, status, "geomesh %s printed:\n%s" % (" ".join(map(str, arguments)), done.stdout))
        return done.stdout

    def report(self, path):
        with open(path) as file:
            return json.load(file)

    def check(self, mesh, *arguments, status=DONE):
        """`geomesh check`; returns its report."""
        file = mesh + ".check.json"
        self.run_program("check", mesh, "--report", file, *arguments, status=status)
        return self.report(file)

    def region_names(self, report):
        return sorted(region["name"] for region in report["regions"])

    def assert_nothing_written(self, folder=None, besides=()):
        """No output file, whole or in part."""
        left = [os.path.join(where, name) for where, _, names in os.walk(folder or self.folder) for name in names]
        left = [file for file in left if file.endswith((".vtu", ".vtp", ".msh", ".inp", ".part", ".report.json")) and file not in besides]
        self.assertEqual(left, [])

    def shared(self, *parts):
        """A file of the shared test data; skips the test, saying so, where it is not there."""
        file = os.path.join(SHARED_DATA, *parts)
        if not os.path.exists(file):
            self.skipTest("skipped: no " + os.path.join(*parts) + " in the shared test data")
        return os.path.abspath(file)

    def sample(self, name):
        return os.path.join(SOURCE, "samples", name, "project.yaml")

    def copy_of_sample(self, name, mesh):
        """The project file of a copy of a sample with `mesh` (None: as shipped) in place of what it says of its mesh."""
        folder = self.path("sample")
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(os.path.join(SOURCE, "samples", name), folder, ignore=shutil.ignore_patterns("out"))
        project = os.path.join(folder, "project.yaml")
        if mesh is not None:
            with open(project) as file:
                text = file.read()
            with open(project, "w") as file:
                file.write(with_mesh(text, mesh))
        return project

    def mesh_sample(self, name, *arguments, mesh="{refine: none}"):
        """Meshes a sample into self.folder, its surfaces kept, and has it checked; returns the run's report and the check's."""
        project = self.copy_of_sample(name, mesh)
        self.run_program(project, "-o", self.folder, *arguments)
        stem = self.path(name.replace("-", "_"))
        for ending in (".vtu", ".faces.vtp", ".curves.vtp", ".report.json"):
            self.assertTrue(os.path.exists(stem + ending), stem + ending)
        return self.report(stem + ".report.json"), self.check(stem + ".vtu", "--project", project)


def with_mesh(project, mesh):
    """The text of a project with `mesh: MESH` in place of what it says. None: `refine: none`, where it says nothing."""
    if re.search(r"(?m)^mesh:", project):
        return project if mesh is None else re.sub(r"(?m)^mesh:.*$", lambda _: "mesh: " + mesh, project)
    return project.rstrip("\n") + "\nmesh: " + (mesh or "{refine: none}") + "\n"


def plane_ts(name, corners):
    """A GOCAD TSurf of one rectangle given by its four corners in order."""
    lines = ["GOCAD TSurf 1", "HEADER {", "name:" + name, "}", "TFACE"]
    lines += ["VRTX %d %.17g %.17g %.17g" % (i + 1, *p) for i, p in enumerate(corners)]
    return "\n".join(lines + ["TRGL 1 2 3", "TRGL 1 3 4", "END", ""])


def off(points, faces):
    """The text of an OFF file."""
    lines = ["OFF", "%d %d 0" % (len(points), len(faces))] + ["%s %s %s" % p for p in points]
    return "\n".join(lines + ["%d " % len(f) + " ".join(map(str, f)) for f in faces] + [""])


def triangles_ts(name, points, triangles):
    lines = ["GOCAD TSurf 1", "HEADER {", "name:" + name, "}", "TFACE"]
    lines += ["VRTX %d %.17g %.17g %.17g" % (i + 1, *p) for i, p in enumerate(points)]
    lines += ["TRGL %d %d %d" % tuple(v + 1 for v in t) for t in triangles]
    return "\n".join(lines + ["END", ""])


def level(name, z, size=10.0, overshoot=1.0):
    """A horizontal rectangle at height z over the box 0..size, overshooting it."""
    low, high = -overshoot, size + overshoot
    return plane_ts(name, [(low, low, z), (high, low, z), (high, high, z), (low, high, z)])


def box_surface(low, high):
    """Points and outward triangles of an axis-aligned box."""
    points = [(x, y, z) for z in (low[2], high[2]) for y in (low[1], high[1]) for x in (low[0], high[0])]
    triangles = [(0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4), (2, 6, 7), (2, 7, 3), (0, 4, 6), (0, 6, 2), (1, 3, 7),
                 (1, 7, 5)]
    return points, triangles


def main():
    unittest.main()
