// SPDX-License-Identifier: MIT
/// Recovers segments by stitching with protecting spheres (Cavalcanti and Mello 1999, section 3.1; Ruppert 1995,
/// section 5; Si and Gaertner 2005, "Meshing piecewise linear complexes by constrained Delaunay tetrahedralizations",
/// for the choice of the sphere).
#include <algorithm>
#include <cmath>

#include "common/geometry.hpp"
#include "common/sort_unique.hpp"
#include "predicates/two_double.hpp"
#include "recover/conforming/conforming.hpp"
#include "recover/model/crossing.hpp"
#include "recover/model/presence.hpp"
#include "recover/model/recovery_budget.hpp"

namespace geomesh::recover {

namespace {

/// Returns whether the angle between a and b is smaller than that with this cosine, by more than a rounding error.
bool is_sharp(const Vec3& a, const Vec3& b, double cosine) {
  return dot(a, b) > (cosine + recovery_budget.sharp_rounding) * std::sqrt(dot(a, a) * dot(b, b));
}

}  // namespace

ConformingRecovery::ConformingRecovery(Recovery& recovery, const RecoverOptions& options)
    : recovery_(recovery), mesh_(recovery.mesh), constraints_(recovery.constraints), options_(options) {
  double largest = 0;
  for (VertexIndex v = 0; v < mesh_.n_input(); ++v)
    for (std::size_t i = 0; i < 3; ++i) largest = std::max(largest, std::fabs(mesh_.point(v)[i]));
  min_edge_ = std::ldexp(largest, recovery_budget.least_edge);
  max_sharp_points_ = recovery_budget.points_per_vertex * mesh_.n_input() + recovery_budget.sharp_points;
  max_other_points_ = recovery_budget.points_per_vertex * mesh_.n_input() + recovery_budget.other_points;
  recovery_.expected_points_per_vertex = recovery_budget.doubtful_points_per_vertex_conforming;
  mark_sharp_vertices();
  mark_sharp_facets();
  facet_queued_.assign(constraints_.subfacets.size(), 0);
  facet_is_given_up_.assign(constraints_.subfacets.size(), 0);
  points_on_facet_.assign(constraints_.subfacets.size(), 0);
  segment_is_given_up_.assign(constraints_.segments.size(), 0);
  points_on_segment_.assign(constraints_.segments.size(), 0);
  for (Index s = 0; s < constraints_.segments.size(); ++s)
    segment_of_ends_.insert({constraints_.segments[s].a, constraints_.segments[s].b}, s);
}

bool ConformingRecovery::run() {
  for (Index s = 0; s < constraints_.subsegments.size(); ++s)
    if (cell_of_subsegment(mesh_, constraints_, s) == no_cell) queue_segment(s);
  recover_queued_segments();
  recovery_.statistics.missing_facets_initial = count_missing_subfacets(recovery_).n;
  for (Index f = 0; f < constraints_.subfacets.size(); ++f)
    if (constraints_.subfacets[f].live && !facet_is_given_up_[f]) queue_facet(f);
  recover_queued_facets();
  for (const Index f : missing_facets_) give_up_facet(f, GivenUpFor::budget);
  sort_unique(given_up_);
  note_given_up();
  return is_within_budget();
}

bool ConformingRecovery::too_short(const Vec3& a, const Vec3& b) const {
  return dot(b - a, b - a) < min_edge_ * min_edge_;
}

void ConformingRecovery::mark_sharp_vertices() {
  std::vector<std::vector<VertexIndex>> joined(mesh_.points().size());
  for (const ModelSegment& s : constraints_.segments) {
    joined[s.a].push_back(s.b);
    joined[s.b].push_back(s.a);
  }
  vertex_is_sharp_.assign(joined.size(), 0);
  for (VertexIndex v = 0; v < joined.size(); ++v)
    for (std::size_t i = 0; i < joined[v].size() && !vertex_is_sharp_[v]; ++i)
      for (std::size_t j = 0; j < i && !vertex_is_sharp_[v]; ++j)
        vertex_is_sharp_[v] = is_sharp(mesh_.point(joined[v][i]) - mesh_.point(v),
                                       mesh_.point(joined[v][j]) - mesh_.point(v), recovery_budget.sharp_cosine);
}

/// Marks facets that meet another facet at less than 90 degrees, or have a vertex at which segments meet sharply.
void ConformingRecovery::mark_sharp_facets() {
  facet_is_sharp_.assign(constraints_.subfacets.size(), 0);
  std::vector<Vec3> inner;  // vectors into the facets at a subsegment, perpendicular to it
  for (const Subsegment& s : constraints_.subsegments) {
    inner.clear();
    for (const Index f : s.subfacets) inner.push_back(inwards(s, f));
    for (std::size_t i = 0; i < inner.size(); ++i) {
      std::uint8_t& is_marked = facet_is_sharp_[s.subfacets[i]];
      if (vertex_is_sharp_[s.a] || vertex_is_sharp_[s.b]) is_marked = 1;
      for (std::size_t j = 0; j < inner.size() && !is_marked; ++j)
        is_marked = j != i && is_sharp(inner[i], inner[j], 0);
    }
  }
}

bool ConformingRecovery::is_sharp_segment(const Subsegment& s) const {
  const ModelSegment* const model = s.segment == no_index ? nullptr : &constraints_.segments[s.segment];
  return (model && (vertex_is_sharp_[model->a] || vertex_is_sharp_[model->b])) ||
         std::any_of(s.subfacets.begin(), s.subfacets.end(), [&](Index f) { return facet_is_sharp_[f] != 0; });
}

/// Returns the direction into the facet, perpendicular to a border edge; zero if the facet lies on both sides of it.
Vec3 ConformingRecovery::inwards(const Subsegment& s, Index f) const {
  const Triangle& t = constraints_.subfacets[f].vertices;
  const Vec3& o = mesh_.point(t[0]);
  const Vec3 normal = cross(mesh_.point(t[1]) - o, mesh_.point(t[2]) - o);
  const std::array<DirectedEdge, 3> sides{{{t[0], t[1]}, {t[1], t[2]}, {t[2], t[0]}}};
  Vec3 along;
  for (const DirectedEdge& e : constraints_.is_piece(f) ? std::span<const DirectedEdge>(constraints_.piece_of(f).border)
                                                        : std::span<const DirectedEdge>(sides))
    if ((e[0] == s.a && e[1] == s.b) || (e[0] == s.b && e[1] == s.a))
      along = along + (mesh_.point(e[1]) - mesh_.point(e[0]));
  return cross(normal, along);
}

void ConformingRecovery::queue_segment(Index s) {
  const Vec3 d = mesh_.point(constraints_.subsegments[s].b) - mesh_.point(constraints_.subsegments[s].a);
  missing_segments_.push({dot(d, d), s});
}

VertexIndex ConformingRecovery::insert(const Vec3& p, VertexIndex near, VertexRecord record) {
  insert_delaunay(mesh_, p, mesh_.cell_of(near), insertion_);
  if (insertion_.vertex == no_vertex) return no_vertex;
  recovery_.count_added_point();
  constraints_.vertices.resize(mesh_.points().size());
  constraints_.vertices[insertion_.vertex] = record;
  for (const auto& [a, b] : insertion_.edges) {
    const Index s = constraints_.subsegment_of(a, b);
    if (s != no_index && !is_edge_of_new_star(a, b)) queue_segment(s);
  }
  for (const Triangle& t : insertion_.faces) {
    const Index f = facet_of_face_.find({t[0], t[1], t[2]});
    if (f != no_index) queue_facet(f);
  }
  return insertion_.vertex;
}

/// Returns whether a-b is an edge of a cell that the last insertion made. These cells suffice, because an edge of a
/// removed cell remains only if a new cell has it, and all edges at the new vertex belong to new cells.
bool ConformingRecovery::is_edge_of_new_star(VertexIndex a, VertexIndex b) const {
  return std::any_of(mesh_.last_created().begin(), mesh_.last_created().end(),
                     [&](CellIndex c) { return mesh_.cells().has_vertex(c, a) && mesh_.cells().has_vertex(c, b); });
}

void ConformingRecovery::queue_facet(Index f) {
  if (facet_queued_[f]) return;
  facet_queued_[f] = 1;
  missing_facets_.push_back(f);
}

void ConformingRecovery::recover_queued_segments() {
  while (!missing_segments_.empty() && is_within_budget()) {
    recovery_.context.check_cancelled();
    const Index s = missing_segments_.top().segment;
    missing_segments_.pop();
    const Subsegment& sub = constraints_.subsegments[s];
    if (!sub.live || cell_of_subsegment(mesh_, constraints_, s) != no_cell) continue;
    if (sub.segment != no_index && segment_is_given_up_[sub.segment]) continue;
    split_segment(s);
  }
}

VertexIndex ConformingRecovery::encroaching_vertex(const Subsegment& s) {
  LineCrossings line;
  walk_line(mesh_, s.a, s.b, line);
  VertexIndex best = no_vertex;
  double smallest = 0;  // limit on the cosine: vertices outside the diametral sphere of the subsegment are ignored
  for (const CellIndex c : line.cells)
    for (const VertexIndex v : mesh_.cells().vertices(c)) {
      if (v == s.a || v == s.b || v == infinite_vertex || mesh_.is_box_vertex(v)) continue;
      const Vec3 to_a = mesh_.point(s.a) - mesh_.point(v), to_b = mesh_.point(s.b) - mesh_.point(v);
      const double cosine = dot(to_a, to_b) / std::sqrt(dot(to_a, to_a) * dot(to_b, to_b));
      if (cosine > smallest ||
          (cosine == smallest && (best == no_vertex || compare_lexicographic(mesh_.point(v), mesh_.point(best)) > 0)))
        continue;
      smallest = cosine;
      best = v;
    }
  return best;
}

bool ConformingRecovery::is_on_segment_from(VertexIndex v, VertexIndex end) const {
  const VertexRecord& r = constraints_.vertices[v];
  if (r.origin == VertexOrigin::on_segment)
    return constraints_.segments[r.owner].a == end || constraints_.segments[r.owner].b == end;
  return r.origin == VertexOrigin::input && segment_of_ends_.find({v, end}) != no_index;
}

/// If the model segment of s meets a segment of the encroaching vertex v sharply at a common end, returns the point of
/// s on the sphere around that end through v, as a distance from s.a. Points on segments that meet sharply then lie on
/// common spheres. Returns a negative value if there is no such sphere or it does not intersect s.
double ConformingRecovery::place_on_common_sphere(const Subsegment& s, VertexIndex v) const {
  if (s.segment == no_index) return -1;
  const Vec3 &a = mesh_.point(s.a), &b = mesh_.point(s.b), &p = mesh_.point(v);
  const ModelSegment& model = constraints_.segments[s.segment];
  const bool a_is_nearer_to_model_a = distance(mesh_.point(model.a), a) <= distance(mesh_.point(model.a), b);
  const double length = distance(a, b);
  double place = -1, largest = recovery_budget.sharp_cosine;
  for (const VertexIndex end : {model.a, model.b}) {
    if (!is_on_segment_from(v, end)) continue;
    const Vec3& e = mesh_.point(end);
    const double radius = distance(p, e), cosine = std::fabs(dot(p - e, b - a)) / (radius * length);
    if (cosine < largest) continue;
    largest = cosine;
    place = (end == model.a) == a_is_nearer_to_model_a ? radius - distance(a, e) : length - (radius - distance(b, e));
  }
  return place < length ? place : -1;
}

/// Returns the place at which to split s: a point on a common sphere if there is one. Otherwise it is the projection of
/// the encroaching vertex, so that points do not cause more distant ones than necessary. If the projection is closer to
/// an end than half of the vertex's distance from it, the place is as far from it as the vertex (Si and Gaertner 2005).
Vec3 ConformingRecovery::split_place(const Subsegment& s) {
  const Vec3 a = mesh_.point(s.a), b = mesh_.point(s.b);
  const VertexIndex v = encroaching_vertex(s);
  if (v == no_vertex) return point_on_segment(s, 0.5 * a + 0.5 * b);
  const double length = distance(a, b);
  double place = place_on_common_sphere(s, v);
  if (place < 0) {
    const Vec3& p = mesh_.point(v);
    const double from_a = distance(a, p), from_b = distance(b, p);
    place = dot(p - a, b - a) / length;
    if (2 * place < from_a && 2 * from_a < length) place = from_a;
    if (2 * (length - place) < from_b && 2 * from_b < length) place = length - from_b;
  }
  return point_on_segment(s, a + place / length * (b - a));
}

/// Returns the point of the model's segment nearest to p, so that rounding errors do not accumulate over splits.
Vec3 ConformingRecovery::point_on_segment(const Subsegment& s, const Vec3& p) const {
  if (s.segment == no_index) return p;
  using exact::TwoDouble;
  const Vec3 &a = mesh_.point(constraints_.segments[s.segment].a), &b = mesh_.point(constraints_.segments[s.segment].b);
  TwoDouble along, squared_length;
  for (std::size_t i = 0; i < 3; ++i) {
    const TwoDouble d = TwoDouble::difference(b[i], a[i]);
    along = along + TwoDouble::difference(p[i], a[i]) * d;
    squared_length = squared_length + d * d;
  }
  const TwoDouble part = along / squared_length;
  Vec3 out;
  for (std::size_t i = 0; i < 3; ++i) out[i] = (TwoDouble{a[i]} + part * TwoDouble::difference(b[i], a[i])).hi;
  return out;
}

void ConformingRecovery::split_segment(Index si) {
  const Subsegment s = constraints_.subsegments[si];
  const Vec3 p = split_place(s);
  const bool is_inner = s.segment == no_index;
  const bool is_sharp = is_sharp_segment(s),
             over_budget = !is_inner && is_sharp && points_on_segment_[s.segment] >= options_.max_steiner_per_facet;
  if (over_budget) return give_up_segment(si, GivenUpFor::points);
  if (too_short(mesh_.point(s.a), p) || too_short(mesh_.point(s.b), p))
    return give_up_segment(si, GivenUpFor::shortness);
  const VertexIndex x =
      insert(p, s.a, {is_inner ? VertexOrigin::on_facet : VertexOrigin::on_segment, is_inner ? s.facet : s.segment});
  if (x == no_vertex) return give_up_segment(si, GivenUpFor::place);
  if (!is_inner) ++points_on_segment_[s.segment];
  ++(is_sharp ? n_sharp_points_ : n_other_points_);
  ++recovery_.statistics.edges_reinserted;
  for (const Index half : constraints_.split_subsegment(si, x))
    if (!is_edge_of_new_star(constraints_.subsegments[half].a, constraints_.subsegments[half].b)) queue_segment(half);
  for (const Index f : s.subfacets) queue_facet(f);
}

void ConformingRecovery::give_up_segment(Index si, GivenUpFor why) {
  const Subsegment& s = constraints_.subsegments[si];
  if (s.segment != no_index) segment_is_given_up_[s.segment] = 1;
  for (const Index f : std::vector<Index>(s.subfacets)) give_up_facet(f, why);
}

}  // namespace geomesh::recover
