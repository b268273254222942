// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The stack of horizons after it was settled, which means ordered and thinned in the map before anything is
/// intersected. The report and the page describe it.
#pragma once

#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"
#include "geomesh/core/size_field.hpp"

namespace geomesh::geomodel {

/// Whether the horizons of the column are settled in the map (docs/model-building.md).
enum class StackRule { automatic, keep };

struct StackRules {
  StackRule rule = StackRule::automatic;
  double size = 0;  ///< target edge length on the horizons, in m
  double tolerance = 0;
  std::vector<Vec2> outline;    ///< corners of the model volume on the map
  bool outline_is_box = false;  ///< along the axes
};

/// Share of the tolerance that settling and simplification may use; remeshing of the surfaces keeps within the rest.
inline constexpr double stack_share = 0.5;

/// Largest distance of the surfaces of a settled stack from the input, as a share of the local target size. If a thin
/// unit determines that size, this is about a quarter of the unit's thickness.
inline constexpr double stack_tolerance_of_size = 0.02;

/// One horizon of the stack. Areas in the map, m2; lengths along the vertical, m.
struct SettledHorizon {
  std::string name;
  std::size_t n_triangles_given = 0, n_triangles = 0;
  double area = 0;
  double area_merged = 0;            ///< area where it coincides with a neighbouring horizon
  double area_above_topography = 0;  ///< area where its input lies above the topography, so that it is cut off
  double area_moved = 0;  ///< remaining area where it is farther from its input than the share of the tolerance
  double largest_move = 0, mean_move = 0;  ///< distances by which the horizon was moved, where it was moved
  Vec3 place;                              ///< place of the largest move
  double largest_off = 0;                  ///< largest distance from the input's points, where it was not moved
};

/// One unit between two horizons of the stack.
struct SettledUnit {
  std::string name, top, base;
  double area = 0;         ///< area over which the unit is present
  double area_merged = 0;  ///< area over which its two horizons coincide
  double volume = 0;       ///< volume between the settled horizons within the bounds of the model volume
  std::size_t n_islands = 0;
  double mean_thickness = 0, largest_thickness = 0;  ///< thickness of the unit where it is present
  std::vector<std::vector<Vec2>> pinch_outs;         ///< lines on the map along which the unit pinches out
};

/// Thicknesses on a raster of the map, for the report page: one row of values per unit, from the south; NaN where the
/// unit is absent.
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
  std::vector<SizeSource> sizes;  ///< sizes that thin units require
};

}  // namespace geomesh::geomodel
