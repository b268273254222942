// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Parts, borders and junctions of a triangulation.
#pragma once

#include <cstddef>

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

struct SheetTopology {
  std::size_t n_parts = 0;         ///< connected across edges
  std::size_t n_border_edges = 0;  ///< with one triangle
  std::size_t n_bad_edges = 0;     ///< with more than two
  Vec3 bad_place;                  ///< of the first
};

/// O(n log n). Vertices are told apart by their rows.
SheetTopology topology_of(const TriangulatedSurface& surface);

}  // namespace geomesh::geomodel
