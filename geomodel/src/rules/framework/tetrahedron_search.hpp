// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Which tetrahedron of a mesh holds a place.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "arrangement/search/bvh.hpp"
#include "geomesh/core/plc.hpp"

namespace geomesh::geomodel {

/// Goes from tetrahedron to tetrahedron towards the place; a tree of boxes answers what that leaves open: places on
/// faces, and walks that end at the border of the mesh. Places beyond a plane that has all of the mesh on one side, as
/// the sides of a box have, need no search. All decisions of what holds a place are exact.
class TetrahedronSearch {
 public:
  /// The tetrahedra are positive and do not overlap.
  TetrahedronSearch(std::vector<Vec3> points, std::vector<Tetrahedron> tetrahedra);

  /// The tetrahedron that holds p, the first of several; no_index where none does. `start`: where the walk begins, best
  /// near p; no_index: anywhere. O(1) steps for places one after another, O(n^(1/3)) for others, O(n) where tetrahedra
  /// overlap in their boxes and the walk ends early.
  Index find(const Vec3& p, Index start) const;
  std::array<Vec3, 4> corners(Index t) const;
  /// The tree of the tetrahedra's boxes, by which those near something are found.
  const arrangement::BoxTree& boxes() const { return *tree_; }

 private:
  struct Plane {
    Vec3 outward;
    double offset;  ///< of all points, with what rounding may add
  };
  void find_neighbours();
  void find_planes(const std::vector<std::array<Index, 2>>& border);
  bool is_beyond_planes(const Vec3& p) const;
  /// The only tetrahedron that holds p; no_index where the walk leaves that open.
  Index walk(const Vec3& p, Index start) const;
  Index search(const Vec3& p) const;

  std::vector<Vec3> points_;
  std::vector<Tetrahedron> tetrahedra_;
  std::vector<std::array<Index, 4>> neighbour_;  ///< opposite to each corner; no_index at the border
  std::vector<Plane> planes_;
  std::unique_ptr<arrangement::BoxTree> tree_;
};

}  // namespace geomesh::geomodel
