// SPDX-License-Identifier: MIT
/// @file
/// The facets and segments of the input at each vertex of a mesh, as the user drew them, however they were meshed.
#pragma once

#include <span>
#include <vector>

#include "geomesh/core/tetrahedralize.hpp"
#include "quality/creases.hpp"

namespace geomesh {

/// A mesh edge on a segment of the input: the side of a facet (or of a patch, if facets were remeshed together, or a
/// sharp feature edge of it), or a listed one.
struct SoupEdge {
  VertexIndex other;
  Index segment;  ///< where listed
  Index face;     ///< a mesh face at it, or no_index if it runs through the interior of a region
  Index n_faces;  ///< number of constrained faces at it
};

/// Two parts of the input that meet at a vertex, by their facets or (where listed) segments.
struct MeetingAngle {
  double degrees = 180;
  Index facet_a = no_index, facet_b = no_index, segment_a = no_index, segment_b = no_index;
};

/// Returns an angle in degrees, from 0 to 180.
double angle_between(const Vec3& a, const Vec3& b);

class SoupStars {
 public:
  /// `facet_patch` is the patch with which each facet of the input was meshed; empty if each was meshed alone. O(n log
  /// n) in the faces of the mesh, which must outlive this object, as must the feature edges.
  SoupStars(const ConstrainedTetrahedralization& mesh, std::span<const Index> facet_patch,
            const InputCreases* creases = nullptr);

  /// Returns the least angle at which two facets or segments of the input meet at v: two sides; a side and a facet to
  /// which it does not belong; two facets along a common side. 180 if no two meet. O(k^2) in the faces at v.
  MeetingAngle least_angle(VertexIndex v) const;
  std::span<const Index> faces(VertexIndex v) const { return faces_at_[v]; }
  std::span<const SoupEdge> edges(VertexIndex v) const { return edges_at_[v]; }
  const ConstrainedTetrahedralization& mesh() const { return mesh_; }
  Index patch_of(Index face) const;
  Index facet_of(Index face) const { return face == no_index ? no_index : mesh_.faces[face].facet; }

 private:
  /// Connected faces of one patch at a vertex: one sector of a facet.
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
  /// Measures the dihedral angle at sides that two fans of triangles share. If a fan is compared with itself, these are
  /// feature edges around which its triangles are connected.
  void compare_fans(VertexIndex v, const Fan& a, const Fan& b, MeetingAngle& least) const;

  const ConstrainedTetrahedralization& mesh_;
  std::span<const Index> facet_patch_;
  const InputCreases* creases_;
  std::vector<std::vector<Index>> faces_at_;     // by vertex
  std::vector<std::vector<SoupEdge>> edges_at_;  // for each vertex, by ascending other end
};

}  // namespace geomesh
