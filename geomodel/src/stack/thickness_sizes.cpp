// SPDX-License-Identifier: GPL-3.0-or-later
#include "stack/thickness_sizes.hpp"

#include <algorithm>
#include <cmath>

#include "stack/map/map_raster.hpp"
#include "stack/sheets/sheet_locator.hpp"

namespace geomesh::geomodel {
std::vector<SizeSource> sizes_of_thickness(const MapSheets& sheets, const MapBounds& bounds,
                                           const ThicknessSizeOptions& options) {
  const double least = options.of_thickness * options.thickness;
  if (!(least < options.size) || sheets.n_horizons < 2) return {};
  const double area = (bounds.max.x - bounds.min.x) * (bounds.max.y - bounds.min.y);
  const double step = std::max(least, std::sqrt(area / most_places));
  const MapRaster raster(bounds, step);
  const SheetLocator locator(sheets);
  std::vector<SizeSource> sources;
  for (std::size_t place = 0; place < raster.size(); ++place) {
    const Vec2 p = raster.centre(place % raster.n_columns, place / raster.n_columns);
    const SheetLocator::Place at = locator.find(p);
    if (at.triangle == no_index) continue;
    for (std::size_t k = 0; k + 1 < sheets.n_horizons; ++k) {
      const double top = locator.height(at, k), base = locator.height(at, k + 1);
      const double size = std::max(least, options.of_thickness * (top - base));
      if (!(top > base && size < options.size)) continue;
      sources.push_back({{p.x, p.y, 0.5 * (top + base)}, size, 0.71 * step + 0.5 * (top - base), 0});
    }
  }
  return sources;
}

}  // namespace geomesh::geomodel
