// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// From the coordinates of each input to those in which the model is computed (docs/coordinates.md).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "coordinates/crs.hpp"
#include "coordinates/proj_conversion.hpp"
#include "geomesh/geomodel/project.hpp"

namespace geomesh::geomodel {

/// One input: its contents as read, and what the project says about it.
struct SourceInput {
  std::string name;  ///< of the entry, for messages
  const SourceSpec* spec;
  FileContents* contents;
};

/// The frame of the model: the project's system, unit and origin, elevation up.
class ModelFrame {
 public:
  /// Finds the zone where the project leaves it open (`utm`, `geographic`): of the box's centre where the project is
  /// geographic and has one with corners, else of the first input in longitude and latitude. Throws Error{usage} where
  /// it cannot be found.
  ModelFrame(const Project& project, const std::vector<SourceInput>& inputs);

  /// Brings everything in the input's contents into the frame. Throws Error{invalid_input} where its coordinates
  /// cannot be what the project says (longitude and latitude in a UTM project, a place outside the system). Throws
  /// Error{usage} where a conversion is not offered.
  void place(const SourceInput& input, std::vector<std::string>& notes, std::vector<std::string>& warnings) const;

  /// A point of the project file.
  Vec3 point(const Vec3& p) const;
  /// The project's model volume. In a geographic project a box becomes the largest upright rectangle inside its outline
  /// on the map, which `note` tells; corners of a polygon and centres are converted.
  VolumeSpec volume(const VolumeSpec& spec, std::string& note) const;

  /// The system in which the mesh is written; what was found where the project left it open.
  const HorizontalCrs& system() const { return system_; }

 private:
  Box3 box(const Box3& box, std::string& note) const;
  Vec2 map_point(const Vec2& p) const;
  Vec2 to_system(const HorizontalCrs& from, const Vec2& p) const;
  HorizontalCrs system_of(const SourceInput& input, std::vector<std::string>& notes) const;
  std::optional<ProjConversion> proj_between(const SourceInput& input, const HorizontalCrs& from) const;
  void check_range(const SourceInput& input, const HorizontalCrs& from) const;
  void refuse_exchanged_degrees(const SourceInput& input, const HorizontalCrs& from) const;

  HorizontalCrs given_;   ///< as the project says
  HorizontalCrs system_;  ///< of the mesh
  std::string unit_;
  double metres_ = 1;  ///< per unit of the project
  bool depth_ = false;
  Vec3 origin_;
};

}  // namespace geomesh::geomodel
