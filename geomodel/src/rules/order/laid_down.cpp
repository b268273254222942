// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/order/laid_down.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "common/by_rounding.hpp"
#include "geomesh/core/error.hpp"

namespace geomesh::geomodel {

LaidDown::LaidDown(const std::vector<TriangulatedSurface>& surfaces, const BuiltRows& built, const ModelRules& rules) {
  std::vector<Index> rows;
  for (std::size_t i = 1; i < rules.column.size(); i += 2) {
    const auto at = std::find_if(surfaces.begin(), surfaces.end(),
                                 [&](const TriangulatedSurface& s) { return s.name == rules.column[i]; });
    if (at == surfaces.end())
      throw Error(ErrorKind::usage, "column: no surface is named " + rules.column[i] + ", which must be a horizon");
    rows.push_back(static_cast<Index>(at - surfaces.begin()));
    horizons_.push_back(horizon_of(*at, built, rows.back()));
  }
  keepers_ = keepers_of(rules, rows, surfaces);
}

LaidDown::Horizon LaidDown::horizon_of(const TriangulatedSurface& surface, const BuiltRows& built, Index row) {
  Horizon horizon;
  std::vector<Index> block(surface.triangles.size(), BuiltRows::of_every_block);
  if (row < built.block_of_triangle.size() && !built.block_of_triangle[row].empty()) {
    horizon.between = built.throw_blocks[row];
    if (row < built.field_of_block.size()) horizon.field_of_block = built.field_of_block[row];
    std::ranges::copy(built.block_of_triangle[row], block.begin());
  }
  if (row < built.first_step.size() && built.first_step[row] < block.size()) block.resize(built.first_step[row]);
  Index n = horizon.between ? horizon.between->framework.n_blocks() : 1;
  for (const Index own : block)
    if (own != BuiltRows::of_every_block) n = std::max(n, own + 1);
  horizon.blocks.resize(n);
  for (std::size_t b = 0; b < horizon.blocks.size(); ++b) {
    TriangulatedSurface& part = horizon.blocks[b].surface;
    part.points = surface.points;
    for (Index t = 0; t < block.size(); ++t)
      if (block[t] == b || block[t] == BuiltRows::of_every_block) part.triangles.push_back(surface.triangles[t]);
    if (!part.triangles.empty()) horizon.blocks[b].locator = std::make_unique<MapLocator>(part);
  }
  return horizon;
}

double LaidDown::height(const Horizon& horizon, const Vec3& p) {
  constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
  const Index block = horizon.between ? owner_at(horizon.between->framework, horizon.field_of_block, p) : 0;
  if (block >= horizon.blocks.size() || !horizon.blocks[block].locator) return nowhere;
  const MapLocator& locator = *horizon.blocks[block].locator;
  double least = std::numeric_limits<double>::infinity(), most = -least;
  locator.for_each({p.x, p.y}, [&](Index triangle, bool) {
    const double z = locator.height(triangle, {p.x, p.y});
    least = std::min(least, z);
    most = std::max(most, z);
  });
  const double tiny = by_rounding * (std::abs(least) + std::abs(most));
  // A horizon with more than one height there overhangs, and counts as absent.
  return most - least <= tiny ? 0.5 * (least + most) : nowhere;
}

UnitRange LaidDown::units_at(const Vec3& p) const {
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
  const auto laid_down = std::make_shared<std::optional<LaidDown>>();
  naming.units_at = [laid_down, &surfaces, &built, &rules](const Vec3& p) {
    if (!*laid_down) laid_down->emplace(surfaces, built, rules);
    return (*laid_down)->units_at(p);
  };
  return naming;
}

}  // namespace geomesh::geomodel
