// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reads the files of a project and converts them to the frame of the model.
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

/// All coordinates are in the frame, minus the origin.
struct ProjectInputs {
  ModelFrame frame;
  std::vector<TriangulatedSurface>
      /// Surfaces in the project's order; points have become surfaces, `smooth` and `resample` were applied.
      surfaces{};
  std::vector<Polyline> wells{};
  std::vector<FittedTop> tops{};  ///< tops to which horizons have been moved
  std::vector<NamedPoint> points{};
  std::optional<VolumeSpec> volume{};  ///< argument of make_volume, with the origin (0, 0, 0)
  /// For each surface: the faults that its fault polygons indicate.
  std::vector<std::vector<std::string>> faults_of_polygons{};
  std::map<std::size_t, std::vector<FieldPart>> field_parts{};  ///< LevelSurfaces::parts
  std::vector<std::string> notes{}, warnings{};
  /// Horizons made from points, which grid_in_blocks may make anew. None that was changed afterwards, or at which the
  /// model ends.
  PointsOfHorizons gridded{};
  std::vector<ToleranceUse> uses{};  ///< how far surfaces are from the data from which they were made

  /// Adds these faults to throw_at of horizons that have no list of their own.
  void add_throws(ModelRules& rules) const;
  /// Completes SurfaceRules::field_parts: triangles and doubts, and places in the frame.
  void complete_field_parts(ModelRules& rules) const;
};

/// Throws as the readers, ModelFrame and grid_points, and Error{invalid_input} if a file does not contain what its
/// entry refers to.
ProjectInputs read_project_inputs(const Project& project, const RunContext& context);

}  // namespace geomesh::geomodel
