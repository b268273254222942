# SPDX-License-Identifier: GPL-3.0-or-later
"""The judge sees every corruption: whole outputs of a model with horizons, a fault with a tip, salt, two wells, a named point, a group and
an attribute are broken in one way each, written as files and given to `geomesh check --project`, which must name the fault. Three meshes:
as the surfaces are, refined, and with surfaces remeshed within a tolerance."""
import concurrent.futures
import copy
import json
import math
import os
import shutil
import subprocess

from geomesh_program import BAD_INPUT, DONE, PROGRAM, SOURCE, ProgramTest, main, plane_ts, triangles_ts
from vtk_files import VtkArray, VtkFile

PROJECT = """name: m
box: {min: [0, 0, -2000], max: [3000, 3000, 0]}
surfaces:
  - {name: top_reservoir,  kind: horizon, file: top_reservoir.ts}
  - {name: base_reservoir, kind: horizon, file: base_reservoir.ts}
  - {name: fault, kind: fault, file: fault.ts}
  - {name: salt, kind: body, file: salt.ts, cuts: all}
wells:
  - {name: w1, file: w1.pl}
  - {name: w2, file: w2.pl}
points: [{name: gauge, at: [2500, 500, -300]}]
column: [overburden, top_reservoir, reservoir, base_reservoir, underburden]
groups: {rock: [reservoir, underburden]}
attributes: {reservoir: {porosity: 0.2}, overburden: {porosity: 0.1}}
rules: {stack: keep}  # where the stack is settled small regions join others, and suffixes and ids are not judged
mesh: %s
output: {directory: out, formats: [vtu]}
"""
MESHES = {"plain": "{mode: constrained, refine: none}", "refined": "{size: 900, honour: exact, quality: fast}",
          "within": "{size: 900, honour: tolerance, tolerance: 2, quality: fast}"}
SIDES = ["xmin", "xmax", "ymin", "ymax", "zmin", "zmax"]


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


CORRUPTIONS = {}


def corruption(*faults):
    """Registers a way to break a model, and the faults of which one at least must be named."""
    def register(function):
        CORRUPTIONS[function.__name__] = (function, faults)
        return function
    return register


def exchange(values, a, b):
    values[a], values[b] = values[b], values[a]


# ---- cells and points


@corruption("inverted_tetrahedra")
def a_cell_inverted(m):
    exchange(m.cells(), 40, 41)


@corruption("box_volume")
def a_cell_lost(m):
    del m.cells()[400:404]
    for array in m.vtu.arrays:
        if array.section == "CellData":
            del array.values[100]
    del m.vtu["Cells", "types"].values[100]
    m.vtu["Cells", "offsets"].values.pop()


@corruption("faces_shared_by_many", "faces_shared_from_one_side")
def a_cell_twice(m):
    m.cells().extend(m.cells()[400:404])
    for array in m.vtu.arrays:
        if array.section == "CellData":
            array.values.append(array.values[100])
    m.vtu["Cells", "types"].values.append(10)
    offsets = m.vtu["Cells", "offsets"].values
    offsets.append(offsets[-1] + 4)


@corruption("equal_points")
def two_points_in_one_place(m):
    xyz = m.vtu["Points", "Points"].values
    xyz[0:3] = xyz[30:33]


@corruption("not_finite")
def a_coordinate_that_is_no_number(m):
    m.vtu["Points", "Points"].values[5] = math.nan


@corruption("unused_points")
def a_point_of_no_cell(m):
    m.vtu["Points", "Points"].values += [1.0, 2.0, -3.0]
    for name, value in (("kind", 4), ("input_vertex", -1)):
        m.vtu["PointData", name].values.append(value)


@corruption("points_outside_box")
def a_point_outside_the_box(m):
    def change(x, y, z):
        return (x, y, 10.0) if (x, y, z) == (0.0, 0.0, 0.0) else (x, y, z)
    m.map_points(change)


def bump(m, height):
    """A smooth shift of everything between the box sides, by so many metres of elevation in the middle: nothing is inverted."""
    def change(x, y, z):
        return x, y, z + height * math.sin(math.pi * x / 3000) ** 2 * math.sin(math.pi * y / 3000) ** 2 * math.sin(-math.pi * z / 2000) ** 2 \
            if 0 < x < 3000 and 0 < y < 3000 and -2000 < z < 0 else z
    m.map_points(change)


