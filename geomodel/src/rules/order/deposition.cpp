// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/order/deposition.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "common/by_rounding.hpp"
#include "geomesh/core/error.hpp"

namespace geomesh::geomodel {

DepositedHorizons::DepositedHorizons(const std::vector<TriangulatedSurface>& surfaces, const BuiltRows& built,
                                     const ModelRules& rules) {
  std::vector<Index> rows;
  for (std::size_t i = 1; i < rules.column.size(); i += 2) {
    const auto at = std::find_if(surfaces.begin(), surfaces.end(),
                                 [&](const TriangulatedSurface& s) { return s.name == rules.column[i]; });
    if (at == surfaces.end())
      throw Error(ErrorKind::usage, "column: no surface is named " + rules.column[i] + ", which must be a horizon");
    rows.push_back(static_cast<Index>(at - surfaces.begin()));
    horizons_.push_back(horizon_of(*at, built, rows.back(), surfaces));
  }
  keepers_ = keepers_of(rules, rows, surfaces);
}

DepositedHorizons::Horizon DepositedHorizons::horizon_of(const TriangulatedSurface& surface, const BuiltRows& built,
                                                         Index row, const std::vector<TriangulatedSurface>& surfaces) {
  Horizon horizon;
  const bool has_blocks = row < built.block_of_triangle.size() && !built.block_of_triangle[row].empty();
  if (has_blocks) {
    for (const Index fault : built.parted_at[row]) horizon.faults.emplace_back(surfaces[fault]);
    horizon.sides = built.sides_of_block[row];
    if (row < built.on_both_sides.size()) horizon.on_both_sides = built.on_both_sides[row];
  }
  horizon.blocks.resize(has_blocks ? horizon.sides.size() : 1);
  for (std::size_t b = 0; b < horizon.blocks.size(); ++b) {
    TriangulatedSurface& part = horizon.blocks[b].surface;
    part.points = surface.points;
    for (Index t = 0; t < surface.triangles.size(); ++t) {
      const Index own = has_blocks ? built.block_of_triangle[row][t] : static_cast<Index>(b);
      if (own == b || own == BuiltRows::of_every_block) part.triangles.push_back(surface.triangles[t]);
    }
    if (!part.triangles.empty()) horizon.blocks[b].locator = std::make_unique<MapLocator>(part);
  }
  return horizon;
}

double DepositedHorizons::height(const Horizon& horizon, const Vec3& p) {
  constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
  std::vector<bool> sides;
  for (const FaultSides& fault : horizon.faults) sides.push_back(fault.is_above(p));
  const auto is_of_block = [&](std::size_t block) {
    for (std::size_t k = 0; k < sides.size(); ++k)
      if (sides[k] != horizon.sides[block][k] && (horizon.on_both_sides.empty() || !horizon.on_both_sides[block][k]))
        return false;
    return true;
  };
  std::size_t block = 0;
  while (!horizon.faults.empty() && block < horizon.sides.size() && !is_of_block(block)) ++block;
  if (block >= horizon.blocks.size() || !horizon.blocks[block].locator) return nowhere;
  const MapLocator& locator = *horizon.blocks[block].locator;
  double least = std::numeric_limits<double>::infinity(), most = -least;
  locator.for_each({p.x, p.y}, [&](Index triangle, bool) {
    const double z = locator.height(triangle, {p.x, p.y});
    least = std::min(least, z);
    most = std::max(most, z);
  });
  const double tiny = by_rounding * (std::abs(least) + std::abs(most));
  // A horizon with more than one height over a place overhangs there, and counts as absent.
  return most - least <= tiny ? 0.5 * (least + most) : nowhere;
}

UnitRange DepositedHorizons::units_at(const Vec3& p) const {
  std::vector<double> heights;
  for (const Horizon& horizon : horizons_) heights.push_back(height(horizon, p));
  settle_column(heights, 0, keepers_, 0);
  Index first = 0, last = static_cast<Index>(heights.size());
  for (Index h = 0; h < heights.size(); ++h) {
    if (p.z < heights[h]) first = h + 1;
    if (p.z > heights[h]) last = std::min(last, h);
  }
  return {first, last};
}

NamingRules with_heights(NamingRules naming, const std::vector<TriangulatedSurface>& surfaces, const BuiltRows& built,
                         const ModelRules& rules) {
  naming.unconformities = unconformities(surfaces, built, rules);
  if (rules.column.empty() || rules.column.size() / 2 > most_horizons) return naming;
  const auto deposited = std::make_shared<std::optional<DepositedHorizons>>();
  naming.units_at = [deposited, &surfaces, &built, &rules](const Vec3& p) {
    if (!*deposited) deposited->emplace(surfaces, built, rules);
    return (*deposited)->units_at(p);
  };
  return naming;
}

}  // namespace geomesh::geomodel
