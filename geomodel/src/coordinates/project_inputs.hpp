// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reads the files of a project and converts their coordinates to the frame of the model.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "coordinates/georeference.hpp"
#include "geomesh/core/run_context.hpp"
#include "geomesh/geomodel/gridding.hpp"
#include "geomesh/geomodel/model_rules.hpp"
#include "geomesh/geomodel/model_volume.hpp"
#include "geomesh/geomodel/tolerance_ledger.hpp"
#include "geomesh/geomodel/tops.hpp"

namespace geomesh::geomodel {

/// Everything that a project reads from files. Coordinates are in the frame of the model, minus its origin.
struct ProjectInputs {
  ModelFrame frame;
  std::vector<TriangulatedSurface>
      /// Surfaces in the project's order, after interpolation of those from points, `smooth` and `resample`.
      surfaces{};
  std::vector<Polyline> wells{};
  std::vector<FittedTop> tops{};  ///< well tops to which horizons have been moved
  std::vector<NamedPoint> points{};
  std::optional<VolumeSpec> volume{};  ///< model volume, for a call of make_volume with the origin (0, 0, 0)
  /// For each surface: names of the faults that pass through its fault polygons.
  std::vector<std::vector<std::string>> faults_of_polygons{};
  std::map<std::size_t, std::vector<FieldPart>> field_parts{};  ///< LevelSurfaces::parts
  std::vector<std::string> notes{}, warnings{};
  /// Horizons interpolated from points, which grid_in_blocks may interpolate again in each fault block. Horizons that
  /// were changed afterwards, or at which the model ends, are not included.
  PointsOfHorizons gridded{};
  std::vector<ToleranceUse> uses{};  ///< distances of surfaces from the data from which they were made

  /// Adds the faults that pass through a horizon's fault polygons to its throw_at, if the project gives no list.
  void add_throws(ModelRules& rules) const;
  /// Completes SurfaceRules::field_parts: which triangles of a surface come from which scalar field, and what could not
  /// be proven about them at which places. The places are converted to the coordinates of the model.
  void complete_field_parts(ModelRules& rules) const;
};

/// Reads all inputs of a project. Throws as the readers, ModelFrame and grid_points do, and Error{invalid_input} if a
/// file does not contain the object that a surface or well uses.
ProjectInputs read_project_inputs(const Project& project, const RunContext& context);

}  // namespace geomesh::geomodel
