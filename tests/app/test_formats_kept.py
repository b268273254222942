#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What comes back: each format there and back, names that files accept, and no half file where one cannot be written or read."""
import os

import format_readers as readers
from geomesh_program import BAD_INPUT, USAGE, ProgramTest, has_module, level, main
from test_formats import FormatTest


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
        for name, ending, keeps_arrays in (("vtu", ".vtu", True), ("msh", ".msh", True), ("msh-binary", ".msh", True), ("msh22", ".msh", True),
                                           ("msh22-binary", ".msh", True), ("inp", ".inp", False), ("exodus", ".e", True), ("med", ".med", False)):
            if not has_module(name):
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
