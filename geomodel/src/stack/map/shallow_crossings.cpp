// SPDX-License-Identifier: GPL-3.0-or-later
#include "stack/map/shallow_crossings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace geomesh::geomodel {
namespace {

constexpr double small_slope = 0.035;  // largest slope of one horizon against another that counts as shallow: 2 degrees
constexpr double shared = 1e-5;        // fraction of the target size: horizons closer than this coincide

/// One row of a lattice of places. For each place and horizon it holds how far the lowest of the younger horizons lies
/// above that horizon; NaN if the horizon or all younger ones are absent.
class Row {
 public:
  Row(const MapSamples& samples, std::size_t n_places) : n_(samples.n_surfaces()), over_(n_places * n_) {}

  void fill(const MapSamples& samples, const MapBounds& bounds, double step, double y) {
    std::vector<double> heights(n_);
    for (std::size_t i = 0; i * n_ < over_.size(); ++i) {
      samples.heights_at({bounds.min.x + static_cast<double>(i) * step, y}, heights);
      double lowest = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < n_; ++k) {
        over_[i * n_ + k] = std::isfinite(lowest) ? lowest - heights[k] : std::nan("");
        if (!std::isnan(heights[k])) lowest = std::min(lowest, heights[k]);
      }
    }
  }
  double over(std::size_t place, std::size_t horizon) const { return over_[place * n_ + horizon]; }

 private:
  std::size_t n_;
  std::vector<double> over_;
};

/// Returns whether two horizons cross at a small angle, from their height differences at three adjacent places.
bool is_shallow(double here, double east, double north, double step, double size) {
  const double largest = std::max({std::abs(here), std::abs(east), std::abs(north)});
  const bool crosses = (here < 0) != (east < 0) || (here < 0) != (north < 0);
  return crosses && largest > shared * size && std::hypot(east - here, north - here) < small_slope * step;
}

}  // namespace

bool cross_at_small_angle(const MapSamples& samples, const MapBounds& bounds, double size) {
  const double width = bounds.max.x - bounds.min.x, step = step_between_places(bounds, size);
  const auto n_columns = static_cast<std::size_t>(width / step) + 1;
  Row row(samples, n_columns), next(samples, n_columns);
  row.fill(samples, bounds, step, bounds.min.y);
  for (double y = bounds.min.y + step; y <= bounds.max.y; y += step) {
    next.fill(samples, bounds, step, y);
    for (std::size_t i = 0; i + 1 < n_columns; ++i)
      for (std::size_t k = 1; k < samples.n_surfaces(); ++k) {
        const double here = row.over(i, k), east = row.over(i + 1, k), north = next.over(i, k);
        if (std::isnan(here + east + north)) continue;
        if (is_shallow(here, east, north, step, size)) return true;
      }
    std::swap(row, next);
  }
  return false;
}

}  // namespace geomesh::geomodel
