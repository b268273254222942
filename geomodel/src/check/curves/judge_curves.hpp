// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// NAME.curves.vtp against the mesh, the face set and the project's wells and points.
#pragma once

#include <map>
#include <vector>

#include "check/judged/claimed_faces.hpp"

namespace geomesh::geomodel::checking {

/// An edge of the mesh by its vertices, the lesser first.
using MeshEdge = std::array<VertexIndex, 2>;

/// The file's curves in vertices of the mesh.
struct JudgedCurves {
  const CurvesFile& file;
  std::vector<MeshEdge> edges;                    ///< as the file's; no_vertex where a point is none of the mesh
  std::vector<VertexIndex> vertices;              ///< as the file's
  std::map<std::int32_t, std::size_t> row_of_id;  ///< in file.curves
};

/// Every line is a mesh edge, once for each curve (`curve_edges_not_in_mesh`, `repeated_curve_edges`). Every curve
/// listed has cells and a known kind, and ids are nobody else's (`wrong_curve_lists`).
JudgedCurves check_curve_cells(const JudgedMesh& mesh, const CurvesFile& file, const FacesFile& faces,
                               CheckResult& result);

/// Intersections, borders and tips are the edges of the face set that docs/output-files.md calls so, all of them and
/// no others (`missing_curve_edges`, `wrong_curve_edges`).
void check_surface_curves(const ClaimedFaces& claimed, const JudgedCurves& curves, CheckResult& result);

/// Each well is the set of mesh edges along its path, all of the path that lies in the mesh (`wells_off`,
/// `missing_well_parts`, `wrong_wells`); each named point is a vertex of the mesh at its place (`wrong_named_points`).
/// `room`: how far points may be off by rounding, and by remeshing.
void check_wells_and_points(const ClaimedFaces& claimed, const JudgedCurves& curves, double room, CheckResult& result);

}  // namespace geomesh::geomodel::checking
