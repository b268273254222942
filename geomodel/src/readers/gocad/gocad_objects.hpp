// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The objects of a GOCAD ASCII file as contained in it, before they are converted.
#pragma once

#include <string>
#include <vector>

#include "geomesh/geomodel/surface.hpp"
#include "readers/text/input_file.hpp"
#include "readers/text/text.hpp"
#include "readers/text/vertex_ids.hpp"

namespace geomesh::geomodel {

/// GOCAD_ORIGINAL_COORDINATE_SYSTEM; without this block: elevation in metres.
struct GocadFrame {
  std::string name, projection, datum;
  std::string unit[3] = {"m", "m", "m"};
  bool depth = false;
  bool given = false;

  Vec3 to_metres(const Vec3& p) const { return {scale[0] * p.x, scale[1] * p.y, (depth ? -scale[2] : scale[2]) * p.z}; }
  double scale[3] = {1, 1, 1};  ///< metres per unit of each axis
};

/// A TFACE of a Model3d with the three points that define its + side (in metres, exchanged like triangles if depth was
/// negated).
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

/// One object; `kind` is the word after GOCAD ("TSurf", "PLine", ...). Points are already in metres with elevation up.
struct GocadObject {
  std::string kind, name;
  std::size_t line = 0;
  GocadFrame frame;
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;              ///< orientation already reversed if depth was negated
  std::vector<Index> part_first;                ///< first triangle of each TFACE
  std::vector<std::vector<VertexIndex>> lines;  ///< PLine: one per ILINE, as chains of rows of `points`
  std::vector<Vec3> path;                       ///< Well
  std::vector<std::string> properties;          ///< properties of its vertices, by name; their values are ignored
  std::vector<std::pair<std::string, double>> markers;  ///< Well: name and measured depth
  std::vector<GocadKeyFace> key_faces;                  ///< Model3d
  std::vector<GocadRegion> regions;                     ///< Model3d
};

/// Throws Error{invalid_input} for anything that would lose data silently: a missing END, an id that is used before its
/// definition, an invalid number. For kinds that are not read (Voxet, SGrid, ...) only kind and name are returned.
std::vector<GocadObject> parse_gocad_objects(const InputFile& file);

}  // namespace geomesh::geomodel
