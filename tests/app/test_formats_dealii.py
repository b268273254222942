#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Gmsh files as deal.II's GridIn reads them, by a small program that is built here: material ids, ids of the boundary, counts, volumes.

deal.II takes ids on the boundary alone: it refuses groups of inner faces and of inner edges.
"""
import os
import re
import shutil
import subprocess

import format_readers as readers
from geomesh_program import SOURCE, WORK, main
from test_formats import FormatTest, plain

ONLY_BOUNDARY = ("--no-inner-faces", "--no-curves")


class DealII(FormatTest):
    program = None

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        build = os.path.join(WORK, "dealii_reads")
        shutil.rmtree(build, ignore_errors=True)
        if not shutil.which("cmake"):
            return
        for command in (["cmake", "-S", os.path.join(SOURCE, "tests", "app", "dealii_reads"), "-B", build], ["cmake", "--build", build]):
            run = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=600)
            if run.returncode and re.search(r'Could not find a (package )?configuration file .*"deal\.II"', " ".join(run.stdout.split())):
                return
            assert run.returncode == 0, run.stdout
        cls.program = os.path.join(build, "dealii_reads")

    def setUp(self):
        super().setUp()
        if not self.program:
            self.skipTest("skipped: libdeal.ii-dev (9.3 or later) or cmake is not installed")

    def run_reader(self, path):
        return subprocess.run([self.program, path], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=200)

    def read(self, path, sidecar):
        run = self.run_reader(path)
        self.assertEqual(run.returncode, 0, run.stdout)
        found = readers.Found(int(re.search(r"(?m)^points (\d+)$", run.stdout).group(1)))
        names = {(g["dimension"], g["id"]): g["name"] for g in sidecar["groups"]}
        for kind, number, n, size in re.findall(r"(?m)^(material|boundary) (\d+) (\d+) (\S+)$", run.stdout):
            dimension, into = {"material": (3, found.regions), "boundary": (2, found.faces)}[kind]
            into[names[(dimension, int(number))]] = int(n), float(size)
        return found

    def assert_boundary(self, found):
        sides = {plain(s["name"]): s["area"] for s in self.model["surfaces"] if s["kind"] == "box"}
        self.assertEqual(sorted(found.faces), sorted(sides))
        for name, area in sides.items():
            self.assertAlmostEqual(found.faces[name][1] / area, 1, delta=1e-10, msg=name)

    def check_boundary_format(self, *options):
        path = self.convert("m.msh", *options, *ONLY_BOUNDARY)
        found = self.read(path, self.sidecar(path))
        self.assertEqual(found.points, self.model["points"])
        self.assert_regions(found)
        self.assert_boundary(found)

    def test_msh41(self):
        self.check_boundary_format()

    def test_msh22(self):
        self.check_boundary_format("--format", "msh22")

    def test_groups_of_inner_faces_are_refused_by_the_reader(self):
        run = self.run_reader(self.convert("m.msh", "--no-curves"))
        self.assertNotEqual(run.returncode, 0)
        self.assertIn("for an internal face", run.stdout)


if __name__ == "__main__":
    main()
