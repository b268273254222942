#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Each format as other people's readers see it: regions, sets of faces and nodes, names, counts, volumes. docs/outputs.md is this table."""
import json
import os
import re
import shutil
import subprocess
import sys
from collections import Counter

import format_readers as readers
from geomesh_program import PROGRAM, SLOWNESS, SOURCE, ProgramTest, has_module, main
from vtk_files import VtkFile


def plain(name):
    """A name as solver files have it, where it is short and has no clash."""
    name = re.sub(r"[^A-Za-z0-9_.-]", "_", name)
    return name if name[:1].isalpha() else "n" + name


def all_formats():
    """Of meshes, as the schema of the project lists them."""
    with open(os.path.join(SOURCE, "docs", "project.schema.json"), encoding="utf-8") as file:
        listed = json.load(file)["properties"]["output"]["properties"]["formats"]["items"]["enum"]
    return [name for name in listed if name != "html"]


class FormatTest(ProgramTest):
    """The faulted-layers sample, meshed once; it has a fault that ends inside, and its tip."""

    stem = None

    @classmethod
    def setUpClass(cls):
        from geomesh_program import WORK
        if FormatTest.stem:
            return
        folder = os.path.join(WORK, "model_of_" + os.path.splitext(os.path.basename(sys.argv[0]))[0])
        shutil.rmtree(folder, ignore_errors=True)
        os.makedirs(folder)
        sample = os.path.join(SOURCE, "samples", "faulted-layers")
        with open(os.path.join(sample, "project.yaml")) as file:
            text = file.read().replace("file: surfaces", "file: " + sample + "/surfaces").replace("refine: none}", "size: 4000}")
        project = os.path.join(folder, "project.yaml")
        with open(project, "w") as file:
            file.write(text)
        done = subprocess.run([PROGRAM, project, "-o", folder], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=300 * SLOWNESS)
        assert done.returncode == 0, done.stdout
        FormatTest.stem = os.path.join(folder, "faulted_layers")
        with open(FormatTest.stem + ".report.json") as file:
            FormatTest.model = json.load(file)

    def convert(self, name, *options):
        """NAME in this test's folder, and the JSON beside it."""
        self.run_program("convert", self.stem + ".vtu", "-o", self.path(name), *options)
        return self.path(name)

    def sidecar(self, path):
        return self.report(path + ".json")

    def read_by(self, reader, path, sidecar):
        try:
            return reader(path, self.sidecar(sidecar or path))
        except readers.ReaderMissing as missing:
            self.skipTest("skipped: %s is not installed" % missing)

    def assert_regions(self, found, precision=1e-10):
        self.assertEqual(sorted(found.regions), sorted(plain(r["name"]) for r in self.model["regions"]))
        for region in self.model["regions"]:
            n, volume = found.regions[plain(region["name"])]
            self.assertEqual(n, region["tetrahedra"], region["name"])
            self.assertAlmostEqual(volume / region["volume"], 1, delta=precision, msg=region["name"])

    def assert_faces(self, found):
        """Every surface under its name with its whole area; faces of two surfaces count for both."""
        areas = {}
        for name, (_, area) in found.faces.items():
            for part in name.split("+"):
                areas[part] = areas.get(part, 0) + area
        for surface in self.model["surfaces"]:
            if surface["area"] > 0:
                self.assertIn(plain(surface["name"]), areas)
                self.assertAlmostEqual(areas[plain(surface["name"])] / surface["area"], 1, delta=1e-9, msg=surface["name"])

    def assert_curves(self, found):
        tips = [c for c in self.model["curves"] if c["kind"] == "fault_tip"]
        self.assertGreater(len(tips), 0)
        for tip in tips:
            length = sum(value for name, (_, value) in found.curves.items() if plain(tip["name"]) in name.split("+"))
            self.assertAlmostEqual(length / tip["length"], 1, delta=1e-9, msg=tip["name"])

    def assert_node_sets(self, found):
        for surface in self.model["surfaces"]:
            if surface["area"] > 0:
                self.assertGreaterEqual(found.nodes[plain(surface["name"])], 3)
        for tip in (c for c in self.model["curves"] if c["kind"] == "fault_tip"):
            self.assertGreaterEqual(found.nodes[plain(tip["name"])], 2)

    def check_format(self, reader, name, options=(), sidecar=None, parts=("faces",)):
        path = self.convert(name, *options)
        found = self.read_by(reader, path, sidecar and self.path(sidecar))
        self.assert_regions(found)
        for part in parts:
            getattr(self, "assert_" + part)(found)
        return found


