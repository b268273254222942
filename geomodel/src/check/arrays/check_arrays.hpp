// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Checks the data arrays of the output files against their definitions in docs/output-files.md.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "check/curves/check_curves.hpp"
#include "check/mesh/checked_faces.hpp"

namespace geomesh::geomodel::checking {

/// Checks that the array `mesh_point` of the face set and of the curves refers to the mesh point with the same
/// coordinates (`wrong_mesh_points`).
void check_mesh_points(const CheckedMesh& mesh, const std::vector<Vec3>& points, const std::vector<std::int32_t>& rows,
                       const std::string& file, CheckResult& result);

/// Checks the point arrays `kind` and `input_vertex` of the mesh (`wrong_kinds`, `wrong_input_vertices`). `rounding` is
/// the largest distance between a point and the input point that it names. `curves` is nullptr if the mesh has none.
void check_point_values(const CheckedFaces& checked, const CheckedCurves* curves, double rounding, CheckResult& result);

/// Checks that surfaces are listed in the project's order with their names, kinds and ids (`wrong_surface_list`), that
/// sets are listed with their members' names (`wrong_surface_sets`), and that a face lies on every surface listed in
/// its set (`faces_off_their_surface`).
void check_surface_lists(const CheckedFaces& checked, double rounding, CheckResult& result);

/// Checks that patches are the sets of faces joined across edges with exactly two faces of the same surfaces
/// (`wrong_patches`).
void check_patches(const CheckedFaces& checked, CheckResult& result);

/// Checks that groups and attributes of regions are those defined in the project (`wrong_groups`, `wrong_attributes`).
void check_unit_arrays(const CheckedFaces& checked, CheckResult& result);

/// Checks that the arrays of `mesh.cell_arrays` exist (`missing_cell_arrays`). Arrays of element shapes, requested or
/// not, must hold the values that the checker measures; sizes must be lengths without jumps inside a region
/// (`wrong_cell_arrays`). `ulp` is the distance between neighbouring numbers at the mesh's largest coordinate.
void check_cell_arrays(const CheckedFaces& checked, double ulp, CheckResult& result);

/// Checks that the statistics of element shapes in the report, for the whole mesh and for each region, are those that
/// the checker measures (`report_differs`): extremes, means, histograms, counts of sharp elements, and the worst
/// elements with their positions.
void check_report_quality(const CheckedMesh& mesh, const nlohmann::json& report, double ulp, CheckResult& result);

/// Checks that the JSON report beside the mesh agrees with the mesh on regions, surfaces, curves and displacement by
/// rounding (`report_differs`). `tolerance` is the largest distance by which rounding may have moved points.
void check_report(const CheckedFaces& checked, const CheckedCurves* curves, const nlohmann::json& report,
                  double tolerance, CheckResult& result);

}  // namespace geomesh::geomodel::checking
