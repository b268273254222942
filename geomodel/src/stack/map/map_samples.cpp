// SPDX-License-Identifier: GPL-3.0-or-later
#include "stack/map/map_samples.hpp"

#include <algorithm>
#include <cmath>

namespace geomesh::geomodel {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t fewest_for_plane = 6;
constexpr std::size_t samples_a_bin = 3;
// Distance beside a surface up to which a place counts as on its border, as a fraction of the sample spacing.
constexpr double by_rounding = 1e-4;

/// Sums for the normal equations of a plane that is fitted to samples around a centre.
struct PlaneSums {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0, z = 0, xz = 0, yz = 0;
  void add(double px, double py, double pz) {
    n += 1, x += px, y += py, xx += px * px, xy += px * py, yy += py * py, z += pz, xz += px * pz, yz += py * pz;
  }
  /// Returns the height of the fitted plane at the centre; NaN if the samples lie nearly on a line.
  double at_centre() const {
    const double mx = x / n, my = y / n, mz = z / n;
    const double cxx = xx / n - mx * mx, cxy = xy / n - mx * my, cyy = yy / n - my * my;
    const double cxz = xz / n - mx * mz, cyz = yz / n - my * mz;
    const double det = cxx * cyy - cxy * cxy, trace = cxx + cyy;
    if (!(det > 1e-3 * trace * trace)) return nan;
    return mz - (mx * (cxz * cyy - cyz * cxy) + my * (cyz * cxx - cxz * cxy)) / det;
  }
};

}  // namespace

double step_between_places(const MapBounds& bounds, double size) {
  constexpr double step_of_size = 1.0 / 8, most_places = 250000;
  const double area = (bounds.max.x - bounds.min.x) * (bounds.max.y - bounds.min.y);
  return std::max(step_of_size * size, std::sqrt(area / most_places));
}

void MapBounds::add(Vec2 p) {
  if (empty()) {
    min = max = p;
    return;
  }
  min = {std::min(min.x, p.x), std::min(min.y, p.y)};
  max = {std::max(max.x, p.x), std::max(max.y, p.y)};
}

MapSamples::MapSamples(const std::vector<const TriangulatedSurface*>& surfaces, const MapBounds& bounds)
    : surfaces_(surfaces), overhangs_(surfaces.size(), 0), bounds_(bounds) {
  for (const TriangulatedSurface* s : surfaces) locators_.push_back(std::make_unique<MapLocator>(*s));
  collect(surfaces, bounds);
  heights_.resize(places_.size() * n_surfaces());
  for (std::size_t i = 0; i < places_.size(); ++i)
    for (std::size_t k = 0; k < n_surfaces(); ++k) {
      const MapLocator::Hit hit = locators_[k]->find(places_[i]);
      heights_[i * n_surfaces() + k] = hit.count > 0 ? locators_[k]->height(hit.triangle, places_[i]) : nan;
      if (hit.count > 1 && hit.strictly) overhangs_[k] = 1;
    }
  const double area = (bounds.max.x - bounds.min.x) * (bounds.max.y - bounds.min.y);
  spacing_ = std::sqrt(area / static_cast<double>(std::max<std::size_t>(1, places_.size())));
  fill_bins(bounds);
}

void MapSamples::collect(const std::vector<const TriangulatedSurface*>& surfaces, const MapBounds& bounds) {
  for (const TriangulatedSurface* s : surfaces) {
    std::vector<char> used(s->points.size(), 0);
    for (const Triangle& t : s->triangles)
      for (const VertexIndex v : t) used[v] = 1;
    for (std::size_t v = 0; v < used.size(); ++v) {
      const Vec2 p{s->points[v].x, s->points[v].y};
      if (used[v] && bounds.holds(p)) places_.push_back(p);
    }
  }
  const auto before = [](Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
  std::sort(places_.begin(), places_.end(), before);
  places_.erase(std::unique(places_.begin(), places_.end()), places_.end());
}

std::size_t MapSamples::bin_of(double at, double from, std::size_t n) const {
  const double bin = (at - from) / (spacing_ * std::sqrt(static_cast<double>(samples_a_bin)));
  return std::min(n - 1, static_cast<std::size_t>(std::max(0.0, bin)));
}

void MapSamples::fill_bins(const MapBounds& bounds) {
  const double width = spacing_ * std::sqrt(static_cast<double>(samples_a_bin));
  n_columns_ = 1 + static_cast<std::size_t>((bounds.max.x - bounds.min.x) / width);
  n_rows_ = 1 + static_cast<std::size_t>((bounds.max.y - bounds.min.y) / width);
  bin_begin_.assign(n_columns_ * n_rows_ + 1, 0);
  const auto bin = [&](Vec2 p) {
    return bin_of(p.y, bounds.min.y, n_rows_) * n_columns_ + bin_of(p.x, bounds.min.x, n_columns_);
  };
  for (const Vec2 p : places_) ++bin_begin_[bin(p) + 1];
  for (std::size_t b = 1; b < bin_begin_.size(); ++b) bin_begin_[b] += bin_begin_[b - 1];
  binned_.resize(places_.size());
  std::vector<Index> next(bin_begin_.begin(), bin_begin_.end() - 1);
  for (Index i = 0; i < places_.size(); ++i) binned_[next[bin(places_[i])]++] = i;
}

double MapSamples::border_reach() const { return by_rounding * spacing_; }

void MapSamples::heights_at(Vec2 p, std::span<double> heights) const {
  const double step = border_reach();
  for (std::size_t k = 0; k < n_surfaces(); ++k) {
    MapLocator::Hit hit = locators_[k]->find(p);
    for (int way = 0; way < 4 && hit.count == 0; ++way)
      hit = locators_[k]->find({p.x + (way % 2 == 0 ? step : -step), p.y + (way / 2 == 0 ? step : -step)});
    heights[k] = hit.count > 0 ? locators_[k]->height(hit.triangle, p) : nan;
  }
}

void MapSamples::fitted_heights(Vec2 p, double radius, std::span<double> heights) const {
  heights_at(p, heights);
  if (!(radius > spacing_)) return;
  std::vector<PlaneSums> sums(n_surfaces());
  const std::size_t i0 = bin_of(p.x - radius, bounds_.min.x, n_columns_),
                    i1 = bin_of(p.x + radius, bounds_.min.x, n_columns_);
  const std::size_t j0 = bin_of(p.y - radius, bounds_.min.y, n_rows_),
                    j1 = bin_of(p.y + radius, bounds_.min.y, n_rows_);
  for (std::size_t j = j0; j <= j1; ++j)
    for (Index b = bin_begin_[j * n_columns_ + i0]; b < bin_begin_[j * n_columns_ + i1 + 1]; ++b) {
      const Vec2 q = places_[binned_[b]];
      const double dx = q.x - p.x, dy = q.y - p.y;
      if (dx * dx + dy * dy > radius * radius) continue;
      const std::span<const double> given = this->heights(binned_[b]);
      for (std::size_t k = 0; k < sums.size(); ++k)
        if (!std::isnan(given[k])) sums[k].add(dx, dy, given[k]);
    }
  for (std::size_t k = 0; k < sums.size(); ++k) {
    if (std::isnan(heights[k]) || sums[k].n < static_cast<double>(fewest_for_plane)) continue;
    const double fitted = sums[k].at_centre();
    if (!std::isnan(fitted)) heights[k] = fitted;
  }
}

}  // namespace geomesh::geomodel
