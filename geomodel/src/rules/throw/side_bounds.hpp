// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Whether a place lies on one side of many planes at once.
#pragma once

#include <cstdint>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

/// A plane through a point, with its normal to one side. Its length does not count; without length it has no sides.
struct SidedPlane {
  Vec3 point, normal;
};

/// Where a place lies against all of some planes.
enum class SideOfAll : std::uint8_t { above, below, not_known };

/// Bounds on normals and offsets, in a tree over the planes by their points. O(n log n) to build. A question costs a
/// few bounds where the place is far from the planes against how much they bend, O(n) at most.
class SideBounds {
 public:
  explicit SideBounds(std::vector<SidedPlane> planes);
  /// Above or below only where each plane says so, by much more than rounding.
  SideOfAll side(const Vec3& p) const;

 private:
  struct Node {
    Box3 normals;                      ///< of length one
    double least_offset, most_offset;  ///< of the planes from the centre, along their normals
    std::size_t right;                 ///< row of the second half, 0: none; that of the first is the next
  };
  std::size_t build(std::vector<SidedPlane>& planes, std::size_t begin, std::size_t end);
  SideOfAll side(std::size_t node, const Vec3& from_centre, double tiny) const;

  Vec3 centre_{};      ///< of the box about the points
  double extent_ = 0;  ///< of the box, from corner to corner
  std::vector<Node> nodes_;
};

}  // namespace geomesh::geomodel
