// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/order/column_heights.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace geomesh::geomodel {
namespace {

bool holds(const std::vector<std::string>& names, const TriangulatedSurface& surface) {
  return std::find(names.begin(), names.end(), surface.name) != names.end();
}

Keeper keeper_of(const ModelRules& rules, Index younger, Index older,
                 const std::vector<TriangulatedSurface>& surfaces) {
  if (surfaces[younger].name == rules.topography) return Keeper::younger;
  if (surfaces[older].name == rules.floor) return Keeper::older;
  if (holds(rules.of(younger).holds_above, surfaces[older])) return Keeper::older;
  if (holds(rules.of(older).holds_below, surfaces[younger])) return Keeper::younger;
  if (rules.of(younger).base == BaseRule::erode) return Keeper::younger;
  if (rules.of(older).base == BaseRule::onlap) return Keeper::older;
  const bool younger_moves = rules.on_crossing == OnCrossing::clip_younger ||
                             (rules.on_crossing != OnCrossing::clip_older && rules.thin_layers == ThinLayers::collapse);
  return younger_moves ? Keeper::older : Keeper::younger;
}

/// The horizons that are present at a place of the map, youngest first.
struct Present {
  std::array<std::size_t, most_horizons> row;
  std::size_t n = 0;
  explicit Present(std::span<const double> heights) {
    for (std::size_t k = 0; k < heights.size(); ++k)
      if (!std::isnan(heights[k])) row[n++] = k;
  }
};

/// Returns whether all pairs of neighbouring horizons from `above` to `below` are merged.
bool are_merged(MergedPairs merged, std::size_t above, std::size_t below) {
  for (std::size_t k = above; k < below; ++k)
    if (!(merged >> k & 1)) return false;
  return true;
}

/// Raises the i-th horizon present at the place, so that it lies on those older ones that keep their height.
void rise(std::span<double> heights, const Present& there, std::size_t i, MergedPairs merged, const Keepers& keepers,
          double gap) {
  const std::size_t own = there.row[i];
  double room = 0;
  for (std::size_t j = i + 1; j < there.n; ++j) {
    const std::size_t below = there.row[j];
    const bool is_merged = are_merged(merged, there.row[j - 1], below);
    if (!is_merged) room += gap;
    if (keepers.of(own, below) != Keeper::older) continue;
    const bool is_one = j == i + 1 && is_merged;
    heights[own] = is_one ? heights[below] : std::max(heights[own], heights[below] + room);
  }
}

/// Lowers older horizons, which are in order among themselves, below the i-th horizon present at the place.
void sink_below(std::span<double> heights, const Present& there, std::size_t i, MergedPairs merged, double gap) {
  for (std::size_t j = i; j + 1 < there.n; ++j) {
    const std::size_t above = there.row[j], below = there.row[j + 1];
    const bool is_one = are_merged(merged, above, below);
    const double most = is_one ? heights[above] : std::min(heights[below], heights[above] - gap);
    if (heights[below] == most) return;
    heights[below] = most;
  }
}

}  // namespace

Keepers keepers_of(const ModelRules& rules, const std::vector<Index>& rows,
                   const std::vector<TriangulatedSurface>& surfaces) {
  Keepers keepers(rows.size(), Keeper::younger);
  for (std::size_t younger = 0; younger < rows.size(); ++younger)
    for (std::size_t older = younger + 1; older < rows.size(); ++older)
      keepers.set(younger, older, keeper_of(rules, rows[younger], rows[older], surfaces));
  return keepers;
}

void settle_column(std::span<double> heights, MergedPairs merged, const Keepers& keepers, double gap) {
  const Present there(heights);
  for (std::size_t i = there.n; i-- > 0;) {
    rise(heights, there, i, merged, keepers, gap);
    sink_below(heights, there, i, merged, gap);
  }
}

}  // namespace geomesh::geomodel
