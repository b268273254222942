#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Each format as other people's readers see it: regions, sets of faces and nodes, names, counts, volumes. docs/outputs.md is this table."""
import json
import os
import re
import shutil
import subprocess
import sys
import unittest

import format_readers as readers
from geomesh_program import BAD_INPUT, PROGRAM, SOURCE, USAGE, ProgramTest, level, main


def plain(name):
    """A name as solver files have it, where it is short and has no clash."""
    name = re.sub(r"[^A-Za-z0-9_.-]", "_", name)
    return name if name[:1].isalpha() else "n" + name


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
        done = subprocess.run([PROGRAM, project, "-o", folder], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=300)
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
        if name not in self.run_program("convert", "--help"):
            self.skipTest("skipped: built without " + name)

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


class ThereAndBack(FormatTest):
    """What a format can hold is kept: regions, surfaces with kinds, curves, counts and volumes."""

    def round_trip(self, name, *options, curves=True):
        path = self.convert(name, *options)
        back = self.path("back")
        os.makedirs(back, exist_ok=True)
        self.run_program("convert", path, "-o", os.path.join(back, "m.vtu"))
        first, second = self.report(self.stem + ".vtu.json"), self.report(os.path.join(back, "m.vtu.json"))
        self.assertEqual(sorted(r["name"] for r in second["regions"]), sorted(r["name"] for r in first["regions"]))
        self.assertEqual({s["name"]: s["kind"] for s in second["surfaces"]}, {s["name"]: s["kind"] for s in first["surfaces"] if self.area(s["name"])})
        if curves:
            self.assertEqual({c["name"]: c["kind"] for c in second["curves"]}, {c["name"]: c["kind"] for c in first["curves"]})
        check = self.check(os.path.join(back, "m.vtu"), status=None)
        volumes = {r["name"]: r["volume"] for r in check["regions"]}
        for region in self.model["regions"]:
            self.assertAlmostEqual(volumes[region["name"]] / region["volume"], 1, delta=1e-12)

    def area(self, name):
        return next(s["area"] for s in self.model["surfaces"] if s["name"] == name) > 0

    def test_vtu(self):
        self.round_trip("m.vtu")

    def test_msh(self):
        self.round_trip("m.msh")

    def test_msh_pieces(self):
        self.round_trip("m.msh", "--groups", "pieces")

    def test_msh_binary(self):
        self.round_trip("m.msh", "--format", "msh-binary")

    def test_msh22_binary(self):
        self.round_trip("m.msh", "--format", "msh22-binary")

    def test_inp(self):
        self.round_trip("m.inp", curves=False)

    def test_exodus(self):
        self.round_trip("m.e", curves=False)

    def test_med(self):
        if "med" in self.run_program("convert", "--help"):
            self.round_trip("m.med")

    def test_mfem(self):
        """MFEM's format of version 1.0 holds numbers and no names: regions come back in the order of their ids."""
        path = self.convert("m.mesh")
        back = self.path("back")
        os.makedirs(back, exist_ok=True)
        self.run_program("convert", path, "-o", os.path.join(back, "m.vtu"))
        regions = self.check(os.path.join(back, "m.vtu"), status=None)["regions"]
        self.assertEqual(len(regions), len(self.model["regions"]))
        for found, region in zip(sorted(regions, key=lambda r: r["id"]), sorted(self.model["regions"], key=lambda r: r["id"])):
            self.assertEqual(found["tetrahedra"], region["tetrahedra"])
            self.assertAlmostEqual(found["volume"] / region["volume"], 1, delta=1e-12)

    def test_check_reads_second_order_of_every_format(self):
        for name in ("m.vtu", "m.msh", "m.inp", "m.e"):
            check = self.check(self.convert(name, "--order", "2"), status=None)
            self.assertEqual(sum(r["tetrahedra"] for r in check["regions"]), sum(r["tetrahedra"] for r in self.model["regions"]), name)


