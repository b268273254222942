// SPDX-License-Identifier: MIT
/// Recovers facets by comparison with a draft triangulation (Cavalcanti and Mello 1999, section 3.2). A facet is
/// present if any mesh faces cover it, so that cocircular points, and points that rounding has moved off the plane,
/// need no special treatment. If the facet is missing, the draft determines where points are inserted.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include "common/geometry.hpp"
#include "delaunay/constrained_triangulation.hpp"
#include "recover/conforming/conforming.hpp"
#include "recover/model/facet_trace.hpp"
#include "recover/model/presence.hpp"

namespace geomesh::recover {

namespace {

/// A constrained Delaunay triangulation of a facet's vertices in a frame of its plane.
class Draft {
 public:
  Draft(const ConstrainedMesh& mesh, const Triangle& plane, const FacetPiece& piece) : piece_(piece) {
    const Vec3 o = mesh.point(plane[0]), u = mesh.point(plane[1]) - o;
    const Vec3 n = cross(u, mesh.point(plane[2]) - o), w = cross(n, u);
    const double lu = length(u), lw = length(w);
    members_ = piece.members;
    std::sort(members_.begin(), members_.end());
    for (VertexIndex v : members_)
      points_.push_back({dot(mesh.point(v) - o, u) / lu, dot(mesh.point(v) - o, w) / lw, 0});
  }
  /// Returns false if rounding in the frame has made the facet's border cross itself.
  bool build() {
    ConstrainedTriangulation plane(points_, {});
    if (!plane.triangulate()) return false;
    std::vector<ConstrainedTriangulation::Edge> border;
    for (const DirectedEdge& e : piece_.border) {
      border.push_back({local(e[0]), local(e[1])});
      if (plane.insert_constraint(border.back()[0], border.back()[1])) return false;
    }
    plane.restore_delaunay();
    for (const Triangle& t : plane.triangles_left_of(border, border))
      triangles_.push_back({members_[t[0]], members_[t[1]], members_[t[2]]});
    return !triangles_.empty();
  }
  const std::vector<Triangle>& triangles() const { return triangles_; }

 private:
  VertexIndex local(VertexIndex v) const {
    return static_cast<VertexIndex>(std::lower_bound(members_.begin(), members_.end(), v) - members_.begin());
  }
  const FacetPiece& piece_;
  std::vector<VertexIndex> members_;
  std::vector<Vec3> points_;
  std::vector<Triangle> triangles_;
};

/// Returns the edges at which points are added to a facet: of each triangle of its own triangulation that is not a mesh
/// face, the longest edge missing in the mesh, or all three if none is missing. The longest edges come first.
std::vector<DirectedEdge> edges_to_split(ConstrainedMesh& mesh, const std::vector<Triangle>& draft) {
  const auto squared_length = [&mesh](const DirectedEdge& e) {
    const Vec3 d = mesh.point(e[1]) - mesh.point(e[0]);
    return dot(d, d);
  };
  std::set<DirectedEdge> edges;
  for (const Triangle& t : draft) {
    if (mesh.find_face(t[0], t[1], t[2]).valid()) continue;
    std::vector<DirectedEdge> all, missing;
    for (unsigned i = 0; i < 3; ++i) {
      all.push_back({std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])});
      if (mesh.find_edge(all.back()[0], all.back()[1]) == no_cell) missing.push_back(all.back());
    }
    if (missing.empty()) {
      edges.insert(all.begin(), all.end());
    } else {
      edges.insert(*std::max_element(missing.begin(), missing.end(), [&](const DirectedEdge& d, const DirectedEdge& e) {
        return squared_length(d) < squared_length(e);
      }));
    }
  }
  std::vector<DirectedEdge> out(edges.begin(), edges.end());
  std::stable_sort(out.begin(), out.end(),
                   [&](const DirectedEdge& d, const DirectedEdge& e) { return squared_length(d) > squared_length(e); });
  return out;
}

}  // namespace

void ConformingRecovery::recover_queued_facets() {
  while (!missing_facets_.empty() && is_within_budget()) {
    recovery_.context.check_cancelled();
    recover_queued_segments();
    const Index f = missing_facets_.front();
    missing_facets_.pop_front();
    facet_queued_[f] = 0;
    if (facet_is_given_up_[f] || register_if_present(f)) continue;
    ++recovery_.statistics.facets_reinserted;
    insert_into_facet(f);
    if (!facet_is_given_up_[f]) queue_facet(f);
  }
  recover_queued_segments();
}

bool ConformingRecovery::register_if_present(Index f) {
  const Triangle& t = constraints_.subfacets[f].vertices;
  if (!constraints_.is_piece(f)) {
    if (!face_of_subfacet(mesh_, constraints_, f).valid()) return false;
    facet_of_face_.insert({t[0], t[1], t[2]}, f);
    return true;
  }
  const FacetTrace trace = trace_piece(mesh_, constraints_, f);
  if (trace.status != FacetTrace::Status::complete) return false;
  for (const Triangle& face : trace.faces) facet_of_face_.insert({face[0], face[1], face[2]}, f);
  return true;
}

