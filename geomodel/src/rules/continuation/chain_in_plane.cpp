// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/continuation/chain_in_plane.hpp"

#include <algorithm>
#include <cmath>

#include "rules/extend/extend.hpp"

namespace geomesh::geomodel {

ChainInPlane::ChainInPlane(const TriangulatedSurface& surface, const BorderChain& chain, const Frame& frame,
                           double within)
    : goes_on_(chain.goes_on), closed_(chain.closed), cell_(within) {
  for (const VertexIndex v : chain.vertices) points_.push_back(frame.to_frame(surface.points[v]));
  find_slopes(surface, chain, frame);
  smooth_slopes(within);
  for (Index e = 0; e < n_edges(); ++e) {
    const Vec3 &a = points_[e], &b = points_[end_of(e)];
    const double reach = 2 * within;
    const auto low = cell_of({std::min(a.x, b.x) - reach, std::min(a.y, b.y) - reach}),
               high = cell_of({std::max(a.x, b.x) + reach, std::max(a.y, b.y) + reach});
    for (std::int64_t j = low.second; j <= high.second; ++j)
      for (std::int64_t i = low.first; i <= high.first; ++i) edges_in_cell_[{i, j}].push_back(e);
  }
}

std::pair<std::int64_t, std::int64_t> ChainInPlane::cell_of(const Vec2& p) const {
  return {static_cast<std::int64_t>(std::floor(p.x / cell_)), static_cast<std::int64_t>(std::floor(p.y / cell_))};
}

double ChainInPlane::length(std::size_t edge) const {
  const Vec3 &a = points_[edge], &b = points_[end_of(edge)];
  return std::hypot(b.x - a.x, b.y - a.y);
}

double ChainInPlane::mean_edge() const {
  double sum = 0;
  for (std::size_t e = 0; e < n_edges(); ++e) sum += length(e);
  return sum / static_cast<double>(n_edges());
}

void ChainInPlane::find_slopes(const TriangulatedSurface& surface, const BorderChain& chain, const Frame& frame) {
  for (std::size_t e = 0; e < chain.n_edges(); ++e) {
    const Triangle& t = surface.triangles[chain.triangles[e]];
    const Vec3 a = frame.to_frame(surface.points[t[0]]), b = frame.to_frame(surface.points[t[1]]),
               c = frame.to_frame(surface.points[t[2]]);
    Vec3 n = cross(b - a, c - a);
    if (n.z < 0) n = -1.0 * n;
    const bool is_steep = std::hypot(n.x, n.y) > steepest_slope * n.z;
    slopes_.push_back(is_steep ? Vec2{0, 0} : Vec2{-n.x / n.z, -n.y / n.z});
    const Vec3 &p = points_[e], &q = points_[end_of(e)];
    const double dx = q.x - p.x, dy = q.y - p.y, l = std::hypot(dx, dy);
    Vec2 out = l > 0 ? Vec2{dy / l, -dx / l} : Vec2{0, 0};
    const Vec3 centre = (1.0 / 3) * (a + b + c);
    if (out.x * (centre.x - p.x) + out.y * (centre.y - p.y) > 0) out = {-out.x, -out.y};
    out_.push_back(out);
  }
}

void ChainInPlane::smooth_slopes(double within) {
  const std::size_t n = n_edges();
  std::vector<Vec2> smooth(n);
  for (std::size_t e = 0; e < n; ++e) {
    double weight = length(e);
    Vec2 sum{weight * slopes_[e].x, weight * slopes_[e].y};
    for (const bool forward : {false, true}) {
      double reach = 0;
      for (std::size_t step = 1; step < n && reach < within; ++step) {
        if (!closed_ && (forward ? e + step >= n : step > e)) break;
        const std::size_t other = (forward ? e + step : e + n - step) % n;
        const double l = length(other);
        sum = {sum.x + l * slopes_[other].x, sum.y + l * slopes_[other].y};
        weight += l;
        reach += l;
      }
    }
    smooth[e] = weight > 0 ? Vec2{sum.x / weight, sum.y / weight} : slopes_[e];
  }
  slopes_ = std::move(smooth);
}

ChainInPlane::Nearest ChainInPlane::nearest_on(Index e, const Vec2& p) const {
  const Vec3 &a = points_[e], &b = points_[end_of(e)];
  const double dx = b.x - a.x, dy = b.y - a.y, l2 = dx * dx + dy * dy;
  const double t = l2 > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / l2, 0.0, 1.0) : 0.0;
  return {e, t, std::hypot(p.x - (a.x + t * dx), p.y - (a.y + t * dy))};
}

std::optional<ChainInPlane::Nearest> ChainInPlane::nearest(const Vec2& p) const {
  const auto at = edges_in_cell_.find(cell_of(p));
  if (at == edges_in_cell_.end()) return std::nullopt;
  std::optional<Nearest> best;
  for (const Index e : at->second)
    if (const Nearest near = nearest_on(e, p); !best || near.distance < best->distance) best = near;
  return best;
}

std::vector<ChainInPlane::Nearest> ChainInPlane::all_near(const Vec2& p, double most) const {
  std::vector<Nearest> found;
  const auto at = edges_in_cell_.find(cell_of(p));
  if (at == edges_in_cell_.end()) return found;
  for (const Index e : at->second)
    if (const Nearest near = nearest_on(e, p); near.distance <= most) found.push_back(near);
  std::sort(found.begin(), found.end(), [](const Nearest& a, const Nearest& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.edge < b.edge;
  });
  return found;
}

bool ChainInPlane::is_outside(const Vec2& p, const Nearest& at) const {
  const std::size_t n = n_edges();
  const Vec3& a = points_[at.edge];
  const Vec3& b = points_[end_of(at.edge)];
  Vec2 out = out_[at.edge];
  bool goes_on = goes_on_[at.edge] != 0;
  const bool is_first = at.along <= 0, is_last = at.along >= 1;
  if (is_first || is_last) {  // if the nearest point is a vertex of the chain, both of its edges are tested
    if (!closed_ && (is_first ? at.edge == 0 : at.edge + 1 == n)) return false;
    const std::size_t other = (is_first ? at.edge + n - 1 : at.edge + 1) % n;
    out = {out.x + out_[other].x, out.y + out_[other].y};
    goes_on = goes_on || goes_on_[other] != 0;
  }
  if (!goes_on) return false;
  const double x = a.x + at.along * (b.x - a.x), y = a.y + at.along * (b.y - a.y);
  return out.x * (p.x - x) + out.y * (p.y - y) > 0;
}

Vec3 ChainInPlane::foot(const Nearest& at) const {
  const Vec3 &a = points_[at.edge], &b = points_[end_of(at.edge)];
  return a + at.along * (b - a);
}

double ChainInPlane::height(const Vec2& p, const Nearest& at) const {
  const Vec3 from = foot(at);
  return from.z + slopes_[at.edge].x * (p.x - from.x) + slopes_[at.edge].y * (p.y - from.y);
}

}  // namespace geomesh::geomodel
