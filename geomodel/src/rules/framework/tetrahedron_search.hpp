// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds the tetrahedron of a mesh that contains a point.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "arrangement/search/bvh.hpp"
#include "geomesh/core/plc.hpp"

namespace geomesh::geomodel {

/// Walks from tetrahedron to tetrahedron towards a point. If the walk fails, because the point is on a face or the walk
/// ends at the border of the mesh, a tree of bounding boxes is searched. Points beyond a plane that has the whole mesh
/// on one side, such as a side of a box, need no search. All decisions on which tetrahedron contains a point are exact.
class TetrahedronSearch {
 public:
  /// The tetrahedra must be positively oriented and must not overlap.
  TetrahedronSearch(std::vector<Vec3> points, std::vector<Tetrahedron> tetrahedra);

  /// Returns the tetrahedron that contains p, the first of several; no_index if none does. The walk begins at `start`,
  /// preferably near p, or anywhere for no_index. O(1) steps for consecutive nearby points, O(n^(1/3)) for others, O(n)
  /// if the boxes of tetrahedra overlap and the walk ends early.
  Index find(const Vec3& p, Index start) const;
  std::array<Vec3, 4> corners(Index t) const;
  /// Returns the tree of the tetrahedra's bounding boxes, which finds those near a point.
  const arrangement::BoxTree& boxes() const { return *tree_; }

 private:
  struct Plane {
    Vec3 outward;
    double offset;  ///< largest dot product of `outward` with a point of the mesh, plus a bound on rounding
  };
  void find_neighbours();
  void find_planes(const std::vector<std::array<Index, 2>>& border);
  bool is_beyond_planes(const Vec3& p) const;
  /// Returns the only tetrahedron that contains p; no_index if the walk does not find it.
  Index walk(const Vec3& p, Index start) const;
  Index search(const Vec3& p) const;

  std::vector<Vec3> points_;
  std::vector<Tetrahedron> tetrahedra_;
  std::vector<std::array<Index, 4>> neighbour_;  ///< each tetrahedron's neighbour opposite each corner, or no_index
  std::vector<Plane> planes_;
  std::unique_ptr<arrangement::BoxTree> tree_;
};

}  // namespace geomesh::geomodel
