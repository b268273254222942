// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Checks NAME.curves.vtp against the mesh, the face set and the project's wells and points.
#pragma once

#include <map>
#include <vector>

#include "check/mesh/checked_faces.hpp"

namespace geomesh::geomodel::checking {

/// A mesh edge by its vertices, the smaller index first.
using MeshEdge = std::array<VertexIndex, 2>;

/// The curves of the curves file, expressed in vertices of the mesh.
struct CheckedCurves {
  const CurvesFile& file;
  /// Curve edges by mesh vertices, in file order; no_vertex for an end that is not in the mesh.
  std::vector<MeshEdge> edges;
  std::vector<VertexIndex> vertices;              ///< as the file's
  std::map<std::int32_t, std::size_t> row_of_id;  ///< in file.curves
};

/// Checks that every line is a mesh edge, listed once for each curve (`curve_edges_not_in_mesh`,
/// `repeated_curve_edges`), and that every listed curve has cells, a known kind and an id of its own
/// (`wrong_curve_lists`).
CheckedCurves check_curve_cells(const CheckedMesh& mesh, const CurvesFile& file, const FacesFile& faces,
                                CheckResult& result);

/// Checks that intersections, borders and tips are exactly those edges of the face set that docs/output-files.md
/// defines as such (`missing_curve_edges`, `wrong_curve_edges`).
void check_surface_curves(const CheckedFaces& checked, const CheckedCurves& curves, CheckResult& result);

/// Checks that each well is the set of mesh edges along its path, wherever the path lies in the mesh (`wells_off`,
/// `missing_well_parts`, `wrong_wells`), and that each named point is a mesh vertex at its position
/// (`wrong_named_points`). `room` is the largest distance by which rounding and remeshing may move points.
void check_wells_and_points(const CheckedFaces& checked, const CheckedCurves& curves, double room, CheckResult& result);

}  // namespace geomesh::geomodel::checking
