// SPDX-License-Identifier: MIT
/// @file
/// The caller's names for the items of the model that is being meshed. The caller gave the model in another frame and
/// order (tetrahedralize/canonical_form.hpp).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh {

/// A frame with permuted and reversed axes, which is exact in doubles.
struct AxisFrame {
  std::array<std::uint8_t, 3> axis{0, 1, 2};  ///< axis i here is the caller's axis[i] ...
  std::array<double, 3> direction{1, 1, 1};   ///< ... times this, 1 or -1

  /// From the caller's frame; -0 becomes 0.
  Vec3 enter(const Vec3& p) const {
    return {direction[0] * p[axis[0]] + 0.0, direction[1] * p[axis[1]] + 0.0, direction[2] * p[axis[2]] + 0.0};
  }
  /// Back to the caller's frame; -0 becomes 0.
  Vec3 leave(const Vec3& p) const {
    Vec3 out;
    for (std::size_t i = 0; i < 3; ++i) out[axis[i]] = direction[i] * p[i] + 0.0;
    return out;
  }
  /// Returns whether a positive tetrahedron of the caller is a negative one here.
  bool mirrors() const {
    const bool is_odd = (axis[0] + 1) % 3 != axis[1];
    return is_odd != (direction[0] * direction[1] * direction[2] < 0);
  }
};

/// The caller's row of each item of the model.
struct ModelNames {
  AxisFrame frame;
  std::vector<VertexIndex> vertex;
  std::vector<Index> facet;
  std::vector<Index> segment;
  std::vector<std::uint8_t> facet_is_reversed;    ///< its outer loop is reversed with respect to the caller's
  std::vector<std::uint8_t> segment_is_reversed;  ///< its ends are exchanged with respect to the caller's

  /// Returns whether the upper side of facet f here (by its loop and the frame here) is the caller's lower side.
  bool swaps_sides(Index f) const { return (facet_is_reversed[f] != 0) != frame.mirrors(); }
};

}  // namespace geomesh
