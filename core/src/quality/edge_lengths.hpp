// SPDX-License-Identifier: MIT
/// @file
/// Lengths of a mesh's edges compared with the target sizes.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "geomesh/core/geometry.hpp"
#include "geomesh/core/size_field.hpp"

namespace geomesh {

/// Lengths of the edges of a set of tetrahedra, each counted once, in ascending order of their vertices.
struct EdgeLengths {
  std::vector<double> length;
  /// Histogram of length divided by target size. The target size of an edge is the mean of the target sizes at its
  /// ends; if the edge is in several components, the smallest of their means. Upper bounds of the bins: 1/4, 1/2,
  /// 1/sqrt 2, 1, sqrt 2, 2, 4, none. All are zero without a size field.
  std::array<std::size_t, 8> by_size{};
};

/// The component (for the size field) and the group (for the statistics) of each tetrahedron. The component of a
/// tetrahedron without one is no_index.
struct CellParts {
  std::span<const Index> component, group;
  std::size_t n_groups = 0;
};

/// Returns the edge lengths of the whole mesh, followed by those of each group. O(n) plus size look-ups, on `threads`
/// threads; the result does not depend on their number.
std::vector<EdgeLengths> measure_edges(std::span<const Vec3> points, std::span<const Tetrahedron> tetrahedra,
                                       const CellParts& parts, const SizeField* size, unsigned threads);

}  // namespace geomesh
