#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh in parts: every cell is owned once, ghosts are those that touch, numbers agree between the parts, and readers put them together."""
import glob
import os
import shutil

import format_readers as readers
from geomesh_program import BAD_INPUT, USAGE, main
from test_formats import FormatTest, plain

N = 3


class PartsTest(FormatTest):
    def setUp(self):
        super().setUp()
        if "without METIS" in self.run_program("convert", self.stem + ".vtu", "-o", self.path("try", "m.pvtu"), "--partitions", "2", status=None):
            self.skipTest("skipped: built without METIS")

    def need(self, *modules):
        try:
            return [readers.need(module) for module in modules]
        except readers.ReaderMissing as missing:
            self.skipTest("skipped: %s is not installed" % missing)

    def n_tetrahedra(self):
        return sum(r["tetrahedra"] for r in self.model["regions"])


class Pvtu(PartsTest):
    def pieces(self):
        """Per part: points, cells, and the arrays of both, as VTK reads them."""
        vtk, numpy = self.need("vtk", "numpy")
        from vtk.util.numpy_support import vtk_to_numpy
        found = []
        for k in range(N):
            reader = vtk.vtkXMLUnstructuredGridReader()
            reader.SetFileName(self.path("m.part%d.vtu" % k))
            reader.Update()
            grid = reader.GetOutput()
            cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)
            arrays = [{data.GetArrayName(i): vtk_to_numpy(data.GetArray(i)) for i in range(data.GetNumberOfArrays())} for data in (grid.GetPointData(), grid.GetCellData())]
            found.append((vtk_to_numpy(grid.GetPoints().GetData()), cells, *arrays))
        return numpy, found

    def test_every_cell_and_point_is_owned_once_and_ghosts_are_all_that_touch(self):
        self.convert("m.pvtu", "--partitions", str(N))
        numpy, parts = self.pieces()
        own_cells, own_points = [], []
        all_cells = {}
        for points, cells, at_points, at_cells in parts:
            ids = at_points["GlobalPointIds"]
            own_cells += at_cells["GlobalCellIds"][at_cells["vtkGhostType"] == 0].tolist()
            own_points += ids[at_points["vtkGhostType"] == 0].tolist()
            for number, cell in zip(at_cells["GlobalCellIds"].tolist(), ids[cells].tolist()):
                self.assertEqual(all_cells.setdefault(number, cell), cell)
        self.assertEqual(sorted(own_cells), list(range(self.n_tetrahedra())))
        self.assertEqual(sorted(own_points), list(range(len(own_points))))
        sizes = []
        for k, (points, cells, at_points, at_cells) in enumerate(parts):
            ids, ghost = at_points["GlobalPointIds"], at_cells["vtkGhostType"]
            touched = set(ids[cells[ghost == 0]].ravel().tolist())
            wanted = {number for number, cell in all_cells.items() if touched & set(cell)}
            self.assertEqual(set(at_cells["GlobalCellIds"].tolist()), wanted)
            self.assertEqual(set(at_cells["partition"][ghost == 0].tolist()), {k})
            self.assertTrue((at_cells["partition"][ghost == 1] != k).all())
            sizes.append(int((ghost == 0).sum()))
        self.assertLess(max(sizes), 1.1 * self.n_tetrahedra() / N)

    def test_vtk_reads_the_whole_with_all_regions(self):
        self.convert("m.pvtu", "--partitions", str(N))
        vtk, numpy = self.need("vtk", "numpy")
        from vtk.util.numpy_support import vtk_to_numpy
        reader = vtk.vtkXMLPUnstructuredGridReader()
        reader.SetFileName(self.path("m.pvtu"))
        reader.Update()
        grid = reader.GetOutput()
        cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)
        own = vtk_to_numpy(grid.GetCellData().GetArray("vtkGhostType")) == 0
        regions = vtk_to_numpy(grid.GetCellData().GetArray("region"))
        points = vtk_to_numpy(grid.GetPoints().GetData())
        for region in self.model["regions"]:
            n, volume = readers.measure(points, cells[own & (regions == region["id"])])
            self.assertEqual(n, region["tetrahedra"])
            self.assertAlmostEqual(volume / region["volume"], 1, delta=1e-10)

    def test_meshio_reads_a_part(self):
        self.convert("m.pvtu", "--partitions", str(N))
        meshio, = self.need("meshio")
        mesh = meshio.read(self.path("m.part0.vtu"))
        self.assertIn("GlobalPointIds", mesh.point_data)
        self.assertGreater(len(mesh.cells[0].data), self.n_tetrahedra() // N)

    def test_convert_puts_the_parts_together_to_the_same_file(self):
        direct = self.convert("direct.vtu")
        self.convert("m.pvtu", "--partitions", str(N))
        os.makedirs(self.path("back"))
        self.run_program("convert", self.path("m.pvtu"), "-o", self.path("back", "direct.vtu"))
        for ending in (".vtu", ".faces.vtp", ".curves.vtp"):
            with open(direct[:-4] + ending, "rb") as a, open(self.path("back", "direct" + ending), "rb") as b:
                self.assertEqual(a.read(), b.read(), ending)
        regions = {r["name"]: r["tetrahedra"] for r in self.check(self.path("m.pvtu"), status=None)["regions"]}
        self.assertEqual(regions, {r["name"]: r["tetrahedra"] for r in self.model["regions"]})

    def test_a_missing_part_is_told(self):
        self.convert("m.pvtu", "--partitions", str(N))
        os.remove(self.path("m.part1.vtu"))
        self.assertIn("m.part1.vtu", self.run_program("convert", self.path("m.pvtu"), "-o", "back.vtu", status=USAGE))

    def test_the_same_mesh_gives_the_same_parts(self):
        files = {}
        for threads in ("1", "4"):
            self.convert("m.pvtu", "--partitions", "5", "--threads", threads)
            for file in glob.glob(self.path("m*")):
                with open(file, "rb") as content:
                    files.setdefault(os.path.basename(file), []).append(content.read())
        self.assertGreaterEqual(len(files), 8)
        for name, (a, b) in files.items():
            self.assertEqual(a, b, name)

    def test_second_order_and_split_faults_in_parts(self):
        fault = next(s["name"] for s in self.model["surfaces"] if s["kind"] == "fault" and s["area"] > 0)
        self.convert("m.pvtu", "--partitions", str(N), "--order", "2", "--split", fault)
        vtk, numpy = self.need("vtk", "numpy")
        from vtk.util.numpy_support import vtk_to_numpy
        places, n_own = {}, 0
        for k in range(N):
            reader = vtk.vtkXMLUnstructuredGridReader()
            reader.SetFileName(self.path("m.part%d.vtu" % k))
            reader.Update()
            grid = reader.GetOutput()
            n_own += int((vtk_to_numpy(grid.GetCellData().GetArray("vtkGhostType")) == 0).sum())
            self.assertEqual({grid.GetCellType(c) for c in range(grid.GetNumberOfCells())}, {24})
            for number, place in zip(vtk_to_numpy(grid.GetPointData().GetArray("GlobalPointIds")).tolist(), vtk_to_numpy(grid.GetPoints().GetData()).tolist()):
                self.assertEqual(places.setdefault(number, place), place)
        self.assertEqual(n_own, self.n_tetrahedra())
        self.assertLess(len({tuple(p) for p in places.values()}), len(places))

    def test_what_is_not_written_in_parts_is_said(self):
        for name, options in (("m.mesh", []), ("m.pvtu", ["--single-grid"]), ("m.inp", [])):
            self.assertIn("in parts", self.run_program("convert", self.stem + ".vtu", "-o", name, "--partitions", "3", *options, status=USAGE))
        self.assertIn("--partitions", self.run_program("convert", self.stem + ".vtu", "-o", "m.pvtu", status=USAGE))


class ExodusParts(PartsTest):
    def test_numbers_sets_and_what_is_shared_agree_between_the_parts(self):
        self.convert("m.e", "--partitions", str(N))
        netCDF4, numpy = self.need("netCDF4", "numpy")
        parts = [netCDF4.Dataset(self.path("m.e.%d.%d" % (N, k))) for k in range(N)]
        elements, areas, shared, counts, names = [], {}, {}, {}, set()
        for k, part in enumerate(parts):
            self.assertEqual(len(part.dimensions["num_processors"]), N)
            self.assertEqual(len(part.dimensions["num_elems_global"]), self.n_tetrahedra())
            numbers = numpy.asarray(part.variables["node_num_map"][:])
            elements += numpy.asarray(part.variables["elem_num_map"][:]).tolist()
            found = readers.netcdf_exodus(self.path("m.e.%d.%d" % (N, k)), None)
            names.add(tuple(found.faces) + tuple(found.nodes))
            for name, (n, volume) in found.regions.items():
                counts[name] = counts.get(name, 0) + n
            for name, (_, area) in found.faces.items():
                areas[name] = areas.get(name, 0) + area
            if "n_comm_nids" in part.variables:
                for node, other in zip(part.variables["n_comm_nids"][:], part.variables["n_comm_proc"][:]):
                    shared.setdefault((k, int(other)), []).append(int(numbers[node - 1]))
        self.assertEqual(sorted(elements), list(range(1, self.n_tetrahedra() + 1)))
        self.assertEqual(counts, {plain(r["name"]): r["tetrahedra"] for r in self.model["regions"]})
        self.assertEqual(len(names), 1)
        for surface in self.model["surfaces"]:
            if surface["area"] > 0:
                self.assertAlmostEqual(areas[plain(surface["name"])] / surface["area"], 1, delta=1e-9)
        self.assertGreater(len(shared), 0)
        for (a, b), nodes in shared.items():
            self.assertEqual(sorted(nodes), sorted(shared[(b, a)]))
            of = [set(numpy.asarray(parts[p].variables["node_num_map"][:]).tolist()) for p in (a, b)]
            self.assertEqual(set(nodes), of[0] & of[1])


class GmshParts(PartsTest):
    def test_gmsh_reads_each_part_with_its_groups(self):
        self.convert("m.msh", "--format", "msh22", "--partitions", str(N))
        if not shutil.which("gmsh"):
            self.skipTest("skipped: gmsh is not installed")
        own = []
        for k in range(1, N + 1):
            path = self.path("m_%d.msh" % k)
            found = self.read_by(readers.gmsh, path, self.path("m.msh"))
            with open(path) as file:
                lines = file.read().split("$Elements\n")[1].splitlines()
            rows = [list(map(int, line.split())) for line in lines[1:1 + int(lines[0])]]
            mine = [r for r in rows if r[1] == 4 and r[6] == k]
            ghosts = [r for r in rows if r[1] == 4 and r[6] != k]
            own += [r[0] for r in mine]
            self.assertGreater(len(ghosts), 0)
            self.assertTrue(all(-k in r[7:7 + r[5] - 1] for r in ghosts))
            self.assertEqual(sum(n for n, _ in found.regions.values()), len(mine) + len(ghosts))
            self.assertEqual(sorted(found.regions), sorted({plain(r["name"]) for r in self.model["regions"]} & set(found.regions)))
        self.assertEqual(len(own), len(set(own)))
        self.assertEqual(len(own), self.n_tetrahedra())

    def test_gmsh_reads_41_with_each_cell_and_face_in_one_part(self):
        for form in ("msh", "msh-binary"):
            counts, areas = {}, {}
            self.convert("m.msh", "--format", form, "--partitions", str(N))
            for k in range(1, N + 1):
                found = self.read_by(readers.gmsh, self.path("m_%d.msh" % k), self.path("m.msh"))
                for name, (n, _) in found.regions.items():
                    counts[name] = counts.get(name, 0) + n
                for name, (_, area) in found.faces.items():
                    for part in name.split("+"):
                        areas[part] = areas.get(part, 0) + area
            self.assertEqual(counts, {plain(r["name"]): r["tetrahedra"] for r in self.model["regions"]}, form)
            for surface in self.model["surfaces"]:
                if surface["area"] > 0:
                    self.assertAlmostEqual(areas[plain(surface["name"])] / surface["area"], 1, delta=1e-9)

    def sections(self, path):
        with open(path) as file:
            text = file.read()
        return {name: [list(map(float, line.split())) for line in body.splitlines()] for name, body in
                ((part.split("\n", 1)) for part in text.split("$") if "\n" in part and part.split("\n", 1)[0] in ("PartitionedEntities", "Elements", "GhostElements"))}

    def test_ghosts_of_41_are_all_that_touch_and_name_their_owner(self):
        self.convert("m.msh", "--partitions", str(N))
        own, ghosts, nodes_of = {}, {}, {}
        for k in range(1, N + 1):
            found = self.sections(self.path("m_%d.msh" % k))
            self.assertEqual(found["PartitionedEntities"][0], [N])
            ghost_entity = found["PartitionedEntities"][2]
            self.assertEqual(ghost_entity[1], k)
            rows = found["Elements"][1:]
            own[k], copies = set(), set()
            while rows:
                dimension, entity, kind, n = map(int, rows[0])
                for row in rows[1:1 + n]:
                    if kind == 4:
                        self.assertEqual(nodes_of.setdefault(int(row[0]), row[1:]), row[1:])
                        (copies if entity == ghost_entity[0] else own[k]).add(int(row[0]))
                rows = rows[1 + n:]
            ghosts[k] = {int(r[0]): int(r[1]) for r in found["GhostElements"][1:]}
            self.assertTrue(all(r[2:] == [1, k] for r in found["GhostElements"][1:]))
            self.assertEqual(set(ghosts[k]), copies)
        self.assertEqual(sum(map(len, own.values())), self.n_tetrahedra())
        for k in own:
            touched = {v for e in own[k] for v in nodes_of[e]}
            self.assertEqual(set(ghosts[k]) | own[k], {e for e, nodes in nodes_of.items() if touched & set(nodes)})
            for element, owner in ghosts[k].items():
                self.assertIn(element, own[owner])


class PutTogether(PartsTest):
    """Parts of Gmsh and Exodus come back as the mesh that they were."""

    def back(self, first, curves):
        os.makedirs(self.path("back"), exist_ok=True)
        self.run_program("convert", self.path(first), "-o", self.path("back", "m.vtu"))
        one, two = self.report(self.stem + ".vtu.json"), self.report(self.path("back", "m.vtu.json"))
        self.assertEqual(sorted(r["name"] for r in two["regions"]), sorted(r["name"] for r in one["regions"]))
        area = {s["name"]: s["area"] for s in self.model["surfaces"]}
        self.assertEqual({s["name"]: s["kind"] for s in two["surfaces"]}, {s["name"]: s["kind"] for s in one["surfaces"] if area[s["name"]] > 0})
        if curves:
            self.assertEqual({c["name"]: c["kind"] for c in two["curves"]}, {c["name"]: c["kind"] for c in one["curves"]})
        check = self.check(self.path("back", "m.vtu"), status=None)
        self.assertEqual({f["id"] for f in check["faults"]} & {"faces_shared_by_many", "open_boundary", "hanging_faces", "equal_points", "open_regions"}, set())
        for region in self.model["regions"]:
            found = next(r for r in check["regions"] if r["name"] == region["name"])
            self.assertEqual(found["tetrahedra"], region["tetrahedra"])
            self.assertAlmostEqual(found["volume"] / region["volume"], 1, delta=1e-12)

    def test_gmsh(self):
        for form in ("msh", "msh-binary", "msh22"):
            with self.subTest(form):
                self.convert("m.msh", "--format", form, "--partitions", str(N))
                self.back("m_2.msh", curves=True)

    def test_exodus(self):
        self.convert("m.e", "--partitions", "11")
        self.back("m.e.11.03", curves=False)

    def test_exodus_of_second_order_is_checked_as_one(self):
        self.convert("m.e", "--partitions", str(N), "--order", "2")
        check = self.check(self.path("m.e.%d.0" % N))
        self.assertTrue(any("Bezier" in text for text in check["checks_done"]))
        self.assertEqual(sum(r["tetrahedra"] for r in check["regions"]), self.n_tetrahedra())

    def test_a_missing_or_doubled_part_is_refused(self):
        self.convert("m.e", "--partitions", str(N))
        shutil.copy(self.path("m.e.%d.0" % N), self.path("m.e.%d.2" % N))
        self.assertIn("in two parts", self.run_program("convert", self.path("m.e.%d.0" % N), "-o", "back.vtu", status=BAD_INPUT))
        os.remove(self.path("m.e.%d.2" % N))
        self.assertIn("m.e.%d.2" % N, self.run_program("convert", self.path("m.e.%d.0" % N), "-o", "back.vtu", status=USAGE))
        self.convert("m.msh", "--partitions", str(N))
        os.remove(self.path("m_3.msh"))
        self.assertIn("m_3.msh", self.run_program("convert", self.path("m_1.msh"), "-o", "back.vtu", status=USAGE))


if __name__ == "__main__":
    main()
