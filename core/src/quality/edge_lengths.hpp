// SPDX-License-Identifier: MIT
/// @file
/// Lengths of a mesh's edges beside those that are asked for.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "geomesh/core/geometry.hpp"
#include "geomesh/core/size_field.hpp"

namespace geomesh {

/// Edges of a set of tetrahedra, each once, in ascending order of their vertices.
struct EdgeLengths {
  std::vector<double> length;
  /// By length over asked size, which is the least that is asked at the edge's middle in the components that it is in:
  /// below 1/4, 1/2, 1/sqrt 2, 1, sqrt 2, 2, 4, above. Zero without a size field.
  std::array<std::size_t, 8> by_size{};
};

/// What the tetrahedra are parted by: a component (for the size field) and a group (for the statistics) of each; no
/// component: no_index.
struct CellParts {
  std::span<const Index> component, group;
  std::size_t n_groups = 0;
};

/// Of the whole, then of each group. O(n) but for size lookups, on `threads` threads; the result does not depend on
/// their number.
std::vector<EdgeLengths> measure_edges(std::span<const Vec3> points, std::span<const Tetrahedron> tetrahedra,
                                       const CellParts& parts, const SizeField* size, unsigned threads);

}  // namespace geomesh
