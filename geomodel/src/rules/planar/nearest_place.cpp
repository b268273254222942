// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/planar/nearest_place.hpp"

#include <algorithm>
#include <cmath>

#include "common/by_rounding.hpp"

namespace geomesh::geomodel {

NearestPlace::NearestPlace(const std::vector<Vec3>& places) : places_(places) {
  for (const Vec3& p : places) bounds_.add(p);
  n_ = std::max<std::size_t>(1, static_cast<std::size_t>(std::sqrt(static_cast<double>(places.size()) / 4)));
  width_ = (bounds_.max.x - bounds_.min.x) / static_cast<double>(n_);
  height_ = (bounds_.max.y - bounds_.min.y) / static_cast<double>(n_);
  cells_.resize(n_ * n_);
  for (Index i = 0; i < places.size(); ++i) cells_[row(places[i].y) * n_ + column(places[i].x)].push_back(i);
}

std::size_t NearestPlace::column(double x) const {
  return width_ > 0 ? std::min(n_ - 1, static_cast<std::size_t>(std::max(0.0, (x - bounds_.min.x) / width_))) : 0;
}

std::size_t NearestPlace::row(double y) const {
  return height_ > 0 ? std::min(n_ - 1, static_cast<std::size_t>(std::max(0.0, (y - bounds_.min.y) / height_))) : 0;
}

double NearestPlace::distance2_of_cell(std::size_t i, std::size_t j, double x, double y) const {
  // Rounding may assign a place on the rim of a cell to the next cell.
  const double x0 = bounds_.min.x + width_ * (static_cast<double>(i) - by_rounding),
               x1 = x0 + width_ * (1 + 2 * by_rounding);
  const double y0 = bounds_.min.y + height_ * (static_cast<double>(j) - by_rounding),
               y1 = y0 + height_ * (1 + 2 * by_rounding);
  const double dx = std::max({0.0, x0 - x, x - x1}), dy = std::max({0.0, y0 - y, y - y1});
  return dx * dx + dy * dy;
}

void NearestPlace::look_into(std::size_t i, std::size_t j, double x, double y, double& best, Index& found) const {
  for (const Index k : cells_[j * n_ + i]) {
    const double d2 = (places_[k].x - x) * (places_[k].x - x) + (places_[k].y - y) * (places_[k].y - y);
    if (d2 < best || (d2 == best && k < found)) best = d2, found = k;
  }
}

Index NearestPlace::find(double x, double y) const {
  const auto ci = static_cast<std::ptrdiff_t>(column(x)), cj = static_cast<std::ptrdiff_t>(row(y));
  const auto n = static_cast<std::ptrdiff_t>(n_);
  double best = std::numeric_limits<double>::infinity();
  Index found = no_index;
  for (std::ptrdiff_t ring = 0; ring < n; ++ring) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::ptrdiff_t j = std::max<std::ptrdiff_t>(0, cj - ring); j <= std::min(n - 1, cj + ring); ++j) {
      const bool whole_row = j == cj - ring || j == cj + ring;
      for (std::ptrdiff_t i = ci - ring; i <= ci + ring; i += whole_row || ring == 0 ? 1 : 2 * ring) {
        if (i < 0 || i >= n) continue;
        const double d2 = distance2_of_cell(static_cast<std::size_t>(i), static_cast<std::size_t>(j), x, y);
        nearest = std::min(nearest, d2);
        if (d2 <= best) look_into(static_cast<std::size_t>(i), static_cast<std::size_t>(j), x, y, best, found);
      }
    }
    if (nearest > best) break;
  }
  return found;
}

}  // namespace geomesh::geomodel