class GmshFormats(FormatTest):
    def test_msh41_by_meshio(self):
        self.check_format(readers.meshio_gmsh, "m.msh")

    def test_msh41_by_gmsh(self):
        self.check_format(readers.gmsh, "m.msh", parts=("faces", "curves"))

    def test_msh41_binary_by_gmsh(self):
        self.check_format(readers.gmsh, "m.msh", ["--format", "msh-binary"], parts=("faces", "curves"))

    def test_msh41_binary_by_meshio(self):
        self.check_format(readers.meshio_gmsh, "m.msh", ["--format", "msh-binary"])

    def test_msh22_by_gmsh(self):
        self.check_format(readers.gmsh, "m.msh", ["--format", "msh22"], parts=("faces", "curves"))

    def test_msh22_by_meshio(self):
        self.check_format(readers.meshio_gmsh, "m.msh", ["--format", "msh22"])

    def test_msh22_by_getfem(self):
        self.check_format(readers.getfem_gmsh22, "model.msh", ("--format", "msh22"))

    def test_msh22_by_netgen(self):
        self.check_format(readers.netgen_gmsh22, "model.msh", ("--format", "msh22"), parts=("faces", "curves"))

    def test_msh22_by_freefem(self):
        self.check_format(readers.freefem_gmsh22, "model.msh", ("--format", "msh22"))

    def test_msh22_binary_by_gmsh(self):
        self.check_format(readers.gmsh, "m.msh", ["--format", "msh22-binary"], parts=("faces", "curves"))

    def test_msh41_of_second_order_by_gmsh(self):
        self.check_format(readers.gmsh, "m.msh", ["--order", "2"], parts=("faces", "curves"))

    def test_pieces_give_each_face_one_group(self):
        whole = self.check_format(readers.gmsh, "whole.msh")
        pieces = self.read_by(readers.gmsh, self.convert("pieces.msh", "--groups", "pieces"), None)
        self.assertGreater(len(pieces.faces), len(whole.faces))
        self.assertEqual(sum(n for n, _ in pieces.faces.values()), sum(n for n, _ in whole.faces.values()))

    def test_inner_faces_and_curves_can_be_left_out(self):
        found = self.read_by(readers.gmsh, self.convert("m.msh", "--no-inner-faces", "--no-curves"), None)
        kinds = {plain(s["name"]): s["kind"] for s in self.model["surfaces"]}
        self.assertEqual({kinds[name] for name in found.faces}, {"box"})
        self.assertEqual(found.curves, {})


