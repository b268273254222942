// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Converts the coordinates of each input to those in which the model is computed (docs/coordinates.md).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "coordinates/crs.hpp"
#include "coordinates/proj_conversion.hpp"
#include "geomesh/geomodel/project.hpp"

namespace geomesh::geomodel {

/// One input: its contents as read, and the project's settings for it.
struct SourceInput {
  std::string name;  ///< name of the entry, for messages
  const SourceSpec* spec;
  FileContents* contents;
};

/// The frame of the model: the project's system, unit and origin, elevation up.
class ModelFrame {
 public:
  /// Finds the zone if the project leaves it open (`utm`, `geographic`): that of the box's centre if the project is
  /// geographic and has a box with corners, else that of the first input in longitude and latitude. Throws Error{usage}
  /// if it cannot be determined.
  ModelFrame(const Project& project, const std::vector<SourceInput>& inputs);

  /// Converts everything in the input's contents to the frame. Throws Error{invalid_input} if its coordinates cannot be
  /// what the project declares (longitude and latitude in a UTM project, a place outside the system), and Error{usage}
  /// if a conversion is not supported.
  void place(const SourceInput& input, std::vector<std::string>& notes, std::vector<std::string>& warnings) const;

  /// Converts a point of the project file.
  Vec3 point(const Vec3& p) const;
  /// Converts the project's model volume. In a geographic project a box becomes the largest upright rectangle inside
  /// its outline on the map, which `note` reports; corners of a polygon and centres are converted.
  VolumeSpec volume(const VolumeSpec& spec, std::string& note) const;

  /// Returns the system in which the mesh is written; it was determined if the project left it open.
  const HorizontalCrs& system() const { return system_; }

 private:
  Box3 box(const Box3& box, std::string& note) const;
  Vec2 map_point(const Vec2& p) const;
  Vec2 to_system(const HorizontalCrs& from, const Vec2& p) const;
  HorizontalCrs system_of(const SourceInput& input, std::vector<std::string>& notes) const;
  std::optional<ProjConversion> proj_between(const SourceInput& input, const HorizontalCrs& from) const;
  void check_range(const SourceInput& input, const HorizontalCrs& from) const;
  void refuse_exchanged_degrees(const SourceInput& input, const HorizontalCrs& from) const;

  HorizontalCrs given_;   ///< system given in the project
  HorizontalCrs system_;  ///< of the mesh
  std::string unit_;
  double metres_ = 1;  ///< metres per unit of the project
  bool depth_ = false;
  Vec3 origin_;
};

}  // namespace geomesh::geomodel
