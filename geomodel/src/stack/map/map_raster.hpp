// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Values on a raster of the map, smoothed, and the curves on which they are zero.
#pragma once

#include <vector>

#include "stack/map/map_samples.hpp"

namespace geomesh::geomodel {

/// Cells of a raster. More would take seconds, and show features that are smaller than elements.
inline constexpr double most_cells = 1e6;

/// Values at the centres of square cells; NaN: none.
struct MapRaster {
  Vec2 origin;  ///< centre of the first cell
  double step = 1;
  std::size_t n_columns = 0, n_rows = 0;
  std::vector<double> values;  ///< row by row from the south

  MapRaster() = default;
  /// Covers the bounds.
  MapRaster(const MapBounds& bounds, double cell);
  std::size_t size() const { return values.size(); }
  Vec2 centre(std::size_t column, std::size_t row) const {
    return {origin.x + step * static_cast<double>(column), origin.y + step * static_cast<double>(row)};
  }
  double& at(std::size_t column, std::size_t row) { return values[row * n_columns + column]; }
  double at(std::size_t column, std::size_t row) const { return values[row * n_columns + column]; }
  /// The cell that holds p or is nearest to it.
  std::size_t cell_of(Vec2 p) const;
  /// Linear both ways between the centres of cells; beyond the rim the nearest one's.
  double between(Vec2 p) const;
};

/// Cells without a value take that of the nearest one by steps along rows and columns.
void fill_from_neighbours(MapRaster& raster);

/// `passes` times the binomial mean over three cells each way. All cells have values.
void smooth(MapRaster& raster, int passes);

/// Groups of cells, joined across sides, whose value is negative (`below`) or not.
struct CellGroups {
  std::vector<Index> group;  ///< per cell; no_index: on the other side of zero
  std::vector<std::size_t> n_cells;
  std::vector<double> least, greatest;  ///< values of each group
};
CellGroups groups_of(const MapRaster& raster, bool below);

/// Where the values, linear between the centres of cells, are zero: curves with negative values on their left. Closed
/// ones end with their first point; open ones end at the rim of the raster.
std::vector<std::vector<Vec2>> zero_curves(const MapRaster& raster);

/// The curve smoothed and divided anew into pieces of about `length`. Its sides keep their areas, where that moves no
/// point further than a quarter of a piece. Ends stay.
std::vector<Vec2> smooth_curve(const std::vector<Vec2>& curve, double length);

/// The curve with each point moved to its left.
std::vector<Vec2> beside(const std::vector<Vec2>& curve, double left);

}  // namespace geomesh::geomodel
