// SPDX-License-Identifier: MIT
// Moves one vertex to improve the shapes around it. Declared in remesh/operations/improve.hpp.
#include <algorithm>
#include <cmath>
#include <utility>

#include "quality/measure/shape.hpp"
#include "remesh/operations/improve.hpp"
#include "remesh/operations/refine_ratios.hpp"

namespace geomesh::remesh {

namespace {

class Smoother {
 public:
  Smoother(Toolbox& tools, VertexIndex v, Workspace& work)
      : tools_(tools),
        mesh_(tools.mesh),
        work_(work),
        cavity_(work.cavity),
        v_(v),
        old_(tools.mesh.point(v)),
        problem_{work.link} {}

  bool run(const SmoothRule& rule) {
    const VertexKind kind = mesh_.kind(v_);
    if (kind == VertexKind::corner || kind == VertexKind::dead) return false;
    if (kind == VertexKind::curve && tools_.guard.exact() && !rule.slides_on_edges) return false;
    gather_star(mesh_, v_, work_.marks, cavity_);
    const double before = removed_shape(mesh_, cavity_);
    if (before >= rule.good_enough && rule.goal == SmoothGoal::worst) return false;
    problem_.set_link(mesh_, cavity_);
    if (!set_freedom()) return false;
    if (rule.goal == SmoothGoal::mean) return try_mean(before, rule);
    return before < rule.good_enough && try_optimal(before, rule);
  }

  bool run_on_surface(double floor) {
    if (mesh_.kind(v_) != VertexKind::surface) return false;
    gather_star(mesh_, v_, work_.marks, cavity_);
    const double needed = std::min(removed_shape(mesh_, cavity_), floor), before = worst_face(old_);
    const Vec3 centre = surface_centroid();
    bool is_set = false;
    for (const double t : {1.0, 0.5}) {
      const Vec3 p = project(old_ + t * (centre - old_));
      if (!(worst_face(p) > before * refine_ratios.regular_rise)) continue;
      if (!std::exchange(is_set, true)) problem_.set_link(mesh_, cavity_);
      if (place(p, 0.9 * needed)) return true;
    }
    return false;
  }

 private:
  double worst_face(const Vec3& p) const {
    double worst = 1;
    for (const Spoke& s : cavity_.spokes) {
      const Vec3 u = mesh_.point(s.a) - p, v = mesh_.point(s.b) - p, w = v - u;
      const double squares = dot(u, u) + dot(v, v) + dot(w, w);
      worst = std::min(worst, 2 * std::sqrt(3.0) * length(cross(u, v)) / squares);
    }
    return worst;
  }

  bool set_freedom() {
    if (mesh_.kind(v_) == VertexKind::surface) {
      problem_.freedom = StarProblem::Freedom::plane;
      problem_.direction = tools_.normal_at(v_);
    } else if (mesh_.kind(v_) == VertexKind::curve) {
      if (cavity_.curves.size() != 2) return false;
      for (unsigned k = 0; k < 2; ++k) ends_[k] = mesh_.point(cavity_.curves[k].a);
      const Vec3 d = ends_[1] - ends_[0];
      problem_.freedom = StarProblem::Freedom::line;
      problem_.direction = (1 / length(d)) * d;
    }
    return true;
  }

  /// Returns the end of the input edge on which v lies: the first corner along the edge from v on. An edge of the input
  /// is straight, and all vertices between its ends were added.
  VertexIndex end_of_edge(const CurveSpoke& first) const {
    VertexIndex from = v_, at = first.a;
    std::vector<CellIndex> star;
    for (VertexIndex next = at; next != no_vertex && mesh_.kind(at) == VertexKind::curve && at != v_;) {
      mesh_.star(at, work_.marks, star);
      next = no_vertex;
      for (const CellIndex c : star)
        for (const VertexIndex x : mesh_.vertices(c))
          if (x != from && x != at && mesh_.curve_of(at, x) != no_index) next = x;
      if (next != no_vertex) from = std::exchange(at, next);
    }
    return at;
  }

  Vec3 project_to_edge(const Vec3& p) const {
    return ends_[0] + dot(p - ends_[0], problem_.direction) * problem_.direction;
  }

  /// Projects p from the line through the neighbours of v on its curve to the line through the ends of the input edge
  /// at v, so that rounding does not add up. Finding the ends takes a walk, so it is done just before v moves.
  Vec3 on_input_edge(const Vec3& p) {
    for (unsigned k = 0; k < 2; ++k) ends_[k] = mesh_.point(end_of_edge(cavity_.curves[k]));
    const Vec3 d = ends_[1] - ends_[0];
    problem_.direction = (1 / length(d)) * d;
    return project_to_edge(p);
  }

