#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Other people's programs load and solve on what the program writes: CalculiX, Gmsh, meshio. Each is skipped, saying so, where absent."""
import os
import random
import shutil
import subprocess
import unittest

from geomesh_program import SOURCE, ProgramTest


def numbers_below(path, title):
    """Rows of numbers below the first line with `title`, up to the next text."""
    rows, found = [], False
    with open(path) as file:
        lines = file.readlines()
    for line in lines:
        if not found:
            found = title in line
            continue
        words = line.split()
        if not words:
            if rows:
                break
            continue
        try:
            rows.append([float(word) for word in words])
        except ValueError:
            break
    return rows


@unittest.skipUnless(shutil.which("ccx"), "skipped: calculix-ccx is not installed")
class HeatThroughLayers(ProgramTest):
    """Steady heat conduction through three layers: temperature is linear in each, whatever the mesh."""

    conductivity = {"top": 1.0, "middle": 2.0, "bottom": 4.0}

    def flat_horizon(self, name, z):
        text = "OFF\n4 2 0\n-1 -1 %g\n5 -1 %g\n5 5 %g\n-1 5 %g\n3 0 1 2\n3 0 2 3\n" % (z, z, z, z)
        self.write(name + ".off", text)

    def test_temperatures_are_analytic(self):
        self.flat_horizon("upper", -1)
        self.flat_horizon("lower", -2)
        rng = random.Random(1)  # points inside, so that the mesh is not trivial
        project = self.write("layers.yaml", """
box: {min: [0, 0, -3], max: [4, 4, 0]}
surfaces:
  - {name: upper, kind: horizon, file: upper.off}
  - {name: lower, kind: horizon, file: lower.off}
column: [top, upper, middle, lower, bottom]
points:
""" + "".join("  - {name: p%d, at: [%.4f, %.4f, %.4f]}\n" % (i, rng.uniform(0.1, 3.9), rng.uniform(0.1, 3.9), rng.uniform(-2.9, -0.1)) for i in range(99))
            + "output: {directory: out, formats: [vtu, inp]}\n")
        self.run_program(project)
        self.assertEqual(self.check(self.path("out", "layers.vtu"))["faults"], [])
        groups = self.report(self.path("out", "layers.inp.json"))["groups"]

        def name_of(kind, full_name):
            return next(g["name"] for g in groups if g["type"] == kind and g["full_name"] == full_name)

        deck = "*INCLUDE, INPUT=layers.inp\n"
        for unit, value in self.conductivity.items():
            deck += "*MATERIAL, NAME=m_%s\n*CONDUCTIVITY\n%g\n*SOLID SECTION, MATERIAL=m_%s, ELSET=%s\n" % (unit, value, unit, name_of("elset", unit))
        deck += "*STEP\n*HEAT TRANSFER, STEADY STATE\n*BOUNDARY\n%s, 11, 11, 100\n%s, 11, 11, 0\n" % (name_of("nset", "zmin"), name_of("nset", "zmax"))
        for horizon in ("upper", "lower"):
            deck += "*NODE PRINT, NSET=%s\nNT\n" % name_of("nset", horizon)
        self.write("out/heat.inp", deck + "*END STEP\n")
        solved = subprocess.run(["ccx", "heat"], cwd=self.path("out"), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=100)
        self.assertEqual(solved.returncode, 0, solved.stdout[-2000:])
        flux = 100 / sum(1 / value for value in self.conductivity.values())
        expected = {"upper": flux / self.conductivity["top"], "lower": flux / self.conductivity["top"] + flux / self.conductivity["middle"]}
        for horizon, temperature in expected.items():
            rows = numbers_below(self.path("out", "heat.dat"), "temperatures for set " + name_of("nset", horizon).upper())
            self.assertGreaterEqual(len(rows), 4)
            for row in rows:
                self.assertAlmostEqual(row[1], temperature, delta=1e-4 * temperature)


