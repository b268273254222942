// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The objects of a GOCAD ASCII file as they stand in it, before anything is made of them.
#pragma once

#include <string>
#include <vector>

#include "geomesh/geomodel/surface.hpp"
#include "readers/text/input_file.hpp"
#include "readers/text/text.hpp"
#include "readers/text/vertex_ids.hpp"

namespace geomesh::geomodel {

/// GOCAD_ORIGINAL_COORDINATE_SYSTEM; without the block: elevation in metres.
struct GocadFrame {
  std::string name, projection, datum;
  std::string unit[3] = {"m", "m", "m"};
  bool depth = false;
  bool given = false;

  Vec3 to_metres(const Vec3& p) const { return {scale[0] * p.x, scale[1] * p.y, (depth ? -scale[2] : scale[2]) * p.z}; }
  double scale[3] = {1, 1, 1};  ///< metres per unit of each axis
};

/// Model3d: TFACE with the three points that fix its + side (in metres, swapped as triangles are where depth was
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

/// One object; `kind` is the word behind GOCAD ("TSurf", "PLine", ...). Points are in metres with elevation up already.
struct GocadObject {
  std::string kind, name;
  std::size_t line = 0;
  GocadFrame frame;
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;                      ///< winding already swapped where depth was negated
  std::vector<Index> part_first;                        ///< first triangle of each TFACE
  std::vector<std::vector<VertexIndex>> lines;          ///< PLine: one per ILINE, as chains of rows of `points`
  std::vector<Vec3> path;                               ///< Well
  std::vector<std::string> properties;                  ///< of its vertices, by name; their values are passed over
  std::vector<std::pair<std::string, double>> markers;  ///< Well: name and measured depth
  std::vector<GocadKeyFace> key_faces;                  ///< Model3d
  std::vector<GocadRegion> regions;                     ///< Model3d
};

/// Throws Error{invalid_input} at anything that would lose data in silence: a missing END, an id used before it stands,
/// a number that is none. Objects of kinds that are not read (Voxet, SGrid, ...) come back with their kind and name
/// alone.
std::vector<GocadObject> parse_gocad_objects(const InputFile& file);

}  // namespace geomesh::geomodel
