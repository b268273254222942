// SPDX-License-Identifier: MIT
#include "recover/constrained/exact_steps.hpp"

#include <algorithm>
#include <cmath>

#include "recover/constrained/crossed_cells.hpp"
#include "recover/model/recovery_budget.hpp"
#include "recover/operations/exact_points.hpp"
#include "recover/operations/star_insertion.hpp"

namespace geomesh::recover {

namespace {

bool try_place(Recovery& recovery, ExactPlace place, const std::vector<CellIndex>& seeds, VertexIndex& x) {
  if (seeds.empty() || !place.is_safe()) return false;
  ConstrainedMesh& mesh = recovery.mesh;
  x = mesh.add_point(std::move(place));
  if (insert_in_star(mesh, recovery.constraints, x, seeds)) return true;
  mesh.drop_last_point();
  return false;
}

class SegmentStep {
 public:
  SegmentStep(Recovery& recovery, Index subsegment)
      : recovery_(recovery),
        mesh_(recovery.mesh),
        a_(recovery.constraints.subsegments[subsegment].a),
        b_(recovery.constraints.subsegments[subsegment].b) {
    walk_line(mesh_, a_, b_, on_.line);
    if (ends_at_crossed_segment(recovery, subsegment, on_.line)) return;
    const Vec3 along = mesh_.offset(a_, b_);
    on_.length = std::sqrt(dot(along, along));
    for (const Crossing& c : on_.line.crossings) on_.parameters.push_back(rough_parameter_of(c));
  }

  VertexIndex run() {
    VertexIndex x = no_vertex;
    if (recovery_.has_ended()) return x;
    const Vec3 &pa = mesh_.point(a_), &pb = mesh_.point(b_);
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < on_.line.crossings.size(); ++i)
      order.emplace_back(-clearance(mesh_, on_.line.crossings[i], rounded(on_.parameters[i]), pa, pb), i);
    std::sort(order.begin(), order.end());
    for (const auto& [negative_clearance, i] : order) {
      const ExactPlace place = place_at(i, recovery_budget.parameter_errors[0]);
      if (try_place(recovery_, place, cells_near_crossing(mesh_, on_, i, place.nearest()), x) ||
          try_place(recovery_, place, crossed_cells(mesh_, on_.line.crossings[i]), x))
        return x;
    }
    for (std::size_t i = 0; i < on_.line.crossings.size(); ++i)
      for (const double error : recovery_budget.parameter_errors)
        if (try_place(recovery_, place_at(i, error), crossed_cells(mesh_, on_.line.crossings[i]), x)) return x;
    return no_vertex;
  }

 private:
  /// Returns three vertices of a plane through the crossed simplex that does not contain the line.
  Triangle plane_through(const Crossing& c) const {
    if (c.kind == CrossingKind::face) return {c.v[0], c.v[1], c.v[2]};
    for (const VertexIndex u : mesh_.cells().vertices(c.cell))
      if (u != c.v[0] && u != c.v[1] && mesh_.orient(a_, b_, c.v[0], u) != Sign::zero) return {c.v[0], c.v[1], u};
    return {c.v[0], c.v[1], c.v[0]};
  }
  /// Returns roughly the parameter on the segment (0 to 1) at which it crosses a mesh face or edge, to order crossings.
  double rough_parameter_of(const Crossing& c) const {
    const Triangle plane = plane_through(c);
    const auto height = [&](VertexIndex v) {
      return mesh_.exact_places().rough_volume(mesh_.points(), {plane[0], plane[1], plane[2], v});
    };
    const double at_a = height(a_), at_b = height(b_);
    return at_a == at_b ? 0.5 : at_a / (at_a - at_b);
  }
  exact::LongExpansion parameter_of(const Crossing& c, double error) const {
    return crossing_parameter(mesh_, a_, b_, plane_through(c), error);
  }
  ExactPlace place_at(std::size_t i, double error) const {
    return place_on_line(mesh_, a_, b_, parameter_of(on_.line.crossings[i], error), error);
  }
  Vec3 rounded(double t) const { return mesh_.point(a_) + t * (mesh_.point(b_) - mesh_.point(a_)); }

  Recovery& recovery_;
  ConstrainedMesh& mesh_;
  VertexIndex a_, b_;
  CrossingsOnLine on_;
};

}  // namespace

VertexIndex step_along_segment(Recovery& recovery, Index subsegment) { return SegmentStep(recovery, subsegment).run(); }

VertexIndex step_onto_plane(Recovery& recovery, const Triangle& plane, VertexIndex below, VertexIndex above) {
  EdgeRing ring;
  const CellIndex cell = recovery.mesh.find_edge(below, above);
  if (cell == no_cell || !recovery.mesh.ring(cell, below, above, ring)) return no_vertex;
  VertexIndex x = no_vertex;
  for (const double error : recovery_budget.parameter_errors)
    if (try_place(recovery, place_in_plane(recovery.mesh, plane, below, above, error), ring.cells, x)) return x;
  return no_vertex;
}

}  // namespace geomesh::recover
