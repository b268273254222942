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
  std::vector<SoupCurve> curves;  ///< as ModelPlc::curves
  std::vector<Edge> edges;        ///< one for each curve that an edge is on
};

/// Makes curves of surfaces and patches of `model` what the faces at each edge say. They are that already, but where
/// refinement gave one surface an edge of another: a border within rounding of a fault becomes an intersection.
/// Wells stay. Precondition: faces and surface sets are filled, with ids of surfaces that follow one another in the
/// order of `surfaces`. O(n log n) for n faces.
void correct_by_faces(const std::vector<TriangulatedSurface>& surfaces, ModelMesh& model, MeshCurves& curves);

}  // namespace geomesh::geomodel