class VtkFormats(FormatTest):
    def test_vtu_by_meshio(self):
        self.check_format(readers.meshio_vtu, "m.vtu", parts=())

    def test_vtu_by_vtk(self):
        self.check_format(readers.vtk_vtu, "m.vtu", parts=())

    def test_vtu_without_compression_by_meshio(self):
        self.check_format(readers.meshio_vtu, "m.vtu", ["--compression", "none"], parts=())

    def test_single_grid_by_vtk(self):
        self.check_format(readers.vtk_vtu, "m.vtu", ["--single-grid", "--region-array", "attribute"], parts=())

    def test_single_grid_by_meshio_has_faces_and_node_sets(self):
        found = self.check_format(readers.meshio_vtu, "m.vtu", ["--single-grid", "--node-arrays"], parts=())
        self.assertGreaterEqual(len(found.faces), 6)
        for surface in self.model["surfaces"]:
            if surface["area"] > 0:
                self.assertGreaterEqual(found.nodes[surface["name"]], 3)

    def test_second_order_by_vtk(self):
        found = self.check_format(readers.vtk_vtu, "m.vtu", ["--order", "2"], parts=())
        self.assertGreater(found.points, 4 * 100)

    def test_material_ids_count_from_0_and_are_the_first_array(self):
        self.check_format(readers.meshio_vtu, "m.vtu", ["--region-array", "MaterialIDs"], parts=())

    def test_opengeosys_meshes_name_nodes_and_elements_of_the_bulk_mesh(self):
        path = self.convert("m.vtu", "--format", "ogs")
        try:
            meshio = readers.need("meshio")
        except readers.ReaderMissing:
            self.skipTest("skipped: python3-meshio is not installed")
        bulk = meshio.read(self.path("m.ogs.vtu"))
        materials = bulk.cell_data["MaterialIDs"][0]
        self.assertEqual((str(materials.dtype), int(materials.min())), ("int32", 0))
        groups = self.sidecar(self.path("m.ogs.vtu"))["groups"]
        areas = {s["name"]: s["area"] for s in self.model["surfaces"]}
        for group in (g for g in groups if g["type"] == "mesh" and g["dimension"] == 2):
            part = meshio.read(self.path(group["name"]))
            nodes, elements = part.point_data["bulk_node_ids"], part.cell_data["bulk_element_ids"][0]
            self.assertEqual((str(nodes.dtype), str(elements.dtype)), ("uint64", "uint64"))
            self.assertEqual(bulk.points[nodes].tolist(), part.points.tolist())
            for triangle, element in zip(part.cells[0].data, elements):
                self.assertLess(set(nodes[triangle].tolist()), set(bulk.cells[0].data[element].tolist()))
            self.assertAlmostEqual(readers.measure(part.points, part.cells[0].data)[1] / areas[group["full_name"]], 1, delta=1e-9)
        del path


