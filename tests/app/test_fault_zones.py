#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fault zones: volume elements between two walls of a fault, checked, in every format, and solved across."""
import os
import shutil
import unittest

import format_readers as readers
from geomesh_program import CANNOT_MESH, SOURCE, USAGE, ProgramTest, has_module, main, plane_ts
from test_formats import plain
from test_formats_solved import Deck
from vtk_files import VtkFile

WALL = [(5, -1, -1), (5, 11, -1), (5, 11, 11), (5, -1, 11)]
DANGLING = [(5, -1, -1), (5, 6, -1), (5, 6, 11), (5, -1, 11)]


class Zones(ProgramTest):
    def project(self, zones, surfaces=(("F1", "fault", WALL),), rest="", output="formats: [vtu]"):
        text = "name: model\nbox: {min: [0, 0, 0], max: [10, 10, 10]}\nsurfaces:\n"
        for name, kind, corners in surfaces:
            self.write(name + ".ts", plane_ts(name, corners))
            text += "  - {name: %s, kind: %s, file: %s.ts}\n" % (name, kind, name)
        text += rest + "mesh: {size: 4}\noutput: {directory: ., fault_zone: %s, %s}\n" % (zones, output)
        return self.write("project.yaml", text)

    def mesh(self, *arguments, **named):
        self.project(*arguments, **named)
        self.run_program("project.yaml")
        return self.report(self.path("model.report.json"))

    def checked(self, status=0):
        return self.check(self.path("model.vtu"), "--project", self.path("project.yaml"), status=status)

    def test_a_zone_has_its_volume_its_walls_and_its_layers(self):
        report = self.mesh("{F1: {thickness: 0.5, layers: 3}}", rest="attributes: {F1.zone: {porosity: 0.1}}\ngroups: {broken: [F1.zone]}\n")
        regions = {r["name"]: r for r in report["regions"]}
        self.assertEqual(set(regions), {"region_1", "region_2", "F1.zone"})
        self.assertAlmostEqual(regions["F1.zone"]["volume"], 0.5 * 100, delta=1e-9)
        for name in ("region_1", "region_2"):
            self.assertAlmostEqual(regions[name]["volume"], 4.75 * 100, delta=1e-9)
        surfaces = {s["name"]: s for s in report["surfaces"]}
        for wall in ("F1.minus", "F1.plus"):
            self.assertAlmostEqual(surfaces[wall]["area"], 100, delta=1e-9)
        self.assertAlmostEqual(surfaces["ymin"]["area"], 100, delta=1e-9)
        grid = VtkFile.read(self.path("model.vtu"))
        points = grid["Points", "Points"].values
        across = sorted({round(x, 9) for x in points[0::3] if 4.7 < x < 5.3})
        self.assertEqual(across, [4.75, round(4.75 + 0.5 / 3, 9), round(4.75 + 1 / 3, 9), 5.25])
        zone = grid["FieldData", "region:F1.zone"].values[0]
        values = {v for v, r in zip(grid["CellData", "porosity"].values, grid["CellData", "region"].values) if r == zone}
        self.assertEqual(values, {0.1})
        self.assertEqual(grid["FieldData", "group:broken"].values, [zone])
        self.checked()

    def test_a_zone_ends_as_a_wedge_at_the_tip(self):
        report = self.mesh("{F1: {thickness: 0.5, layers: 2}}", surfaces=[("F1", "fault", DANGLING), ("top", "horizon", [(-1, -1, 5), (11, -1, 5), (11, 11, 5), (-1, 11, 5)])],
                           rest="column: [upper, top, lower]\n")
        zone = next(r for r in report["regions"] if r["name"] == "F1.zone")
        self.assertLess(zone["volume"], 0.5 * 60)
        self.assertGreater(zone["volume"], 0.5 * 30)
        self.assertEqual([c["length"] for c in report["curves"] if c["kind"] == "fault_tip"], [10])
        names = {c["name"] for c in report["curves"]}
        self.assertLessEqual({"F1.minus*top", "F1.plus*top", "F1.minus*ymin"}, names)
        self.assertNotIn("F1*top", names)
        self.checked()

    def test_walls_follow_the_surfaces_that_they_cut(self):
        """A horizon that dips by 45 degrees across the fault stays plane, and sides of the box stay where they are."""
        slope = [(-1, -1, -1), (11, -1, 11), (11, 11, 11), (-1, 11, -1)]
        report = self.mesh("{F1: {thickness: 1}}", surfaces=[("F1", "fault", WALL), ("slope", "horizon", slope)], rest="column: [upper, slope, lower]\n")
        self.assertAlmostEqual(sum(r["volume"] for r in report["regions"]), 1000, delta=1e-9)
        faces = VtkFile.read(self.path("model.faces.vtp"))
        slope_id = faces["FieldData", "surface:slope"].values[0]
        points, ids, nodes = faces["Points", "Points"].values, faces["CellData", "surface"].values, faces["Polys", "connectivity"].values
        on = {n for f, surface in enumerate(ids) if surface == slope_id for n in nodes[3 * f:3 * f + 3]}
        self.assertGreater(len(on), 5)
        for n in on:
            self.assertAlmostEqual(points[3 * n], points[3 * n + 2], delta=1e-9)
        self.checked()

    def test_faults_with_throw_have_one_side_all_over(self):
        """Region ids change order along the fault, the walls do not change sides."""
        folder = os.path.join(SOURCE, "samples", "faulted-layers")
        with open(os.path.join(folder, "project.yaml")) as file:
            text = file.read().replace("file: surfaces", "file: " + folder + "/surfaces")
        project = self.write("project.yaml", text.replace("formats: [vtu]", "formats: [vtu], fault_zone: {west_fault: {thickness: 30, layers: 2}}") + "\nmesh: {size: 1000}\n")
        self.run_program(project, "-o", self.folder)
        stem = self.path("faulted_layers")
        self.check(stem + ".vtu", "--project", project)
        faces = VtkFile.read(stem + ".faces.vtp")
        points, nodes, ids = faces["Points", "Points"].values, faces["Polys", "connectivity"].values, faces["CellData", "surface"].values
        seen = []
        for wall in ("west_fault.minus", "west_fault.plus"):
            number = faces["FieldData", "surface:" + wall].values[0]
            ways = set()
            for f in (f for f, surface in enumerate(ids) if surface == number):
                a, b, c = ([points[3 * n + k] for k in range(3)] for n in nodes[3 * f:3 * f + 3])
                u, v = [q - p for p, q in zip(a, b)], [q - p for p, q in zip(a, c)]
                ways.add((u[1] * v[2] - u[2] * v[1]) > 0)
            self.assertEqual(len(ways), 1, wall)
            seen.append(ways)
        self.assertNotEqual(seen[0], seen[1])
        report = self.report(stem + ".report.json")
        zone = next(r for r in report["regions"] if r["name"] == "west_fault.zone")
        wall = next(s for s in report["surfaces"] if s["name"] == "west_fault.minus")
        self.assertAlmostEqual(zone["volume"] / (30 * wall["area"]), 1, delta=0.05)

    def test_zones_in_samples_pass(self):
        """A fault that ends inside and crosses another, faults that meet, a throw that dies out: with the sizes that the samples ship with."""
        for sample, fault in (("faulted-layers", "north_fault"), ("fault-junctions", "x_west"), ("dying-throw", "fault")):
            with self.subTest(sample):
                project = self.copy_of_sample(sample, None)
                with open(project) as file:
                    lines = [line for line in file.read().splitlines() if not line.startswith("output:")]
                with open(project, "w") as file:
                    file.write("\n".join(lines) + "\noutput: {formats: [vtu], fault_zone: {%s: {thickness: 10, layers: 2}}}\n" % fault)
                self.run_program(project, "-o", self.path(sample))
                mesh = next(f for f in os.listdir(self.path(sample)) if f.endswith(".vtu"))
                check = self.check(self.path(sample, mesh), "--project", project)
                self.assertIn(fault + ".zone", {r["name"] for r in check["regions"]})

    def test_what_cannot_be_opened_is_refused_by_name(self):
        cross = [(-1, 5, -1), (11, 5, -1), (11, 5, 11), (-1, 5, 11)]
        self.project("{F1: {thickness: 0.2}, F2: {thickness: 0.2}}", surfaces=[("F1", "fault", WALL), ("F2", "fault", cross)])
        said = self.run_program("project.yaml", status=CANNOT_MESH)
        self.assertIn("more than two sides of zones meet", said)
        self.assertRegex(said, "F1|F2")
        self.project("{F1: {thickness: 9.9}}", rest="points: [{name: well_head, at: [6, 5, 5]}]\n")
        self.assertIn("would be turned over", self.run_program("project.yaml", status=CANNOT_MESH))
        self.assert_nothing_written()
        for zones, words in (("{F9: {thickness: 1}}", "no surface F9"), ("{F1: {thickness: 0}}", "above 0"), ("{F1: {layers: 2}}", "thickness"),
                             ("{F1: {thickness: 1, layers: 1.5}}", "whole number"), ("[F1]", "map")):
            self.project(zones)
            self.assertIn(words, self.run_program("project.yaml", status=USAGE))
        self.project("{F1: {thickness: 1}}", output="split: [F1]")
        self.assertIn("split too", self.run_program("project.yaml", status=USAGE))

    def test_two_faults_that_meet_when_one_is_a_zone(self):
        cross = [(-1, 5, -1), (11, 5, -1), (11, 5, 11), (-1, 5, 11)]
        report = self.mesh("{F1: {thickness: 0.4}}", surfaces=[("F1", "fault", WALL), ("F2", "fault", cross)])
        self.assertAlmostEqual(next(s["area"] for s in report["surfaces"] if s["name"] == "F2"), 96, delta=1e-9)
        self.checked()

    def test_the_checker_sees_another_thickness_other_layers_and_moved_points(self):
        self.mesh("{F1: {thickness: 0.5, layers: 2}}")
        self.checked()
        with open(self.path("project.yaml")) as file:
            text = file.read()
        for asked in ("thickness: 0.7, layers: 2", "thickness: 0.5, layers: 3"):
            self.write("project.yaml", text.replace("thickness: 0.5, layers: 2", asked))
            self.assertIn("wrong_fault_zones", {f["id"] for f in self.checked(status=3)["faults"]})
        self.write("project.yaml", text)
        grid = VtkFile.read(self.path("model.vtu"))
        at = grid["PointData", "before_zones"]
        at.values = [x + (0.25 if i % 3 == 0 and abs(x - 5) < 1e-9 else 0) for i, x in enumerate(at.values)]
        grid.write(self.path("model.vtu"))
        self.assertTrue({f["id"] for f in self.checked(status=3)["faults"]})
        grid.remove("PointData", "before_zones")
        grid.write(self.path("model.vtu"))
        self.assertIn("wrong_fault_zones", {f["id"] for f in self.checked(status=3)["faults"]})

    def test_convert_opens_a_zone_too(self):
        self.project("{}")
        self.run_program("project.yaml")
        self.run_program("convert", "model.vtu", "-o", "open.msh", "--fault-zone", "F1=0.5,2")
        check = self.check(self.path("open.msh"), status=None)
        self.assertAlmostEqual(next(r["volume"] for r in check["regions"] if r["name"] == "F1.zone"), 50, delta=1e-9)
        self.run_program("convert", "model.vtu", "-o", "open.msh", "--fault-zone", "F1=0.5,2", "--split", "F1", status=USAGE)
        self.run_program("convert", "model.vtu", "-o", "open.msh", "--fault-zone", "F1", status=USAGE)

    def test_every_format_has_the_zone(self):
        self.project("{F1: {thickness: 0.5, layers: 2}}")
        self.run_program("project.yaml")
        report = self.report(self.path("model.report.json"))
        zone = next(r for r in report["regions"] if r["name"] == "F1.zone")
        for form, ending in (("msh", ".msh"), ("msh-binary", ".msh"), ("msh22", ".msh"), ("msh22-binary", ".msh"), ("inp", ".inp"), ("exodus", ".e"), ("med", ".med"),
                             ("xdmf", ".xdmf"), ("ogs", ".vtu"), ("openfoam", ".foam"), ("mfem", ".mesh"), ("pflotran", ".ugi"), ("tetgen", ".ele"), ("geos", ".vtm")):
            if not has_module(form):
                continue
            with self.subTest(form):
                folder = self.path(form)
                os.makedirs(folder)
                out = os.path.join(folder, "m" + ending)
                self.run_program("convert", "model.vtu", "-o", out, "--format", form)
                sidecars = [self.report(os.path.join(where, f)) for where, _, names in os.walk(folder) for f in names if f.endswith(".json")]
                full = {g["full_name"] for s in sidecars for g in s["groups"]}
                self.assertIn("F1.zone", full)
                self.assertTrue(any(name.startswith("F1.minus") for name in full), full)
                if form in ("msh", "msh-binary", "msh22", "msh22-binary", "inp", "exodus", "med"):
                    back = {r["name"]: r for r in self.check(out, status=None)["regions"]}
                    self.assertEqual(back[plain("F1.zone")]["tetrahedra"], zone["tetrahedra"])
                    self.assertAlmostEqual(back[plain("F1.zone")]["volume"], 50, delta=1e-9)

    def test_gmsh_reads_the_walls(self):
        self.project("{F1: {thickness: 0.5, layers: 2}}", output="formats: [msh]")
        self.run_program("project.yaml")
        try:
            found = readers.gmsh(self.path("model.msh"), self.report(self.path("model.msh.json")))
        except readers.ReaderMissing as missing:
            self.skipTest("skipped: %s is not installed" % missing)
        self.assertAlmostEqual(found.regions["F1.zone"][1], 50, delta=1e-9)
        for wall in ("F1.minus", "F1.plus"):
            self.assertAlmostEqual(found.faces[wall][1], 100, delta=1e-9)


