#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""CalculiX solves on what the formats hold: heat and elasticity of first and second order, and a fault with doubled nodes."""
import shutil
import subprocess
import unittest

from geomesh_program import ProgramTest, level, main, plane_ts


def rows_below(path, title):
    """Rows of numbers below each line with `title`, to the next text."""
    rows, reading = [], False
    with open(path) as file:
        for line in file:
            if title in line:
                reading = True
                continue
            words = line.split()
            try:
                values = [float(word) for word in words]
            except ValueError:
                reading = False
                continue
            if reading and values:
                rows.append(values)
    return rows


class Deck(ProgramTest):
    """A box of ten by ten by ten, and CalculiX' answers on its mesh."""

    def mesh(self, surfaces, rest):
        """Meshes surfaces (name -> (kind, text)) in the box 0..10; returns the stem of the mesh."""
        text = "name: model\nbox: {min: [0, 0, 0], max: [10, 10, 10]}\nsurfaces:\n"
        for name, (kind, content) in surfaces.items():
            self.write(name + ".ts", content)
            text += "  - {name: %s, kind: %s, file: %s.ts}\n" % (name, kind, name)
        self.write("project.yaml", text + rest)
        self.run_program("project.yaml")
        return self.path("model")

    def solve(self, deck):
        self.write("job.inp", deck)
        done = subprocess.run(["ccx", "job"], cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=200)
        self.assertEqual(done.returncode, 0, done.stdout[-2000:])
        self.assertNotIn("*ERROR", done.stdout)
        return self.path("job.dat")

    def rows(self, deck, title):
        return rows_below(self.solve(deck), title)

    def heights(self):
        heights, reading = {}, False
        with open(self.path("model.inp")) as file:
            for line in file:
                if line.startswith("*"):
                    reading = line.startswith("*NODE") and len(line.strip()) == 5
                elif reading:
                    number, x, y, z = line.split(",")
                    heights[int(number)] = (float(x), float(y), float(z))
        return heights


