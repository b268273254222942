#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Formats of single programs and files of surfaces: read back by others, or by the format's document (exchange_readers.py)."""
import math
import os
import re

import exchange_readers as exchange
import format_readers as readers
from geomesh_program import ProgramTest, has_module, main
from test_formats import FormatTest, plain


class SinglePrograms(FormatTest):
    """Tetrahedra with regions, faces with surfaces."""

    def has(self, name):
        if not has_module(name):
            self.skipTest("skipped: built without the module geomesh-" + name)

    def test_flac3d_by_meshio(self):
        self.check_format(exchange.meshio_flac3d, "m.f3grid")

    def test_feflow_by_its_document(self):
        self.check_format(exchange.feflow, "m.fem", parts=("node_sets",))

    def test_comsol_by_its_document(self):
        self.check_format(exchange.comsol, "m.mphtxt", parts=("faces", "curves"))

    def test_avs_by_meshio(self):
        self.check_format(exchange.meshio_avs, "m.avs")

    def test_avs_by_vtk(self):
        found = self.read_by(exchange.vtk_avs, self.convert("m.avs"), None)
        self.assert_regions(found, 1e-5)  # VTK's reader gives points in single precision

    def test_medit_by_meshio(self):
        self.check_format(exchange.meshio_medit, "m.mesh", ["--format", "medit"], parts=("faces", "curves"))

    def test_medit_by_gmsh(self):
        self.check_format(exchange.gmsh_medit, "m.mesh", ["--format", "medit"], parts=("faces", "curves"))

    def test_medit_binary_by_meshio(self):
        self.check_format(exchange.meshio_medit, "m.meshb", parts=("faces", "curves"))

    def test_medit_has_the_mean_length_of_edges_at_every_node(self):
        self.convert("m.mesh", "--format", "medit")
        self.convert("m.meshb")
        try:
            numpy, meshio = readers.need("numpy"), readers.need("meshio")
        except readers.ReaderMissing as missing:
            self.skipTest("skipped: %s is not installed" % missing)
        text, binary = exchange.sizes_of(self.path("m.sol")), exchange.sizes_of(self.path("m.solb"))
        self.assertTrue((text == binary).all())
        mesh = meshio.read(self.path("m.meshb"))
        total, count = numpy.zeros(len(mesh.points)), numpy.zeros(len(mesh.points))
        for cells in (c.data for c in mesh.cells if c.type == "tetra"):
            for i, j in ((0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)):
                length = numpy.linalg.norm(mesh.points[cells[:, i]] - mesh.points[cells[:, j]], axis=1)
                for end in (i, j):
                    numpy.add.at(total, cells[:, end], length)
                    numpy.add.at(count, cells[:, end], 1)
        numpy.testing.assert_allclose(text, total / count, rtol=1e-12)

    def test_tsolid_by_its_document(self):
        self.check_format(exchange.gocad_solid, "m.so")

    def test_vtkhdf_by_vtk(self):
        self.has("vtkhdf")
        self.check_format(exchange.vtk_hdf, "m.vtkhdf", parts=())

    def test_vtkhdf_of_second_order_and_with_one_grid_by_vtk(self):
        self.has("vtkhdf")
        self.check_format(exchange.vtk_hdf, "second.vtkhdf", ["--order", "2"], parts=())
        self.check_format(exchange.vtk_hdf, "single.vtkhdf", ["--single-grid"], parts=("faces", "curves"))

    def test_files_are_the_same_whenever_they_are_written(self):
        for name in ("m.vtkhdf", "m.puml", "m.f3grid", "m.glb"):
            if not has_module({"vtkhdf": "vtkhdf", "puml": "seissol"}.get(name.split(".")[1], "")):
                continue
            written = []
            for folder in ("first", "second"):
                os.makedirs(self.path(folder), exist_ok=True)
                self.convert(os.path.join(folder, name))
                with open(self.path(folder, name + (".h5" if name.endswith("puml") else "")), "rb") as file:
                    written.append(file.read())
            self.assertTrue(written[0] == written[1], name)