class GmshFileOfSamples(ProgramTest):
    def write_msh(self, sample):
        folder = os.path.join(SOURCE, "samples", sample)
        with open(os.path.join(folder, "project.yaml")) as file:
            text = file.read().replace("file: surfaces", "file: " + folder + "/surfaces")
        project = self.write("project.yaml", "\n".join(line for line in text.splitlines() if not line.startswith("output:")) +
                             "\noutput: {directory: out, formats: [vtu, msh]}\n")
        self.run_program(project)
        stem = next(f for f in os.listdir(self.path("out")) if f.endswith(".msh"))[:-4]
        report = self.report(self.path("out", stem + ".report.json"))
        groups = self.report(self.path("out", stem + ".msh.json"))["groups"]
        return self.path("out", stem + ".msh"), report, groups

    def meshio_reads(self, sample):
        try:
            import meshio
        except ImportError:
            self.skipTest("skipped: python3-meshio is not installed")
        file, report, groups = self.write_msh(sample)
        mesh = meshio.read(file)
        self.assertEqual(sorted(mesh.field_data), sorted(g["name"] for g in groups))
        count = {kind: sum(len(c.data) for c in mesh.cells if c.type == kind) for kind in ("tetra", "triangle")}
        self.assertEqual(count["tetra"], sum(r["tetrahedra"] for r in report["regions"]))
        names = {g["full_name"]: g["name"] for g in groups if g.get("dimension") == 3}
        for region in report["regions"]:
            tag = mesh.field_data[names[region["name"]]][0]
            found = sum(int((mesh.cell_data["gmsh:physical"][i] == tag).sum()) for i, c in enumerate(mesh.cells) if c.type == "tetra")
            self.assertEqual(found, region["tetrahedra"], region["name"])
        self.assertGreater(count["triangle"], 0)

    def gmsh_reads(self, sample):
        if not shutil.which("gmsh"):
            self.skipTest("skipped: gmsh is not installed")
        file, report, groups = self.write_msh(sample)
        again = self.path("again.msh")
        run = subprocess.run(["gmsh", file, "-0", "-format", "msh22", "-o", again], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                             timeout=100)
        self.assertEqual(run.returncode, 0, run.stdout)
        self.assertNotIn("Error", run.stdout)
        with open(again) as written:
            lines = written.read().splitlines()
        at = lines.index("$PhysicalNames")
        names = [line.split(None, 2)[2].strip('"') for line in lines[at + 2:at + 2 + int(lines[at + 1])]]
        self.assertEqual(sorted(names), sorted(g["name"] for g in groups))
        at = lines.index("$Elements")
        kinds = [line.split(None, 2)[1] for line in lines[at + 2:at + 2 + int(lines[at + 1])]]
        self.assertEqual(kinds.count("4"), sum(r["tetrahedra"] for r in report["regions"]))

    def test_meshio_reads_salt_dome(self):
        self.meshio_reads("salt-dome")

    def test_meshio_reads_faulted_layers(self):
        self.meshio_reads("faulted-layers")

    def test_gmsh_reads_salt_dome(self):
        self.gmsh_reads("salt-dome")

    def test_gmsh_reads_faulted_layers(self):
        self.gmsh_reads("faulted-layers")


class Hull(ProgramTest):
    def test_two_loose_triangles_are_meshed_in_their_hull(self):
        loose = self.write("loose.off", "OFF\n6 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0.2 1\n0.1 1 1.2\n3 0 1 2\n3 3 4 5\n")
        self.run_program("mesh", loose, "-o", "open.vtu", status=4)
        self.run_program("mesh", loose, "--hull", "-o", "hull.vtu")
        report = self.report(self.path("hull.report.json"))
        self.assertEqual(self.region_names(report), ["hull"])
        self.assertEqual(self.check(self.path("hull.vtu"))["faults"], [])


if __name__ == "__main__":
    unittest.main()