@corruption("faces_off_their_triangle", "faces_off_their_surface")
def interfaces_moved_by_50_m_and_the_report_excuses_it(m):
    bump(m, 50)
    m.report["displacement"]["rounding"]["largest"] = 100


@corruption("faces_off_their_triangle", "faces_off_their_surface")
def interfaces_moved_by_3_m(m):
    bump(m, 3)


@corruption("wells_off")
def a_well_5_m_off_its_path(m):
    def change(x, y, z):
        near = math.hypot(x - 2040, y - 960)
        return (x + 5 * max(0.0, 1 - near / 200), y, z) if -1400 < z < -1e-9 else (x, y, z)
    m.map_points(change)


# ---- regions and their names


@corruption("wrong_face_regions", "unlisted_region_faces")
def a_cell_of_another_region(m):
    regions = sorted(set(m.region()))
    m.region()[100] = regions[0] if m.region()[100] != regions[0] else regions[1]


@corruption("region_ids_not_positive")
def a_region_id_of_zero(m):
    m.region()[7] = 0


@corruption("wrong_region_names", "names_differ")
def names_of_two_regions_exchanged_in_the_mesh(m):
    exchange(m.names(m.vtu, "region"), 0, 1)


@corruption("wrong_region_names")
def names_of_two_regions_exchanged_everywhere(m):
    for file in (m.vtu, m.faces):
        exchange(m.names(file, "region"), 0, 2)
    names = [r["name"] for r in m.report["regions"]]
    m.report["regions"][0]["name"], m.report["regions"][2]["name"] = names[2], names[0]


@corruption("wrong_region_names")
def a_region_renamed_to_a_word_of_no_unit(m):
    m.rename_region("reservoir", "treasure")


@corruption("wrong_region_names")
def a_region_named_after_another_unit(m):
    m.rename_region("reservoir", "underburden__2")


@corruption("wrong_region_names")
def a_body_named_after_a_unit(m):
    m.rename_region("salt", "reservoir__2")


@corruption("wrong_name_suffixes")
def a_suffix_where_there_is_one_region(m):
    m.rename_region("reservoir", "reservoir__1")


@corruption("wrong_region_names", "wrong_name_suffixes")
def a_joined_name(m):
    m.rename_region("reservoir", "reservoir+underburden")


@corruption("names_differ")
def names_that_differ_between_mesh_and_faces(m):
    m.names(m.faces, "region")[1] = "reservoir__1"


@corruption("unnamed_regions")
def a_region_without_a_name(m):
    m.names(m.vtu, "region")[1] = ""


@corruption("empty_regions")
def a_region_of_no_cell(m):
    m.vtu["FieldData", "region_ids"].values.append(9)
    m.names(m.vtu, "region").append("underburden__2")


@corruption("wrong_region_ids")
def two_region_ids_exchanged_everywhere(m):
    def other(region):
        return {1: 2, 2: 1}.get(region, region)
    for array in (m.vtu["CellData", "region"], m.faces["CellData", "region_minus"], m.faces["CellData", "region_plus"],
                  m.vtu["FieldData", "group_region_ids"]):
        array.values = [other(r) for r in array.values]
    for file in (m.vtu, m.faces):
        exchange(m.names(file, "region"), 0, 1)
    for region in m.report["regions"]:
        region["id"] = other(region["id"])


@corruption("wrong_groups")
def a_group_of_other_regions(m):
    m.vtu["FieldData", "group_region_ids"].values[0] = 1


@corruption("wrong_attributes")
def an_attribute_of_another_value(m):
    values = m.vtu["CellData", "porosity"].values
    values[next(i for i, v in enumerate(values) if v == 0.2)] = 0.21


@corruption("wrong_attributes")
def an_attribute_lost(m):
    m.vtu.remove("CellData", "porosity")


# ---- the face set


@corruption("unlisted_region_faces")
def a_face_of_a_horizon_dropped(m):
    m.remove_faces(m.faces_of("base_reservoir")[5:6])


@corruption("unlisted_region_faces")
def a_face_of_the_box_dropped(m):
    m.remove_faces(m.faces_of("zmin")[0:1])


