# SPDX-License-Identifier: GPL-3.0-or-later
"""The files of one output, read into memory, changed and written: what the test of the checker breaks."""
import json
import os
import copy

from vtk_files import VtkArray, VtkFile

KINDS = {"surface": ["surface", "horizon", "fault", "body", "box"], "curve": ["intersection", "border", "fault_tip", "well", "other"]}


def gather_names(file):
    """Names that stand as those of arrays (`region:NAME`, its value the id) become the lists `region_ids` and `region_names` that the
    corruptions work on; kinds that stand as numbers become words, groups a list of lists. Files with lists of texts stay as they are."""
    file.spread = any(array.section == "FieldData" and ":" in array.name for array in file.arrays)
    if not file.spread:
        return
    found = {}
    for array in [a for a in file.arrays if a.section == "FieldData" and ":" in a.name]:
        what, name = array.name.split(":", 1)
        found.setdefault(what, []).append((name, array.values))
        file.arrays.remove(array)
    points = found.pop("point", [])
    for what, entries in found.items():
        names, values = [name for name, _ in entries], [v for _, v in entries]
        if what == "group":
            offsets = [sum(map(len, values[:i])) for i in range(len(values) + 1)]
            lists = {"group_offsets": offsets, "group_region_ids": [id for v in values for id in v]}
        else:
            lists = {what + "_ids": [v[0] for v in values]}
        if what in KINDS and file.has("FieldData", what + "_kinds"):
            kinds = file["FieldData", what + "_kinds"]
            kinds.kind, kinds.values = "String", [KINDS[what][k] for k in kinds.values]
            if what == "curve":
                names, lists["curve_ids"] = names + [n for n, _ in points], lists["curve_ids"] + [v[0] for _, v in points]
                kinds.values = kinds.values[:len(names) - len(points)] + ["point"] * len(points)
        file.arrays += [VtkArray("FieldData", name, "Int32", 1, values) for name, values in lists.items()]
        file.arrays.append(VtkArray("FieldData", what + "_names", "String", 1, names))


def spread_names(file):
    if not file.spread:
        return
    for what in ("region", "surface", "curve", "group"):
        if not file.has("FieldData", what + "_names"):
            continue
        names = file["FieldData", what + "_names"].values
        if what == "group":
            offsets, ids = file["FieldData", "group_offsets"].values, file["FieldData", "group_region_ids"].values
            values = [ids[offsets[i]:offsets[i + 1]] for i in range(len(names))]
        else:
            values = [[id] for id in file["FieldData", what + "_ids"].values]
        prefixes = [what] * len(names)
        if what in KINDS and file.has("FieldData", what + "_kinds"):
            kinds = file["FieldData", what + "_kinds"].values
            prefixes = ["point" if kind == "point" else what for kind in kinds]
            numbers = [KINDS[what].index(kind) if kind in KINDS[what] else 9 for kind in kinds if kind != "point"]
            file.remove("FieldData", what + "_kinds")
            file.arrays.append(VtkArray("FieldData", what + "_kinds", "Int32", 1, numbers))
        for name, value, prefix in zip(names, values, prefixes):
            file.arrays.append(VtkArray("FieldData", prefix + ":" + name, "Int32", 1, value))
        for array in ("_names", "_ids"):
            file.remove("FieldData", what + array)
    for array in ("group_offsets", "group_region_ids"):
        file.remove("FieldData", array)


class Model:
    """The files of one output, in memory."""

    def __init__(self, folder):
        self.vtu, self.faces, self.curves = (VtkFile.read(os.path.join(folder, "m" + ending)) for ending in (".vtu", ".faces.vtp", ".curves.vtp"))
        with open(os.path.join(folder, "m.report.json")) as file:
            self.report = json.load(file)
        for file in (self.vtu, self.faces, self.curves):
            gather_names(file)

    def write(self, folder):
        os.makedirs(folder)
        for file, ending in ((self.vtu, ".vtu"), (self.faces, ".faces.vtp"), (self.curves, ".curves.vtp")):
            if file:
                written = copy.deepcopy(file)
                spread_names(written)
                written.write(os.path.join(folder, "m" + ending))
        with open(os.path.join(folder, "m.report.json"), "w") as file:
            json.dump(self.report, file)

    # What corruptions speak of.
    def cells(self):
        return self.vtu["Cells", "connectivity"].values

    def region(self):
        return self.vtu["CellData", "region"].values

    def face(self, name):
        return self.faces["CellData", name].values

    def id_of(self, surface):
        field = self.faces["FieldData", "surface_names"].values
        return self.faces["FieldData", "surface_ids"].values[field.index(surface)]

    def faces_of(self, surface):
        wanted = self.id_of(surface)
        return [f for f, s in enumerate(self.face("surface")) if s == wanted]

    def curve_id(self, name):
        return self.curves["FieldData", "curve_ids"].values[self.curves["FieldData", "curve_names"].values.index(name)]

    def lines_of(self, name):
        """Rows of the lines of a curve; `curve` counts the points before them."""
        n_vertices = len(self.curves["Verts", "offsets"].values)
        wanted = self.curve_id(name)
        return [row - n_vertices for row, c in enumerate(self.curves["CellData", "curve"].values) if c == wanted and row >= n_vertices]

    def remove_lines(self, rows):
        n_vertices = len(self.curves["Verts", "offsets"].values)
        gone = set(rows)
        connectivity, ids = self.curves["Lines", "connectivity"], self.curves["CellData", "curve"]
        n = len(self.curves["Lines", "offsets"].values)
        connectivity.values = [v for i, v in enumerate(connectivity.values) if i // 2 not in gone]
        ids.values = ids.values[:n_vertices] + [c for i, c in enumerate(ids.values[n_vertices:]) if i not in gone]
        self.curves["Lines", "offsets"].values = list(range(2, 2 * (n - len(gone)) + 1, 2))

    def add_line(self, a, b, curve):
        self.curves["Lines", "connectivity"].values += [a, b]
        offsets = self.curves["Lines", "offsets"].values
        offsets.append(offsets[-1] + 2)
        self.curves["CellData", "curve"].values.append(curve)

    def remove_faces(self, rows):
        gone = set(rows)
        n = len(self.face("surface"))
        for array in self.faces.arrays:
            if array.section == "CellData":
                array.values = [v for i, v in enumerate(array.values) if i not in gone]
        polys = self.faces["Polys", "connectivity"]
        polys.values = [v for i, v in enumerate(polys.values) if i // 3 not in gone]
        self.faces["Polys", "offsets"].values = list(range(3, 3 * (n - len(gone)) + 1, 3))

    def add_face_again(self, row):
        for array in self.faces.arrays:
            if array.section == "CellData":
                array.values.append(array.values[row])
        polys = self.faces["Polys", "connectivity"].values
        polys += polys[3 * row:3 * row + 3]
        offsets = self.faces["Polys", "offsets"].values
        offsets.append(offsets[-1] + 3)

    def map_points(self, change):
        for file in (self.vtu, self.faces, self.curves):
            xyz = file["Points", "Points"].values
            for i in range(0, len(xyz), 3):
                xyz[i:i + 3] = change(*xyz[i:i + 3])

    def names(self, file, what):
        return file["FieldData", what + "_names"].values

    def rename_region(self, old, new):
        for file in (self.vtu, self.faces):
            names = self.names(file, "region")
            names[names.index(old)] = new
        for region in self.report["regions"]:
            if region["name"] == old:
                region["name"] = new

    def kind_rows(self, kind):
        return [v for v, k in enumerate(self.vtu["PointData", "kind"].values) if k == kind]
