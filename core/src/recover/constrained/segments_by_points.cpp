// SPDX-License-Identifier: MIT
/// Segments that flips do not recover get points. The stepping insertion always ends: the point stands where the line
/// first crosses the mesh, so that the part before it is an edge and the part behind it crosses one simplex less.
#include <algorithm>
#include <cmath>

#include "common/geometry.hpp"
#include "common/sort_unique.hpp"
#include "recover/model/crossing.hpp"
#include "recover/model/messages.hpp"
#include "recover/model/presence.hpp"
#include "recover/model/recover.hpp"
#include "recover/operations/cavity_retriangulation.hpp"
#include "recover/operations/star_insertion.hpp"

namespace geomesh::recover {

namespace {

/// Parameter on a-b where the line meets the plane of p, q, r; floating point is enough, as membership is declared.
double plane_parameter(const Vec3& a, const Vec3& b, const Vec3& p, const Vec3& q, const Vec3& r) {
  const Vec3 n = cross(q - p, r - p);
  const double da = dot(n, a - p), db = dot(n, b - p);
  return da == db ? 0.5 : da / (da - db);
}

/// Parameter on a-b nearest to the line p-q.
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

/// The cells of the simplex crossed: two of a face, all of an edge.
std::vector<CellIndex> crossed_cells(const ConstrainedMesh& mesh, const Crossing& c) {
  if (c.kind == CrossingKind::face) return {c.cell, mesh.cells().mirror(c.face).cell()};
  EdgeRing ring;
  if (!mesh.ring(c.cell, c.v[0], c.v[1], ring)) return {};
  return ring.cells;
}

void refuse_contradictions(const Recovery& recovery, Index s, const LineCrossings& line) {
  for (const Crossing& c : line.crossings) {
    if (c.kind != CrossingKind::edge) continue;
    const Index other = recovery.constraints.subsegment_of(c.v[0], c.v[1]);
    if (other != no_index) fail_segments_cross(recovery, s, other);
  }
}

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

/// Square of the distance to the nearest of the segment's ends and of the vertices of the simplex crossed.
double clearance(const ConstrainedMesh& mesh, const Crossing& c, const Vec3& x, const Vec3& a, const Vec3& b) {
  double out = std::min(dot(x - a, x - a), dot(x - b, x - b));
  for (VertexIndex v : c.v)
    if (v != no_vertex) out = std::min(out, dot(x - mesh.point(v), x - mesh.point(v)));
  return out;
}

/// Parts of a subsegment next to its ends are left alone, so that points do not crowd.
constexpr double least_part = 1e-6;

/// Later attempts leave the crossing by a small part of the way to the nearer end: there is no other vertex in its
/// plane.
double placed_parameter(double t, unsigned attempt) {
  if (attempt == 0) return t;
  const double part = (attempt % 2 == 0 ? 0.25 : -0.25) / (1 + attempt);
  return t + part * std::min(t, 1 - t);
}

/// Square of the distance of p from the line through a and b.
double distance_to_line(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 u = b - a, n = cross(u, p - a);
  return dot(n, n) / dot(u, u);
}

/// The cells of crossing i and of what the point x there would have beside it at the distance of a rounding error:
/// other crossings, and edges of the face crossed. Were they left, the next crossing would be an ulp from x.
std::vector<CellIndex> cells_near_crossing(const ConstrainedMesh& mesh, const LineCrossings& line,
                                           const std::vector<double>& parameters, std::size_t i, const Vec3& x,
                                           double length) {
  constexpr double near = 1e-7;  // of the subsegment
  std::vector<CellIndex> out;
  EdgeRing ring;
  for (std::size_t k = 0; k < line.crossings.size(); ++k) {
    if (std::fabs(parameters[k] - parameters[i]) > near) continue;
    const Crossing& c = line.crossings[k];
    const std::vector<CellIndex> cells = crossed_cells(mesh, c);
    out.insert(out.end(), cells.begin(), cells.end());
    if (c.kind != CrossingKind::face) continue;
    for (unsigned e = 0; e < 3; ++e) {
      const VertexIndex v = c.v[e], w = c.v[(e + 1) % 3];
      if (distance_to_line(x, mesh.point(v), mesh.point(w)) < near * near * length * length &&
          mesh.ring(c.cell, v, w, ring))
        out.insert(out.end(), ring.cells.begin(), ring.cells.end());
    }
  }
  sort_unique(out);
  return out;
}

/// A point on the missing subsegment where the line crosses the mesh, as far from other vertices as can be.
VertexIndex insert_on_segment(Recovery& recovery, Index s) {
  ConstrainedMesh& mesh = recovery.mesh;
  const VertexIndex a = recovery.constraints.subsegments[s].a, b = recovery.constraints.subsegments[s].b;
  const Vec3 pa = mesh.point(a), pb = mesh.point(b);
  LineCrossings line;
  walk_line(mesh, a, b, line);
  refuse_contradictions(recovery, s, line);
  const auto is_crowded = [&](const Vec3& p) {
    const double least = recovery.least_spacing * recovery.least_spacing;
    return dot(p - pa, p - pa) < least || dot(p - pb, p - pb) < least;
  };
  std::vector<std::pair<double, std::size_t>> order;
  std::vector<Vec3> places;
  std::vector<double> parameters;
  for (const Crossing& c : line.crossings) parameters.push_back(crossing_parameter(mesh, c, pa, pb));
  for (std::size_t i = 0; i < line.crossings.size(); ++i) {
    const double t = placed_parameter(parameters[i], recovery.attempt);
    places.push_back(on_segment(pa, pb, t));
    if (t > least_part && t < 1 - least_part && !is_crowded(places[i]))
      order.emplace_back(-clearance(mesh, line.crossings[i], places[i], pa, pb), i);
  }
  std::sort(order.begin(), order.end());
  VertexIndex x = no_vertex;
  for (const auto& [negative_clearance, i] : order)
    if (try_point(recovery, places[i], cells_near_crossing(mesh, line, parameters, i, places[i], distance(pb, pa)),
                  x) ||
        try_point(recovery, places[i], crossed_cells(mesh, line.crossings[i]), x))
      return x;
  for (double t : {0.5, 0.25, 0.75, 0.125, 0.875, 0.375, 0.625})
    if (!is_crowded(on_segment(pa, pb, t)) && try_point(recovery, on_segment(pa, pb, t), {mesh.cell_of(a)}, x))
      return x;
  return no_vertex;
}

struct Missing {
  Index subsegment;
  unsigned halvings;
};

std::size_t n_crossings(ConstrainedMesh& mesh, const Subsegment& s) {
  LineCrossings line;
  walk_line(mesh, s.a, s.b, line);
  return line.crossings.size();
}

/// More points than this on one subsegment only crowd: each removes a crossing, but flips that gave way to it may have
/// made others.
std::size_t most_points(ConstrainedMesh& mesh, const Subsegment& s) { return 100 + 4 * n_crossings(mesh, s); }

/// Deep flips may bring back what points have removed, so beyond a few halvings points alone step on, which ends. And
/// lines that cross much they clear hardly ever, at ten times the cost.
bool recover_parted_by_flips(Recovery& recovery, const Subsegment& s, unsigned halvings) {
  constexpr std::size_t max_crossings = 20;
  constexpr unsigned few = 6, many = 12;
  if (halvings >= many) return false;
  const unsigned deepest = n_crossings(recovery.mesh, s) > max_crossings ? 1 : 2;
  return recover_segment_by_flips(recovery, s.a, s.b, halvings < few ? deepest : 0);
}

/// Throws Error{cannot_mesh} where no point can be placed or `most_points` do not suffice.
void recover_by_points(Recovery& recovery, Missing first) {
  ConstrainedMesh& mesh = recovery.mesh;
  Constraints& constraints = recovery.constraints;
  std::vector<Missing> stack{first};
  std::size_t points_left = most_points(mesh, constraints.subsegments[first.subsegment]);
  while (!stack.empty()) {
    recovery.context.check_cancelled();
    const Missing item = stack.back();
    stack.pop_back();
    if (!constraints.subsegments[item.subsegment].live) continue;
    const Subsegment s = constraints.subsegments[item.subsegment];
    if (mesh.find_edge(s.a, s.b) != no_cell || recover_parted_by_flips(recovery, s, item.halvings)) continue;
    const VertexIndex x = insert_on_segment(recovery, item.subsegment);
    if (x == no_vertex || points_left-- == 0) fail_segment_not_recovered(recovery, item.subsegment);
    recovery.count_added_point();
    const bool inside_facet = s.segment == no_index;
    constraints.vertices.resize(mesh.points().size());
    constraints.vertices[x] = {inside_facet ? VertexOrigin::on_facet : VertexOrigin::on_segment,
                               inside_facet ? s.facet : s.segment};
    const auto halves = constraints.split_subsegment(item.subsegment, x);
    stack.push_back({halves[1], item.halvings + 1});
    stack.push_back({halves[0], item.halvings + 1});
  }
}

}  // namespace

namespace {

/// Whether the subsegment could be an edge but is none. Its ends may come to the mesh later (hard_parts_first.hpp).
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
    std::erase_if(missing, [&](Index s) {
      const VertexIndex a = constraints.subsegments[s].a, b = constraints.subsegments[s].b;
      return recover_segment_by_flips(recovery, a, b, depth) ||
             (depth > 0 && recover_segment_by_cavity(recovery, a, b, {200 * depth}));
    });
  }
  for (Index s : missing) {
    const Subsegment& hard = constraints.subsegments[s];
    if (hard.segment == no_index) {
      recovery.hard_facets.push_back(hard.facet);
    } else {
      recovery.hard_segments.push_back(hard.segment);
    }
  }
  for (Index s : missing) {
    recovery.context.check_cancelled();
    recover_by_points(recovery, {s, 0});
  }
  recovery.statistics.edges_reinserted += n_missing_before;
}

}  // namespace geomesh::recover
