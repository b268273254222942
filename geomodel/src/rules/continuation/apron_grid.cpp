// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/continuation/apron_grid.hpp"

#include <algorithm>
#include <cmath>

#include "rules/planar/planar_fill.hpp"

namespace geomesh::geomodel {
namespace {

/// Smallest spacing of grid points as a fraction of the width of the strip that continues a surface: about ten rows.
constexpr double least_step = 1.0 / 8;
/// Smallest distance of grid points from the border, as a fraction of their spacing.
constexpr double room_at_border = 0.5;

}  // namespace

ApronGrid::ApronGrid(const TriangulatedSurface& surface, Index row, const BorderChain& chain, const Walls& walls,
                     const ApronSetting& setting)
    : row_(row),
      border_(chain),
      walls_(walls),
      frame_(setting.frame),
      within_(setting.within),
      bounds_(setting.bounds),
      chain_(surface, chain, setting.frame, setting.within),
      step_(std::clamp(chain_.mean_edge(), least_step * within_, within_)) {
  const auto last_edge = static_cast<Index>(chain_.n_edges() - 1);
  for (Index k = 0; k < chain_.points().size(); ++k) {
    const Vec3& p = chain_.points()[k];
    nodes_.push_back({{p.x, p.y}, surface.points[chain.vertices[k]], 0, std::min(k, last_edge)});
  }
  n_border_ = static_cast<Index>(nodes_.size());
  add_grid();
  if (nodes_.size() == n_border_) return;
  crosses_itself_ = !find_triangles();
  if (!crosses_itself_) leave_out_open();
}

ApronNode ApronGrid::node_at(const Vec2& p, const ChainInPlane::Nearest& at) const {
  return {p, frame_.to_model({p.x, p.y, chain_.height(p, at)}), at.distance, at.edge};
}
/// Returns whether a bounding surface hides the node from a border place, or separates that place from the surface.
bool ApronGrid::is_hidden(const ApronNode& node, const ChainInPlane::Nearest& at) {
  const std::uint8_t cut_off = border_.cut_off[at.edge];
  if (cut_off == 3) return true;
  const Vec3 foot = frame_.to_model(chain_.foot(at));
  std::optional<Walls::Hit> hit;
  if (cut_off != 0) {
    const std::size_t kept = cut_off == 1 ? chain_.end_of(at.edge) : at.edge;
    hit = walls_.first_surface(nodes_[kept].point, foot, row_);
  }
  if (!hit) hit = walls_.first_surface(foot, node.point, row_);
  if (hit) crossed_.insert(hit->surface);
  return hit.has_value();
}

/// Adds grid points beside the border that is continued, on a grid that is fixed in space whatever the border.
void ApronGrid::add_grid() {
  Vec2 low = nodes_.front().place, high = low;
  for (const ApronNode& n : nodes_) {
    low = {std::min(low.x, n.place.x), std::min(low.y, n.place.y)};
    high = {std::max(high.x, n.place.x), std::max(high.y, n.place.y)};
  }
  const double reach = within_ + step_;
  const auto first = [&](double v) { return static_cast<std::int64_t>(std::floor((v - reach) / step_)); };
  const auto last = [&](double v) { return static_cast<std::int64_t>(std::ceil((v + reach) / step_)); };
  for (std::int64_t j = first(low.y); j <= last(high.y); ++j)
    for (std::int64_t i = first(low.x); i <= last(high.x); ++i)
      add_node({static_cast<double>(i) * step_, static_cast<double>(j) * step_}, reach);
}

void ApronGrid::add_node(const Vec2& p, double reach) {
  const auto nearest = chain_.nearest(p);
  if (!nearest || nearest->distance < room_at_border * step_ || nearest->distance > reach ||
      !chain_.is_outside(p, *nearest))
    return;
  // Beyond the distance of continuation, a grid node counts as visible only if no bounding surface hides it from the
  // nearest border edge.
  for (const ChainInPlane::Nearest& at : chain_.all_near(p, reach)) {
    if (at.distance > within_ && at.distance > nearest->distance) break;
    const ApronNode node = node_at(p, at);
    if (is_hidden(node, at)) continue;
    nodes_.push_back(node);
    return;
  }
  nodes_.push_back(node_at(p, *nearest));
  nodes_.back().is_seen = false;
}

/// Triangulates the border's vertices and the grid. Returns false if the border crosses itself in the plane.
bool ApronGrid::find_triangles() {
  std::vector<std::pair<Index, Index>> constraints;
  for (std::size_t e = 0; e < chain_.n_edges(); ++e)
    constraints.emplace_back(static_cast<Index>(e), static_cast<Index>(chain_.end_of(e)));
  std::vector<Vec2> places;
  for (const ApronNode& n : nodes_) places.push_back(n.place);
  const auto all = triangulate_plane(places, constraints);
  if (!all) return false;
  for (const PlanarTriangle& t : *all) {
    const auto& v = t.vertices;
    const Vec2 centre{(places[v[0]].x + places[v[1]].x + places[v[2]].x) / 3,
                      (places[v[0]].y + places[v[1]].y + places[v[2]].y) / 3};
    const auto at = chain_.nearest(centre);
    if (at && at->distance <= within_ + step_ && chain_.is_outside(centre, *at)) triangles_.push_back(v);
  }
  return true;
}

bool ApronGrid::is_in_model(const Vec3& p) const {
  return p.x > bounds_.min.x && p.y > bounds_.min.y && p.z > bounds_.min.z && p.x < bounds_.max.x &&
         p.y < bounds_.max.y && p.z < bounds_.max.z;
}

/// Removes the triangles at border edges from which a grid node in the model beyond the distance of continuation is
/// visible: no bounding surface stops the surface there, and the border remains open.
void ApronGrid::leave_out_open() {
  std::vector<std::uint8_t> is_open(chain_.n_edges(), 0);
  for (Index v = n_border_; v < nodes_.size(); ++v)
    if (nodes_[v].is_seen && nodes_[v].distance > within_ && is_in_model(nodes_[v].point)) is_open[nodes_[v].edge] = 1;
  std::erase_if(triangles_, [&](const Corners& t) {
    return std::any_of(t.begin(), t.end(), [&](Index v) { return v >= n_border_ && is_open[nodes_[v].edge]; });
  });
}

}  // namespace geomesh::geomodel
