// SPDX-License-Identifier: MIT
/// Adds points to segments that flips do not recover. Stepping insertion always terminates: the point is placed where
/// the line first crosses the mesh, so the part before it is an edge, and the part behind it crosses one simplex less.
#include <algorithm>
#include <cmath>
#include <string>

#include "common/geometry.hpp"
#include "recover/constrained/crossed_cells.hpp"
#include "recover/constrained/exact_steps.hpp"
#include "recover/model/messages.hpp"
#include "recover/model/presence.hpp"
#include "recover/model/recover.hpp"
#include "recover/model/recovery_budget.hpp"
#include "recover/operations/cavity_retriangulation.hpp"
#include "recover/operations/star_insertion.hpp"

namespace geomesh::recover {

namespace {

/// Returns the parameter on a-b at which the line meets the plane of p, q, r; floating point is accurate enough,
/// because the point is declared to lie on the segment.
double plane_parameter(const Vec3& a, const Vec3& b, const Vec3& p, const Vec3& q, const Vec3& r) {
  const Vec3 n = cross(q - p, r - p);
  const double da = dot(n, a - p), db = dot(n, b - p);
  return da == db ? 0.5 : da / (da - db);
}

/// Returns the parameter (0 at a, 1 at b) of the point on the line a-b that is nearest to the line p-q.
double line_parameter(const Vec3& a, const Vec3& b, const Vec3& p, const Vec3& q) {
  const Vec3 u = b - a, v = q - p, w = a - p;
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), d = uu * vv - uv * uv;
  return d == 0 ? 0.5 : (uv * dot(v, w) - vv * dot(u, w)) / d;
}

double crossing_parameter(const ConstrainedMesh& mesh, const Crossing& c, const Vec3& a, const Vec3& b) {
  const Vec3 &p = mesh.point(c.v[0]), &q = mesh.point(c.v[1]);
  return c.kind == CrossingKind::edge ? line_parameter(a, b, p, q) : plane_parameter(a, b, p, q, mesh.point(c.v[2]));
}

Vec3 on_segment(const Vec3& a, const Vec3& b, double t) { return t <= 0.5 ? a + t * (b - a) : b + (1 - t) * (a - b); }

bool try_point(Recovery& recovery, const Vec3& p, const std::vector<CellIndex>& seeds, VertexIndex& x) {
  ConstrainedMesh& mesh = recovery.mesh;
  x = mesh.add_point(p);
  if (!seeds.empty() && insert_in_star(mesh, recovery.constraints, x, seeds)) return true;
  const CellIndex start = seeds.empty() ? mesh.cell_of(static_cast<VertexIndex>(mesh.n_input())) : seeds[0];
  const CellIndex at = mesh.locate(p, start);
  if (at != no_cell && insert_in_star(mesh, recovery.constraints, x, cells_about(mesh, p, at))) return true;
  mesh.drop_last_point();
  return false;
}

/// Adds a point on the missing subsegment where the line crosses the mesh, as far from other vertices as possible.
VertexIndex insert_on_segment(Recovery& recovery, Index s) {
  ConstrainedMesh& mesh = recovery.mesh;
  const VertexIndex a = recovery.constraints.subsegments[s].a, b = recovery.constraints.subsegments[s].b;
  const Vec3 pa = mesh.point(a), pb = mesh.point(b);
  CrossingsOnLine on;
  const std::vector<Crossing>& crossings = on.line.crossings;
  walk_line(mesh, a, b, on.line);
  on.length = std::sqrt(dot(pb - pa, pb - pa));
  if (ends_at_crossed_segment(recovery, s, on.line)) return no_vertex;
  const auto is_crowded = [&](const Vec3& p) {
    const double least = recovery.least_spacing * recovery.least_spacing;
    return dot(p - pa, p - pa) < least || dot(p - pb, p - pb) < least;
  };
  std::vector<std::pair<double, std::size_t>> order;
  std::vector<Vec3> places;
  for (const Crossing& c : crossings) on.parameters.push_back(crossing_parameter(mesh, c, pa, pb));
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    const double t = on.parameters[i];
    places.push_back(on_segment(pa, pb, t));
    if (t > recovery_budget.least_part && t < 1 - recovery_budget.least_part && !is_crowded(places[i]))
      order.emplace_back(-clearance(mesh, crossings[i], places[i], pa, pb), i);
  }
  std::sort(order.begin(), order.end());
  VertexIndex x = no_vertex;
  for (const auto& [negative_clearance, i] : order)
    if (try_point(recovery, places[i], cells_near_crossing(mesh, on, i, places[i]), x) ||
        try_point(recovery, places[i], crossed_cells(mesh, crossings[i]), x))
      return x;
  for (double t : {0.5, 0.25, 0.75, 0.125, 0.875, 0.375, 0.625})
    if (!is_crowded(on_segment(pa, pb, t)) && try_point(recovery, on_segment(pa, pb, t), {mesh.cell_of(a)}, x))
      return x;
  return no_vertex;
}

std::size_t n_crossings(ConstrainedMesh& mesh, const Subsegment& s) {
  LineCrossings line;
  walk_line(mesh, s.a, s.b, line);
  return line.crossings.size();
}

