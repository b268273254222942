// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/column_order.hpp"

#include <algorithm>

#include "rules/planar/map_locator.hpp"

namespace geomesh::geomodel {
namespace {

constexpr std::size_t most_samples = 2000;  // number of triangles of the younger horizon that are sampled at most
constexpr double nearly_everywhere = 0.9;

/// Counts the sampled triangle centres of the younger horizon that lie above and below the older one.
struct Tally {
  std::size_t above = 0, below = 0;
};

Tally compare(const TriangulatedSurface& younger, const TriangulatedSurface& older) {
  const MapLocator locator(older);
  const std::size_t step = 1 + younger.triangles.size() / most_samples;
  Tally tally;
  for (std::size_t t = 0; t < younger.triangles.size(); t += step) {
    const Triangle& v = younger.triangles[t];
    const Vec3 p = (1.0 / 3) * (younger.points[v[0]] + younger.points[v[1]] + younger.points[v[2]]);
    const auto height = locator.height({p.x, p.y});
    if (height && *height != p.z) ++(p.z > *height ? tally.above : tally.below);
  }
  return tally;
}

/// Returns whether the surface lies entirely above the box, or entirely below it.
bool is_beyond(const TriangulatedSurface& surface, const Box3& box) {
  return std::all_of(surface.points.begin(), surface.points.end(), [&](const Vec3& p) { return p.z > box.max.z; }) ||
         std::all_of(surface.points.begin(), surface.points.end(), [&](const Vec3& p) { return p.z < box.min.z; });
}

}  // namespace

void warn_of_column_order(const std::vector<TriangulatedSurface>& surfaces, const ModelRules& rules,
                          const BuildLog& log) {
  if (rules.on_crossing != OnCrossing::leave) return;
  const auto row_of = [&](const std::string& name) {
    return static_cast<std::size_t>(
        std::find_if(surfaces.begin(), surfaces.end(), [&](const auto& s) { return s.name == name; }) -
        surfaces.begin());
  };
  for (std::size_t i = 1; i + 2 < rules.column.size(); i += 2) {
    const std::size_t younger = row_of(rules.column[i]), older = row_of(rules.column[i + 2]);
    // Horizons of the column that do not exist were reported when the column was read.
    if (younger == surfaces.size() || older == surfaces.size()) continue;
    if (rules.column[i] == rules.topography || rules.of(younger).base == BaseRule::erode ||
        rules.of(older).base == BaseRule::onlap)
      continue;
    // Skips horizons entirely above or below the model: usually their z is wrong, which was reported already.
    if (rules.box && (is_beyond(surfaces[younger], *rules.box) || is_beyond(surfaces[older], *rules.box))) continue;
    const Tally tally = compare(surfaces[younger], surfaces[older]);
    if (static_cast<double>(tally.below) > nearly_everywhere * static_cast<double>(tally.above + tally.below))
      log.warnings.push_back("horizon " + surfaces[younger].name + " is listed before " + surfaces[older].name +
                             " in the column, as the younger one, but lies below it" +
                             (tally.above == 0 ? " everywhere" : " nearly everywhere") +
                             ": is the column in the order from the youngest to the oldest, and does z count up (z: "
                             "depth where it counts down)?");
  }
}

}  // namespace geomesh::geomodel
