// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The stack of horizons as it was settled in the map before anything was intersected: what the report and the page
/// tell of it.
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
  double size = 0;              ///< edge length asked on the horizons, m
  double tolerance = 0;         ///< of surfaces against the input, m; 0: surfaces are kept exactly, nothing is settled
  std::vector<Vec2> outline;    ///< corners of the model volume in the map
  bool outline_is_box = false;  ///< along the axes
};

/// Part of the tolerance that settling and thinning out may use; what remeshes the surfaces keeps within the rest.
inline constexpr double stack_share = 0.5;

/// Share of the size asked at a place by which surfaces of a settled stack may be off there at most: where a thin unit
/// asks for the size, about a quarter of its thickness.
inline constexpr double stack_tolerance_of_size = 0.02;

/// One horizon of the stack. Areas in the map, m2; lengths along the vertical, m.
struct SettledHorizon {
  std::string name;
  std::size_t n_triangles_given = 0, n_triangles = 0;
  double area = 0;
  double area_merged = 0;                  ///< shared with a neighbour
  double area_above_topography = 0;        ///< where its input lies above it, so that it is cut off
  double area_moved = 0;                   ///< elsewhere: off its input by more than the share of the tolerance
  double largest_move = 0, mean_move = 0;  ///< where it was moved
  Vec3 place;                              ///< of the largest move
  double largest_off = 0;                  ///< elsewhere: distance from the input's points
};

/// One unit between two horizons of the stack.
struct SettledUnit {
  std::string name, top, base;
  double area = 0;            ///< where it is there
  double area_merged = 0;     ///< where its horizons share one surface
  double volume = 0;          ///< between the settled horizons, in the bounds of the model volume
  std::size_t n_islands = 0;  ///< too small to be shared or to stand alone, which went
  double mean_thickness = 0, largest_thickness = 0;  ///< where it is there
  std::vector<std::vector<Vec2>> pinch_outs;         ///< lines of the map
};

/// Thicknesses over a raster of the map, for the page: one row of values a unit, from the south; NaN: not there.
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
  std::vector<SizeSource> sizes;  ///< that thin units ask for
};

}  // namespace geomesh::geomodel
