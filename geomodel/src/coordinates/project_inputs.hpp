// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The files of a project, read and brought into the frame of the model.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "coordinates/georeference.hpp"
#include "geomesh/core/run_context.hpp"
#include "geomesh/geomodel/model_rules.hpp"
#include "geomesh/geomodel/model_volume.hpp"
#include "geomesh/geomodel/tolerance_ledger.hpp"
#include "geomesh/geomodel/tops.hpp"

namespace geomesh::geomodel {

/// Everything in the frame, less the origin.
struct ProjectInputs {
  ModelFrame frame;
  std::vector<TriangulatedSurface>
      surfaces{};  ///< in the project's order; points have become surfaces, `smooth` and `resample` are done
  std::vector<Polyline> wells{};
  std::vector<FittedTop> tops{};  ///< horizons have been moved to pass through them
  std::vector<NamedPoint> points{};
  std::optional<VolumeSpec> volume{};                           ///< for make_volume with the origin (0, 0, 0)
  std::vector<std::vector<std::string>> faults_of_polygons{};   ///< per surface: those that its fault polygons tell
  std::map<std::size_t, std::vector<FieldPart>> field_parts{};  ///< LevelSurfaces::parts
  std::vector<std::string> notes{}, warnings{};
  std::vector<ToleranceUse> uses{};  ///< how far surfaces are off the data that they were made from

  /// Adds these faults to throw_at of horizons that have no list of their own.
  void add_throws(ModelRules& rules) const;
  /// Completes SurfaceRules::field_parts: triangles and doubts, and places in the frame.
  void complete_field_parts(ModelRules& rules) const;
};

/// Throws as the readers, ModelFrame and grid_points, and Error{invalid_input} where a file does not hold what its
/// entry means.
ProjectInputs read_project_inputs(const Project& project, const RunContext& context);

}  // namespace geomesh::geomodel
