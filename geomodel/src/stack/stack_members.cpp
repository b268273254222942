// SPDX-License-Identifier: GPL-3.0-or-later
#include "stack/stack_members.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "rules/planar/map_locator.hpp"
#include "rules/planar/single_valued.hpp"
#include "stack/map/map_samples.hpp"

namespace geomesh::geomodel {
namespace {

// Least ratio of the volumes above and below another horizon for a horizon to count as lying over it.
constexpr double far_over = 4;
// Width of islands in which two horizons cross, in target sizes, below which a mesh cannot resolve them.
constexpr double narrow = 3;

Stack named_stack(const std::vector<TriangulatedSurface>& surfaces, const ModelRules& rules) {
  Stack stack;
  std::vector<std::string> names, units;
  for (std::size_t i = 1; i < rules.column.size(); i += 2) names.push_back(rules.column[i]);
  for (std::size_t i = 2; i + 1 < rules.column.size(); i += 2) units.push_back(rules.column[i]);
  const auto stands = [&](const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  if (!rules.topography.empty() && !stands(rules.topography)) {
    if (!names.empty()) units.insert(units.begin(), rules.column.front());
    names.insert(names.begin(), rules.topography);
  }
  if (!rules.floor.empty() && !stands(rules.floor)) {
    if (!names.empty() && !rules.column.empty()) units.push_back(rules.column.back());
    names.push_back(rules.floor);
  }
  for (const std::string& name : names)
    for (Index s = 0; s < surfaces.size(); ++s)
      if (surfaces[s].name == name) stack.rows.push_back(s);
  stack.units = std::move(units);
  return stack;
}

struct Lie {
  double volume_over = 0, volume_under = 0;
  /// Area in which one horizon lies below another, and total length of the lines in which both horizons cross.
  double area_under = 0, crossing = 0;

  bool is_over() const { return volume_over > far_over * volume_under; }
  /// Returns the mean width of islands; a strip of width w and length l has the area w l and an outline of length 2 l.
  double width_of_islands() const { return crossing > 0 ? 2 * area_under / crossing : 0; }
};

/// Compares the heights of two horizons on a lattice over the model's outline in the map. In the mean over all
/// directions, a line is pi / 4 times as long as the lattice edges that it crosses.
Lie compare(const TriangulatedSurface& upper, const TriangulatedSurface& lower, const StackRules& asked) {
  MapBounds bounds;
  for (const Vec2& p : asked.outline) bounds.add(p);
  const double width = bounds.max.x - bounds.min.x, step = step_between_places(bounds, asked.size);
  const MapLocator over(upper), under(lower);
  const auto n_columns = static_cast<std::size_t>(width / step) + 1;
  std::vector<std::optional<double>> row(n_columns), last(n_columns);
  Lie lie;
  const auto cross = [&](const std::optional<double>& a, const std::optional<double>& b) {
    if (a && b && (*a < 0) != (*b < 0)) lie.crossing += std::numbers::pi / 4 * step;
  };
  for (double y = bounds.min.y; y <= bounds.max.y; y += step) {
    for (std::size_t i = 0; i < n_columns; ++i) {
      const Vec2 p{bounds.min.x + static_cast<double>(i) * step, y};
      const std::optional<double> top = over.height(p), base = top ? under.height(p) : std::nullopt;
      row[i] = base ? std::optional(*top - *base) : std::nullopt;
      cross(row[i], last[i]);
      if (i > 0) cross(row[i], row[i - 1]);
      if (!row[i]) continue;
      const double volume = std::abs(*row[i]) * step * step;
      (*row[i] < 0 ? lie.volume_under : lie.volume_over) += volume;
      if (*row[i] < 0) lie.area_under += step * step;
    }
    std::swap(row, last);
  }
  return lie;
}

bool may_stand(const BuiltSurfaces& built, Index row, const ModelRules& rules) {
  const TriangulatedSurface& s = built.surfaces[row];
  return s.kind == SurfaceKind::horizon && s.name != rules.floor && built.rows.block_of_triangle[row].empty() &&
         is_single_valued(s);
}

/// Returns a horizon that lies above the stack but does not belong to it yet; no_index if there is none.
Index next_over(const BuiltSurfaces& built, const ModelRules& rules, const Stack& stack) {
  const TriangulatedSurface& first = built.surfaces[stack.rows.front()];
  for (Index row = 0; row < built.surfaces.size(); ++row) {
    if (std::find(stack.rows.begin(), stack.rows.end(), row) != stack.rows.end() || !may_stand(built, row, rules))
      continue;
    const Lie lie = compare(built.surfaces[row], first, rules.stack);
    if (lie.is_over() && lie.crossing > 0 && lie.width_of_islands() < narrow * rules.stack.size) return row;
  }
  return no_index;
}

}  // namespace

Stack find_stack(BuiltSurfaces& built, const ModelRules& rules) {
  Stack stack = named_stack(built.surfaces, rules);
  const bool has_top = !rules.topography.empty() || rules.column.empty() || stack.rows.empty();
  const bool is_known = stack.rows.empty() || may_stand(built, stack.rows.front(), rules);
  for (Index row; !has_top && is_known && (row = next_over(built, rules, stack)) != no_index;) {
    built.warnings.push_back(
        "horizon " + built.surfaces[row].name + " is not in the column; it lies over " +
        built.surfaces[stack.rows.front()].name +
        " and crosses it in islands of few elements, so that both are settled together: it cuts what is "
        "older. Say rules: {topography: " +
        built.surfaces[row].name + "} where it is the ground; {stack: keep} leaves it as it is");
    stack.rows.insert(stack.rows.begin(), row);
    stack.units.insert(stack.units.begin(), rules.column.front());
  }
  stack.keepers = keepers_of(rules, stack.rows, built.surfaces);
  return stack;
}

}  // namespace geomesh::geomodel
