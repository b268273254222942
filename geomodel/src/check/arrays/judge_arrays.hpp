// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The arrays of the files against their definitions in docs/output-files.md.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "check/curves/judge_curves.hpp"
#include "check/judged/claimed_faces.hpp"

namespace geomesh::geomodel::checking {

/// `mesh_point` of the face set and of the curves names the mesh's point at that place (`wrong_mesh_points`).
void check_mesh_points(const JudgedMesh& mesh, const std::vector<Vec3>& points, const std::vector<std::int32_t>& rows,
                       const std::string& file, CheckResult& result);

/// `kind` and `input_vertex` (`wrong_kinds`, `wrong_input_vertices`). `rounding`: how far an input point may be off its
/// row. `curves`: nullptr where there are none.
void check_point_values(const ClaimedFaces& claimed, const JudgedCurves* curves, double rounding, CheckResult& result);

/// Surfaces are listed in the project's order under their names, kinds and ids (`wrong_surface_list`). Sets are listed
/// under their members' names (`wrong_surface_sets`). A face lies on every surface of its set
/// (`faces_off_their_surface`).
void check_surface_lists(const ClaimedFaces& claimed, double rounding, CheckResult& result);

/// Patches are the faces joined across edges where just two faces of the same surfaces meet (`wrong_patches`).
void check_patches(const ClaimedFaces& claimed, CheckResult& result);

/// Groups and attributes of regions are those that the project gives (`wrong_groups`, `wrong_attributes`).
void check_unit_arrays(const ClaimedFaces& claimed, CheckResult& result);

/// Arrays of `mesh.cell_arrays` are there (`missing_cell_arrays`). Those of shapes, asked for or not, hold what the
/// judge measures; sizes are lengths that do not jump inside a region (`wrong_cell_arrays`). `ulp`: the distance
/// between neighbouring numbers at the mesh's largest coordinate.
void check_cell_arrays(const ClaimedFaces& claimed, double ulp, CheckResult& result);

/// What the report tells of the elements' shapes, of the whole and of each region, is what the judge measures
/// (`report_differs`): extremes, means, histograms, counts of sharp elements, and the worst ones with their places.
void check_report_quality(const JudgedMesh& mesh, const nlohmann::json& report, double ulp, CheckResult& result);

/// What the report beside the mesh tells of regions, surfaces, curves and of displacement by rounding agrees with the
/// mesh (`report_differs`). Nothing else is taken from it. `tolerance`: what rounding may have moved.
void check_report(const ClaimedFaces& claimed, const JudgedCurves* curves, const nlohmann::json& report,
                  double tolerance, CheckResult& result);

}  // namespace geomesh::geomodel::checking
