# SPDX-License-Identifier: GPL-3.0-or-later
"""`output.fractures_only`: triangles of two squares and of a network without tetrahedra, with areas and junctions that are known."""
import json
import math
import os
import unittest
from collections import Counter

from geomesh_program import USAGE, ProgramTest, has_module, main

try:
    import meshio
except ImportError:
    meshio = None

SQUARES = "2,2,5,8,2,5,8,8,5,2,8,5\n5,3,2,5,7,2,5,7,8,5,3,8\n"  # areas 36 and 24, a junction of length 4
FORMATS = {"vtu": ".vtu", "msh": ".msh", "msh22": ".msh", "avs": ".avs", "mfem": ".mesh", "xdmf": ".xdmf", "stl": ".stl", "obj": ".obj",
           "glb": ".glb", "tsurf": ".ts"}


def area(corners):
    (a, b, c) = corners
    u, v = [q - p for p, q in zip(a, b)], [q - p for p, q in zip(a, c)]
    return 0.5 * math.sqrt(sum((u[i - 1] * v[i] - u[i] * v[i - 1]) ** 2 for i in range(3)))


class Triangles:
    """Nodes, triangles and edges by the name of their group, of a mesh in Gmsh 2.2, AVS or MFEM. Nothing else may be in the file."""

    def __init__(self, file):
        self.nodes, self.triangles, self.edges = [], {}, {}
        with open(file) as text:
            rows = [line.split() for line in text]
        with open(file + ".json") as sidecar:
            self.names = {(g["dimension"], g["id"]): g["full_name"] for g in json.load(sidecar)["groups"]}
        {".msh": self.gmsh, ".avs": self.avs, ".mesh": self.mfem}[os.path.splitext(file)[1]](rows)

    def add(self, dimension, group, nodes):
        assert len(nodes) == dimension + 1 and len(set(nodes)) == len(nodes)
        (self.edges if dimension == 1 else self.triangles).setdefault(self.names[dimension, group], []).append(nodes)

    def gmsh(self, rows):
        at = rows.index(["$Nodes"])
        n = int(rows[at + 1][0])
        self.nodes = [tuple(map(float, row[1:])) for row in rows[at + 2:at + 2 + n]]
        at = rows.index(["$Elements"])
        for row in rows[at + 2:at + 2 + int(rows[at + 1][0])]:
            kind, n_tags, group = int(row[1]), int(row[2]), int(row[3])
            assert kind in (1, 2), "an element of type %d" % kind
            self.add(kind, group, [int(v) - 1 for v in row[3 + n_tags:]])

    def avs(self, rows):
        n, n_cells = int(rows[0][0]), int(rows[0][1])
        self.nodes = [tuple(map(float, row[1:])) for row in rows[1:1 + n]]
        for row in rows[1 + n:1 + n + n_cells]:
            assert row[2] == "tri"
            self.add(2, int(row[1]), [int(v) - 1 for v in row[3:]])

    def mfem(self, rows):
        assert rows[rows.index(["dimension"]) + 1] == ["2"]
        for title, dimension in (("elements", 2), ("boundary", 1)):
            at = rows.index([title])
            for row in rows[at + 2:at + 2 + int(rows[at + 1][0])]:
                assert int(row[1]) == dimension
                self.add(dimension, int(row[0]), [int(v) for v in row[2:]])
        at = rows.index(["vertices"])
        self.nodes = [tuple(map(float, row)) for row in rows[at + 3:at + 3 + int(rows[at + 1][0])]]

    def area(self, name):
        return sum(area([self.nodes[v] for v in t]) for t in self.triangles[name])

    def length(self, name):
        return sum(math.dist(self.nodes[a], self.nodes[b]) for a, b in self.edges[name])

    def sides(self, name):
        """How many triangles of the surface have each edge."""
        return Counter(tuple(sorted((t[i], t[(i + 1) % 3]))) for t in self.triangles[name] for i in range(3))