@corruption("uncovered_triangles", "input_off_the_mesh", "borders_off", "surfaces_changed", "missing_curve_edges")
def a_face_of_a_fault_inside_one_region_dropped(m):
    minus, plus = m.face("region_minus"), m.face("region_plus")
    m.remove_faces([next(f for f in m.faces_of("fault") if minus[f] == plus[f])])


@corruption("repeated_faces")
def a_face_twice(m):
    m.add_face_again(m.faces_of("top_reservoir")[0])


@corruption("wrong_face_regions")
def a_face_turned(m):
    row = m.faces_of("top_reservoir")[0]
    exchange(m.faces["Polys", "connectivity"].values, 3 * row, 3 * row + 1)


@corruption("wrong_face_regions")
def a_face_of_another_region(m):
    m.face("region_plus")[m.faces_of("top_reservoir")[0]] = 3


@corruption("face_points_not_in_mesh")
def a_point_of_the_faces_moved(m):
    m.faces["Points", "Points"].values[2] += 1e-3


@corruption("wrong_surface_sets", "faces_off_their_triangle", "faces_off_their_surface", "wrong_source_triangles")
def a_face_of_another_surface(m):
    m.face("surface")[m.faces_of("top_reservoir")[3]] = m.id_of("base_reservoir")


@corruption("wrong_surface_sets")
def a_face_of_another_set(m):
    row = m.faces_of("top_reservoir")[3]
    sets = m.face("surface_set")
    sets[row] = sets[m.faces_of("base_reservoir")[0]]


@corruption("wrong_surface_list")
def names_of_two_surfaces_exchanged(m):
    exchange(m.names(m.faces, "surface"), 0, 1)


@corruption("wrong_surface_list")
def names_of_two_box_sides_exchanged(m):
    exchange(m.names(m.faces, "surface"), 4, 5)


@corruption("wrong_surface_list")
def a_surface_of_another_kind(m):
    m.faces["FieldData", "surface_kinds"].values[2] = "horizon"


@corruption("wrong_surface_sets")
def a_set_of_another_name(m):
    if m.faces.has("FieldData", "surface_set_names"):
        m.faces["FieldData", "surface_set_names"].values[0] += "+salt"
    else:  # sets have no names of their own: one of another member
        m.faces["FieldData", "surface_set_ids"].values[0] = m.id_of("salt")


@corruption("wrong_patches")
def a_face_of_another_patch(m):
    patches = m.face("patch")
    patches[m.faces_of("top_reservoir")[3]] = patches[m.faces_of("base_reservoir")[0]]


@corruption("wrong_patches")
def all_faces_of_one_patch(m):
    m.faces["CellData", "patch"].values = [1] * len(m.face("patch"))


