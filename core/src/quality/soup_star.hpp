// SPDX-License-Identifier: MIT
/// @file
/// What of the input there is at each vertex of a mesh: the facets and segments that a user drew, not how they were
/// meshed.
#pragma once

#include <span>
#include <vector>

#include "geomesh/core/tetrahedralize.hpp"
#include "quality/creases.hpp"

namespace geomesh {

/// A mesh edge on a segment of the input: the side of a facet (or of a patch, where facets were remeshed together, or a
/// sharp crease of it), or a listed one.
struct SoupEdge {
  VertexIndex other;
  Index segment;  ///< where listed
  Index face;     ///< a mesh face at it, or no_index: it runs through the inside of a region
  Index n_faces;  ///< constrained faces at it
};

/// Two parts of the input that meet at a vertex, by their facets or (where listed) segments.
struct MeetingAngle {
  double degrees = 180;
  Index facet_a = no_index, facet_b = no_index, segment_a = no_index, segment_b = no_index;
};

/// Degrees, 0 to 180.
double angle_between(const Vec3& a, const Vec3& b);

class SoupStars {
 public:
  /// `facet_patch`: per facet of the input what it was meshed as one with; empty: each for itself. O(n log n) in the
  /// faces of the mesh, which must outlive this, as must the creases.
  SoupStars(const ConstrainedTetrahedralization& mesh, std::span<const Index> facet_patch,
            const InputCreases* creases = nullptr);

  /// The least angle at which two facets or segments of the input meet at v: two sides; a side and a facet that it is
  /// no side of; two facets along a common side. 180 where no two meet. O(k^2) in the faces at v.
  MeetingAngle least_angle(VertexIndex v) const;
  std::span<const Index> faces(VertexIndex v) const { return faces_at_[v]; }
  std::span<const SoupEdge> edges(VertexIndex v) const { return edges_at_[v]; }
  const ConstrainedTetrahedralization& mesh() const { return mesh_; }
  Index patch_of(Index face) const;
  Index facet_of(Index face) const { return face == no_index ? no_index : mesh_.faces[face].facet; }

 private:
  /// Faces of one patch at a vertex that hang together there: one sector of a facet.
  struct Fan {
    Index patch;
    std::vector<Index> faces;
  };
  void collect_edges();
  bool is_crease(Index face, Index other, VertexIndex a, VertexIndex b) const;
  std::vector<Fan> fans(VertexIndex v) const;
  bool is_side(VertexIndex v, VertexIndex other) const;
  std::array<VertexIndex, 2> sides(VertexIndex v, Index face) const;
  Vec3 direction(VertexIndex v, VertexIndex to) const { return mesh_.points[to] - mesh_.points[v]; }
  void compare_edges(VertexIndex v, MeetingAngle& least) const;
  void compare_edge_with_fan(VertexIndex v, const SoupEdge& edge, const Fan& fan, MeetingAngle& least) const;
  /// Along sides that they have in common; with itself where a fan hangs together around a crease.
  void compare_fans(VertexIndex v, const Fan& a, const Fan& b, MeetingAngle& least) const;

  const ConstrainedTetrahedralization& mesh_;
  std::span<const Index> facet_patch_;
  const InputCreases* creases_;
  std::vector<std::vector<Index>> faces_at_;     // by vertex
  std::vector<std::vector<SoupEdge>> edges_at_;  // by vertex, by rising other end
};

}  // namespace geomesh