void ConformingRecovery::insert_into_facet(Index f) {
  constraints_.make_piece(f);
  for (const DirectedEdge& e : constraints_.piece_of(f).border)
    // The missing edge is on a segment that was given up, so the facet is given up, too.
    if (mesh_.find_edge(e[0], e[1]) == no_cell) return give_up_facet(f, GivenUpFor::points);
  if (facet_is_sharp_[f] && points_on_facet_[f] >= options_.max_steiner_per_facet)
    return give_up_facet(f, GivenUpFor::points);
  Draft draft(mesh_, constraints_.subfacets[f].vertices, constraints_.piece_of(f));
  if (!draft.build()) return give_up_facet(f, GivenUpFor::place);
  const std::vector<DirectedEdge> edges = edges_to_split(mesh_, draft.triangles());
  if (edges.empty()) return give_up_facet(f, GivenUpFor::place);
  // The facet's 2D triangulation is updated once in a round. A point near another one inserted in this round is left
  // out, because the other point may have made it unnecessary.
  std::vector<Vec3> added;
  for (const DirectedEdge& e : edges) {
    const Vec3 a = mesh_.point(e[0]), b = mesh_.point(e[1]), middle = 0.5 * a + 0.5 * b;
    const bool is_near = std::any_of(added.begin(), added.end(),
                                     [&](const Vec3& p) { return dot(p - middle, p - middle) < dot(b - a, b - a); });
    if (is_near) continue;
    if (!insert_midpoint(f, e[0], e[1])) return give_up_facet(f, GivenUpFor::shortness);
    added.push_back(middle);
  }
}

bool ConformingRecovery::insert_midpoint(Index f, VertexIndex a, VertexIndex b) {
  const Index s = constraints_.subsegment_of(a, b);
  if (s != no_index) {
    split_segment(s);
    ++points_on_facet_[f];
    return !constraints_.subsegments[s].live;
  }
  const Vec3 pa = mesh_.point(a), pb = mesh_.point(b);
  const Vec3 p{0.5 * pa.x + 0.5 * pb.x, 0.5 * pa.y + 0.5 * pb.y, 0.5 * pa.z + 0.5 * pb.z};
  if (too_short(pa, p)) return false;
  const VertexIndex x = insert(p, a, {VertexOrigin::on_facet, constraints_.subfacets[f].facet});
  if (x == no_vertex) return false;
  ++points_on_facet_[f];
  ++(facet_is_sharp_[f] ? n_sharp_points_ : n_other_points_);
  constraints_.add_member(f, x);
  return true;
}

void ConformingRecovery::give_up_facet(Index f, GivenUpFor why) {
  if (facet_is_given_up_[f]) return;
  facet_is_given_up_[f] = 1;
  given_up_.push_back(constraints_.subfacets[f].facet);
  ++n_given_up_for_[static_cast<std::size_t>(why)];
}

namespace {

/// Returns the smallest angle of a triangle in degrees, and stores the position of its corner in `where`.
double smallest_angle(const ConstrainedMesh& mesh, const Triangle& t, Vec3& where) {
  double smallest = 180;
  for (unsigned i = 0; i < 3; ++i) {
    const Vec3 &o = mesh.point(t[i]), u = mesh.point(t[(i + 1) % 3]) - o, v = mesh.point(t[(i + 2) % 3]) - o;
    const double angle = std::atan2(length(cross(u, v)), dot(u, v)) * 180 / pi;
    if (angle >= smallest) continue;
    smallest = angle;
    where = o;
  }
  return smallest;
}

}  // namespace

void ConformingRecovery::note_given_up() const {
  if (given_up_.empty()) return;
  double sharpest = 180;
  Vec3 where;
  for (Index f = 0; f < constraints_.subfacets.size(); ++f) {
    Vec3 corner;
    if (!facet_is_given_up_[f]) continue;
    const double angle = smallest_angle(mesh_, constraints_.subfacets[f].vertices, corner);
    if (angle >= sharpest) continue;
    sharpest = angle;
    where = recovery_.names.frame.leave(corner);
  }
  char text[400];
  std::snprintf(text, sizeof text,
                "conforming mode gives up %zu facets of %zu after %zu points: %zu that would need more than %zu points "
                "each, %zu with "
                "edges below %.3g, %zu without a place for a point, %zu as the budget of %zu points is spent; the "
                "sharpest angle of them is %.2g degrees at (%.17g, %.17g, %.17g)",
                given_up_.size(), recovery_.plc.n_facets(), n_sharp_points_ + n_other_points_, n_given_up_for_[0],
                options_.max_steiner_per_facet, n_given_up_for_[1], min_edge_, n_given_up_for_[2], n_given_up_for_[3],
                max_sharp_points_ + max_other_points_, sharpest, where.x, where.y, where.z);
  recovery_.context.note(LogLevel::warning, text);
}

}  // namespace geomesh::recover
