// SPDX-License-Identifier: MIT
/// @file
/// Decides whether an element spans a gap between parts of the input, and measures the width of the gap there.
#pragma once

#include <limits>
#include <optional>

#include "quality/soup_star.hpp"
#include "search/closest_point.hpp"

namespace geomesh {

struct Gap {
  double width = std::numeric_limits<double>::infinity();
  Index facet_a = no_index, facet_b = no_index;      ///< facets of the input on the two sides of the gap, if any
  Index segment_a = no_index, segment_b = no_index;  ///< listed segments on the two sides of the gap, if any
};

/// An element spans a gap between two parts of the input if it has a vertex on each part and the parts face each other
/// across the element. The width of the gap is the local feature size. Parts are facets, segments (sides of facets and
/// listed ones) and vertices of the input. Two parts face each other if
///   - the shortest path from the vertex on one part to the other part is within 60 degrees of the normals of facets,
///     on the side where the element lies, and at an angle of 60 degrees or more to segments;
///   - facets and segments are parallel up to 16 degrees. Parts that converge faster meet at an angle, which is a cause
///     of its own.
/// An element over the hollow of one curved surface spans no gap.
class GapFinder {
 public:
  /// Parts of the input at `angle` degrees or more to each other are not parallel. `fixed_vertices` is true if vertices
  /// of the input are parts, too, because no surface may move. O(n log n) in the faces of the mesh.
  GapFinder(const SoupStars& stars, double angle, bool fixed_vertices);

  /// Returns the narrowest gap wider than `above` that the element spans; its width is infinite if the element spans
  /// none. O(k^2 log n) for k faces at the element's vertices.
  Gap narrowest(Index tetrahedron, double above) const;

 private:
  /// A path across the element, from one of its vertices to the nearest point of an input item at another vertex.
  struct Way {
    VertexIndex from, to;
    Vec3 inside;  ///< centroid of the element, which shows on which side of a facet the element lies
  };
  void to_facets(const Way& way, double above, Gap& best) const;
  void to_segments(const Way& way, double above, Gap& best) const;
  void to_vertex(const Way& way, double above, Gap& best) const;
  bool leaves_facet(const Way& way, const Vec3& step, const Vec3& opposite_normal, Gap& found) const;
  bool leaves_segment(VertexIndex v, const Vec3& step, const Vec3* normal, const Vec3* parallel, Gap& found) const;
  VertexIndex end_of_segment(const Way& way, const SoupEdge& first) const;
  bool is_fixed(VertexIndex v) const;
  bool has_side(VertexIndex v, VertexIndex other) const;
  Vec3 normal_towards(Index face, const Vec3& inside) const;
  bool is_on(VertexIndex v, Index patch) const;

  const SoupStars& stars_;
  const ConstrainedTetrahedralization& mesh_;
  search::ClosestPointTrees patches_;
  double cosine_, sine_;  // of the angle
  bool fixed_vertices_;
};

}  // namespace geomesh
