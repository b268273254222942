# SPDX-License-Identifier: GPL-3.0-or-later
"""Ways to break the cells, the points, the face set and the curves of an output."""
import itertools
import math

from corruption import corruption, exchange

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
    lines, xyz = m.curves["Lines", "connectivity"].values, m.curves["Points", "Points"].values
    vertices = {v for row in m.lines_of("fault*top_reservoir") for v in lines[2 * row:2 * row + 2]}
    m.add_line(*max(itertools.combinations(sorted(vertices), 2), key=lambda e: math.dist(*(xyz[3 * v:3 * v + 3] for v in e))), m.curve_id("fault*top_reservoir"))


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
