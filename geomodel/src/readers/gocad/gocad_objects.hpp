// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The objects of a GOCAD ASCII file as the file contains them, before they are converted.
#pragma once

#include <string>
#include <vector>

#include "geomesh/geomodel/surface.hpp"
#include "readers/text/input_file.hpp"
#include "readers/text/text.hpp"
#include "readers/text/vertex_ids.hpp"

namespace geomesh::geomodel {

/// Coordinate frame of a GOCAD object (GOCAD_ORIGINAL_COORDINATE_SYSTEM). Without it, z is elevation and all
/// coordinates are in metres.
struct GocadFrame {
  std::string name, projection, datum;
  std::string unit[3] = {"m", "m", "m"};
  bool depth = false;
  bool given = false;

  Vec3 to_metres(const Vec3& p) const { return {scale[0] * p.x, scale[1] * p.y, (depth ? -scale[2] : scale[2]) * p.z}; }
  double scale[3] = {1, 1, 1};  ///< metres per unit of x, y and z in the file
};

/// A TFACE of a GOCAD Model3d with the three points that define its + side, in metres. If z was converted from depth,
/// two of the points are exchanged.
struct GocadKeyFace {
  std::int64_t id;
  std::string type, surface;
  Vec3 key[3];
  std::size_t line;
};

struct GocadRegion {
  std::string name;
  std::vector<std::int64_t> signed_faces;
  std::size_t line;
};

/// One object of a GOCAD file; `kind` is the word after GOCAD ("TSurf", "PLine", ...). Points are already in metres
/// with elevation up.
struct GocadObject {
  std::string kind, name;
  std::size_t line = 0;
  GocadFrame frame;
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;              ///< triangles of the surface, inverted if z was converted from depth
  std::vector<Index> part_first;                ///< row of the first triangle of each TFACE (a part of a GOCAD surface)
  std::vector<std::vector<VertexIndex>> lines;  ///< polylines of a PLine, one for each ILINE, as rows of `points`
  std::vector<Vec3> path;                       ///< Well
  std::vector<std::string> properties;  ///< names of properties that the file gives at vertices; values are ignored
  std::vector<std::pair<std::string, double>> markers;  ///< names and measured depths of the markers of a well
  std::vector<GocadKeyFace> key_faces;                  ///< Model3d
  std::vector<GocadRegion> regions;                     ///< Model3d
};

/// Parses the objects of a GOCAD file. Throws Error{invalid_input} for anything that would lose data silently: a
/// missing END, an id that is used before its definition, an invalid number. For kinds that are not read (Voxet, SGrid,
/// ...) only kind and name are returned.
std::vector<GocadObject> parse_gocad_objects(const InputFile& file);

}  // namespace geomesh::geomodel
