// SPDX-License-Identifier: MIT
#include "remesh/operations/star_optimizer.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "quality/measure/shape.hpp"
#include "remesh/operations/improve_schedule.hpp"
#include "remesh/operations/operations.hpp"

namespace geomesh::remesh {

void StarProblem::set_link(const DomainMesh& mesh, const StarCavity& cavity) {
  measure = mesh.measure();
  link.clear(measure.kernels());
  for (const LinkFace& f : cavity.link)
    link.add(mesh.point(f.vertices[0]), mesh.point(f.vertices[1]), mesh.point(f.vertices[2]));
  link.prepare();
}

Vec3 StarProblem::constrain(const Vec3& v) const {
  switch (freedom) {
    case Freedom::plane:
      return v - dot(v, direction) * direction;
    case Freedom::line:
      return dot(v, direction) * direction;
    default:
      return v;
  }
}

namespace {

/// Returns the point nearest to the origin in the convex hull of the vectors g, by Gilbert's iteration (1966). Its
/// accuracy suffices for a direction along which all shapes rise.
Vec3 nearest_to_origin(const std::vector<Vec3>& g) {
  Vec3 x = g[0];
  for (const Vec3& v : g)
    if (dot(v, v) < dot(x, x)) x = v;
  for (unsigned step = 0; step < ascent_limits.hull_steps; ++step) {
    const Vec3* least = &g[0];
    for (const Vec3& v : g)
      if (dot(x, v) < dot(x, *least)) least = &v;
    const Vec3 d = *least - x;
    const double gain = -dot(x, d), dd = dot(d, d);
    if (gain <= ascent_limits.hull_accuracy * dot(x, x) || !(dd > 0)) break;
    x = x + std::min(1.0, gain / dd) * d;
  }
  return x;
}

/// Collects the gradients of all shapes below `limit`, projected to the directions in which the vertex may move.
void active_gradients(const StarProblem& problem, const Vec3& p, double limit, std::vector<Vec3>& g) {
  g.clear();
  const std::vector<double>& shapes = problem.link.shapes(p);
  for (std::size_t i = 0; i < problem.link.size(); ++i) {
    if (shapes[i] > limit) continue;
    problem.measure.append_gradients({problem.link.corner(i, 0), problem.link.corner(i, 1), problem.link.corner(i, 2)},
                                     p, limit, g);
  }
  for (Vec3& v : g) v = problem.constrain(v);
}

double shortest_reach(const StarProblem& problem, const Vec3& p) {
  double d = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < problem.link.size(); ++i)
    for (unsigned k = 0; k < 3; ++k) d = std::min(d, squared_distance(p, problem.link.corner(i, k)));
  return std::sqrt(d);
}

}  // namespace

OptimizedPlace optimize_place(const StarProblem& problem, const Vec3& start, const OptimizeLimits& limits) {
  OptimizedPlace best{start, problem.shape_at(start)};
  if (!(best.shape > 0)) return best;
  thread_local std::vector<Vec3> g;
  double reach = ascent_limits.first_reach * shortest_reach(problem, start);
  const double least_reach = ascent_limits.least_reach * reach;
  for (unsigned step = 0; step < limits.max_steps && best.shape < limits.good_enough; ++step) {
    const double active = best.shape * ascent_limits.active_share + ascent_limits.active_margin;
    active_gradients(problem, best.point, active, g);
    if (g.empty()) break;
    const Vec3 direction = nearest_to_origin(g);
    const double slope = length(direction);
    if (!(slope * reach > ascent_limits.least_slope)) break;
    bool moved = false;
    for (unsigned trial = 0; trial < ascent_limits.trials && reach > least_reach; ++trial) {
      const Vec3 p = best.point + (reach / slope) * direction;
      const double s = problem.shape_at(p, best.shape);
      if (s > best.shape * limits.least_rise) {
        best = {p, s};
        moved = true;
        break;
      }
      reach *= ascent_limits.shorten;
    }
    if (!moved) break;
    reach *= ascent_limits.lengthen;
  }
  return best;
}

Vec3 optimize_mean(const StarProblem& problem, const Vec3& start, double floor, unsigned max_steps, double least_gain) {
  Vec3 best = start;
  double sum = problem.link.sum_of_worths(start, floor),
         reach = ascent_limits.first_reach * shortest_reach(problem, start);
  const double least_reach = ascent_limits.mean_reach_by_gain * least_gain * reach;
  for (unsigned step = 0; step < max_steps; ++step) {
    const Vec3 g = problem.constrain(problem.link.gradient_of_sum(best));
    const double slope = length(g);
    if (!(slope * reach > ascent_limits.least_slope)) break;
    bool moved = false;
    for (; !moved && reach > least_reach; reach *= ascent_limits.shorten) {
      const Vec3 p = best + (reach / slope) * g;
      const double s = problem.link.sum_of_worths(p, floor);
      if (s > sum + least_gain) best = p, sum = s, moved = true;
    }
    if (!moved) break;
    reach *= ascent_limits.lengthen_mean;
  }
  return best;
}

Vec3 link_centroid(const StarProblem& problem) {
  Vec3 sum;
  double weight = 0;
  for (std::size_t i = 0; i < problem.link.size(); ++i) {
    const double area = length(problem.link.normal(i));
    sum = sum + (area / 3) * (problem.link.corner(i, 0) + problem.link.corner(i, 1) + problem.link.corner(i, 2));
    weight += area;
  }
  return weight > 0 ? (1 / weight) * sum : sum;
}

}  // namespace geomesh::remesh