class EverythingThereAndBack(ProgramTest):
    """Attributes, arrays of cells, groups of regions, unit and origin, by way of each format."""

    def model(self):
        for name, z in (("upper", 7), ("lower", 4)):
            self.write(name + ".ts", level(name, z))
        self.write("project.yaml", "name: model\ncrs: {unit: km}\nbox: {min: [0, 0, 0], max: [10, 10, 10]}\nsurfaces:\n  - {name: upper, kind: horizon, file: upper.ts}\n"
                   "  - {name: lower, kind: horizon, file: lower.ts}\ncolumn: [top, upper, middle, lower, bottom]\ngroups: {cover: [top, middle]}\n"
                   "attributes:\n  top: {porosity: 0.25, density: 2100}\n  bottom: {density: 2700.125}\n"
                   "mesh: {size: 4, cell_arrays: [radius_ratio]}\noutput: {directory: ., formats: [vtu], origin: [4, 2, 1]}\n")
        self.run_program("project.yaml")
        return self.report(self.path("model.vtu.json"))

    def values(self, stem):
        """Per centroid: region's name and all arrays."""
        try:
            meshio = readers.need("meshio")
        except readers.ReaderMissing:
            self.skipTest("skipped: python3-meshio is not installed")
        mesh = meshio.read(stem + ".vtu")
        sidecar = self.report(stem + ".vtu.json")
        name = {r["id"]: r["name"] for r in sidecar["regions"]}
        arrays = {key: blocks[0] for key, blocks in mesh.cell_data.items() if key != "region"}
        rows = {}
        for c, cell in enumerate(mesh.cells[0].data):
            place = tuple(sorted(tuple(round(x, 9) for x in mesh.points[p]) for p in cell))
            rows[place] = (name[mesh.cell_data["region"][0][c]], {key: repr(float(values[c])) for key, values in arrays.items()})
        return rows

    def test_all_formats_that_are_read(self):
        before = self.model()
        first = self.values(self.path("model"))
        self.assertEqual(set(next(iter(first.values()))[1]), {"porosity", "density", "radius_ratio"})
        listed = self.run_program("convert", "--help")
        for name, ending, keeps_arrays in (("vtu", ".vtu", True), ("msh", ".msh", True), ("msh-binary", ".msh", True), ("msh22", ".msh", True),
                                           ("msh22-binary", ".msh", True), ("inp", ".inp", False), ("exodus", ".e", True), ("med", ".med", False)):
            if name == "med" and "med" not in listed:
                continue
            with self.subTest(name):
                folder = self.path("by_" + name)
                os.makedirs(os.path.join(folder, "back"))
                self.run_program("convert", "model.vtu", "-o", os.path.join(folder, "m" + ending), "--format", name)
                self.run_program("convert", os.path.join(folder, "m" + ending), "-o", os.path.join(folder, "back", "m.vtu"))
                after = self.report(os.path.join(folder, "back", "m.vtu.json"))
                self.assertEqual((after["unit"], after["origin"]), ("km", [4, 2, 1]))
                self.assertEqual({r["name"]: r.get("attributes") for r in after["regions"]}, {r["name"]: r.get("attributes") for r in before["regions"]})
                of = lambda report: {g["name"]: sorted(r["name"] for r in report["regions"] if r["id"] in g["regions"]) for g in report["region_groups"]}
                self.assertEqual(of(after), of(before))
                last = self.values(os.path.join(folder, "back", "m"))
                self.assertEqual(set(last), set(first))
                for place, (region, arrays) in first.items():
                    self.assertEqual(last[place][0], region)
                    for key, value in arrays.items():
                        if keeps_arrays or key != "radius_ratio":
                            self.assertEqual(last[place][1][key], value, key)


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

    def test_medit_by_gmsh(self):
        self.by_gmsh("mesh", "m_medit.mesh", lambda text: int(re.search(r"Tetrahedra\s+(\d+)", text).group(1)))

    def by_meshio(self, name):
        try:
            meshio = readers.need("meshio")
        except readers.ReaderMissing:
            self.skipTest("skipped: python3-meshio is not installed")
        mesh = meshio.read(self.convert("m.vtu"))
        meshio.write(self.path(name), mesh)
        again = meshio.read(self.path(name))
        self.assertEqual(sum(len(c.data) for c in again.cells if c.type == "tetra"), sum(r["tetrahedra"] for r in self.model["regions"]))

    def test_flac3d_by_meshio(self):
        self.by_meshio("m.f3grid")


