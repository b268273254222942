// SPDX-License-Identifier: MIT
/// @file
/// Interface to the reference surfaces or curves to which distances are measured and proven. They may consist of
/// triangles (triangle_surfaces.hpp) or be described by a function.
#pragma once

#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "search/cover_proof.hpp"

namespace geomesh::search {

/// The question whether all of a triangle or line segment is within a distance of a reference surface, and the answer.
struct DistanceQuestion {
  Corners item;
  Index group;
  double limit;
  Cover answer;
};

/// Reference surfaces or curves, one for each group (a patch or a class of curves). All calls may be concurrent.
class ReferenceSurfaces {
 public:
  using Piece = ClosestPointTrees::Item;

  ReferenceSurfaces() = default;
  ReferenceSurfaces(const ReferenceSurfaces&) = default;
  ReferenceSurfaces& operator=(const ReferenceSurfaces&) = default;
  ReferenceSurfaces(ReferenceSurfaces&&) = default;
  ReferenceSurfaces& operator=(ReferenceSurfaces&&) = default;
  virtual ~ReferenceSurfaces() = default;

  /// Returns the point of the group nearest to p. `item` of the result is the facet of the input from which a mesh face
  /// at that point derives. The distance is infinite if there is no point within `limit`.
  virtual ClosestPoint closest(const Vec3& p, Index group,
                               double limit = std::numeric_limits<double>::infinity()) const = 0;
  /// Returns the unit normal of the reference surface at its point nearest to p; `item` is the input facet there.
  virtual Vec3 normal(Index item, const Vec3& p) const = 0;

  /// Returns whether all of a triangle is proven to be within distance `limit` of the group. It is used for single
  /// changes of a mesh and may give up early. If the group is known to be one smooth surface over all of the triangle,
  /// `over` receives the item of one of the surface's points, otherwise no_index.
  virtual bool within(const Corners& triangle, Index group, double limit, Index& over) const = 0;
  /// Decides for each given triangle or line segment, without giving up early, whether it is within a limit of a group.
  virtual void within(std::span<DistanceQuestion> questions) const = 0;

  /// Returns triangles or line segments that approximate the reference up to deviation_of_pieces(). A mesh that covers
  /// the pieces within a limit covers the reference within the sum of the limit and the deviation.
  virtual const std::vector<Piece>& pieces() const = 0;
  virtual double deviation_of_pieces() const { return 0; }
  /// Calls visit(piece) for the triangles or line segments of a group in the box, and for some near it.
  virtual void visit_pieces(const Box3& box, Index group, const std::function<void(const Piece&)>& visit) const = 0;
  /// Returns whether the group has points in the box and the cosine of the angle between each of their normals and the
  /// mean normal is at least `least_cosine`.
  virtual bool is_even(const Box3& box, Index group, double least_cosine) const = 0;
};

}  // namespace geomesh::search
