#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Voronoi grids for PFLOTRAN and TOUGH, and split nodes for GEOS."""
import os
import random
import xml.etree.ElementTree as tree

import format_readers as readers
from geomesh_program import CANNOT_MESH, ProgramTest, main
from test_formats import FormatTest

N = 6


class VoronoiGrids(ProgramTest):
    def mesh(self):
        """Points of a lattice 0..5, the inner ones moved a little: Delaunay, all circumcentres inside."""
        random.seed(3)
        lines = []
        for x in range(N):
            for y in range(N):
                for z in range(N):
                    inner = all(0 < c < N - 1 for c in (x, y, z))
                    lines.append(" ".join("%.17g" % (c + (random.uniform(-0.15, 0.15) if inner else 0)) for c in (x, y, z)))
        self.write("points.xyz", "\n".join(lines) + "\n")
        self.run_program("delaunay", "points.xyz", "-o", "cube.vtu")
        return self.path("cube.vtu")

    def read_uge(self, path):
        with open(path) as file:
            words = file.read().split()
        n = int(words[1])
        cells = [(int(words[2 + 5 * i]), *map(float, words[3 + 5 * i:7 + 5 * i])) for i in range(n)]
        at = 2 + 5 * n
        m = int(words[at + 1])
        links = [(int(words[at + 2 + 6 * i]), int(words[at + 3 + 6 * i]), *map(float, words[at + 4 + 6 * i:at + 8 + 6 * i])) for i in range(m)]
        self.assertEqual(len(words), at + 2 + 6 * m)
        return cells, links

    def test_pflotran_cells_fill_the_mesh_and_faces_close_about_every_inner_cell(self):
        self.run_program("convert", self.mesh(), "-o", "m.uge")
        cells, links = self.read_uge(self.path("m.uge"))
        self.assertEqual([c[0] for c in cells], list(range(1, N ** 3 + 1)))
        self.assertAlmostEqual(sum(c[4] for c in cells), (N - 1) ** 3, delta=1e-9)
        self.assertTrue(all(c[4] > 0 for c in cells))
        place = {c[0]: c[1:4] for c in cells}
        closed = {number: [0.0, 0.0, 0.0] for number in place}
        for a, b, x, y, z, area in links:
            self.assertGreater(area, 0)
            along = [q - p for p, q in zip(place[a], place[b])]
            length = sum(d * d for d in along) ** 0.5
            for k, c in enumerate((x, y, z)):
                self.assertAlmostEqual(c, (place[a][k] + place[b][k]) / 2, delta=1e-12)
                closed[a][k] += area * along[k] / length
                closed[b][k] -= area * along[k] / length
        inner = [n for n, p in place.items() if all(0.3 < c < N - 1.3 for c in p)]
        self.assertEqual(len(inner), (N - 2) ** 3)
        for number in inner:  # so that a linear field has no residual: two-point fluxes are consistent
            self.assertLess(max(map(abs, closed[number])), 1e-10)
        sidecar = self.report(self.path("m.uge.json"))
        self.assertEqual(sidecar["negative_areas"], 0)
        groups = sidecar["groups"]
        with open(self.path(next(g["name"] for g in groups if g["dimension"] == 3))) as file:
            self.assertEqual(list(map(int, file.read().split())), list(range(1, N ** 3 + 1)))

    def test_tough_has_the_same_cells_and_connections_in_its_columns(self):
        mesh = self.mesh()
        self.run_program("convert", mesh, "-o", "m.uge")
        self.run_program("convert", mesh, "-o", "m.tough")
        cells, links = self.read_uge(self.path("m.uge"))
        with open(self.path("m.tough")) as file:
            elements, connections = file.read().split("\n\n")[:2]
        elements, connections = elements.splitlines(), connections.splitlines()
        self.assertTrue(elements[0].startswith("ELEME") and connections[0].startswith("CONNE"))
        names = [line[:5] for line in elements[1:]]
        self.assertEqual((len(names), len(set(names))), (len(cells), len(cells)))
        for line, cell in zip(elements[1:], cells):
            self.assertEqual(line[15:20], "R0001")
            self.assertAlmostEqual(float(line[20:30]) / cell[4], 1, delta=1e-4)
            for k in range(3):
                self.assertAlmostEqual(float(line[50 + 10 * k:60 + 10 * k]), cell[1 + k], delta=1e-4)
        self.assertEqual(len(connections) - 1, len(links))
        place = {c[0]: c[1:4] for c in cells}
        for line, (a, b, _, _, _, area) in zip(connections[1:], links):
            self.assertEqual((line[:5], line[5:10], line[29]), (names[a - 1], names[b - 1], "1"))
            length = sum((q - p) ** 2 for p, q in zip(place[a], place[b])) ** 0.5
            self.assertAlmostEqual(float(line[30:40]), length / 2, delta=1e-4)
            self.assertAlmostEqual(float(line[40:50]), length / 2, delta=1e-4)
            self.assertAlmostEqual(float(line[50:60]), area, delta=1e-4)
            self.assertAlmostEqual(float(line[60:70]), (place[a][2] - place[b][2]) / length, delta=1e-4)


