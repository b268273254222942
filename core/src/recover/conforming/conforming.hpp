// SPDX-License-Identifier: MIT
/// @file
/// Conforming mode (Cavalcanti and Mello 1999, sections 3.1 and 3.2): points are inserted on segments and facets until
/// these are unions of Delaunay edges and faces. Points are rounded to doubles before they are inserted.
///
/// Budgets, beyond which a facet or all facets at a segment are given up and later recovered by the constrained
/// methods:
///   - `max_steiner_per_facet` points on one segment, or on one facet that meets another at less than 90 degrees or has
///     segments that meet at less than 60 degrees. Refinement of other facets always ends (section 3.2; Ruppert 1995),
///     so none of them is given up;
///   - 30 points for each vertex of the model, and 3,000 more, on all such facets and segments together; as many, and
///     100,000 more, on the others;
///   - no new edge on a segment or in a facet shorter than `min_edge`: 2^-40 of the largest coordinate (4096 ulps).
#pragma once

#include <array>
#include <deque>
#include <queue>

#include "recover/conforming/delaunay_insertion.hpp"
#include "recover/model/recover.hpp"

namespace geomesh::recover {

/// Reasons for which conforming mode gives a facet up.
enum class GivenUpFor : std::uint8_t {
  points,     ///< more than max_steiner_per_facet points on the facet or on one of its segments
  shortness,  ///< an edge of the mesh would be shorter than 2^-40 of the largest coordinate
  place,      ///< a new point equals a vertex, or rounding has made the facet's own 2D triangulation invalid
  budget,     ///< no more points are allowed on all facets and segments together
};
inline constexpr std::size_t n_reasons_given_up = 4;

class ConformingRecovery {
 public:
  ConformingRecovery(Recovery& recovery, const RecoverOptions& options);

  /// Recovers segments, then facets, and again those that were lost meanwhile, until nothing is missing or everything
  /// missing has been given up. Returns false if more points than the budget allows were needed in all; items that are
  /// still missing have then been given up, too.
  bool run();
  /// Returns the facets, sorted, that conforming mode left to the constrained methods.
  const std::vector<Index>& facets_given_up() const { return given_up_; }

 protected:
  // conforming_segments.cpp
  void mark_sharp_vertices();
  void mark_sharp_facets();
  bool is_sharp_segment(const Subsegment& s) const;
  Vec3 inwards(const Subsegment& s, Index f) const;
  void queue_segment(Index s);
  void recover_queued_segments();
  void split_segment(Index s);
  /// Returns the vertex at which a missing subsegment subtends the largest angle, among those of the cells that it
  /// crosses. Returns no_vertex if that angle is not obtuse.
  VertexIndex encroaching_vertex(const Subsegment& s);
  /// Returns whether v lies on a model segment that has `end` as an end.
  bool is_on_segment_from(VertexIndex v, VertexIndex end) const;
  double place_on_common_sphere(const Subsegment& s, VertexIndex v) const;
  Vec3 split_place(const Subsegment& s);
  Vec3 point_on_segment(const Subsegment& s, const Vec3& p) const;
  void give_up_segment(Index s, GivenUpFor why);

  // conforming_facets.cpp
  void recover_queued_facets();
  bool register_if_present(Index f);
  void insert_into_facet(Index f);
  bool insert_midpoint(Index f, VertexIndex a, VertexIndex b);
  void give_up_facet(Index f, GivenUpFor why);
  /// Reports how many facets were given up, for which reasons, and their sharpest angle.
  void note_given_up() const;
  void queue_facet(Index f);

  /// Inserts a point and queues the segments and facets that the insertion removes from the mesh. Returns no_vertex if
  /// nothing could be inserted.
  VertexIndex insert(const Vec3& p, VertexIndex near, VertexRecord record);
  bool is_edge_of_new_star(VertexIndex a, VertexIndex b) const;
  bool is_within_budget() const {
    return !recovery_.has_ended() && n_sharp_points_ < max_sharp_points_ && n_other_points_ < max_other_points_;
  }
  /// Sets the counts of added points, which are limited over all facets and segments together, to zero.
  void renew_budget() { n_sharp_points_ = n_other_points_ = 0; }
  bool too_short(const Vec3& a, const Vec3& b) const;

  Recovery& recovery_;
  ConstrainedMesh& mesh_;
  Constraints& constraints_;
  RecoverOptions options_;
  /// Order of missing segments. Short ones come first, because they need the fewest points, and these points may
  /// encroach on longer segments, which are split afterwards.
  struct QueuedSegment {
    double squared_length;
    Index segment;
    bool operator<(const QueuedSegment& other) const {
      return squared_length != other.squared_length ? squared_length > other.squared_length : segment > other.segment;
    }
  };

  DelaunayInsertion insertion_;
  double min_edge_ = 0;
  std::size_t n_sharp_points_ = 0, n_other_points_ = 0, max_sharp_points_ = 0, max_other_points_ = 0;
  EdgeMap segment_of_ends_;  ///< model segments
  std::priority_queue<QueuedSegment> missing_segments_;
  std::deque<Index> missing_facets_;
  FaceMap facet_of_face_;                        ///< the facet of each mesh face that is known to be a part of one
  std::vector<std::uint8_t> facet_queued_;       ///< per subfacet
  std::vector<std::uint8_t> facet_is_given_up_;  ///< per subfacet
  /// for each vertex of the model, whether segments meet there at less than 60 degrees
  std::vector<std::uint8_t> vertex_is_sharp_;
  std::vector<std::uint8_t> facet_is_sharp_;       ///< for each subfacet, whether its number of added points is limited
  std::vector<std::uint8_t> segment_is_given_up_;  ///< per model segment
  std::vector<std::uint32_t> points_on_facet_, points_on_segment_;
  std::vector<Index> given_up_;
  std::array<std::size_t, n_reasons_given_up> n_given_up_for_{};
};

}  // namespace geomesh::recover
