// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Counts the components, borders and non-manifold edges of a triangulation.
#pragma once

#include <cstddef>

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

struct SheetTopology {
  std::size_t n_parts = 0;         ///< connected across edges
  std::size_t n_border_edges = 0;  ///< with one triangle
  std::size_t n_bad_edges = 0;     ///< number of edges with more than two triangles
  Vec3 bad_place;                  ///< of the first
};

/// Counts the components and borders of a surface in O(n log n). Vertices are identified by rows, not coordinates.
SheetTopology topology_of(const TriangulatedSurface& surface);

}  // namespace geomesh::geomodel
