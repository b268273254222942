#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""geomesh check --project of the forms that a project may ask of its files: split surfaces, one grid for all cells, files without curves.
Each form passes, and what is broken in it is found."""
import json
import os
import shutil

from geomesh_program import ProgramTest, level, main, triangles_ts
from vtk_files import VtkFile

MODEL = {
    "name": "m", "box": {"min": [0, 0, 0], "max": [10, 10, 10]},
    "surfaces": [{"name": "h", "kind": "horizon", "file": "h.ts"}, {"name": "f", "kind": "fault", "file": "f.ts"}, {"name": "g", "kind": "fault", "file": "g.ts"}],
    "column": ["upper", "h", "lower"], "wells": [{"name": "w", "file": "w.pl"}], "points": [{"name": "gauge", "at": [2, 2, 2]}],
    "mesh": {"size": 2.5},
}


class FormsChecked(ProgramTest):
    def setUp(self):
        """Fault f ends inside, g goes through; both cross the horizon, and each other."""
        super().setUp()
        self.write("h.ts", level("h", 5.3, -1, 11))
        self.write("f.ts", triangles_ts("f", [(2.5, 3, 1.5), (7.5, 3.5, 1.5), (7.5, 3.5, 8.5), (2.5, 3, 8.5)], [(0, 1, 2), (0, 2, 3)]))
        self.write("g.ts", triangles_ts("g", [(5, -1, -1), (5, 11, -1), (5, 11, 11), (5, -1, 11)], [(0, 1, 2), (0, 2, 3)]))
        self.write("w.pl", "GOCAD PLine 1\nHEADER {\nname:w\n}\nILINE\nVRTX 1 8 8 10\nVRTX 2 8 8 4\nSEG 1 2\nEND\n")

    def mesh(self, **output):
        """Meshes with this output, in a folder of its own; the mesh's path."""
        self.project = self.write("m.yaml", json.dumps({**MODEL, "output": {"directory": "out", "formats": ["vtu"], **output}}))
        shutil.rmtree(self.path("out"), ignore_errors=True)
        self.run_program(self.project)
        return self.path("out", "m.pvtu" if "partitions" in output else "m.vtu")

    def checked(self, mesh, status=0):
        """What was checked; with a status other than 0 the kinds of fault."""
        report = self.check(mesh, "--project", self.project, status=status)
        return {fault["id"] for fault in report["faults"]} if status else " ".join(report["checks_done"])

    def test_split_surfaces_are_checked_with_their_sides_joined(self):
        for output in ({"split": ["f"]}, {"split": ["f", "g"]}, {"split": ["g", "f"], "cohesive": True}, {"split": ["g"], "order": 2},
                       {"split": ["f", "g"], "partitions": 2}, {"split": ["f"], "single_grid": True, "cohesive": True}):
            with self.subTest(output):
                done = self.checked(self.mesh(**output))
                self.assertIn("each there once on either side", done)
                self.assertIn("curves of surfaces are", done)
                self.assertIn("regions were held against", done)

    def broken(self, change, **output):
        """The kinds of fault once `change` had its way with the mesh and its face set."""
        mesh = self.mesh(**output)
        files = [VtkFile.read(path) for path in (mesh, mesh[:-4] + ".faces.vtp") if os.path.exists(path)]
        change(*files)
        for file, ending in zip(files, (".vtu", ".faces.vtp")):
            file.write(mesh[:-4] + ending)
        return self.checked(mesh, status=3)

    @staticmethod
    def twins(grid):
        """Pairs of nodes in one place."""
        points, seen, pairs = grid["Points", "Points"].values, {}, []
        for row in range(grid.n_points()):
            first = seen.setdefault(tuple(points[3 * row:3 * row + 3]), row)
            if first != row:
                pairs.append((first, row))
        return pairs

    def test_what_is_wrong_with_split_surfaces_is_found(self):
        def close_a_node(grid, faces):
            first, twin = self.twins(grid)[0]
            cells = grid["Cells", "connectivity"]
            cells.values = [first if v == twin else v for v in cells.values]

        def open_a_node(grid, faces):
            """One tetrahedron at a node of no split surface gets a node of its own."""
            doubled = {row for pair in self.twins(grid) for row in pair}
            cells, points = grid["Cells", "connectivity"].values, grid["Points", "Points"]
            corner = next(k for k, v in enumerate(cells) if v not in doubled)
            points.values += points.values[3 * cells[corner]:3 * cells[corner] + 3]
            for name in ("kind", "input_vertex"):
                values = grid["PointData", name].values
                values.append(values[cells[corner]])
            cells[corner] = grid.n_points() - 1

        def turn_a_side(grid, faces):
            sides = faces["CellData", "region_plus"].values
            k = max(i for i, region in enumerate(sides) if region == 0)  # the last ones are of plus sides
            polys = faces["Polys", "connectivity"].values
            polys[3 * k], polys[3 * k + 1] = polys[3 * k + 1], polys[3 * k]

        def drop_a_side(grid, faces):
            """The last face of a plus side becomes another one's twin."""
            polys = faces["Polys", "connectivity"].values
            polys[-3:] = polys[-6:-3]

        for change in (close_a_node, open_a_node, turn_a_side, drop_a_side):
            with self.subTest(change.__name__):
                self.assertIn("wrong_splits", self.broken(change, split=["f", "g"]))

    def test_points_of_the_files_beside_a_split_mesh_are_checked(self):
        """Faces and curves name the rows of their points; they have to be there, too."""
        for ending in (".faces.vtp", ".curves.vtp"):
            with self.subTest(ending):
                mesh = self.mesh(split=["f", "g"])
                beside = VtkFile.read(mesh[:-4] + ending)
                beside["Points", "Points"].values[2] += 0.5
                beside.write(mesh[:-4] + ending)
                self.assertIn("wrong_mesh_points", self.checked(mesh, status=3))

    def test_a_split_mesh_with_a_coordinate_that_is_no_number(self):
        def spoil(grid, faces):
            grid["Points", "Points"].values[0] = float("nan")

        self.assertIn("not_finite", self.broken(spoil, split=["f", "g"]))

    def test_a_mesh_that_is_not_split_is_found(self):
        mesh = self.mesh()
        self.project = self.write("m.yaml", json.dumps({**MODEL, "output": {"directory": "out", "formats": ["vtu"], "split": ["f"]}}))
        self.assertTrue(self.checked(mesh, status=3))

    def test_wrong_prisms_are_found(self):
        def turn(grid, faces):
            nodes = self.prism(grid)
            grid["Cells", "connectivity"].values[nodes:nodes + 2] = grid["Cells", "connectivity"].values[nodes:nodes + 2][::-1]

        def move(grid, faces):
            nodes = self.prism(grid)
            grid["Cells", "connectivity"].values[nodes] = 0

        for change in (turn, move):
            with self.subTest(change.__name__):
                self.assertIn("wrong_splits", self.broken(change, split=["f"], cohesive=True))

    @staticmethod
    def prism(grid):
        """Where the nodes of the first prism begin."""
        types = grid["Cells", "types"].values
        return 4 * types.index(13)

    def test_one_grid_for_all_cells_is_checked_with_its_surfaces_and_curves(self):
        for name in ("region", "MaterialIDs", "attribute"):
            done = self.checked(self.mesh(single_grid=True, region_array=name, order=2 if name == "attribute" else 1))
            self.assertIn("curves of surfaces are", done)
            self.assertIn("edges of 1 wells", done)

    def test_a_wrong_id_in_one_grid_is_found(self):
        def exchange_surfaces(grid):
            types, ids = grid["Cells", "types"].values, grid["CellData", "region"].values
            ids[types.index(5)] = ids[len(types) - 1 - types[::-1].index(5)]

        def exchange_curves(grid):
            types, ids = grid["Cells", "types"].values, grid["CellData", "region"].values
            ids[types.index(3)] = ids[len(types) - 1 - types[::-1].index(3)]

        self.assertIn("wrong_surface_sets", self.broken(exchange_surfaces, single_grid=True))
        self.assertTrue({"missing_curve_edges", "wrong_curve_edges"} & self.broken(exchange_curves, single_grid=True))

    def test_files_without_curves(self):
        self.assertIn("regions were held against", self.checked(self.mesh(curves=False)))
        mesh = self.mesh()
        os.remove(self.path("out", "m.curves.vtp"))
        self.assertIn("missing_curves", self.checked(mesh, status=3))

    def test_faces_inside_are_there_whatever_solver_files_get(self):
        self.assertIn("regions were held against", self.checked(self.mesh(inner_faces=False)))


if __name__ == "__main__":
    main()
