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
  std::vector<std::size_t> round_begin;  ///< begin of each insertion round in `order`; last, the number of points
  /// The part of the Hilbert curve in which each point of `order` lies. The curve is cut into `n_places` parts that
  /// hold about equally many points, the same parts for all rounds.
  std::vector<std::uint16_t> place;
  static constexpr unsigned n_places = 4096;
};

/// Returns an order in which to insert the points. It depends on the coordinates alone, except that equal points are
/// ordered by index. Translating the points without rounding, or scaling them by a power of two, does not change it.
/// The last round holds 7/8 of all points, the round before it 7/8 of the others, and so on. The curve is refined where
/// points are dense, so that the points of a dense cluster are ordered, too. O(n) for evenly spread points, otherwise
/// O(n log n). At most 2^28 points. `scratch` is memory for 2 n items; it is not used if it is smaller. `threads` does
/// not influence the result.
SpatialOrder spatial_order(std::span<const Vec3> points, std::span<std::uint64_t> scratch = {}, unsigned threads = 1);

/// Returns all points ordered along one Hilbert curve.
std::vector<VertexIndex> hilbert_order(std::span<const Vec3> points);

}  // namespace geomesh
