// SPDX-License-Identifier: GPL-3.0-or-later
#include "stack/throw/fault_strips.hpp"

#include <algorithm>
#include <cmath>

#include "rules/planar/map_locator.hpp"

namespace geomesh::geomodel {
namespace {

constexpr double cells_a_size = 8;
constexpr double margin_of_size = 0.3;
constexpr double piece_of_size = 0.6;
constexpr int smoothing_passes = 2;

/// Marks with -1 the raster cells that have several blocks of a horizon, or none. Returns whether any cell has none.
bool mark_cells(const BlockData& horizon, const MapBounds& bounds, MapRaster& raster) {
  const MapLocator single(horizon.single);
  std::vector<MapLocator> blocks(horizon.blocks.begin(), horizon.blocks.end());
  bool is_open = false;
  for (std::size_t c = 0; c < raster.size(); ++c) {
    const Vec2 p = raster.centre(c % raster.n_columns, c / raster.n_columns);
    if (!bounds.holds(p) || single.find(p).count > 0) continue;
    if (std::none_of(blocks.begin(), blocks.end(), [&](const MapLocator& b) { return b.find(p).count > 0; }))
      is_open = true;
    raster.values[c] = -1;
  }
  return is_open;
}

/// Marks also those cells of the raster that are within `reach` of marked cells.
void widen(MapRaster& raster, double reach) {
  const std::vector<double> before = raster.values;
  const auto n = static_cast<std::ptrdiff_t>(std::ceil(reach / raster.step));
  const auto columns = static_cast<std::ptrdiff_t>(raster.n_columns), rows = static_cast<std::ptrdiff_t>(raster.n_rows);
  for (std::ptrdiff_t c = 0; c < columns * rows; ++c) {
    if (!(before[static_cast<std::size_t>(c)] < 0)) continue;
    for (std::ptrdiff_t j = std::max<std::ptrdiff_t>(0, c / columns - n); j <= std::min(rows - 1, c / columns + n); ++j)
      for (std::ptrdiff_t i = std::max<std::ptrdiff_t>(0, c % columns - n); i <= std::min(columns - 1, c % columns + n);
           ++i)
        if (std::hypot(static_cast<double>(i - c % columns), static_cast<double>(j - c / columns)) * raster.step <=
            reach)
          raster.values[static_cast<std::size_t>(j * columns + i)] = -1;
  }
}

/// Gives each cell of the raster beyond the bounds the value of the nearest cell within them.
void continue_beyond(MapRaster& raster, const MapBounds& bounds) {
  for (std::size_t c = 0; c < raster.size(); ++c)
    if (!bounds.holds(raster.centre(c % raster.n_columns, c / raster.n_columns))) raster.values[c] = std::nan("");
  fill_from_neighbours(raster);
}

}  // namespace

FaultStrips find_fault_strips(const std::vector<BlockData>& horizons, const MapBounds& bounds, double size) {
  FaultStrips strips;
  if (std::none_of(horizons.begin(), horizons.end(), [](const BlockData& h) { return h.has_throw(); })) return strips;
  const double width = bounds.max.x - bounds.min.x, height = bounds.max.y - bounds.min.y;
  const double step = std::max(size / cells_a_size, std::sqrt(width * height / most_cells));
  strips.inside = MapRaster(bounds.grown(4 * step), step);
  std::fill(strips.inside.values.begin(), strips.inside.values.end(), 1.0);
  for (const BlockData& horizon : horizons)
    if (horizon.has_throw() && mark_cells(horizon, bounds, strips.inside)) strips.is_open = true;
  continue_beyond(strips.inside, bounds);
  widen(strips.inside, margin_of_size * size);
  smooth(strips.inside, smoothing_passes);
  for (const std::vector<Vec2>& curve : zero_curves(strips.inside))
    strips.outlines.push_back(smooth_curve(curve, piece_of_size * size));
  return strips;
}

}  // namespace geomesh::geomodel
