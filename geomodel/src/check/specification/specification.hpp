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

struct SpecifiedNames {
  std::vector<std::string> column;  ///< alternating units and horizons of the column, youngest first; may be empty
  std::vector<NamedPoint> seeds;    ///< seed points: each gives its name to the region around it; in the mesh's frame
  std::map<std::string, std::vector<std::string>> groups;           ///< by group of regions: names of its members
  std::map<std::string, std::map<std::string, double>> attributes;  ///< by unit or region: values of its attributes
  bool fault_blocks = false;                ///< whether names of regions include the number of their fault block
  bool merges_small = false;                ///< whether regions may consist of several separate pieces
  std::vector<std::string> unconformities;  ///< names of the horizons that are unconformities, which cut older horizons
  std::vector<Index> continued;  ///< in the column: the horizons that are continued to other surfaces by default
  double continued_within = 0;   ///< m; how far
  /// If merges_small is set, regions may contain parts of other units with less than this volume in m3.
  double min_volume = 0;
};

/// Describes which parts of one surface the rules of the model may remove. Indices refer to `Specification::surfaces`.
struct TrimRules {
  std::vector<Index> above, below;  ///< surfaces above (below) which rules may remove parts of this one
  double near_others = 0;           ///< this surface may lose parts that overshoot another one by at most this much
  double near_faults = 0;           ///< largest distance by which a fault may overshoot other faults on which it ends
  /// Number of triangles of the surface in the input; later ones were made by rules.
  std::size_t n_given_triangles = 0;
  bool continuation = false;  ///< whether any triangle by which rules continued this surface may be removed
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
  bool within_by_count = false;  ///< whether `within` follows from target sizes derived from a number of elements
  double merging = 0;            ///< distance within which features were merged (the project's `merge_within`)
  bool may_be_trimmed(Index row) const { return row < trims.size() && trims[row].any(); }
  const Box3* box() const { return volume && volume->box ? &*volume->box : nullptr; }
  bool named = false;    ///< whether the names of surfaces in the mesh files are those of `surfaces`, as with a project
  bool refined = false;  ///< whether the mesher may have added points to improve sizes and shapes
  std::vector<std::string> cell_arrays;  ///< names of the cell arrays of sizes and shapes that the project requests
  double size_growth = 0;  ///< largest growth of target sizes per unit of distance inside a region; 0 if not known

  WriteOptions output;  ///< which files the project requests, with their contents and form; defaults without a project

  // Names of regions, wells and points, which only projects specify.
  SpecifiedNames names;
  std::vector<Polyline> wells;
  std::vector<NamedPoint> points;
  std::vector<Vec3> input_points;  ///< points of all input surfaces; the mesh's `input_vertex` has indices in this list
};

/// Reads a project, transforms it to the mesh's frame and builds its surfaces. This shares code with the mesher:
/// reading of files, change of coordinates, gridding, and the rules that act on single surfaces (docs/checking.md).
Specification specification_of_project(const std::filesystem::path& file);
/// Surface files alone.
Specification specification_of_surfaces(const std::vector<std::filesystem::path>& files);

}  // namespace geomesh::geomodel::checking
