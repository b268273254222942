// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The specification against which a mesh is checked: surfaces, volume, and the project's names, wells and points.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"
#include "geomesh/geomodel/model_rules.hpp"
#include "geomesh/geomodel/model_volume.hpp"
#include "geomesh/geomodel/surface.hpp"
#include "geomesh/geomodel/write_options.hpp"

namespace geomesh::geomodel::checking {

/// Specification of the names of regions, taken from the project.
struct SpecifiedNames {
  std::vector<std::string> column;  ///< alternating units and horizons of the column, youngest first; may be empty
  std::vector<NamedPoint> seeds;    ///< points that name their region, in the mesh's frame
  std::map<std::string, std::vector<std::string>> groups;           ///< members of each group, by the group's name
  std::map<std::string, std::map<std::string, double>> attributes;  ///< values of attributes by unit or region
  bool fault_blocks = false;                ///< whether names of units include the number of their block
  bool merges_small = false;                ///< whether regions may consist of several separate pieces
  std::vector<std::string> unconformities;  ///< names of the horizons that are unconformities, which cut older horizons
  std::vector<Index> continued;  ///< indices of the column's horizons that are continued to other surfaces by default
  double continued_within = 0;   ///< m; how far
  /// Regions may contain pieces of other units with less than this volume in m3, if merges_small is set.
  double min_volume = 0;
};

/// Describes which parts of one surface the rules of the model may remove. Indices refer to `Specification::surfaces`.
struct TrimRules {
  std::vector<Index> above, below;    ///< rules may remove parts of this surface above (below) these surfaces
  double near_others = 0;             ///< parts that overshoot another surface by at most this distance may be removed
  double near_faults = 0;             ///< largest distance by which a fault may overshoot other faults on which it ends
  std::size_t n_given_triangles = 0;  ///< number of input triangles; triangles after these were made by rules
  bool continuation = false;          ///< whether any triangle by which rules continued this surface may be removed
  /// Whether any part of a horizon with throw may be removed because it continues beyond its fault.
  bool given_beyond_faults = false;
  /// Parts of the surface that come from one scalar field each, and may be missing outside the block of that field.
  std::vector<FieldPart> fields;
  /// Triangles that extend faults only to separate the blocks of one horizon, and that the mesher removed again.
  std::vector<std::array<Vec3, 3>> partings;
  bool any() const {
    return !above.empty() || !below.empty() || near_others > 0 || near_faults > 0 || continuation ||
           given_beyond_faults || !fields.empty();
  }
};

struct Specification {
  /// Surfaces in the mesh's frame, after applying the rules that act on single surfaces.
  std::vector<TriangulatedSurface> surfaces;
  std::optional<ModelVolume> volume;
  bool ends_inside = false;  ///< whether the model ends at a topography or base and fills only a part of the volume
  /// The parts of each surface that rules may remove; empty if rules remove nothing from any surface.
  std::vector<TrimRules> trims;
  double within = 0;  ///< largest distance between surfaces and their input, in both directions, beyond rounding
  bool within_by_count = false;  ///< whether the distance `within` follows from a requested number of elements
  double merging = 0;            ///< distance within which features were merged (the project's `merge_within`)
  bool may_be_trimmed(Index row) const { return row < trims.size() && trims[row].any(); }
  const Box3* box() const { return volume && volume->box ? &*volume->box : nullptr; }
  bool named = false;                    ///< whether mesh files and `surfaces` use the same names, as with a project
  bool refined = false;                  ///< whether the mesher may have added points to improve sizes and shapes
  std::vector<std::string> cell_arrays;  ///< names of the cell arrays of sizes and shapes that the project requests
  double size_growth = 0;  ///< largest growth of target sizes per unit of distance within one region; 0: not known

  WriteOptions output;  ///< which files the project requests, with their contents and form; defaults without a project

  // Names of regions, wells and points, which only projects specify.
  SpecifiedNames names;
  std::vector<Polyline> wells;
  std::vector<NamedPoint> points;
  std::vector<Vec3> input_points;  ///< points of all surfaces in their order, to which the mesh's `input_vertex` refers
};

/// Reads a project, transforms it to the mesh's frame and builds its surfaces. This shares code with the mesher:
/// reading of files, change of coordinates, gridding, and the rules that act on single surfaces (docs/checking.md).
Specification specification_of_project(const std::filesystem::path& file);
/// Surface files alone.
Specification specification_of_surfaces(const std::vector<std::filesystem::path>& files);

}  // namespace geomesh::geomodel::checking
