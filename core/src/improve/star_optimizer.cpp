// SPDX-License-Identifier: MIT
#include "improve/star_optimizer.hpp"

#include <algorithm>
#include <cmath>

#include "improve/improve.hpp"

namespace geomesh::remesh {

void StarProblem::set_link(const DomainMesh& mesh, const StarCavity& cavity) {
  link.clear();
  for (const LinkFace& f : cavity.link)
    link.emplace_back(mesh.point(f.vertices[0]), mesh.point(f.vertices[1]), mesh.point(f.vertices[2]));
}

double StarProblem::shape_at(const Vec3& p, double enough) const {
  double worst = 1;
  for (const ShapeBase& f : link) {
    worst = std::min(worst, shape(f, p));
    if (worst <= enough) break;
  }
  return worst;
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

/// Point nearest to the origin in the convex hull, by Gilbert's iteration (1966): enough for a direction that raises all terms.
Vec3 nearest_to_origin(const std::vector<Vec3>& g) {
  Vec3 x = g[0];
  for (const Vec3& v : g)
    if (dot(v, v) < dot(x, x)) x = v;
  for (unsigned step = 0; step < 40; ++step) {
    const Vec3* least = &g[0];
    for (const Vec3& v : g)
      if (dot(x, v) < dot(x, *least)) least = &v;
    const Vec3 d = *least - x;
    const double gain = -dot(x, d), dd = dot(d, d);
    if (gain <= 1e-3 * dot(x, x) || !(dd > 0)) break;
    x = x + std::min(1.0, gain / dd) * d;
  }
  return x;
}

/// Gradients, constrained, of the terms below `limit`.
void active_gradients(const StarProblem& problem, const Vec3& p, double limit, std::vector<Vec3>& g) {
  g.clear();
  for (const ShapeBase& base : problem.link) {
    if (shape(base, p) > limit) continue;
    const auto& [a, b, c] = base.corner;
    const detail::ShapeFrame frame(a, b, c, p);
    const ShapeTerms t = shape_terms(frame, a, b, c);
    for (unsigned k = 0; k < 6; ++k)
      if (t.value[k] <= limit) g.push_back(problem.constrain(shape_gradient(frame, k, t.value[k])));
  }
}

double shortest_reach(const StarProblem& problem, const Vec3& p) {
  double d = std::numeric_limits<double>::infinity();
  for (const ShapeBase& f : problem.link)
    for (const Vec3& q : f.corner) d = std::min(d, squared_distance(p, q));
  return std::sqrt(d);
}

}  // namespace

OptimizedPlace optimize_place(const StarProblem& problem, const Vec3& start, const OptimizeLimits& limits) {
  OptimizedPlace best{start, problem.shape_at(start)};
  if (!(best.shape > 0)) return best;
  thread_local std::vector<Vec3> g;
  double reach = 0.3 * shortest_reach(problem, start);
  const double least_reach = 1e-3 * reach;
  for (unsigned step = 0; step < limits.max_steps && best.shape < limits.good_enough; ++step) {
    active_gradients(problem, best.point, best.shape * 1.03 + 1e-4, g);
    if (g.empty()) break;
    const Vec3 direction = nearest_to_origin(g);
    const double slope = length(direction);
    if (!(slope * reach > 1e-6)) break;
    bool moved = false;
    for (unsigned trial = 0; trial < 6 && reach > least_reach; ++trial) {
      const Vec3 p = best.point + (reach / slope) * direction;
      const double s = problem.shape_at(p, best.shape);
      if (s > best.shape * limits.least_rise) {
        best = {p, s};
        moved = true;
        break;
      }
      reach *= 0.4;
    }
    if (!moved) break;
    reach *= 1.5;
  }
  return best;
}

namespace {

/// Sum of the worths of the cells about p; minus infinity where one is not above `floor`.
double sum_of_worths(const StarProblem& problem, const Vec3& p, double floor) {
  double sum = 0;
  for (const ShapeBase& base : problem.link) {
    const double s = shape(base, p);
    if (!(s > floor)) return -std::numeric_limits<double>::infinity();
    sum += MeanGoal::worth(s);
  }
  return sum;
}

Vec3 gradient_of_sum(const StarProblem& problem, const Vec3& p) {
  Vec3 g;
  for (const ShapeBase& base : problem.link) {
    const auto& [a, b, c] = base.corner;
    const detail::ShapeFrame frame(a, b, c, p);
    const ShapeTerms t = shape_terms(frame, a, b, c);
    const auto k = static_cast<unsigned>(std::min_element(t.value.begin(), t.value.end()) - t.value.begin());
    g = g + MeanGoal::slope_of_worth(t.value[k]) * shape_gradient(frame, k, t.value[k]);
  }
  return problem.constrain(g);
}

}  // namespace

Vec3 optimize_mean(const StarProblem& problem, const Vec3& start, double floor, unsigned max_steps, double least_gain) {
  Vec3 best = start;
  double sum = sum_of_worths(problem, start, floor), reach = 0.3 * shortest_reach(problem, start);
  const double least_reach = 7.5 * least_gain * reach;
  for (unsigned step = 0; step < max_steps; ++step) {
    const Vec3 g = gradient_of_sum(problem, best);
    const double slope = length(g);
    if (!(slope * reach > 1e-6)) break;
    bool moved = false;
    for (; !moved && reach > least_reach; reach *= 0.4) {
      const Vec3 p = best + (reach / slope) * g;
      const double s = sum_of_worths(problem, p, floor);
      if (s > sum + least_gain) best = p, sum = s, moved = true;
    }
    if (!moved) break;
    reach *= 2;
  }
  return best;
}

Vec3 link_centroid(const StarProblem& problem) {
  Vec3 sum;
  double weight = 0;
  for (const ShapeBase& f : problem.link) {
    const double area = length(f.normal);
    sum = sum + (area / 3) * (f.corner[0] + f.corner[1] + f.corner[2]);
    weight += area;
  }
  return weight > 0 ? (1 / weight) * sum : sum;
}

Vec3 odt_place(const StarProblem& problem, const Vec3& p) {
  Vec3 sum;
  double weight = 0;
  for (const ShapeBase& f : problem.link) {
    const double volume = dot(f.normal, p - f.corner[0]);
    const Vec3 centre = circumsphere(f.corner[0], f.corner[1], f.corner[2], p).centre;
    if (!(volume > 0) || !(dot(centre, centre) < std::numeric_limits<double>::infinity())) continue;
    sum = sum + volume * centre;
    weight += volume;
  }
  return weight > 0 ? (1 / weight) * sum : p;
}

}  // namespace geomesh::remesh
