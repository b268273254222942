// SPDX-License-Identifier: MIT
/// @file
/// The caller's frame and the caller's indices of vertices, facets and segments. The model is meshed in another frame
/// and order than the caller's (tetrahedralize/canonical_form.hpp).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh {

/// A change of frame that permutes and reverses axes, which is exact in doubles.
struct AxisFrame {
  std::array<std::uint8_t, 3> axis{0, 1, 2};  ///< axis i of the model is the caller's axis[i], times direction[i]
  std::array<double, 3> direction{1, 1, 1};   ///< -1 for each axis of the model that is reversed, else 1

  /// Converts p from the caller's frame to that of the model; -0 becomes 0.
  Vec3 enter(const Vec3& p) const {
    return {direction[0] * p[axis[0]] + 0.0, direction[1] * p[axis[1]] + 0.0, direction[2] * p[axis[2]] + 0.0};
  }
  /// Converts p from the frame of the model to that of the caller; -0 becomes 0.
  Vec3 leave(const Vec3& p) const {
    Vec3 out;
    for (std::size_t i = 0; i < 3; ++i) out[axis[i]] = direction[i] * p[i] + 0.0;
    return out;
  }
  /// Returns whether a tetrahedron that is positive in the caller's frame is negative in the frame of the model.
  bool mirrors() const {
    const bool is_odd = (axis[0] + 1) % 3 != axis[1];
    return is_odd != (direction[0] * direction[1] * direction[2] < 0);
  }
};

/// The caller's index of each vertex, facet and segment of the model.
struct ModelNames {
  AxisFrame frame;
  std::vector<VertexIndex> vertex;
  std::vector<Index> facet;
  std::vector<Index> segment;
  std::vector<std::uint8_t> facet_is_reversed;    ///< whether a facet's outer loop is the reverse of the caller's
  std::vector<std::uint8_t> segment_is_reversed;  ///< whether a segment's ends are in reverse of the caller's order

  /// Returns whether the upper side of facet f, by its loop in the model's frame, is its lower side for the caller.
  bool swaps_sides(Index f) const { return (facet_is_reversed[f] != 0) != frame.mirrors(); }
};

}  // namespace geomesh
