// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Which curve an edge is on, by the surfaces that meet there.
#pragma once

#include <vector>

#include "geomesh/geomodel/build_model.hpp"

namespace geomesh::geomodel {

/// The curve of an edge where `n_facets` facets of `rows` (ascending rows of `surfaces`) meet, an edge inside of no
/// patch (docs/output-files.md).
SoupCurve curve_of(const std::vector<Index>& rows, std::size_t n_facets,
                   const std::vector<TriangulatedSurface>& surfaces);

/// Curves with their edges in a mesh.
struct MeshCurves {
  struct Edge {
    VertexIndex a, b;  ///< rows of ModelMesh::points
    Index curve;       ///< row of `curves`
  };
  std::vector<SoupCurve> curves;
  std::vector<Edge> edges;  ///< one for each curve that an edge is on
};

/// Curves of surfaces and patches as the faces at each edge tell them; fills the faces' patches. Those of the complex
/// (ModelPlc) may differ: refinement gives a fault the edge on which a horizon ends, within rounding of it. Curves are
/// ordered by kind, then name, edges by their ends, patches by their first face. Precondition: faces and surface sets
/// are filled, with ids of surfaces that follow one another in the order of `surfaces`. O(n log n) for n faces.
MeshCurves tell_curves_and_patches(const std::vector<TriangulatedSurface>& surfaces, ModelMesh& model);

}  // namespace geomesh::geomodel