  Vec3 project(const Vec3& p) const {
    switch (mesh_.kind(v_)) {
      case VertexKind::surface:
        return tools_.guard.project_to_patch(mesh_.support(v_), p);
      case VertexKind::curve:
        return tools_.guard.exact() ? project_to_edge(p) : tools_.guard.project_to_curve(mesh_.support(v_), p);
      default:
        return p;
    }
  }

  bool try_mean(double before, const SmoothRule& rule) {
    const double needed = std::min((1 - 1e-9) * before, rule.floor);
    const Vec3 best = optimize_mean(problem_, old_, needed, rule.max_steps, rule.least_gain);
    if (best == old_) return false;  // projecting an unmoved vertex would move it by rounding
    return place(project(best), needed);
  }

  Vec3 surface_centroid() const {
    if (!cavity_.curves.empty()) return 0.5 * (mesh_.point(cavity_.curves[0].a) + mesh_.point(cavity_.curves[1].a));
    Vec3 sum;
    double weight = 0;
    for (const Spoke& s : cavity_.spokes) {
      const Vec3 &a = mesh_.point(s.a), &b = mesh_.point(s.b);
      const double area = length(cross(a - old_, b - old_));
      sum = sum + (area / 3) * (old_ + a + b);
      weight += area;
    }
    return weight > 0 ? (1 / weight) * sum : old_;
  }

  bool try_optimal(double before, const SmoothRule& rule) {
    const OptimizeLimits limits{rule.max_steps, rule.good_enough, std::sqrt(rule.least_rise)};
    OptimizedPlace best = optimize_place(problem_, old_, limits);
    if (mesh_.kind(v_) == VertexKind::inside && best.shape < rule.good_enough) {
      const OptimizedPlace other = optimize_place(problem_, link_centroid(problem_), limits);
      if (other.shape > best.shape) best = other;
    }
    if (best.point == old_) return false;
    // On a curved patch the tolerance may permit only a part of the move.
    for (const double t : {1.0, 0.5, 0.25}) {
      const Vec3 p = project(old_ + t * (best.point - old_));
      if (place(p, before * rule.least_rise)) return true;
      if (mesh_.kind(v_) == VertexKind::inside) break;
    }
    return false;
  }

  /// Moves v to p if the worst shape around it is then above `least`.
  bool place(Vec3 p, double least) {
    if (!(problem_.shape_at(p, least) > least)) return false;
    if (mesh_.kind(v_) == VertexKind::curve && tools_.guard.exact()) {
      p = on_input_edge(p);
      if (!(problem_.shape_at(p, least) > least)) return false;
    }
    if (p == old_ || !star_is_positive(mesh_, cavity_, p)) return false;
    const std::vector<double>& shapes = problem_.link.shapes(p);  // shapes of the cells around v
    if (tools_.spoils(cavity_, shapes) ||
        !tools_.guard.admits(surface_of(mesh_, cavity_, old_), surface_of(mesh_, cavity_, p)))
      return false;
    mesh_.move_vertex(v_, p);
    for (std::size_t k = 0; k < cavity_.cells.size(); ++k) mesh_.set_shape(cavity_.cells[k], shapes[k]);
    tools_.lengths.forget(v_);
    return true;
  }

  Toolbox& tools_;
  DomainMesh& mesh_;
  Workspace& work_;
  StarCavity& cavity_;
  VertexIndex v_;
  Vec3 old_;
  StarProblem problem_;
  // If v is on a curve: the adjacent vertices on the curve, or the ends of the input edge on which v is.
  std::array<Vec3, 2> ends_{};
};

}  // namespace

bool smooth_on_surface(Toolbox& tools, VertexIndex v, double floor, Workspace& work) {
  return Smoother(tools, v, work).run_on_surface(floor);
}

bool smooth_vertex(Toolbox& tools, VertexIndex v, const SmoothRule& rule) {
  tools.make_room_for_normals();
  const bool moved = Smoother(tools, v, tools.work).run(rule);
  tools.statistics.smoothing_moves += moved;
  return moved;
}

bool smooth_beside_others(Toolbox& tools, VertexIndex v, const SmoothRule& rule, Workspace& work) {
  return Smoother(tools, v, work).run(rule);
}

}  // namespace geomesh::remesh
