// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Tests whether a place lies on the same side of each of many planes.
#pragma once

#include <cstdint>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

/// A plane through a point, with its normal to one side. The length of the normal is irrelevant; if it is zero the
/// plane has no sides.
struct SidedPlane {
  Vec3 point, normal;
};

/// Position of a place relative to all of several planes.
enum class SideOfAll : std::uint8_t { above, below, not_known };

/// Bounds on normals and offsets, in a tree over the planes by their points. O(n log n) to build. A query visits a few
/// bounds if the place is far from the planes compared with how much they bend, and O(n) at most.
class SideBounds {
 public:
  explicit SideBounds(std::vector<SidedPlane> planes);
  /// Returns that p is above (or below) all planes only if it is so by a margin much larger than rounding.
  SideOfAll side(const Vec3& p) const;

 private:
  struct Node {
    Box3 normals;                      ///< of length one
    double least_offset, most_offset;  ///< least and greatest offset of planes from one centre, along their normals
    std::size_t right;  ///< child node with the second half of the planes, 0 if none; the next node has the first half
  };
  std::size_t build(std::vector<SidedPlane>& planes, std::size_t begin, std::size_t end);
  SideOfAll side(std::size_t node, const Vec3& from_centre, double tiny) const;

  Vec3 centre_{};      ///< centre of the bounding box of the planes' points
  double extent_ = 0;  ///< diagonal of the bounding box of the planes' points
  std::vector<Node> nodes_;
};

}  // namespace geomesh::geomodel
