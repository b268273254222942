// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What the mesh is said to be a mesh of: surfaces, volume, and what the project says of names, wells and points.
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

/// What the project says about the names of regions.
struct ClaimedNames {
  std::vector<std::string> column;                         ///< unit, horizon, unit ..., youngest first; may be empty
  std::vector<NamedPoint> seeds;                           ///< places that name their region, in the mesh's frame
  std::map<std::string, std::vector<std::string>> groups;  ///< group: units, bodies or regions
  std::map<std::string, std::map<std::string, double>> attributes;  ///< unit or region: attribute: value
  bool fault_blocks = false;                                        ///< units bear the number of their block
  bool merges_small = false;                                        ///< regions may hold several pieces
  std::vector<std::string> unconformities;                          ///< horizons that cut what is older
  std::vector<Index> continued;  ///< rows of its horizons that are continued by default
  double continued_within = 0;   ///< m; how far
  double min_volume = 0;         ///< m3; smaller pieces may have joined a region of another unit, where merges_small
};

/// What the rules of the model may take away of one surface. Rows are of Claim::surfaces.
struct TrimRules {
  std::vector<Index> above, below;    ///< parts above (below) one of these surfaces, on the vertical
  double near_others = 0;             ///< parts that overshoot another surface by no more than this
  double near_faults = 0;             ///< of a fault that ends on others: the same, beyond faults alone
  std::size_t n_given_triangles = 0;  ///< the others were made by rule
  bool continuation = false;          ///< any part of the triangles made by rule
  bool given_beyond_faults = false;   ///< any part: a horizon with throw that runs beyond its fault
  /// Fields, each of which may be away outside of its domain: where the horizon's faults say so.
  std::vector<FieldPart> fields;
  std::vector<std::array<Vec3, 3>> partings;  ///< of faults that were continued to part its blocks, and are gone again
  bool any() const {
    return !above.empty() || !below.empty() || near_others > 0 || near_faults > 0 || continuation ||
           given_beyond_faults || !fields.empty();
  }
};

struct Claim {
  std::vector<TriangulatedSurface> surfaces;  ///< in the mesh's frame, as the rules of one surface left them
  std::optional<ModelVolume> volume;
  bool ends_inside = false;      ///< at a topography or a bottom: less than the volume is filled
  std::vector<TrimRules> trims;  ///< per surface: what rules of the model may take away of it; empty: nothing of any
  double within = 0;             ///< how far surfaces may be off their triangles, both ways, beyond rounding
  bool within_by_count = false;  ///< `within` follows from sizes that the project leaves to a number of elements
  double merging = 0;            ///< what is nearer than this was brought together (the project's `tolerance`)
  bool may_be_trimmed(Index row) const { return row < trims.size() && trims[row].any(); }
  const Box3* box() const { return volume && volume->box ? &*volume->box : nullptr; }
  bool named = false;                    ///< surfaces bear the names under which the faces file knows them
  bool refined = false;                  ///< points may have been added for sizes and shapes
  std::vector<std::string> cell_arrays;  ///< of sizes and shapes, as the project asks for them
  double size_growth = 0;  ///< sizes asked in one region grow by no more per unit of distance; 0: not known

  WriteOptions output;  ///< of a project: what the files hold, and the forms of the mesh that it asks for

  // Of a project alone.
  ClaimedNames names;
  std::vector<Polyline> wells;
  std::vector<NamedPoint> points;
  std::vector<Vec3> input_points;  ///< of all surfaces, one after the other: what `input_vertex` counts
};

/// The project read, brought into the mesh's frame and built. Shared with the mesher: the reading of files, the change
/// of coordinates, gridding, and the rules that add to one surface (docs/checking.md says so).
Claim claim_of_project(const std::filesystem::path& file);
/// Surface files alone.
Claim claim_of_surfaces(const std::vector<std::filesystem::path>& files);

}  // namespace geomesh::geomodel::checking
