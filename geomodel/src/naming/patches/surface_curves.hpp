// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Determines the curve on which an edge lies from the surfaces that meet at the edge.
#pragma once

#include <vector>

#include "geomesh/geomodel/build_model.hpp"

namespace geomesh::geomodel {

/// Returns the curve at an edge, which must not be inside a patch (docs/output-files.md). `rows` are the ascending
/// indices in `surfaces` of the surfaces whose `n_facets` facets meet at the edge.
SoupCurve curve_of(const std::vector<Index>& rows, std::size_t n_facets,
                   const std::vector<TriangulatedSurface>& surfaces);

struct MeshCurves {
  struct Edge {
    VertexIndex a, b;  ///< rows of ModelMesh::points
    Index curve;       ///< row of `curves`
  };
  std::vector<SoupCurve> curves;
  std::vector<Edge> edges;  ///< Edges of curves. An edge that is on several curves occurs once for each of them.
};

/// Determines patches and curves of surfaces from the faces at each edge of the mesh, and sets the patch number of each
/// face. The curves may differ from those of the complex (ModelPlc): refinement may give a fault the edge on which a
/// horizon ends, within rounding of it. Curves are ordered by kind, then name, edges by their ends, patches by their
/// first face. Precondition: faces and surface sets are filled, with ids of surfaces that are consecutive in the order
/// of `surfaces`. O(n log n) for n faces.
MeshCurves tell_curves_and_patches(const std::vector<TriangulatedSurface>& surfaces, ModelMesh& model);

}  // namespace geomesh::geomodel
