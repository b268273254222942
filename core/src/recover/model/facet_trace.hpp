// SPDX-License-Identifier: MIT
/// @file
/// Determines how a subfacet with a complete border lies in the mesh: which mesh faces are part of it and which mesh
/// edges pierce it. Because no mesh edge crosses the subfacet's border, the part of the subfacet in a cell is the whole
/// section of that cell or nothing. After the first piercing edge, found in the ring of a border edge, the sides of the
/// vertices alone therefore decide: every edge of a pierced cell whose ends lie on different sides of the plane pierces
/// the subfacet.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "recover/model/constrained_mesh.hpp"
#include "recover/model/constraints.hpp"

namespace geomesh::recover {

struct PiercingEdge {
  VertexIndex below = no_vertex, above = no_vertex;
  /// A cell that had the edge when it was found. Later searches start there, because stars of needles are large.
  CellIndex cell = no_cell;
};

struct FacetTrace {
  enum class Status {
    complete,  ///< mesh faces cover the subfacet completely
    pierced,   ///< mesh edges pierce the subfacet, so it is not in the mesh
    touched,   ///< the vertex `culprit` lies in the subfacet, but the model does not say so
    unclear,   ///< the orientations around a mesh edge contradict each other, which only rounding by a few ulps causes
  };
  Status status = Status::complete;
  std::vector<Triangle> faces;         ///< mesh faces in the subfacet, in its orientation
  std::vector<CellIndex> cells;        ///< for each face in `faces`, a cell that has it
  std::vector<PiercingEdge> piercing;  ///< mesh edges that pierce the subfacet, each once, in the order of finding
  VertexIndex culprit = no_vertex;
};

/// Sides of vertices relative to the plane of a triangle. `members` are vertices that are declared to lie in the plane.
class FacetSides {
 public:
  FacetSides(const ConstrainedMesh& mesh, const Triangle& plane, std::vector<VertexIndex> members)
      : mesh_(mesh), plane_(plane), members_(std::move(members)) {
    std::sort(members_.begin(), members_.end());
    find_whether_exact();
  }
  void add_member(VertexIndex v) {
    members_.insert(std::lower_bound(members_.begin(), members_.end(), v), v);
    find_whether_exact();
  }
  /// Returns whether all of the facet's vertices are exactly in its plane, so that signs determine the left of an edge.
  bool is_exact() const { return is_exact_; }
  /// Returns whether v lies left of the line p->q in the plane of the facet, as seen from above; only if is_exact().
  bool is_left(VertexIndex p, VertexIndex q, VertexIndex v) const {
    const Vec3 n = normal();
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i)
      if (std::fabs(n[i]) > std::fabs(n[axis])) axis = i;
    const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
    return static_cast<int>(mesh_.orient_flat(p, q, v, i, j)) *
               static_cast<int>(mesh_.orient_flat(plane_[0], plane_[1], plane_[2], i, j)) >
           0;
  }
  int operator()(VertexIndex v) const {
    return is_member(v) ? 0 : static_cast<int>(mesh_.orient(plane_[0], plane_[1], plane_[2], v));
  }
  bool is_member(VertexIndex v) const { return std::binary_search(members_.begin(), members_.end(), v); }
  const Vec3& origin() const { return mesh_.point(plane_[0]); }
  /// Returns the normal of the facet's plane in doubles, which is not of unit length.
  Vec3 normal() const {
    const Vec3& o = mesh_.point(plane_[0]);
    return cross(mesh_.point(plane_[1]) - o, mesh_.point(plane_[2]) - o);
  }

 private:
  void find_whether_exact() {
    is_exact_ = mesh_.has_exact_places() &&
                std::all_of(members_.begin(), members_.end(), [&](VertexIndex v) { return is_in_plane(v); });
  }
  bool is_in_plane(VertexIndex v) const {
    return v == plane_[0] || v == plane_[1] || v == plane_[2] ||
           mesh_.orient(plane_[0], plane_[1], plane_[2], v) == Sign::zero;
  }

  const ConstrainedMesh& mesh_;
  Triangle plane_;
  std::vector<VertexIndex> members_;
  bool is_exact_ = false;
};

/// Finds mesh faces in a subfacet and mesh edges that pierce it. `border`: directed mesh edges with it on their left.
FacetTrace trace_facet(ConstrainedMesh& mesh, const FacetSides& sides, const std::vector<DirectedEdge>& border);

}  // namespace geomesh::recover