@corruption("wrong_patches")
def a_patch_in_two_numbers(m):
    patches = m.face("patch")
    wanted = patches[m.faces_of("top_reservoir")[0]]
    rows = [f for f, p in enumerate(patches) if p == wanted]
    for f in rows[:len(rows) // 2]:
        patches[f] = 1000


@corruption("wrong_patches")
def a_patch_of_zero(m):
    m.face("patch")[4] = 0


@corruption("faces_off_their_triangle")
def a_source_triangle_elsewhere(m):
    rows = m.faces_of("top_reservoir")
    sources = m.face("source_triangle")
    sources[rows[0]] = sources[max(rows, key=lambda f: abs(sources[f] - sources[rows[0]]))]


@corruption("wrong_source_triangles")
def a_source_triangle_that_is_not_there(m):
    m.face("source_triangle")[m.faces_of("salt")[0]] = 10 ** 6


@corruption("wrong_mesh_points")
def a_mesh_point_of_the_faces_wrong(m):
    m.faces["PointData", "mesh_point"].values[3] += 1


@corruption("wrong_mesh_points")
def no_mesh_points_in_the_faces(m):
    m.faces.remove("PointData", "mesh_point")


@corruption("missing_face_arrays")
def no_patches(m):
    m.faces.remove("CellData", "patch")


# ---- the curves


@corruption("missing_curve_edges")
def an_edge_of_an_intersection_dropped(m):
    m.remove_lines(m.lines_of("fault*top_reservoir")[1:2])


@corruption("missing_curve_edges")
def an_edge_of_a_tip_dropped(m):
    m.remove_lines(m.lines_of("fault.tip")[0:1])


@corruption("missing_curves")
def no_curves(m):
    m.curves = None


@corruption("missing_curve_edges", "wrong_curve_edges")
def names_of_two_curves_exchanged(m):
    names = m.names(m.curves, "curve")
    exchange(names, names.index("fault*top_reservoir"), names.index("base_reservoir*fault"))


@corruption("missing_well_parts")
def all_wells_dropped(m):
    m.remove_lines(m.lines_of("w1") + m.lines_of("w2"))
    for name in ("w1", "w2"):
        row = m.names(m.curves, "curve").index(name)
        for array in ("curve_ids", "curve_names", "curve_kinds"):
            del m.curves["FieldData", array].values[row]


@corruption("missing_well_parts")
def an_edge_of_a_well_dropped(m):
    m.remove_lines(m.lines_of("w2")[1:2])


@corruption("wells_off")
def an_edge_elsewhere_called_a_well(m):
    lines = m.curves["Lines", "connectivity"].values
    row = m.lines_of("fault*top_reservoir")[0]
    m.add_line(lines[2 * row], lines[2 * row + 1], m.curve_id("w1"))


@corruption("wells_off", "missing_well_parts")
def names_of_two_wells_exchanged(m):
    names = m.names(m.curves, "curve")
    exchange(names, names.index("w1"), names.index("w2"))


@corruption("wrong_wells")
def a_well_of_another_name(m):
    names = m.names(m.curves, "curve")
    names[names.index("w1")] = "w7"


@corruption("curve_edges_not_in_mesh")
def a_curve_edge_that_no_mesh_edge_is(m):
    lines = m.curves["Lines", "connectivity"].values
    rows = m.lines_of("fault*top_reservoir")
    m.add_line(lines[2 * rows[0]], lines[2 * rows[-1] + 1], m.curve_id("fault*top_reservoir"))


@corruption("repeated_curve_edges")
def a_curve_edge_twice(m):
    lines = m.curves["Lines", "connectivity"].values
    row = m.lines_of("fault.tip")[0]
    m.add_line(lines[2 * row + 1], lines[2 * row], m.curve_id("fault.tip"))


@corruption("wrong_curve_edges")
def an_edge_inside_a_patch_called_an_intersection(m):
    inner = m.lines_of("w1")
    lines = m.curves["Lines", "connectivity"].values
    m.add_line(lines[2 * inner[0]], lines[2 * inner[0] + 1], m.curve_id("fault*top_reservoir"))


@corruption("wrong_curve_lists", "missing_curve_edges")
def a_tip_called_a_border(m):
    row = m.names(m.curves, "curve").index("fault.tip")
    m.curves["FieldData", "curve_kinds"].values[row] = "border"


@corruption("wrong_curve_lists")
def a_curve_of_no_kind(m):
    m.curves["FieldData", "curve_kinds"].values[0] = "line"


@corruption("wrong_curve_lists")
def a_curve_with_the_id_of_a_surface(m):
    ids, cells = m.curves["FieldData", "curve_ids"].values, m.curves["CellData", "curve"].values
    old, ids[0] = ids[0], m.id_of("fault")
    for i, c in enumerate(cells):
        if c == old:
            cells[i] = ids[0]


@corruption("wrong_mesh_points")
def a_mesh_point_of_the_curves_wrong(m):
    m.curves["PointData", "mesh_point"].values[0] += 1


@corruption("wrong_named_points")
def a_named_point_renamed(m):
    names = m.names(m.curves, "curve")
    names[names.index("gauge")] = "gage"


# ---- arrays of points


@corruption("wrong_kinds")
def an_input_point_called_an_inner_one(m):
    m.vtu["PointData", "kind"].values[0] = 4


@corruption("wrong_kinds")
def an_intersection_called_a_point_of_a_facet(m):
    m.vtu["PointData", "kind"].values[m.kind_rows(1)[0]] = 3


@corruption("wrong_kinds")
def a_kind_that_is_none(m):
    m.vtu["PointData", "kind"].values[-1] = 7


@corruption("wrong_kinds")
def an_added_point_called_input(m):
    m.vtu["PointData", "kind"].values[m.kind_rows(1)[-1]] = 0


@corruption("missing_point_arrays")
def no_kinds(m):
    m.vtu.remove("PointData", "kind")


@corruption("wrong_input_vertices", "wrong_kinds")
def an_input_vertex_of_another_row(m):
    rows = m.vtu["PointData", "input_vertex"].values
    rows[0] += 40


@corruption("wrong_input_vertices", "wrong_kinds")
def an_input_point_without_its_row(m):
    m.vtu["PointData", "input_vertex"].values[0] = -1


@corruption("wrong_input_vertices", "wrong_kinds")
def an_added_point_with_a_row(m):
    m.vtu["PointData", "input_vertex"].values[m.kind_rows(1)[0]] = 5


# ---- the report


@corruption("report_differs")
def a_displacement_that_rounding_cannot_make(m):
    m.report["displacement"]["rounding"]["largest"] = 100


@corruption("report_differs")
def a_name_of_the_report_alone(m):
    m.report["regions"][0]["name"] = "reservoir"


@corruption("report_differs")
def a_volume_of_the_report_alone(m):
    m.report["regions"][0]["volume"] *= 1.001


@corruption("report_differs")
def a_length_of_the_report_alone(m):
    m.report["curves"][0]["length"] *= 1.001


class Judge(ProgramTest):
    def write_project(self, mesh):
        surfaces = os.path.join(SOURCE, "samples", "wells", "surfaces")
        for name in ("top_reservoir.ts", "base_reservoir.ts", "w1.pl", "w2.pl"):
            shutil.copy(os.path.join(surfaces, name), self.folder)
        self.write("fault.ts", plane_ts("fault", [(700, -60, -2100), (700, 2000, -2100), (700, 2000, 100), (700, -60, 100)]))
        x, y, z, r = 2300.0, 2200.0, -1400.0, 300.0
        points = [(x - r, y, z), (x + r, y, z), (x, y - r, z), (x, y + r, z), (x, y, z - r), (x, y, z + r)]
        triangles = [(1, 3, 5), (3, 0, 5), (0, 2, 5), (2, 1, 5), (3, 1, 4), (0, 3, 4), (2, 0, 4), (1, 2, 4)]
        self.write("salt.ts", triangles_ts("salt", points, triangles))
        return self.write("project.yaml", PROJECT % mesh)

    def judge(self, folder, project):
        """Names of the faults that the check finds in a folder; it must exit with 3 where there are any."""
        file = os.path.join(folder, "check.json")
        done = subprocess.run([PROGRAM, "check", os.path.join(folder, "m.vtu"), "--project", project, "--report", file], timeout=self.timeout,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if not os.path.exists(file):
            raise AssertionError(done.stdout)
        with open(file) as report:
            faults = [fault["id"] for fault in json.load(report)["faults"]]
        self.assertEqual(done.returncode, BAD_INPUT if faults else DONE)
        return faults

    def see_all(self, mesh):
        project = self.write_project(MESHES[mesh])
        self.run_program(project, "-o", self.path("out"), "--quiet")
        whole = Model(self.path("out"))
        whole.write(self.path("whole"))
        self.assertEqual(self.judge(self.path("whole"), project), [], "the whole output passes")

        def see(name):
            break_it, _ = CORRUPTIONS[name]
            model = copy.deepcopy(whole)
            break_it(model)
            model.write(self.path(name))
            return self.judge(self.path(name), project)

        self.assertGreaterEqual(len(CORRUPTIONS), 60)
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            found = dict(zip(CORRUPTIONS, pool.map(see, CORRUPTIONS)))
        for name, faults in found.items():
            with self.subTest(corruption=name):
                self.assertTrue(set(CORRUPTIONS[name][1]) & set(faults), "expected one of %s, found %s" % (CORRUPTIONS[name][1], faults))
        print("%s: %d corruptions, each found" % (mesh, len(found)))

    def test_every_corruption_of_a_plain_mesh_is_named(self):
        self.see_all("plain")

    def test_every_corruption_of_a_refined_mesh_is_named(self):
        self.see_all("refined")

    def test_every_corruption_of_a_mesh_within_a_tolerance_is_named(self):
        self.see_all("within")


if __name__ == "__main__":
    main()
