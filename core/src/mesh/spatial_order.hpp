// SPDX-License-Identifier: MIT
/// @file
/// The order of insertion: rounds of growing size (BRIO, Amenta, Choi and Rote 2003), each along a Hilbert curve.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh {

struct SpatialOrder {
  std::vector<VertexIndex> order;
  std::vector<std::size_t> round_begin;  ///< positions in `order`; one more entry than rounds
  /// The place of each position along the curve, in `n_places` parts that hold about as many points each, over all
  /// rounds.
  std::vector<std::uint16_t> place;
  static constexpr unsigned n_places = 4096;
};

/// Depends on the coordinates alone, except that equal points are ordered by index. Moving the points without rounding,
/// or scaling them by a power of two, changes nothing. A round holds 7/8 of the points that the later rounds leave. The
/// curve is refined where points are dense, so that clusters of any density are ordered within. O(n) for evenly spread
/// points, otherwise O(n log n). At most 2^28 points. `scratch` has memory for 2 n items; a smaller one is not used.
/// `threads` does not influence the result.
SpatialOrder spatial_order(std::span<const Vec3> points, std::span<std::uint64_t> scratch = {}, unsigned threads = 1);

/// Orders all points along one such curve.
std::vector<VertexIndex> hilbert_order(std::span<const Vec3> points);

}  // namespace geomesh