class OtherFormats(FormatTest):
    def test_inp_by_meshio(self):
        self.check_format(readers.meshio_inp, "m.inp", parts=("node_sets",))

    def test_exodus_by_netcdf(self):
        self.check_format(readers.netcdf_exodus, "m.e", parts=("faces", "node_sets"))

    def test_exodus_by_vtk(self):
        found = self.read_by(readers.vtk_exodus, self.convert("m.e"), None)
        self.assert_regions(found, 1e-6)  # VTK's reader gives points in single precision
        self.assertEqual(sorted(found.faces), sorted(plain(s["name"]) for s in self.model["surfaces"] if s["area"] > 0))

    def test_exodus_of_second_order_by_netcdf(self):
        self.check_format(readers.netcdf_exodus, "m.e", ["--order", "2"], parts=("faces", "node_sets"))

    def has(self, name):
        if not has_module(name):
            self.skipTest("skipped: built without the module geomesh-" + name)

    def test_med_by_meshio(self):
        self.has("med")
        self.check_format(readers.meshio_med, "m.med", parts=("faces", "curves", "node_sets"))

    def test_med_conforms(self):
        self.has("med")
        if not shutil.which("medconforme"):
            self.skipTest("skipped: libmed-tools is not installed")
        for options in ([], ["--order", "2"]):
            path = self.convert("m.med", *options)
            done = subprocess.run(["medconforme", path], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=100)
            self.assertEqual(done.returncode, 0, done.stdout)

    def test_xdmf_by_h5py(self):
        self.has("xdmf")
        self.check_format(readers.h5py_xdmf, "m.xdmf", parts=("faces", "curves"))

    def test_xdmf_by_meshio(self):
        self.has("xdmf")
        self.check_format(readers.meshio_xdmf, "m.xdmf", parts=("faces",))

    def test_tetgen_by_tetgen(self):
        self.check_format(readers.tetgen, "m.ele", parts=("faces", "curves"))

    def test_tetgen_by_meshio(self):
        try:
            meshio = readers.need("meshio")
        except readers.ReaderMissing:
            self.skipTest("skipped: python3-meshio is not installed")
        path = self.convert("m.ele")
        mesh = meshio.read(path)
        names = {g["id"]: g["full_name"] for g in self.sidecar(path)["groups"] if g["dimension"] == 3}
        counts = {}
        for attribute in mesh.cell_data["tetgen:ref"][0].tolist():
            counts[names[int(attribute)]] = counts.get(names[int(attribute)], 0) + 1
        self.assertEqual(counts, {r["name"]: r["tetrahedra"] for r in self.model["regions"]})

    def test_openfoam_check_mesh(self):
        if not shutil.which("checkMesh"):
            self.skipTest("skipped: openfoam is not installed")
        self.convert("m.foam")
        done = subprocess.run(["checkMesh", "-case", self.path("m.foam"), "-constant"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                              timeout=100, env=dict(os.environ, WM_PROJECT_DIR=os.environ.get("WM_PROJECT_DIR", "/usr/share/openfoam")))
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertNotIn("FOAM FATAL", done.stdout)
        wrong = re.findall(r"\*\*\*.*(?:volume|boundary openness|incorrectly|ordering|cells with zero|upper triangular|face zone).*", done.stdout)
        self.assertEqual(wrong, [], done.stdout)
        for what, n in (("cells", sum(r["tetrahedra"] for r in self.model["regions"])), ("cell zones", len(self.model["regions"]))):
            self.assertRegex(done.stdout, r"(?m)^ *%s: *%d$" % (what, n))
        for side in ("xmin", "xmax", "ymin", "ymax", "zmin", "zmax"):
            self.assertRegex(done.stdout, r"(?m)^ *%s +\d+ " % side)

    def test_mfem_counts(self):
        path = self.convert("m.mesh")
        with open(path) as file:
            text = file.read().split("\n\n")
        sections = {part.splitlines()[0]: part.splitlines()[1:] for part in text[1:]}
        names = {g["id"]: g["full_name"] for g in self.sidecar(path)["groups"] if g["dimension"] == 3}
        counts = {}
        for line in sections["elements"][1:]:
            attribute, kind = line.split()[:2]
            self.assertEqual(kind, "4")
            counts[names[int(attribute)]] = counts.get(names[int(attribute)], 0) + 1
        self.assertEqual(counts, {r["name"]: r["tetrahedra"] for r in self.model["regions"]})

    def test_pflotran_lists_cells_and_faces(self):
        path = self.convert("m.ugi")
        with open(path) as file:
            n_cells, n_points = map(int, file.readline().split())
            cells = [tuple(map(int, file.readline().split()[1:])) for _ in range(n_cells)]
            self.assertEqual(len(file.read().splitlines()), n_points)
        self.assertEqual(n_cells, sum(r["tetrahedra"] for r in self.model["regions"]))
        for group in self.sidecar(path)["groups"]:
            with open(self.path(group["name"])) as file:
                lines = file.read().splitlines()
            if group["dimension"] == 3:
                self.assertEqual(len(lines), next(r["tetrahedra"] for r in self.model["regions"] if r["name"] == group["full_name"]))
            else:
                self.assertEqual(int(lines[0]), len(lines) - 1)
        faces = {tuple(sorted(t[:i] + t[i + 1:])) for t in cells for i in range(4)}
        with open(self.path("m_xmin.ss")) as file:
            for line in file.read().splitlines()[1:]:
                self.assertIn(tuple(sorted(map(int, line.split()[1:]))), faces)


class TipAndJunction(FormatTest):
    """A fault that ends at a tip inside and crosses another: nodes are there once at the tip, four times where the two cross."""
    SPLIT = ("--split", "west_fault", "--split", "north_fault")
    READ_BACK = {"msh": ".msh", "msh-binary": ".msh", "msh22": ".msh", "msh22-binary": ".msh", "inp": ".inp", "exodus": ".e", "med": ".med", "mfem": ".mesh"}

    def places(self, path):
        xyz = VtkFile.read(path)["Points", "Points"].values
        return Counter(tuple(round(x, 6) for x in xyz[3 * v:3 * v + 3]) for v in range(len(xyz) // 3))

    def on_curve(self, kind, name):
        """Places of a curve in the mesh before it is split."""
        curves = VtkFile.read(self.stem + ".curves.vtp")
        own = next(a.values[0] for a in curves.arrays if a.section == "FieldData" and a.name == "curve:" + name)
        rows, lines = curves["PointData", "mesh_point"].values, curves["Lines", "connectivity"].values
        ids = curves["CellData", "curve"].values[-(len(lines) // 2):]
        xyz = VtkFile.read(self.stem + ".vtu")["Points", "Points"].values
        found = {rows[v] for k, curve in enumerate(ids) if curve == own for v in lines[2 * k:2 * k + 2]}
        self.assertGreater(len(found), 2, kind)
        return {tuple(round(x, 6) for x in xyz[3 * v:3 * v + 3]) for v in found}

    def test_every_format_has_each_node_as_often_as_it_is_due(self):
        wanted = self.places(self.convert("split.vtu", *self.SPLIT))
        tip, junction = self.on_curve("tip", "north_fault.tip"), self.on_curve("junction", "north_fault*west_fault")
        self.assertEqual({wanted[p] for p in tip - junction}, {1})
        self.assertEqual({wanted[p] for p in junction - tip}, {4})
        formats = all_formats()
        counted = {"ogs": lambda: sum(self.places(self.path("m.ogs.vtu")).values()), "geos": lambda: sum(self.places(self.path("m.geos.vtu")).values()),
                   "tetgen": lambda: int(self.first_word("m.node")), "pflotran": lambda: int(self.first_word("m.ugi", 1)),
                   "openfoam": lambda: int(re.search(r"(?m)^(\d+)$", open(self.path("m.foam", "constant", "polyMesh", "points")).read()).group(1)),
                   "flac3d": lambda: sum(line.startswith("G ") for line in open(self.path("m.f3grid"))),
                   "feflow": lambda: int(re.search(r"DIMENS\n (\d+)", open(self.path("m.fem")).read()).group(1)),
                   "comsol": lambda: int(re.search(r"(\d+) # number of mesh vertices", open(self.path("m.mphtxt")).read()).group(1)),
                   "avs": lambda: int(self.first_word("m.avs")), "tsolid": lambda: sum(line.startswith("VRTX") for line in open(self.path("m.so"))),
                   "medit": lambda: int(re.search(r"Vertices\n(\d+)", open(self.path("m.mesh")).read()).group(1)),
                   "medit-binary": lambda: int.from_bytes(open(self.path("m.meshb"), "rb").read(40)[36:40], "little"),
                   "vtkhdf": lambda: len(readers.need("h5py").File(self.path("m.vtkhdf"), "r")["VTKHDF/Points"]),
                   "xdmf": lambda: int(re.search(r'Dimensions="(\d+) 3"', open(self.path("m.xdmf")).read()).group(1))}
        done = {"vtu"}
        for name in formats:
            if name in self.READ_BACK:
                self.run_program("convert", self.stem + ".vtu", "-o", "m" + self.READ_BACK[name], "--format", name, *self.SPLIT)
                self.run_program("convert", "m" + self.READ_BACK[name], "-o", "back.vtu")
                self.assertTrue(self.places(self.path("back.vtu")) == wanted, name)
                done.add(name)
            elif name in counted:
                self.run_program("convert", self.stem + ".vtu", "-o", "m", "--format", name, *self.SPLIT)
                self.assertEqual(counted[name](), sum(wanted.values()), name)
                done.add(name)
        # Voronoi grids have no nodes to double.
        # SeisSol splits faults itself; files of surfaces alone have no nodes of the mesh.
        surfaces = {"tsurf", "glb", "obj", "stl"}
        self.assertEqual(set(formats) - done, {"pflotran-explicit", "tough", "seissol"} | surfaces)

    def first_word(self, name, at=0):
        with open(self.path(name)) as file:
            return file.readline().split()[at]


class ByAnotherTool(FormatTest):
    """The commands of docs/outputs.md for formats that geomesh does not write itself."""

    def by_gmsh(self, form, name, count):
        if not shutil.which("gmsh"):
            self.skipTest("skipped: gmsh is not installed")
        out = self.path(name)
        done = subprocess.run(["gmsh", self.convert("m.msh"), "-0", "-format", form, "-o", out], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True, timeout=100)
        self.assertEqual(done.returncode, 0, done.stdout)
        with open(out) as file:
            self.assertEqual(count(file.read()), sum(r["tetrahedra"] for r in self.model["regions"]))

    def test_nastran_by_gmsh(self):
        self.by_gmsh("bdf", "m.bdf", lambda text: len(re.findall(r"(?m)^CTETRA", text)))

    def test_unv_by_gmsh(self):
        self.by_gmsh("unv", "m.unv", lambda text: len(re.findall(r"(?m)^ *\d+ +111 +\d+ +\d+ +\d+ +4 *$", text)))


if __name__ == "__main__":
    main()
