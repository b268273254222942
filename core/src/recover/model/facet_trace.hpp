// SPDX-License-Identifier: MIT
/// @file
/// How a subfacet, whose border edges are present, lies in the mesh: which mesh faces are part of it and which mesh
/// edges pierce it.
///
/// As no mesh edge crosses the subfacet's border, the part of the subfacet in a cell is the whole section of that cell
/// or nothing. So after the first piercing edge, found in the ring of a border edge, the sides of the vertices alone
/// decide: every edge of a pierced cell whose ends lie on different sides pierces the subfacet too.
#pragma once

#include <algorithm>
#include <vector>

#include "recover/model/constrained_mesh.hpp"
#include "recover/model/constraints.hpp"

namespace geomesh::recover {

struct PiercingEdge {
  VertexIndex below = no_vertex, above = no_vertex;
  friend auto operator<=>(const PiercingEdge&, const PiercingEdge&) = default;
};

struct FacetTrace {
  enum class Status {
    complete,  ///< the faces cover the subfacet
    pierced,   ///< edges pierce it
    touched,   ///< `culprit` lies in it and is not declared part of it
    unclear,   ///< the signs about an edge contradict each other, which only rounding to a few ulps can do
  };
  Status status = Status::complete;
  std::vector<Triangle> faces;         ///< in the orientation of the subfacet
  std::vector<CellIndex> cells;        ///< for each of these a cell that has it
  std::vector<PiercingEdge> piercing;  ///< in the order found, each once
  VertexIndex culprit = no_vertex;
};

/// Sides of vertices relative to the plane of a triangle; `members` (declared to lie on it) are on it.
class FacetSides {
 public:
  FacetSides(const ConstrainedMesh& mesh, const Triangle& plane, std::vector<VertexIndex> members)
      : mesh_(mesh), plane_(plane), members_(std::move(members)) {
    std::sort(members_.begin(), members_.end());
  }
  void add_member(VertexIndex v) { members_.insert(std::lower_bound(members_.begin(), members_.end(), v), v); }
  int operator()(VertexIndex v) const {
    return is_member(v) ? 0 : static_cast<int>(mesh_.orient(plane_[0], plane_[1], plane_[2], v));
  }
  bool is_member(VertexIndex v) const { return std::binary_search(members_.begin(), members_.end(), v); }
  const Vec3& origin() const { return mesh_.point(plane_[0]); }
  /// Rounded; not of unit length.
  Vec3 normal() const {
    const Vec3& o = mesh_.point(plane_[0]);
    return cross(mesh_.point(plane_[1]) - o, mesh_.point(plane_[2]) - o);
  }

 private:
  const ConstrainedMesh& mesh_;
  Triangle plane_;
  std::vector<VertexIndex> members_;
};

/// `border`: directed edges of the mesh with the subfacet on their left.
FacetTrace trace_facet(ConstrainedMesh& mesh, const FacetSides& sides, const std::vector<DirectedEdge>& border);

}  // namespace geomesh::recover
