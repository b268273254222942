// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The specification against which a mesh is checked: surfaces, volume, and what the project says about names, wells
/// and points.
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

/// The project's specification of the names of regions.
struct SpecifiedNames {
  std::vector<std::string> column;  ///< alternating units and horizons, youngest first; may be empty
  std::vector<NamedPoint> seeds;    ///< points that name their region, in the mesh's frame
  std::map<std::string, std::vector<std::string>> groups;  ///< units, bodies or regions by the name of their group
  std::map<std::string, std::map<std::string, double>> attributes;  ///< values by unit or region, then by attribute
  bool fault_blocks = false;                ///< whether names of units include the number of their block
  bool merges_small = false;                ///< whether regions may consist of several pieces
  std::vector<std::string> unconformities;  ///< names of the horizons that cut older surfaces
  std::vector<Index> continued;             ///< rows of the column's horizons that are continued by default
  double continued_within = 0;              ///< m; how far
  /// Volume in m3 below which pieces may have joined a region of another unit, if merges_small is set.
  double min_volume = 0;
};

/// Parts of one surface that the rules of the model may remove. Rows refer to `Specification::surfaces`.
struct TrimRules {
  std::vector<Index> above, below;    ///< surfaces above (below) which parts may be removed, compared on the vertical
  double near_others = 0;             ///< parts that overshoot another surface by at most this distance may be removed
  double near_faults = 0;             ///< for a fault that ends on others: the same distance, beyond faults only
  std::size_t n_given_triangles = 0;  ///< triangles after these were made by rules
  bool continuation = false;          ///< whether any part of the triangles made by rules may be removed
  /// Whether any part may be removed: a horizon with throw that continues beyond its fault.
  bool given_beyond_faults = false;
  /// The fields of the surface. Each may be absent outside its domain, which the horizon's faults bound.
  std::vector<FieldPart> fields;
  /// Triangles of the extensions of faults that were made only to separate blocks and were removed again.
  std::vector<std::array<Vec3, 3>> partings;
  bool any() const {
    return !above.empty() || !below.empty() || near_others > 0 || near_faults > 0 || continuation ||
           given_beyond_faults || !fields.empty();
  }
};

struct Specification {
  /// Surfaces in the mesh's frame, after the rules that act on single surfaces.
  std::vector<TriangulatedSurface> surfaces;
  std::optional<ModelVolume> volume;
  bool ends_inside = false;  ///< whether the model ends at a topography or base, so that less than the volume is filled
  /// For each surface, what rules of the model may remove from it; empty if nothing of any surface.
  std::vector<TrimRules> trims;
  double within = 0;             ///< how far surfaces may be from their triangles, in both directions, beyond rounding
  bool within_by_count = false;  ///< whether `within` follows from sizes that were derived from a number of elements
  double merging = 0;            ///< distance within which features were merged (the project's `tolerance`)
  bool may_be_trimmed(Index row) const { return row < trims.size() && trims[row].any(); }
  const Box3* box() const { return volume && volume->box ? &*volume->box : nullptr; }
  bool named = false;                    ///< whether surfaces have the names that the faces file uses
  bool refined = false;                  ///< whether points may have been added for sizes and shapes
  std::vector<std::string> cell_arrays;  ///< arrays of sizes and shapes that the project requests
  double size_growth = 0;  ///< largest growth of target sizes per unit of distance within one region; 0: not known

  WriteOptions output;  ///< for a project: what the files contain, and the requested forms of the mesh

  // Specification of names, for projects only.
  SpecifiedNames names;
  std::vector<Polyline> wells;
  std::vector<NamedPoint> points;
  std::vector<Vec3> input_points;  ///< points of all surfaces concatenated, to which `input_vertex` refers
};

/// Reads a project, transforms it to the mesh's frame and builds its surfaces. This shares code with the mesher:
/// reading of files, change of coordinates, gridding, and the rules that act on single surfaces (listed in
/// docs/checking.md).
Specification specification_of_project(const std::filesystem::path& file);
/// Surface files alone.
Specification specification_of_surfaces(const std::vector<std::filesystem::path>& files);

}  // namespace geomesh::geomodel::checking
