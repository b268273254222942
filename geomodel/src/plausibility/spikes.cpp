// SPDX-License-Identifier: GPL-3.0-or-later
#include "plausibility/spikes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

#include "geomesh/geomodel/words.hpp"

namespace geomesh::geomodel {
namespace {

constexpr double least_over_steps = 10;    ///< least height of a spike, relative to the height differences around it
constexpr double least_over_range = 0.25;  ///< least height of a spike, relative to the horizon's height range
constexpr double part_of_each_end = 0.05;  ///< share of a horizon's vertices ignored at each end of its height range
constexpr std::size_t least_neighbours = 3;
constexpr std::size_t least_vertices = 100;  ///< surfaces with fewer vertices are skipped: a spike may be a real summit

struct Around {
  double above = std::numeric_limits<double>::infinity();  ///< height above the vertex's highest neighbour
  double below = std::numeric_limits<double>::infinity();  ///< depth below the vertex's lowest neighbour
  double step = 0;  ///< largest height difference between two neighbours of the vertex that are joined by an edge
  std::size_t n_triangles = 0;
};

std::vector<Around> surroundings(const TriangulatedSurface& s) {
  std::vector<Around> around(s.points.size());
  for (const Triangle& t : s.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      Around& a = around[t[k]];
      const double z = s.points[t[k]].z, p = s.points[t[(k + 1) % 3]].z, q = s.points[t[(k + 2) % 3]].z;
      a.above = std::min({a.above, z - p, z - q});
      a.below = std::min({a.below, p - z, q - z});
      a.step = std::max(a.step, std::abs(p - q));
      ++a.n_triangles;
    }
  return around;
}

/// Returns the value below which the share `part` of the values lies. Changes their order.
double quantile(std::vector<double>& values, double part) {
  const auto row = static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + row, values.end());
  return values[static_cast<std::size_t>(row)];
}

}  // namespace

Spikes find_spikes(const TriangulatedSurface& surface) {
  Spikes spikes;
  const std::vector<Around> around = surroundings(surface);
  std::vector<double> heights, steps;
  for (std::size_t v = 0; v < around.size(); ++v) {
    if (around[v].n_triangles == 0) continue;
    heights.push_back(surface.points[v].z);
    steps.push_back(around[v].step);
  }
  if (heights.size() < least_vertices) return spikes;
  const double low = quantile(heights, part_of_each_end), high = quantile(heights, 1 - part_of_each_end);
  const double least = std::max(least_over_range * (high - low), least_over_steps * quantile(steps, 0.5));
  for (std::size_t v = 0; v < around.size(); ++v) {
    const Around& a = around[v];
    const double height = std::max(a.above, a.below);
    if (a.n_triangles < least_neighbours || !(height > least) || !(height > least_over_steps * a.step)) continue;
    if (++spikes.n == 1 || height > std::abs(spikes.height)) {
      spikes.place = surface.points[v];
      spikes.height = a.above > 0 ? a.above : -a.below;
      spikes.around = a.step;
    }
  }
  return spikes;
}

std::string spikes_words(const Spikes& spikes, const Vec3& origin) {
  char place[120];
  std::snprintf(place, sizeof place, "(%.8g, %.8g, %.6g)", spikes.place.x + origin.x, spikes.place.y + origin.y,
                spikes.place.z + origin.z);
  const std::string count = spikes.n == 1 ? "1 vertex stands" : std::to_string(spikes.n) + " vertices stand";
  return count + " far above or below all neighbours" + (spikes.n == 1 ? ": " : ", most the one ") +
         short_words(std::abs(spikes.height)) + (spikes.height > 0 ? " above" : " below") + " them at " + place +
         ", among which steps are " + short_words(spikes.around) + " at most";
}

}  // namespace geomesh::geomodel
