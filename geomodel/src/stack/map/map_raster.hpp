// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Values on a raster of the map, their smoothing, and their zero curves.
#pragma once

#include <vector>

#include "stack/map/map_samples.hpp"

namespace geomesh::geomodel {

/// Largest number of cells of a raster. More would take seconds and resolve features smaller than the elements.
inline constexpr double most_cells = 1e6;

/// A raster of the map: values at the centres of square cells; NaN means no value.
struct MapRaster {
  Vec2 origin;  ///< centre of the raster's first cell
  double step = 1;
  std::size_t n_columns = 0, n_rows = 0;
  std::vector<double> values;  ///< values of the cells, row by row from the south

  MapRaster() = default;
  MapRaster(const MapBounds& bounds, double cell);
  std::size_t size() const { return values.size(); }
  Vec2 centre(std::size_t column, std::size_t row) const {
    return {origin.x + step * static_cast<double>(column), origin.y + step * static_cast<double>(row)};
  }
  double& at(std::size_t column, std::size_t row) { return values[row * n_columns + column]; }
  double at(std::size_t column, std::size_t row) const { return values[row * n_columns + column]; }
  /// Returns the raster cell that contains p or is nearest to it.
  std::size_t cell_of(Vec2 p) const;
  /// Interpolates the raster bilinearly between cell centres; beyond the rim, the value of the nearest cell is used.
  double between(Vec2 p) const;
};

/// Gives each cell without a value that of the nearest cell, counted in steps along rows and columns.
void fill_from_neighbours(MapRaster& raster);

/// Smooths the raster `passes` times by the binomial mean over three cells in each direction. All cells need values.
void smooth(MapRaster& raster, int passes);

/// Groups of raster cells, connected across sides, whose values are all negative (if `below`), or all not negative.
struct CellGroups {
  std::vector<Index> group;  ///< group of each raster cell; no_index for cells whose values have the other sign
  std::vector<std::size_t> n_cells;
  std::vector<double> least, greatest;  ///< smallest and largest value of the cells of each group
};
CellGroups groups_of(const MapRaster& raster, bool below);

/// Returns the curves on which the raster's values, linear between the centres of cells, are zero, with negative values
/// on their left. Closed curves end with their first point; open ones end at the rim of the raster.
std::vector<std::vector<Vec2>> zero_curves(const MapRaster& raster);

/// Returns the curve smoothed and divided into pieces of about `length`. The areas on its sides are preserved unless a
/// point would have to move farther than a quarter of a piece. The ends of an open curve do not move.
std::vector<Vec2> smooth_curve(const std::vector<Vec2>& curve, double length);

/// Returns the curve with each point moved to the curve's left by the distance `left`.
std::vector<Vec2> beside(const std::vector<Vec2>& curve, double left);

}  // namespace geomesh::geomodel