class SeisSol(FormatTest):
    def setUp(self):
        super().setUp()
        if not has_module("seissol"):
            self.skipTest("skipped: built without the module geomesh-seissol")
        self.convert("m.puml")
        self.path_of_mesh = self.path("m.puml.h5")
        try:
            self.puml = exchange.Puml(self.path_of_mesh)
        except readers.ReaderMissing as missing:
            self.skipTest("skipped: %s is not installed" % missing)

    def test_regions_are_groups_and_types_are_those_of_the_document(self):
        self.assert_regions(self.read_by(exchange.seissol, self.path_of_mesh, None))
        self.assertEqual(self.puml.kinds, ["float64", "int64", "int32", "int32"])
        with open(self.path("m.puml.xdmf")) as file:
            self.assertIn("m.puml.h5:/boundary", file.read())

    def area(self, condition):
        cells = self.puml.faces_with(condition)
        return readers.measure(self.puml.points, cells)[1] if cells else 0.0

    def test_the_top_is_free_the_other_sides_absorb_and_faults_have_conditions_of_their_own(self):
        areas = {s["name"]: s["area"] for s in self.model["surfaces"]}
        self.assertAlmostEqual(self.area(1) / areas["zmax"], 1, delta=1e-9)
        self.assertAlmostEqual(self.area(5) / sum(areas[s] for s in ("xmin", "xmax", "ymin", "ymax", "zmin")), 1, delta=1e-9)
        faults = {g["name"]: g["id"] for g in self.sidecar(self.path_of_mesh)["groups"] if g["type"] == "boundary"}
        self.assertEqual(sorted(faults), ["north_fault", "west_fault"])
        self.assertEqual(sorted(faults.values()), [3, 65])
        for name, condition in faults.items():  # from both sides
            self.assertAlmostEqual(self.area(condition) / areas[name], 2, delta=1e-9, msg=name)
        self.assertEqual(sorted(set(self.puml.conditions.ravel().tolist())), [0, 1, 3, 5, 65])

    def test_the_free_surface_looks_upwards_out_of_the_mesh(self):
        numpy = readers.need("numpy")
        for a, b, c in self.puml.faces_with(1):
            normal = numpy.cross(self.puml.points[b] - self.puml.points[a], self.puml.points[c] - self.puml.points[a])
            self.assertGreater(normal[2], 0)

    def test_split_faults_are_refused_as_seissol_splits_them_itself(self):
        self.assertIn("its solver splits them", self.run_program("convert", self.stem + ".vtu", "-o", "split.puml", "--split", "west_fault", status=2))


class SurfacesAlone(FormatTest):
    def check_surfaces(self, reader, name):
        found = self.read_by(reader, self.convert(name), None)
        self.assert_faces(found)
        return found

    def test_obj_by_meshio(self):
        self.check_surfaces(exchange.meshio_obj, "m.obj")
        with open(self.path("m.mtl")) as colours, open(self.path("m.obj")) as objects:
            named = re.findall(r"(?m)^newmtl (\S+)$", colours.read())
            self.assertEqual(sorted(named), sorted(set(re.findall(r"(?m)^usemtl (\S+)$", objects.read()))))

    def test_stl_by_its_document(self):
        self.check_surfaces(exchange.stl_text, "m.stl")

    def test_stl_by_meshio(self):
        try:
            meshio = readers.need("meshio")
        except readers.ReaderMissing as missing:
            self.skipTest("skipped: %s is not installed" % missing)
        mesh = meshio.read(self.convert("m.stl"))
        area = sum(readers.measure(mesh.points, c.data)[1] for c in mesh.cells)
        found = self.read_by(exchange.stl_text, self.path("m.stl"), None)
        self.assertAlmostEqual(area / sum(a for _, a in found.faces.values()), 1, delta=1e-9)

    def test_tsurf_by_its_document(self):
        found = self.check_surfaces(exchange.gocad_surfaces, "m.ts")
        self.assertFalse([name for name in found.faces if "+" in name])

    def test_tsurf_by_geomesh_itself(self):
        """It reads these files as input: the same surfaces with the same areas."""
        self.convert("m.ts")
        told = self.run_program("info", self.path("m.ts"))
        for surface in self.model["surfaces"]:
            if surface["area"] > 0:
                self.assertIn(plain(surface["name"]), told)

    def test_glb_by_its_document(self):
        found = self.read_by(exchange.glb, self.convert("m.glb"), None)
        areas = {}
        for name, (_, area) in found.faces.items():
            for part in name.split("+"):
                areas[part] = areas.get(part, 0) + area
        for surface in self.model["surfaces"]:
            if surface["area"] > 0:
                self.assertAlmostEqual(areas[plain(surface["name"])] / surface["area"], 1, delta=1e-4)

    def test_glb_stands_upright_about_its_centre_and_shows_the_regions(self):
        try:
            numpy = readers.need("numpy")
        except readers.ReaderMissing as missing:
            self.skipTest("skipped: %s is not installed" % missing)
        file = exchange.Glb(self.convert("m.glb"))
        x, y, z = numpy.array(file.matrix[:3, :3]) @ [1.0, 2.0, 3.0]
        self.assertEqual((x, y, z), (1.0, 3.0, -2.0))
        low, high = file.points.min(axis=0) + file.centre, file.points.max(axis=0) + file.centre
        numpy.testing.assert_allclose(low, [self.model["bounds"]["min"][k] if "bounds" in self.model else low[k] for k in range(3)], atol=1)
        self.assertTrue((numpy.abs(file.points.min(axis=0) + file.points.max(axis=0)) < 1e-3 * (high - low)).all())
        materials = [m["name"] for m in file.json["materials"]]
        self.assertEqual(materials[:len(self.model["regions"])], [r["name"] for r in self.model["regions"]])
        side = next(n for n in file.nodes if n["name"] == "xmin")
        units = {materials[p["material"]] for p in file.json["meshes"][side["mesh"]]["primitives"]}
        self.assertGreater(len(units), 1)
        self.assertLessEqual(units, {r["name"] for r in self.model["regions"]})

    def test_glb_by_vtk(self):
        try:
            vtk = readers.need("vtk")
        except readers.ReaderMissing as missing:
            self.skipTest("skipped: %s is not installed" % missing)
        if not hasattr(vtk, "vtkGLTFReader"):
            self.skipTest("skipped: this VTK reads no glTF")
        reader = vtk.vtkGLTFReader()
        reader.SetFileName(self.convert("m.glb"))
        reader.Update()
        area, blocks = 0.0, reader.GetOutput().NewIterator()
        while not blocks.IsDoneWithTraversal():
            measure = vtk.vtkMassProperties()
            data = blocks.GetCurrentDataObject()
            triangles = vtk.vtkTriangleFilter()
            triangles.SetInputData(data)
            triangles.Update()
            measure.SetInputConnection(triangles.GetOutputPort())
            measure.Update()
            area += measure.GetSurfaceArea()
            blocks.GoToNextItem()
        found = self.read_by(exchange.glb, self.path("m.glb"), None)
        self.assertTrue(math.isclose(area, sum(a for _, a in found.faces.values()), rel_tol=1e-4))

    def test_surfaces_of_a_split_fault_have_both_sides(self):
        found = self.read_by(exchange.gocad_surfaces, self.convert("m.ts", "--split", "west_fault"), None)
        self.assertEqual(found.faces["west_fault.minus"][0], found.faces["west_fault.plus"][0])


