// SPDX-License-Identifier: MIT
/// Stitching with protecting spheres (section 3.1; Ruppert 1995, section 5).
#include <algorithm>
#include <cmath>

#include "recover/conforming.hpp"

namespace geomesh::recover {

ConformingRecovery::ConformingRecovery(Recovery& recovery, const RecoverOptions& options)
    : recovery_(recovery), mesh_(recovery.mesh), constraints_(recovery.constraints), options_(options) {
  double largest = 0;
  for (VertexIndex v = 0; v < mesh_.n_input(); ++v)
    for (std::size_t i = 0; i < 3; ++i) largest = std::max(largest, std::fabs(mesh_.point(v)[i]));
  min_edge_ = std::ldexp(largest, -40);
  max_points_ = 30 * mesh_.n_input() + 3000;
  facet_queued_.assign(constraints_.subfacets.size(), 0);
  facet_is_given_up_.assign(constraints_.subfacets.size(), 0);
  points_on_facet_.assign(constraints_.subfacets.size(), 0);
  segment_is_given_up_.assign(constraints_.segments.size(), 0);
  points_on_segment_.assign(constraints_.segments.size(), 0);
  find_sharp_vertices();
}

bool ConformingRecovery::run() {
  for (Index s = 0; s < constraints_.subsegments.size(); ++s)
    if (mesh_.find_edge(constraints_.subsegments[s].a, constraints_.subsegments[s].b) == no_cell) missing_segments_.push_back(s);
  recover_queued_segments();
  recovery_.statistics.missing_facets_initial = count_missing_subfacets(recovery_);
  for (Index f = 0; f < constraints_.subfacets.size(); ++f)
    if (constraints_.subfacets[f].live && !facet_is_given_up_[f]) {
      facet_queued_[f] = 1;
      missing_facets_.push_back(f);
    }
  recover_queued_facets();
  for (const Index f : missing_facets_) give_up_facet(f);
  std::sort(given_up_.begin(), given_up_.end());
  given_up_.erase(std::unique(given_up_.begin(), given_up_.end()), given_up_.end());
  return recovery_.n_points_added < max_points_;
}

bool ConformingRecovery::too_short(const Vec3& a, const Vec3& b) const { return dot(b - a, b - a) < min_edge_ * min_edge_; }

void ConformingRecovery::find_sharp_vertices() {
  std::vector<std::vector<VertexIndex>> ends(mesh_.points().size());
  for (const ModelSegment& s : constraints_.segments) {
    ends[s.a].push_back(s.b);
    ends[s.b].push_back(s.a);
  }
  sharp_.assign(mesh_.points().size(), 0);
  for (VertexIndex v = 0; v < ends.size(); ++v)
    for (std::size_t i = 0; i < ends[v].size() && !sharp_[v]; ++i)
      for (std::size_t j = 0; j < i && !sharp_[v]; ++j) {
        const Vec3 a = mesh_.point(ends[v][i]) - mesh_.point(v), b = mesh_.point(ends[v][j]) - mesh_.point(v);
        const double c = dot(a, b);
        sharp_[v] = c > 0 && 4 * c * c > dot(a, a) * dot(b, b);
      }
}

VertexIndex ConformingRecovery::insert(const Vec3& p, VertexIndex near, VertexRecord record) {
  const DelaunayInsertion insertion = insert_delaunay(mesh_, p, mesh_.cell_of(near));
  if (insertion.vertex == no_vertex) return no_vertex;
  recovery_.count_added_point();
  constraints_.vertices.resize(mesh_.points().size());
  constraints_.vertices[insertion.vertex] = record;
  sharp_.resize(mesh_.points().size(), 0);
  for (const Tetrahedron& t : insertion.removed) {
    for (const auto& e : edge_vertices) {
      const Index s = constraints_.subsegment_of(t[e[0]], t[e[1]]);
      if (s != no_index && mesh_.find_edge(t[e[0]], t[e[1]]) == no_cell) missing_segments_.push_back(s);
    }
    for (const auto& l : face_vertices) {
      const Index f = facet_of_face_.find({t[l[0]], t[l[1]], t[l[2]]});
      if (f == no_index || facet_queued_[f] || mesh_.find_face(t[l[0]], t[l[1]], t[l[2]]).valid()) continue;
      facet_queued_[f] = 1;
      missing_facets_.push_back(f);
    }
  }
  return insertion.vertex;
}

void ConformingRecovery::recover_queued_segments() {
  while (!missing_segments_.empty() && recovery_.n_points_added < max_points_) {
    recovery_.context.check_cancelled();
    const Index s = missing_segments_.front();
    missing_segments_.pop_front();
    const Subsegment& sub = constraints_.subsegments[s];
    if (!sub.live || mesh_.find_edge(sub.a, sub.b) != no_cell) continue;
    if (sub.segment != no_index && segment_is_given_up_[sub.segment]) continue;
    split_segment(s);
  }
}

/// The middle; where segments meet sharply at one end, the nearest distance from that end that is a power of two, so that the points on
/// the segments about it come to lie on common spheres.
Vec3 ConformingRecovery::split_place(const Subsegment& s) const {
  const Vec3 a = mesh_.point(s.a), b = mesh_.point(s.b);
  const bool sharp_a = sharp_[s.a], sharp_b = sharp_[s.b];
  if (sharp_a == sharp_b) return {0.5 * a.x + 0.5 * b.x, 0.5 * a.y + 0.5 * b.y, 0.5 * a.z + 0.5 * b.z};
  const Vec3 from = sharp_a ? a : b, to = sharp_a ? b : a;
  const double length = std::sqrt(dot(to - from, to - from));
  double shell = std::ldexp(1.0, std::ilogb(length));
  while (shell > 2.0 / 3.0 * length) shell /= 2;
  return from + shell / length * (to - from);
}

void ConformingRecovery::split_segment(Index si) {
  const Subsegment s = constraints_.subsegments[si];
  const Vec3 p = split_place(s);
  const bool is_inner = s.segment == no_index;
  const bool over_budget = !is_inner && points_on_segment_[s.segment] >= options_.max_steiner_per_facet;
  if (over_budget || too_short(mesh_.point(s.a), p) || too_short(mesh_.point(s.b), p)) return give_up_segment(si);
  const VertexIndex x = insert(p, s.a, {is_inner ? VertexOrigin::on_facet : VertexOrigin::on_segment, is_inner ? s.facet : s.segment});
  if (x == no_vertex) return give_up_segment(si);
  if (!is_inner) ++points_on_segment_[s.segment];
  ++recovery_.statistics.edges_reinserted;
  for (const Index half : constraints_.split_subsegment(si, x)) missing_segments_.push_back(half);
  for (const Index f : s.subfacets) {
    if (facet_queued_[f]) continue;
    facet_queued_[f] = 1;
    missing_facets_.push_back(f);
  }
}

void ConformingRecovery::give_up_segment(Index si) {
  const Subsegment& s = constraints_.subsegments[si];
  if (s.segment != no_index) segment_is_given_up_[s.segment] = 1;
  for (const Index f : std::vector<Index>(s.subfacets)) give_up_facet(f);
}

}  // namespace geomesh::recover