@unittest.skipUnless(shutil.which("ccx"), "skipped: calculix-ccx is not installed")
class Solved(Deck):
    def layers(self, order):
        return self.mesh({"upper": ("horizon", level("upper", 7)), "lower": ("horizon", level("lower", 4))},
                         "column: [top, upper, middle, lower, bottom]\nmesh: {size: 4}\noutput: {directory: ., formats: [inp, vtu], order: %d}\n" % order)

    def heat(self, order):
        self.layers(order)
        conductivity = {"top": 1.0, "middle": 2.0, "bottom": 4.0}
        thickness = {"top": 3.0, "middle": 3.0, "bottom": 4.0}
        deck = "*INCLUDE, INPUT=model.inp\n"
        for unit, value in conductivity.items():
            deck += "*MATERIAL, NAME=m_%s\n*CONDUCTIVITY\n%g\n*SOLID SECTION, MATERIAL=m_%s, ELSET=%s\n" % (unit, value, unit, unit)
        deck += "*STEP\n*HEAT TRANSFER, STEADY STATE\n*BOUNDARY\nzmin, 11, 11, 100\nzmax, 11, 11, 0\n*NODE PRINT, NSET=upper\nNT\n*NODE PRINT, NSET=lower\nNT\n*END STEP\n"
        rows = rows_below(self.solve(deck), "temperatures for set")
        flux = 100 / sum(thickness[unit] / conductivity[unit] for unit in conductivity)
        wanted = {7.0: flux * 3, 4.0: flux * 3 + flux * 1.5}
        place = self.heights()
        self.assertGreaterEqual(len(rows), 8)
        for node, temperature in rows:
            self.assertAlmostEqual(temperature, wanted[place[int(node)][2]], delta=1e-4 * 100)

    def test_heat_through_three_layers_first_order(self):
        self.heat(1)

    def test_heat_through_three_layers_second_order(self):
        self.heat(2)

    def compression(self, order):
        """Uniaxial strain of layers in series: each compresses by its own share."""
        self.layers(order)
        modulus = {"top": 1.0e9, "middle": 2.0e9, "bottom": 4.0e9}
        deck = "*INCLUDE, INPUT=model.inp\n"
        for unit, value in modulus.items():
            deck += "*MATERIAL, NAME=m_%s\n*ELASTIC\n%g, 0.25\n*SOLID SECTION, MATERIAL=m_%s, ELSET=%s\n" % (unit, value, unit, unit)
        deck += "*STEP\n*STATIC\n*BOUNDARY\nxmin, 1, 1\nxmax, 1, 1\nymin, 2, 2\nymax, 2, 2\nzmin, 3, 3\nzmax, 3, 3, -0.01\n"
        deck += "*NODE PRINT, NSET=upper\nU\n*NODE PRINT, NSET=lower\nU\n*END STEP\n"
        rows = rows_below(self.solve(deck), "displacements")
        compliance = {"top": 3 / 1.0, "middle": 3 / 2.0, "bottom": 4 / 4.0}
        total = sum(compliance.values())
        wanted = {4.0: -0.01 * compliance["bottom"] / total, 7.0: -0.01 * (compliance["bottom"] + compliance["middle"]) / total}
        place = self.heights()
        self.assertGreaterEqual(len(rows), 8)
        for node, _, _, settled in rows:
            self.assertAlmostEqual(settled, wanted[place[int(node)][2]], delta=1e-6)

    def test_layers_compressed_first_order(self):
        self.compression(1)

    def test_layers_compressed_second_order(self):
        self.compression(2)

    def split_model(self, fault, extra=""):
        return self.mesh({"F1": ("fault", fault)}, "column: []\nmesh: {size: 4}\noutput: {directory: ., formats: [inp, vtu], split: [F1]%s}\n".replace("column: []\n", "") % extra)

    def test_a_block_slides_on_a_fault_whose_nodes_are_doubled(self):
        """The fault cuts the box in two at x = 5. One half is moved along it, the other stays: no stress, no motion of the other."""
        self.split_model(plane_ts("F1", [(5, -1, -1), (5, 11, -1), (5, 11, 11), (5, -1, 11)]))
        deck = "*INCLUDE, INPUT=model.inp\n*MATERIAL, NAME=rock\n*ELASTIC\n1e9, 0.25\n"
        regions = [r["name"] for r in self.report(self.path("model.report.json"))["regions"]]
        self.assertEqual(len(regions), 2)
        names = [g["name"] for g in self.report(self.path("model.inp.json"))["groups"] if g["type"] == "elset"]
        for name in names:
            deck += "*SOLID SECTION, MATERIAL=rock, ELSET=%s\n" % name
        deck += "*STEP\n*STATIC\n*BOUNDARY\nxmin, 1, 3\nxmax, 1, 2\nxmax, 3, 3, 0.5\n*NODE PRINT, NSET=F1.minus\nU\n*NODE PRINT, NSET=F1.plus\nU\n*END STEP\n"
        rows = rows_below(self.solve(deck), "displacements")
        self.assertGreaterEqual(len(rows), 8)
        moved = [round(row[3], 6) for row in rows]
        self.assertEqual(set(moved), {0.0, 0.5})
        self.assertEqual(moved.count(0.0), moved.count(0.5))

    def node_set(self, name):
        nodes, reading = [], False
        with open(self.path("model.inp")) as file:
            for line in file:
                if line.startswith("*"):
                    reading = line.split() == ["*NSET,", "NSET=" + name]
                elif reading:
                    nodes += [int(word) for word in line.replace(",", " ").split()]
        return nodes

    def test_a_fault_slips_under_springs(self):
        """Stiff halves, held together across the fault and pulled past each other: the slip is the force over the sum of the springs."""
        self.split_model(plane_ts("F1", [(5, -1, -1), (5, 11, -1), (5, 11, 11), (5, -1, 11)]))
        place, force, spring = self.heights(), 3.0e6, 2.0e6
        plus = {place[node]: node for node in self.node_set("F1.plus")}
        pairs = [(node, plus[place[node]]) for node in self.node_set("F1.minus")]
        self.assertGreaterEqual(len(pairs), 8)
        loaded = self.node_set("xmax")
        deck = "*INCLUDE, INPUT=model.inp\n*MATERIAL, NAME=rock\n*ELASTIC\n1e13, 0.25\n"
        for name in [g["name"] for g in self.report(self.path("model.inp.json"))["groups"] if g["type"] == "elset"]:
            deck += "*SOLID SECTION, MATERIAL=rock, ELSET=%s\n" % name
        deck += "*ELEMENT, TYPE=SPRING2, ELSET=springs\n" + "".join("%d, %d, %d\n" % (10 ** 6 + k, a, b) for k, (a, b) in enumerate(pairs))
        deck += "*SPRING, ELSET=springs\n3,3\n%.1f\n" % spring
        deck += "".join("*EQUATION\n2\n%d, %d, 1.0, %d, %d, -1.0\n" % (b, axis, a, axis) for a, b in pairs for axis in (1, 2))
        deck += "*STEP\n*STATIC\n*BOUNDARY\nxmin, 1, 3\nxmax, 1, 2\n*CLOAD\n" + "".join("%d, 3, %.12g\n" % (node, force / len(loaded)) for node in loaded)
        deck += "*NODE PRINT, NSET=F1.minus\nU\n*NODE PRINT, NSET=F1.plus\nU\n*END STEP\n"
        moved = {int(row[0]): row[3] for row in rows_below(self.solve(deck), "displacements")}
        wanted = force / (spring * len(pairs))
        for a, b in pairs:
            self.assertAlmostEqual((moved[b] - moved[a]) / wanted, 1, delta=1e-3)

    def test_a_fault_that_ends_inside_opens_but_for_its_tip(self):
        """Pulled apart, a crack from x = 0 to x = 5 opens at its mouth and is closed at its tip."""
        self.split_model(plane_ts("F1", [(-1, -1, 5), (5, -1, 5), (5, 11, 5), (-1, 11, 5)]))
        place = self.heights()
        deck = "*INCLUDE, INPUT=model.inp\n*MATERIAL, NAME=rock\n*ELASTIC\n1e9, 0.25\n"
        names = [g["name"] for g in self.report(self.path("model.inp.json"))["groups"] if g["type"] == "elset"]
        for name in names:
            deck += "*SOLID SECTION, MATERIAL=rock, ELSET=%s\n" % name
        deck += "*STEP\n*STATIC\n*BOUNDARY\nzmin, 1, 3\nzmax, 1, 2\nzmax, 3, 3, 0.1\n*NODE PRINT, NSET=F1.minus\nU\n*NODE PRINT, NSET=F1.plus\nU\n*END STEP\n"
        rows = rows_below(self.solve(deck), "displacements")
        at = {}
        for node, _, _, up in rows:
            at.setdefault(place[int(node)], {})[int(node)] = up
        tip = [nodes for p, nodes in at.items() if p[0] == 5]
        mouth = [nodes for p, nodes in at.items() if p[0] == 0]
        self.assertGreaterEqual(len(tip), 2)
        self.assertEqual({len(nodes) for nodes in tip}, {1})
        self.assertEqual({len(nodes) for nodes in mouth}, {2})
        for nodes in mouth:
            self.assertGreater(max(nodes.values()) - min(nodes.values()), 0.01)

    def test_cohesive_prisms_have_coh3d6_nodes_in_pairs(self):
        self.split_model(plane_ts("F1", [(5, -1, -1), (5, 11, -1), (5, 11, 11), (5, -1, 11)]), ", cohesive: true")
        place, prisms, reading = self.heights(), 0, False
        with open(self.path("model.inp")) as file:
            for line in file:
                if line.startswith("*"):
                    reading = "TYPE=COH3D6" in line
                    continue
                if not reading:
                    continue
                nodes = [int(word) for word in line.split(",")][1:]
                prisms += 1
                for k in range(3):
                    self.assertNotEqual(nodes[k], nodes[k + 3])
                    self.assertEqual(place[nodes[k]], place[nodes[k + 3]])
        self.assertGreater(prisms, 1)


if __name__ == "__main__":
    main()