@unittest.skipUnless(shutil.which("ccx"), "skipped: calculix-ccx is not installed")
class Solved(Deck):
    def model(self, order):
        return self.mesh({"F1": ("fault", plane_ts("F1", WALL))},
                         "attributes: {F1.zone: {conductivity: 0.05}}\nmesh: {size: 4}\noutput: {directory: ., formats: [inp, vtu], order: %d, fault_zone: {F1: {thickness: 0.5, layers: 2}}}\n" % order)

    def heat(self, order):
        """Blocks of conductivity 1 on both sides of a zone of 0.05: by far the most of the drop is in the zone."""
        self.model(order)
        deck = "*INCLUDE, INPUT=model.inp\n"
        for name in ("region_1", "region_2", "F1.zone"):
            deck += "*MATERIAL, NAME=m_%s\n*CONDUCTIVITY\n%g\n*SOLID SECTION, MATERIAL=m_%s, ELSET=%s\n" % (name, 0.05 if name == "F1.zone" else 1, name, name)
        deck += "*STEP\n*HEAT TRANSFER, STEADY STATE\n*BOUNDARY\nxmin, 11, 11, 100\nxmax, 11, 11, 0\n*NODE PRINT, NSET=F1.minus\nNT\n*NODE PRINT, NSET=F1.plus\nNT\n*END STEP\n"
        rows = self.rows(deck, "temperatures for set")
        flux = 100 / (4.75 + 0.5 / 0.05 + 4.75)
        place = self.heights()
        self.assertEqual({place[int(node)][0] for node, _ in rows}, {4.75, 5.25})
        for node, temperature in rows:
            self.assertAlmostEqual(temperature, 100 - flux * 4.75 if place[int(node)][0] < 5 else flux * 4.75, delta=1e-3)

    def test_heat_across_a_zone(self):
        self.heat(1)

    def test_heat_across_a_zone_second_order(self):
        self.heat(2)

    def test_a_weak_zone_takes_the_shear(self):
        """Uniaxial strain across three layers in series, the middle one soft."""
        self.model(1)
        deck = "*INCLUDE, INPUT=model.inp\n"
        for name in ("region_1", "region_2", "F1.zone"):
            deck += "*MATERIAL, NAME=m_%s\n*ELASTIC\n%g, 0.25\n*SOLID SECTION, MATERIAL=m_%s, ELSET=%s\n" % (name, 1e8 if name == "F1.zone" else 1e9, name, name)
        deck += "*STEP\n*STATIC\n*BOUNDARY\nymin, 2, 2\nymax, 2, 2\nzmin, 3, 3\nzmax, 3, 3\nxmin, 1, 1\nxmax, 1, 1, 0.01\n*NODE PRINT, NSET=F1.minus\nU\n*NODE PRINT, NSET=F1.plus\nU\n*END STEP\n"
        total = 4.75 + 5 + 4.75
        place = self.heights()
        rows = self.rows(deck, "displacements")
        self.assertGreaterEqual(len(rows), 8)
        for node, moved, _, _ in rows:
            self.assertAlmostEqual(moved, 0.01 * (4.75 if place[int(node)][0] < 5 else 9.75) / total, delta=1e-6)


if __name__ == "__main__":
    main()
