// SPDX-License-Identifier: MIT
/// @file
/// The surfaces or curves from which distances are taken and proven, whatever describes them: triangles
/// (triangle_surfaces.hpp), or a function.
#pragma once

#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "search/cover_proof.hpp"

namespace geomesh::search {

/// A triangle or line piece, the limit within which all of it must be, and what is found.
struct DistanceQuestion {
  Corners item;
  Index group;
  double limit;
  Cover answer;
};

/// Each group (a patch, or a class of curves) is a reference of its own. All functions may be called concurrently.
class ReferenceSurfaces {
 public:
  using Piece = ClosestPointTrees::Item;

  ReferenceSurfaces() = default;
  ReferenceSurfaces(const ReferenceSurfaces&) = default;
  ReferenceSurfaces& operator=(const ReferenceSurfaces&) = default;
  ReferenceSurfaces(ReferenceSurfaces&&) = default;
  ReferenceSurfaces& operator=(ReferenceSurfaces&&) = default;
  virtual ~ReferenceSurfaces() = default;

  /// Returns the point of the group nearest to p. `item` is the facet of the input from which a face there derives. The
  /// distance is infinite if there is no point within `limit`.
  virtual ClosestPoint closest(const Vec3& p, Index group,
                               double limit = std::numeric_limits<double>::infinity()) const = 0;
  /// Returns the unit normal at the point nearest to p, whose item is known.
  virtual Vec3 normal(Index item, const Vec3& p) const = 0;

  /// Returns whether all of the triangle is proven to be within the limit. This is for single changes of a mesh, so it
  /// may give up early. `over` receives the item at a point of the reference if that is known to be one smooth sheet
  /// over all of the triangle, and no_index otherwise.
  virtual bool within(const Corners& triangle, Index group, double limit, Index& over) const = 0;
  /// Answers all questions, with every effort.
  virtual void within(std::span<DistanceQuestion> questions) const = 0;

  /// Returns triangles or line pieces that together are the reference, up to `deviation_of_pieces`: a mesh that covers
  /// the pieces within a limit covers the reference within the sum of both.
  virtual const std::vector<Piece>& pieces() const = 0;
  virtual double deviation_of_pieces() const { return 0; }
  /// Calls visit for the pieces of a group near the box.
  virtual void visit_pieces(const Box3& box, Index group, const std::function<void(const Piece&)>& visit) const = 0;
  /// Returns whether the group has points in the box, and the cosine between their normals and the mean of these is
  /// nowhere below the bound.
  virtual bool is_even(const Box3& box, Index group, double least_cosine) const = 0;
};

}  // namespace geomesh::search
