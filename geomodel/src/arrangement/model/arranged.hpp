// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// One exact round of the arrangement: from contacts to facets over exact vertices that meet only in shared vertices
/// and edges.
#pragma once

#include <vector>

#include "arrangement/model/complex.hpp"
#include "arrangement/model/contacts.hpp"
#include "arrangement/model/exact_point.hpp"

namespace geomesh::geomodel::arrangement {

/// Vertices of an arrangement round: those below n_given are points of the complex, the others were constructed.
class ExactVertices {
 public:
  ExactVertices(const std::vector<Vec3>& given, ExactFrame frame) : given_(given), frame_(frame) {}
  std::size_t n_given() const { return given_.size(); }
  std::size_t size() const { return given_.size() + made_.size(); }
  bool is_made(Index v) const { return v >= given_.size(); }
  const Vec3& rounded(Index v) const { return is_made(v) ? made_rounded_[v - given_.size()] : given_[v]; }
  const ExactPoint* made(Index v) const { return is_made(v) ? &made_[v - given_.size()] : nullptr; }
  ExactPoint exact(Index v) const { return is_made(v) ? made_[v - given_.size()] : frame_.to_exact(given_[v]); }
  const ExactFrame& frame() const { return frame_; }
  void append(std::vector<ExactPoint>&& points, std::vector<Vec3>&& rounded);

 private:
  const std::vector<Vec3>& given_;
  ExactFrame frame_;
  std::vector<ExactPoint> made_;
  std::vector<Vec3> made_rounded_;
};

/// Result of an arrangement round. Vertices at equal places have one index in `facets` and `segments`; some are unused.
struct Arranged {
  ExactVertices vertices;
  std::vector<Triangle> facets;
  OriginLists origins;
  /// For each facet, whether the round made it, so that it is no facet of the input complex.
  std::vector<std::uint8_t> changed;
  std::vector<PolygonSoup::Segment> segments;
  std::vector<PolygonSoup::IsolatedPoint> isolated_points;
  /// For each facet contact (a point or a segment): the vertices of its ends; the second is no_index for a point.
  std::vector<std::array<Index, 2>> contact_ends;
};

/// Cuts the facets of a complex along their contacts, so that they meet only in shared vertices and edges. Throws
/// Error{cannot_mesh} if that would need more than `max_bytes` of memory.
Arranged arrange_round(const Complex& complex, const Contacts& contacts, const RunContext& context,
                       std::size_t max_bytes = no_memory_bound);

/// Coplanar facets that overlap, split into pieces together with all contacts on them.
struct ClusterPieces {
  static constexpr Index made_here = 0x80000000u;  ///< bit that is set in facet corners that are indices in `made`
  std::vector<Triangle> facets;
  OriginLists origins;
  std::vector<ExactPoint> made;
  std::vector<Vec3> made_rounded;
};
struct ClusterInput {
  std::vector<Index> members;  ///< facets, ascending
  std::vector<Index> points;   ///< vertices on the cluster's facets other than the facets' corners
  struct Constraint {
    Index a, b;
    Line line;
    friend auto operator<=>(const Constraint&, const Constraint&) = default;
  };
  std::vector<Constraint> constraints;
};
ClusterPieces triangulate_cluster(const Complex& complex, const ExactVertices& vertices, ClusterInput input);

}  // namespace geomesh::geomodel::arrangement
