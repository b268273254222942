// SPDX-License-Identifier: GPL-3.0-or-later
#include "stack/sheets/column_heights.hpp"

#include <algorithm>
#include <cmath>

namespace geomesh::geomodel {
namespace {

/// The next row from `row` on that has a height.
std::size_t present_from(std::span<const double> heights, std::size_t row) {
  while (row < heights.size() && std::isnan(heights[row])) ++row;
  return row;
}

/// A pair of neighbours among the horizons that are there, with all pairs of the stack between them.
struct Neighbours {
  std::size_t above, below;
  bool is_merged(MergedPairs merged) const {
    for (std::size_t k = above; k < below; ++k)
      if (!(merged >> k & 1)) return false;
    return true;
  }
  bool older_keeps(const std::vector<Keeper>& keepers) const {
    return std::any_of(keepers.begin() + static_cast<std::ptrdiff_t>(above),
                       keepers.begin() + static_cast<std::ptrdiff_t>(below),
                       [](Keeper k) { return k == Keeper::older; });
  }
};

}  // namespace

void settle_column(std::span<double> heights, MergedPairs merged, const std::vector<Keeper>& keepers, double gap) {
  std::vector<Neighbours> pairs;
  for (std::size_t above = present_from(heights, 0); above < heights.size();) {
    const std::size_t below = present_from(heights, above + 1);
    if (below < heights.size()) pairs.push_back({above, below});
    above = below;
  }
  for (auto pair = pairs.rbegin(); pair != pairs.rend(); ++pair) {  // younger ones rise onto older ones that stay
    if (!pair->older_keeps(keepers)) continue;
    const double least = heights[pair->below];
    heights[pair->above] = pair->is_merged(merged) ? least : std::max(heights[pair->above], least + gap);
  }
  for (const Neighbours& pair : pairs) {  // then all older ones sink as far as they must
    const double most = heights[pair.above];
    heights[pair.below] = pair.is_merged(merged) ? most : std::min(heights[pair.below], most - gap);
  }
}

}  // namespace geomesh::geomodel