class FracturesAlone(ProgramTest):
    def run_network(self, fractures, output, size=2, status=0):
        project = self.write("network.yaml", "box: {min: [0, 0, 0], max: [10, 10, 10]}\nfractures: %s\nmesh: {size: %g}\n"
                             "output: {directory: out, fractures_only: true, %s}\n" % (fractures, size, output))
        return self.run_program(project, status=status)

    def verify_squares(self, mesh):
        self.assertEqual(sorted(mesh.triangles), ["fracture_1", "fracture_2"])
        self.assertAlmostEqual(mesh.area("fracture_1"), 36, delta=36e-9)
        self.assertAlmostEqual(mesh.area("fracture_2"), 24, delta=24e-9)
        self.assertEqual({v for rows in mesh.triangles.values() for t in rows for v in t}, set(range(len(mesh.nodes))))
        self.assertEqual(len(set(mesh.nodes)), len(mesh.nodes))
        first, second = mesh.sides("fracture_1"), mesh.sides("fracture_2")
        both = set(first) & set(second)
        self.assertAlmostEqual(sum(math.dist(mesh.nodes[a], mesh.nodes[b]) for a, b in both), 4, delta=1e-9)
        self.assertEqual({first[e] for e in both} | {second[e] for e in both}, {2})

    def test_two_squares_have_their_areas_and_share_the_nodes_of_their_junction(self):
        self.write("two.csv", SQUARES)
        for name in ("msh22", "avs", "mfem"):
            self.run_network("{file: two.csv}", "formats: [%s]" % name)
            mesh = Triangles(self.path("out", "network" + FORMATS[name]))
            self.verify_squares(mesh)
            if name == "avs":  # it holds no curves
                continue
            junction = [c for c in mesh.edges if set(c.split("*")) == {"fracture_1", "fracture_2"}]
            self.assertEqual(len(junction), 1, name)
            self.assertAlmostEqual(mesh.length(junction[0]), 4, delta=1e-9)
            outlines = sum(mesh.length(c) for c in mesh.edges if c not in junction)
            self.assertAlmostEqual(outlines, 24 + 20, delta=1e-9)

    @unittest.skipIf(meshio is None, "skipped: the Python package meshio is not installed")
    def test_the_triangles_are_cells_of_the_vtu_itself(self):
        self.write("two.csv", SQUARES)
        self.run_network("{file: two.csv}", "formats: [vtu]")
        mesh = meshio.read(self.path("out", "network.vtu"))
        self.assertEqual(set(mesh.cells_dict), {"triangle", "line"})
        total = sum(area([mesh.points[v] for v in t]) for t in mesh.cells_dict["triangle"])
        self.assertAlmostEqual(total, 60, delta=60e-9)
        self.assertEqual(len(set(mesh.cell_data_dict["region"]["triangle"])), 2)
        self.assertFalse(os.path.exists(self.path("out", "network.faces.vtp")))

    def test_each_junction_of_a_network_has_nodes_of_both_fractures(self):
        self.run_network("{seed: 3, corners: 12, families: [{name: steep, dip_direction: 70, dip: 80, kappa: 10, radius: 2, count: 20}, "
                         "{name: flat, dip: 10, kappa: 10, radius: 2, count: 20}]}", "formats: [msh22]", 1.2)
        mesh, report = Triangles(self.path("out", "network.msh")), self.report(self.path("out", "network.report.json"))
        areas = {s["name"]: s["area"] for s in report["surfaces"] if s["kind"] == "fault"}
        self.assertEqual(set(mesh.triangles), set(areas))
        for name, value in areas.items():
            self.assertAlmostEqual(mesh.area(name) / value, 1, delta=1e-12, msg=name)
        n = 0
        for curve, edges in mesh.edges.items():
            names = [name for name in curve.split("*") if name in areas]
            n += len(names) > 1
            for name in names:
                self.assertTrue({tuple(sorted(e)) for e in edges} <= set(mesh.sides(name)), curve)
        self.assertGreater(n, 10)

    def test_every_format_that_holds_triangles_alone_is_written(self):
        self.write("two.csv", SQUARES)
        for name, extension in FORMATS.items():
            if has_module(name):
                self.run_network("{file: two.csv}", "formats: [%s]" % name)
                self.assertTrue(os.path.exists(self.path("out", "network" + extension)), name)

    def test_a_mesh_that_is_there_is_converted(self):
        self.write("two.csv", SQUARES)
        self.run_program(self.write("whole.yaml", "box: {min: [0, 0, 0], max: [10, 10, 10]}\nfractures: {file: two.csv}\nmesh: {size: 2}\n"))
        self.run_program("convert", "out/whole.vtu", "-o", "alone.msh", "--format", "msh22", "--fractures-only")
        self.verify_squares(Triangles(self.path("alone.msh")))

    def test_what_needs_tetrahedra_is_refused_before_anything_is_meshed(self):
        self.write("two.csv", SQUARES)
        for output, words in (("formats: [exodus]", "the format exodus holds no fractures alone"), ("formats: [msh], order: 2", "order: 2 needs"),
                              ("formats: [msh], split: [fracture_1]", "split needs"), ("formats: [msh], partitions: 2", "partitions needs")):
            self.assertIn(words, self.run_network("{file: two.csv}", output, status=USAGE))
        printed = self.run_program(self.write("none.yaml", "box: {min: [0, 0, 0], max: [10, 10, 10]}\n"
                                              "output: {fractures_only: true}\n"), status=USAGE)
        self.assertIn("neither fractures nor faults", printed)


if __name__ == "__main__":
    main()
