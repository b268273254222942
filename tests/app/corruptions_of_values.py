# SPDX-License-Identifier: GPL-3.0-or-later
"""Ways to break the names, the arrays and the report of an output."""
import math

from corruption import corruption, exchange
from vtk_files import VtkArray

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


@corruption("wrong_cell_arrays")
def shapes_of_two_cells_exchanged(m):
    values = m.vtu["CellData", "min_dihedral"].values
    exchange(values, 7, next(i for i, v in enumerate(values) if abs(v - values[7]) > 1e-3))


@corruption("wrong_cell_arrays")
def ratios_a_millionth_too_large(m):
    values = m.vtu["CellData", "mean_ratio"].values
    values[:] = [1.000001 * v for v in values]


@corruption("wrong_cell_arrays")
def an_aspect_that_is_no_number(m):
    m.vtu["CellData", "aspect"].values[3] = math.nan


@corruption("wrong_cell_arrays")
def a_size_three_times_too_large(m):
    """The plain mesh has no sizes: there they are zeros."""
    if not m.vtu.has("CellData", "size"):
        m.vtu.arrays.append(VtkArray("CellData", "size", "Float64", 1, [0.0] * len(m.region())))
    m.vtu["CellData", "size"].values[11] *= 3


@corruption("missing_cell_arrays")
def an_array_of_shapes_lost(m):
    m.vtu.remove("CellData", "radius_ratio")


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


@corruption("report_differs")
def a_least_angle_of_the_report_alone(m):
    m.report["quality"]["min_dihedral"] += 0.001


@corruption("report_differs")
def a_greatest_angle_of_a_region_in_the_report(m):
    m.report["quality"]["regions"][1]["max_dihedral"]["max"] -= 0.001


@corruption("report_differs")
def a_mean_of_the_report_alone(m):
    m.report["quality"]["regions"][0]["mean_ratio"]["mean"] *= 1.00001


@corruption("report_differs")
def a_histogram_of_the_report_with_one_element_more(m):
    m.report["quality"]["whole"]["radius_ratio_histogram"][10] += 1


@corruption("report_differs")
def sharp_elements_not_counted(m):
    m.report["quality"]["below_8_degrees"]["tetrahedra"] += 2


@corruption("report_differs")
def a_worst_element_elsewhere(m):
    m.report["quality"]["worst"][4]["place"][1] += 1


@corruption("report_differs")
def the_worst_elements_are_others(m):
    worst = m.report["quality"]["worst"]
    worst[0]["tetrahedron"] = worst[1]["tetrahedron"]
