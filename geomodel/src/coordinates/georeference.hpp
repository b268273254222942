// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Converts the coordinates of each input to the frame in which the model is computed (docs/coordinates.md).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "coordinates/crs.hpp"
#include "coordinates/proj_conversion.hpp"
#include "geomesh/geomodel/project.hpp"

namespace geomesh::geomodel {

/// One input: its contents as read, and the settings of the project for it.
struct SourceInput {
  std::string name;  ///< name of the surface or well, for messages
  const SourceSpec* spec;
  FileContents* contents;
};

/// The coordinate frame in which a model is computed: the project's coordinate system, unit and origin, with elevation
/// up.
class ModelFrame {
 public:
  /// Sets up the frame of a project. If the project leaves the UTM zone open (`utm`, `geographic`), it is the zone of
  /// the box's centre if the project is geographic and has a box with corners, else that of the first input in
  /// longitude and latitude. Throws Error{usage} if the zone cannot be determined.
  ModelFrame(const Project& project, const std::vector<SourceInput>& inputs);

  /// Converts all coordinates of an input to the frame. Throws Error{invalid_input} if they cannot be what the project
  /// declares (longitude and latitude in a UTM project, a place outside the range of the system), and Error{usage} if
  /// the conversion is not supported.
  void place(const SourceInput& input, std::vector<std::string>& notes, std::vector<std::string>& warnings) const;

  /// Converts a point of the project file to the frame.
  Vec3 point(const Vec3& p) const;
  /// Converts the project's model volume to the frame. In a geographic project, a box becomes the largest upright
  /// rectangle inside its outline on the map, which `note` reports; the corners of a polygon and the centre of a
  /// rotated box are converted.
  VolumeSpec volume(const VolumeSpec& spec, std::string& note) const;

  /// Returns the coordinate system in which the mesh is written, with its UTM zone.
  const HorizontalCrs& system() const { return system_; }

 private:
  Box3 box(const Box3& box, std::string& note) const;
  Vec2 map_point(const Vec2& p) const;
  Vec2 to_system(const HorizontalCrs& from, const Vec2& p) const;
  HorizontalCrs system_of(const SourceInput& input, std::vector<std::string>& notes) const;
  std::optional<ProjConversion> proj_between(const SourceInput& input, const HorizontalCrs& from) const;
  void check_range(const SourceInput& input, const HorizontalCrs& from) const;
  void refuse_exchanged_degrees(const SourceInput& input, const HorizontalCrs& from) const;

  HorizontalCrs given_;   ///< coordinate system named in the project
  HorizontalCrs system_;  ///< of the mesh
  std::string unit_;
  double metres_ = 1;  ///< metres per unit of length of the project
  bool depth_ = false;
  Vec3 origin_;
};

}  // namespace geomesh::geomodel
