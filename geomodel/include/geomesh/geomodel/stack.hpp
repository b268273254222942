// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The settled stack: the horizons of the stratigraphic column after they were put in depositional order and too thin
/// layers were removed, on the map, before anything is intersected.
#pragma once

#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"
#include "geomesh/core/size_field.hpp"

namespace geomesh::geomodel {

/// Whether the horizons of the stratigraphic column are put in depositional order before they are intersected.
enum class StackRule { automatic, keep };

struct StackRules {
  StackRule rule = StackRule::automatic;
  double size = 0;  ///< target edge length on the horizons, in m
  /// Largest distance of surfaces from the input, in m; 0: surfaces are kept exactly, and horizons are not put in
  /// order.
  double tolerance = 0;
  std::vector<Vec2> outline;    ///< corners of the model volume on the map
  bool outline_is_box = false;  ///< along the axes
};

/// Share of the tolerance that ordering and simplifying the horizons may use; remeshing uses the rest.
inline constexpr double stack_share = 0.5;

/// Largest distance from the input of horizons that were put in depositional order, as a share of the local target
/// size. If a thin unit determines that size, this is about a quarter of the unit's thickness.
inline constexpr double stack_tolerance_of_size = 0.02;

/// One horizon, as changed by putting horizons in depositional order. Map areas in m2; lengths along the vertical, m.
struct SettledHorizon {
  std::string name;
  std::size_t n_triangles_given = 0, n_triangles = 0;
  double area = 0;
  double area_merged = 0;  ///< area where the horizon coincides with a neighbouring horizon
  /// Area where the horizon's input lies above the topography, so that it is cut off.
  double area_above_topography = 0;
  /// Area, without area_above_topography, where the horizon is farther from its input than its share of the tolerance.
  double area_moved = 0;
  /// Largest and mean distance by which the horizon was moved, over the area where it was moved.
  double largest_move = 0, mean_move = 0;
  Vec3 place;                 ///< place where the horizon was moved farthest
  double largest_off = 0;     ///< Largest distance of the horizon from the points of its input, where it was not moved.
  double area_at_faults = 0;  ///< Area along faults with throw, where the horizon is rebuilt from both sides.
  /// Largest vertical shift applied on one side of a fault to restore the order of the horizons.
  double largest_move_at_faults = 0;
  Vec3 place_at_faults;
};

/// One unit between two horizons, after the horizons were put in depositional order.
struct SettledUnit {
  std::string name, top, base;
  double area = 0;         ///< map area over which the unit is present
  double area_merged = 0;  ///< area over which the top and the base of the unit coincide
  double volume = 0;       ///< volume between the two horizons of the unit inside the model volume
  /// Number of islands of the unit that were removed because they were too small to be merged or kept.
  std::size_t n_islands = 0;
  double mean_thickness = 0, largest_thickness = 0;  ///< thickness of the unit where it is present
  std::vector<std::vector<Vec2>> pinch_outs;         ///< lines on the map along which the unit pinches out
};

/// Thicknesses of the units on a raster of the map, for the report page: one array of values for each unit, beginning
/// with the southern row; NaN where the unit is absent.
struct ThicknessMaps {
  Vec2 origin;
  double step = 0;
  std::size_t n_columns = 0, n_rows = 0;
  std::vector<std::vector<double>> values;
};

struct SettledStack {
  bool settled = false;
  double size = 0, tolerance = 0, min_thickness = 0;
  std::vector<SettledHorizon> horizons;  ///< youngest first
  std::vector<SettledUnit> units;
  ThicknessMaps maps;
  std::vector<SizeSource> sizes;  ///< target sizes that thin units require
};

}  // namespace geomesh::geomodel
