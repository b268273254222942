// SPDX-License-Identifier: MIT
/// @file
/// Finds the facets and segments of the input at each vertex of a mesh, regardless of how they were meshed.
#pragma once

#include <span>
#include <vector>

#include "geomesh/core/tetrahedralize.hpp"
#include "quality/creases.hpp"

namespace geomesh {

/// A mesh edge on a segment of the input: on the side of a facet or on a listed segment. If facets were remeshed
/// together as a patch, on the side of the patch or on a sharp feature edge of it.
struct SoupEdge {
  VertexIndex other;
  Index segment;  ///< the segment listed in the input on which the edge lies, if any
  Index face;     ///< a mesh face on a facet at the edge, or no_index if the edge is inside a region
  Index n_faces;  ///< number of constrained faces at the edge
};

/// The angle between two parts of the input that meet at a vertex, and the facet or listed segment of each part.
struct MeetingAngle {
  double degrees = 180;
  Index facet_a = no_index, facet_b = no_index, segment_a = no_index, segment_b = no_index;
};

/// Returns the angle between two vectors in degrees, from 0 to 180.
double angle_between(const Vec3& a, const Vec3& b);

class SoupStars {
 public:
  /// `facet_patch` is the patch with which each facet of the input was meshed; empty if each facet was meshed alone.
  /// The mesh and `creases` must outlive this object. O(n log n) in the faces of the mesh.
  SoupStars(const ConstrainedTetrahedralization& mesh, std::span<const Index> facet_patch,
            const InputCreases* creases = nullptr);

  /// Returns the least angle at which two parts of the input meet at v: two sides of facets or listed segments, a side
  /// and a facet to which it does not belong, or two facets along a common side. Returns 180 if no two parts meet.
  /// O(k^2) in the faces at v.
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
  /// Measures the dihedral angle at each edge at v that borders two fans (triangles of one patch around v). If both are
  /// the same fan, these are feature edges within it.
  void compare_fans(VertexIndex v, const Fan& a, const Fan& b, MeetingAngle& least) const;

  const ConstrainedTetrahedralization& mesh_;
  std::span<const Index> facet_patch_;
  const InputCreases* creases_;
  std::vector<std::vector<Index>> faces_at_;     // mesh faces on facets, by vertex
  std::vector<std::vector<SoupEdge>> edges_at_;  // edges on facets and segments, by vertex, sorted by their other end
};

}  // namespace geomesh