class Names(ProgramTest):
    def test_blanks_umlauts_length_and_clashes_come_out_legal_unique_and_traceable(self):
        long = "a name of more than eighty letters that goes on and on until nobody can remember how it began"
        names = ["Südlicher Flügel", "Suedlicher Fluegel", "suedlicher fluegel", long, long + " again"]
        for i, _ in enumerate(names):
            self.write("h%d.ts" % i, level("h", 1.5 * (i + 1)))
        column = "[oben, %s]" % ", ".join('"%s", unit_%d' % (name, i) for i, name in reversed(list(enumerate(names))))
        self.write("project.yaml", "box: {min: [0, 0, 0], max: [10, 10, 10]}\nsurfaces:\n" + "".join(
            '  - {name: "%s", kind: horizon, file: h%d.ts}\n' % (name, i) for i, name in enumerate(names)) + "column: %s\noutput: {directory: ., formats: [msh, inp, exodus]}\n" % column)
        self.run_program("project.yaml")
        for ending, limit in ((".msh", 80), (".inp", 80), (".e", 256)):
            sidecar = next(self.report(self.path(f)) for f in os.listdir(self.folder) if f.endswith(ending + ".json"))
            taken = {}
            for group in sidecar["groups"]:
                self.assertRegex(group["name"], r"^[A-Za-z][A-Za-z0-9_.-]{0,%d}$" % (limit - 1))
                self.assertTrue(taken.setdefault((group["type"], group["name"].lower()), group["full_name"]) == group["full_name"], group)
            full = {group["full_name"] for group in sidecar["groups"]}
            for name in names:
                self.assertTrue(any(f.split(".minus")[0] == name for f in full), name)
            self.assertTrue(any(g["name"].startswith("Suedlicher_Fluegel") and g["full_name"].startswith("Südlicher") for g in sidecar["groups"]))


class Refusals(FormatTest):
    def test_a_full_disk_leaves_no_half_file(self):
        if not os.path.exists("/dev/full"):
            self.skipTest("skipped: no /dev/full")
        for name in ("m.vtu", "m.msh", "m.inp", "m.e", "m.mesh"):
            os.symlink("/dev/full", self.path(name))
            self.assertIn("cannot write", self.run_program("convert", self.stem + ".vtu", "-o", self.path(name), status=None))
            self.assertNotEqual(self.last_status, 0, name)
            os.remove(self.path(name)) if os.path.lexists(self.path(name)) else None
            self.assertEqual([f for f in os.listdir(self.folder) if not f.endswith(".json")], [], name)

    def test_a_folder_that_is_a_file(self):
        self.write("file", "")
        for name in ("m.vtu", "m.msh", "m.e", "m.foam"):
            self.run_program("convert", self.stem + ".vtu", "-o", self.path("file", name), status=USAGE)

    def test_what_a_format_cannot_hold_is_said(self):
        self.assertIn("second order", self.run_program("convert", self.stem + ".vtu", "-o", "m.mesh", "--order", "2", status=USAGE))
        self.assertIn("no surface is named", self.run_program("convert", self.stem + ".vtu", "-o", "m.msh", "--split", "nothing", status=USAGE))
        self.assertIn("unknown extension", self.run_program("convert", self.stem + ".vtu", "-o", "m.xyz", status=USAGE))

    def test_damaged_files_are_refused(self):
        for name in ("m.msh", "m.e", "m.inp", "m.mesh"):
            path = self.convert(name)
            with open(path, "rb") as file:
                content = file.read()
            with open(path, "wb") as file:
                file.write(content[:len(content) // 2])
            self.run_program("convert", path, "-o", self.path("back.vtu"), status=None)
            self.assertIn(self.last_status, (BAD_INPUT,) if name != "m.inp" else (0, BAD_INPUT), name)


if __name__ == "__main__":
    main()