/// Returns the largest useful number of points on one subsegment. Each point removes a crossing, but flips that were
/// tried before may have made other crossings.
std::size_t most_points(ConstrainedMesh& mesh, const Subsegment& s) {
  return recovery_budget.points_on_subsegment + recovery_budget.points_on_crossing * n_crossings(mesh, s);
}

/// Recovers a part of a subsegment by flips. Flips may restore crossings that points have removed, so once the work
/// allowed for flips is used up only points are added, which terminates. Deep flips hardly ever clear lines with many
/// crossings, at ten times the cost.
bool recover_parted_by_flips(Recovery& recovery, const Subsegment& s, std::size_t& work_left) {
  const unsigned depth = n_crossings(recovery.mesh, s) > recovery_budget.crossings_flipped ? 1 : 2;
  return work_left > 0 && recover_segment_by_flips(recovery, s.a, s.b, depth, work_left);
}

/// Recovers missing subsegments by adding points.
class PointsOnSegments {
 public:
  explicit PointsOnSegments(Recovery& recovery)
      : recovery_(recovery), mesh_(recovery.mesh), constraints_(recovery.constraints) {}

  /// Recovers one subsegment. Ends the attempt at recovery if no point can be placed or `most_points` do not suffice.
  void recover(Index first) {
    std::vector<Index> stack{first};
    std::size_t work_left = recovery_budget.flips_tried;
    std::size_t points_left = most_points(mesh_, constraints_.subsegments[first]);
    while (!stack.empty() && !recovery_.has_ended()) {
      recovery_.context.check_cancelled();
      const Index subsegment = stack.back();
      stack.pop_back();
      const Subsegment s = constraints_.subsegments[subsegment];
      if (!s.live || mesh_.find_edge(s.a, s.b) != no_cell || recover_parted_by_flips(recovery_, s, work_left)) continue;
      if (recovery_.has_ended()) return;
      const VertexIndex x = recovery_.has_exact_points ? step_along_segment(recovery_, subsegment)
                                                       : insert_on_segment(recovery_, subsegment);
      if (x == no_vertex || points_left-- == 0)
        recovery_.end(error_of_segment_not_recovered(recovery_, subsegment));
      else
        recovery_.count_added_point();
      if (x == no_vertex) return;
      const std::array<Index, 2> halves = split(subsegment, x);
      stack.push_back(halves[1]);
      stack.push_back(halves[0]);
    }
  }

 private:
  std::array<Index, 2> split(Index subsegment, VertexIndex x) {
    const Subsegment& s = constraints_.subsegments[subsegment];
    const bool inside_facet = s.segment == no_index;
    constraints_.vertices.resize(mesh_.points().size());
    constraints_.vertices[x] = {inside_facet ? VertexOrigin::on_facet : VertexOrigin::on_segment,
                                inside_facet ? s.facet : s.segment};
    return constraints_.split_subsegment(subsegment, x);
  }

  Recovery& recovery_;
  ConstrainedMesh& mesh_;
  Constraints& constraints_;
};

}  // namespace

namespace {

/// Returns whether the subsegment could be an edge but is none. Its ends may be inserted later (hard_parts_first.hpp).
bool is_missing(Recovery& recovery, Index subsegment) {
  const Subsegment& s = recovery.constraints.subsegments[subsegment];
  return s.live && recovery.mesh.in_mesh(s.a) && recovery.mesh.in_mesh(s.b) &&
         cell_of_subsegment(recovery.mesh, recovery.constraints, subsegment) == no_cell;
}

}  // namespace

void recover_segments(Recovery& recovery) {
  Constraints& constraints = recovery.constraints;
  std::vector<Index> missing;
  for (Index s = 0; s < constraints.subsegments.size(); ++s)
    if (is_missing(recovery, s)) missing.push_back(s);
  std::size_t n_missing_before = missing.size();
  for (std::size_t i = missing.size(); recovery.attempt > 0 && i > 1; --i)
    std::swap(missing[i - 1], missing[recovery.mesh.random(static_cast<unsigned>(i))]);
  for (unsigned depth : {0u, 1u}) {
    recovery.context.check_cancelled();
    std::size_t n_tried = 0;
    const std::size_t n_missing = missing.size();
    std::erase_if(missing, [&](Index s) {
      if (n_tried++ % 64 == 0) recovery.context.report(n_tried, n_missing);
      const VertexIndex a = constraints.subsegments[s].a, b = constraints.subsegments[s].b;
      std::size_t work_left = recovery_budget.flips_tried;
      return !recovery.has_ended() &&
             (recover_segment_by_flips(recovery, a, b, depth, work_left) ||
              (depth > 0 && !recovery.has_ended() &&
               recover_segment_by_cavity(recovery, a, b, {recovery_budget.filling_nodes * depth})));
    });
  }
  if (recovery.has_ended()) return;
  for (Index s : missing) {
    const Subsegment& hard = constraints.subsegments[s];
    if (hard.segment == no_index) {
      recovery.hard_facets.push_back(hard.facet);
    } else {
      recovery.hard_segments.push_back(hard.segment);
    }
  }
  PointsOnSegments by_points(recovery);
  for (const Index s : missing) {
    by_points.recover(s);
    if (recovery.has_ended()) return;
  }
  recovery.statistics.edges_reinserted += n_missing_before;
}

}  // namespace geomesh::recover
