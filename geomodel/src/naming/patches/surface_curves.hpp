// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Determines on which curve an edge lies, by the surfaces that meet there.
#pragma once

#include <vector>

#include "geomesh/geomodel/build_model.hpp"

namespace geomesh::geomodel {

/// Returns the curve of an edge at which `n_facets` facets of `rows` (ascending rows of `surfaces`) meet and which is
/// not inside a patch (docs/output-files.md).
SoupCurve curve_of(const std::vector<Index>& rows, std::size_t n_facets,
                   const std::vector<TriangulatedSurface>& surfaces);

/// Curves together with their edges in a mesh.
struct MeshCurves {
  struct Edge {
    VertexIndex a, b;  ///< rows of ModelMesh::points
    Index curve;       ///< row of `curves`
  };
  std::vector<SoupCurve> curves;
  std::vector<Edge> edges;  ///< one entry for each curve on which an edge lies
};

/// Determines curves of surfaces and patches from the faces at each edge, and fills the faces' patches. They may differ
/// from those of the complex (ModelPlc): refinement may give a fault the edge on which a horizon ends, within rounding
/// of it. Curves are ordered by kind, then name, edges by their ends, patches by their first face. Precondition: faces
/// and surface sets are filled, with ids of surfaces that are consecutive in the order of `surfaces`. O(n log n) for n
/// faces.
MeshCurves tell_curves_and_patches(const std::vector<TriangulatedSurface>& surfaces, ModelMesh& model);

}  // namespace geomesh::geomodel
