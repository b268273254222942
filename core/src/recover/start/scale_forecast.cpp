// SPDX-License-Identifier: MIT
#include "recover/start/scale_forecast.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/sort_unique.hpp"
#include "recover/model/crossing.hpp"
#include "recover/model/recovery_budget.hpp"

namespace geomesh::recover {

namespace {

/// The half-plane x * s + y * t <= limit.
struct HalfPlane {
  double x, y, limit;
};

/// Returns whether the half-planes have a point in common, by processing them one by one (Seidel 1991): the current
/// point is the best one in a fixed direction. If it is outside the next half-plane, it is replaced by the best one on
/// the border of that half-plane. O(n^2), in practice less.
bool have_common_point(const std::vector<HalfPlane>& planes, double far) {
  double s = far, t = far;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const HalfPlane& h = planes[i];
    if (h.x * s + h.y * t <= h.limit) continue;
    const double squared = h.x * h.x + h.y * h.y;
    if (squared == 0) return false;
    const double os = h.x * h.limit / squared,
                 ot = h.y * h.limit / squared;  // point of the half-plane's border line nearest to the origin
    double low = -std::numeric_limits<double>::infinity(), high = -low;
    const auto cut = [&](double slope, double room) {
      if (slope > 0) high = std::min(high, room / slope);
      if (slope < 0) low = std::max(low, room / slope);
      if (slope == 0 && room < 0) high = -std::numeric_limits<double>::infinity();
    };
    cut(-h.y, far - os);
    cut(h.y, far + os);
    cut(h.x, far - ot);
    cut(-h.x, far + ot);
    for (std::size_t k = 0; k < i; ++k)
      cut(planes[k].y * h.x - planes[k].x * h.y, planes[k].limit - planes[k].x * os - planes[k].y * ot);
    if (low > high) return false;
    const double along = h.x - h.y > 0 ? high : low;
    s = os - along * h.y;
    t = ot + along * h.x;
  }
  return true;
}

/// Collects the vertices of the cells that a subsegment crosses if it is no edge of the triangulation; otherwise those
/// of the cells around it and of their neighbours.
void gather_about(ConstrainedMesh& mesh, const Subsegment& s, CellIndex cell, std::vector<VertexIndex>& out) {
  const TetMesh& cells = mesh.cells();
  out.clear();
  LineCrossings line;
  EdgeRing ring;
  if (cell == no_cell) {
    walk_line(mesh, s.a, s.b, line);
  } else if (mesh.ring(cell, s.a, s.b, ring)) {
    for (const CellIndex c : ring.cells)
      for (unsigned i = 0; i < 4; ++i) line.cells.push_back(cells.neighbor_cell(c, i));
  }
  for (const CellIndex c : line.cells)
    for (const VertexIndex v : cells.vertices(c))
      if (v != s.a && v != s.b && v != infinite_vertex && !mesh.is_box_vertex(v)) out.push_back(v);
  sort_unique(out);
}

}  // namespace

ScaleForecast::ScaleForecast(ConstrainedMesh& mesh, const Constraints& constraints,
                             const std::vector<CellIndex>& seen_in) {
  std::vector<Index> present, missing;
  for (Index s = 0; s < seen_in.size(); ++s) (seen_in[s] == no_cell ? missing : present).push_back(s);
  std::vector<VertexIndex> about;
  for (const std::vector<Index>* some : {&present, &missing}) {
    const std::size_t n = std::min(recovery_budget.forecast_sample, some->size());
    for (std::size_t i = 0; i < n; ++i) {
      const Index row = (*some)[i * some->size() / n];
      const Subsegment& s = constraints.subsegments[row];
      gather_about(mesh, s, seen_in[row], about);
      samples_.push_back(
          {mesh.point(s.a), mesh.point(s.b), {}, static_cast<double>(some->size()) / static_cast<double>(n)});
      for (const VertexIndex v : about) samples_.back().about.push_back(mesh.point(v));
    }
  }
}

double ScaleForecast::n_missing(const std::array<int, 3>& exponents) const {
  const Vec3 scale{std::ldexp(1.0, exponents[0]), std::ldexp(1.0, exponents[1]), std::ldexp(1.0, exponents[2])};
  double n = 0;
  for (const Sample& sample : samples_)
    if (!is_delaunay(sample, scale)) n += sample.weight;
  return n;
}

bool ScaleForecast::is_delaunay(const Sample& sample, const Vec3& scale) {
  const auto place = [&](const Vec3& p) { return Vec3{scale.x * p.x, scale.y * p.y, scale.z * p.z}; };
  const Vec3 a = place(sample.a), b = place(sample.b), o = 0.5 * (a + b), d = 0.5 * (b - a);
  // Axes in the plane that perpendicularly bisects the subsegment, each half as long as the subsegment.
  const double x = std::fabs(d.x), y = std::fabs(d.y), z = std::fabs(d.z), squared = dot(d, d),
               length = std::sqrt(squared);
  Vec3 u = cross(d, x <= y && x <= z ? Vec3{1, 0, 0} : y <= z ? Vec3{0, 1, 0} : Vec3{0, 0, 1});
  u = length / std::sqrt(dot(u, u)) * u;
  const Vec3 w = 1 / length * cross(d, u);
  std::vector<HalfPlane> planes;
  for (const Vec3& p : sample.about) {
    const Vec3 v = place(p) - o;
    planes.push_back({dot(v, u) / squared, dot(v, w) / squared, 0.5 * (dot(v, v) - squared) / squared});
  }
  return have_common_point(planes, recovery_budget.forecast_reach);
}

}  // namespace geomesh::recover