class NotDelaunay(FormatTest):
    def test_a_mesh_that_is_not_delaunay_is_refused_with_the_place(self):
        for name in ("m.uge", "m.tough"):
            said = self.run_program("convert", self.stem + ".vtu", "-o", name, status=CANNOT_MESH)
            self.assertRegex(said, "not Delaunay")
            self.assertRegex(said, r"the first at \(")
            self.assertFalse(os.path.exists(self.path(name)))


class Geos(FormatTest):
    def test_blocks_and_split_nodes_by_vtk(self):
        fault = next(s["name"] for s in self.model["surfaces"] if s["kind"] == "fault" and any(c["kind"] == "fault_tip" and c["name"].startswith(s["name"]) for c in self.model["curves"]))
        self.convert("m.vtm", "--split", fault)
        try:
            vtk = readers.need("vtk")
            readers.need("numpy")
        except readers.ReaderMissing as missing:
            self.skipTest("skipped: %s is not installed" % missing)
        from vtk.util.numpy_support import vtk_to_numpy
        reader = vtk.vtkXMLMultiBlockDataReader()
        reader.SetFileName(self.path("m.vtm"))
        reader.Update()
        blocks = {reader.GetOutput().GetMetaData(i).Get(vtk.vtkCompositeDataSet.NAME()): reader.GetOutput().GetBlock(i) for i in range(reader.GetOutput().GetNumberOfBlocks())}
        self.assertEqual(sorted(blocks), sorted(["main", fault]))
        main_block, cut = blocks["main"], blocks[fault]
        attribute = vtk_to_numpy(main_block.GetCellData().GetArray(0))
        self.assertEqual(main_block.GetCellData().GetArray(0).GetName(), "attribute")
        for region in self.model["regions"]:
            self.assertEqual(int((attribute == region["id"]).sum()), region["tetrahedra"])
        points, nodes = vtk_to_numpy(main_block.GetPoints().GetData()), vtk_to_numpy(cut.GetPointData().GetArray("collocated_nodes"))
        places = vtk_to_numpy(cut.GetPoints().GetData())
        width = 1 if nodes.ndim == 1 else nodes.shape[1]
        self.assertGreaterEqual(width, 2)
        counts = {}
        for place, row in zip(places.tolist(), nodes.tolist()):
            own = [n for n in row if n >= 0]
            self.assertEqual(len(own), len(set(own)))
            counts[len(own)] = counts.get(len(own), 0) + 1
            for node in own:
                self.assertEqual(points[node].tolist(), place)
        self.assertGreater(counts.get(1, 0), 0)  # at the tip
        self.assertGreater(counts.get(2, 0), 0)
        cells = vtk_to_numpy(cut.GetCells().GetConnectivityArray()).reshape(-1, 3)
        surface = next(s for s in self.model["surfaces"] if s["name"] == fault)
        self.assertLessEqual(readers.measure(places, cells)[1] / surface["area"], 1 + 1e-9)
        self.assertGreater(readers.measure(places, cells)[1] / surface["area"], 0.9)
        root = tree.parse(self.path("m.geos.xml")).getroot()
        listed = {b.strip("{} ") for r in root.iter("CellElementRegion") for b in r.get("cellBlocks").split(",")}
        self.assertEqual(listed, {"%d_tetrahedra" % r["id"] for r in self.model["regions"]})
        self.assertIn(fault, root.find("Mesh").find("VTKMesh").get("faceBlocks"))


if __name__ == "__main__":
    main()
