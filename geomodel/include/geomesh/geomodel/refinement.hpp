// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What a project or a command line asks of sizes and shapes, in the user's names (docs/meshing.md).
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "geomesh/core/refine.hpp"

namespace geomesh::geomodel {

/// A size asked near a place.
struct PlaceSize {
  Vec3 place;  ///< in the project's coordinates
  AskedSize asked;
};

/// Sizes by name. `base` holds what needs no names: global size, curvature, gaps, gradation, bounds.
struct NamedSizes {
  SizeOptions base;
  std::map<std::string, AskedSize> units;     ///< by unit, body or region; inside of it
  std::map<std::string, AskedSize> surfaces;  ///< by surface or side of the box
  /// By curve, by well, or by kind: `wells`, `intersections`, `borders`, `fault_tips`.
  std::map<std::string, AskedSize> curves;
  std::vector<PlaceSize> near;
  /// Sizes at points, read into base.background before meshing (docs/meshing.md says which files); empty: none.
  std::filesystem::path background;
};

struct RefinementSettings {
  bool refine = false;  ///< false: the mesh keeps the points that recovery needs, and the rest is not looked at
  NamedSizes size;
  QualityLevel quality = QualityLevel::standard;
  Honour honour = Honour::exact;
  double tolerance = 0;
  bool sizes_on_surfaces = true;  ///< false: surfaces get no points for sizes (RefineOptions::size_surfaces)
  std::size_t max_elements = 50'000'000;
  double time_budget = 0;
  std::vector<std::string> cell_arrays;  ///< of known_cell_arrays(), written with the mesh whether it is refined or not
};

/// size, min_dihedral, max_dihedral, radius_ratio, mean_ratio, aspect.
const std::vector<std::string>& known_cell_arrays();

/// What about the settings contradicts itself or the mode of meshing, in words; empty: nothing.
std::string contradiction(const RefinementSettings& settings, const RecoverOptions& recover);

}  // namespace geomesh::geomodel