class SplitFaults(ProgramTest):
    """No tetrahedron has all four corners on a split fault (geodynamics/pylith#795). A wavy fault has such tetrahedra in its hollows."""

    PROJECT = "box: {min: [0, 0, -1000], max: [1000, 1000, 0]}\nsurfaces: [{name: F1, kind: fault, file: f1.off}]\n"

    def wavy_fault(self):
        n = 9
        points = [(400 + 0.2 * y + 60 * math.sin(y / 110) * math.cos(z / 130), y, z)
                  for z in (-1000 + 1000 * i / (n - 1) for i in range(n)) for y in (1000 * j / (n - 1) for j in range(n))]
        rows = [(i * n + j, i * n + j + 1, (i + 1) * n + j + 1, (i + 1) * n + j) for i in range(n - 1) for j in range(n - 1)]
        faces = [f for a, b, c, d in rows for f in ((a, b, c), (a, c, d))]
        self.write("f1.off", "OFF\n%d %d 0\n" % (len(points), len(faces)) + "".join("%r %r %r\n" % p for p in points) +
                   "".join("3 %d %d %d\n" % f for f in faces))

    def on_fault(self, path):
        """(tetrahedra with all corners on one fault, tetrahedra, their volume)"""
        meshio, numpy = readers.need("meshio"), readers.need("numpy")
        mesh = meshio.read(path)
        names = {int(v[0]): k for k, v in mesh.field_data.items() if int(v[1]) == 2}
        nodes = set()
        for cells, tags in zip(mesh.cells, mesh.cell_data["gmsh:physical"]):
            if cells.type == "triangle":
                nodes.update(*(row for row, tag in zip(cells.data.tolist(), tags.tolist()) if names[int(tag)].split(".")[0] == "F1"))
        tetrahedra = numpy.concatenate([c.data for c in mesh.cells if c.type == "tetra"])
        return sum(nodes.issuperset(row) for row in tetrahedra.tolist()), len(tetrahedra), readers.measure(mesh.points, tetrahedra)[1]

    def test_no_tetrahedron_keeps_all_corners_on_a_split_fault(self):
        self.wavy_fault()
        self.write("cut.yaml", self.PROJECT + "mesh: {refine: none, cell_arrays: [min_dihedral, aspect]}\noutput: {split: [F1], formats: [vtu]}\n")
        self.run_program("cut.yaml", "-o", ".")
        self.write("whole.yaml", self.PROJECT + "mesh: {refine: none}\noutput: {formats: [msh]}\n")
        self.run_program("whole.yaml", "-o", ".")
        self.run_program("convert", "cut.vtu", "-o", "split.msh")
        try:
            held, n, volume = self.on_fault(self.path("whole.msh"))
            after, n_after, volume_after = self.on_fault(self.path("split.msh"))
        except readers.ReaderMissing as missing:
            self.skipTest("skipped: %s is not installed" % missing)
        self.assertGreater(held, 0, "this fault has no such tetrahedron: choose another")
        self.assertEqual((after, n_after), (0, n + 3 * held))
        self.assertTrue(math.isclose(volume, volume_after, rel_tol=1e-12))
        self.assertIn("passes", self.run_program("check", "cut.vtu", "--project", "cut.yaml"))


if __name__ == "__main__":
    main()
