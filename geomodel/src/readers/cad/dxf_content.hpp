// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The content of a DXF file, and its expansion: inserted blocks (INSERT) are replaced by copies of their contents.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "readers/text/input_file.hpp"

namespace geomesh::geomodel {

/// One INSERT of a DXF file: a block inserted at a place, in columns and rows.
struct DxfInsert {
  std::string block, layer;
  std::size_t line = 0;  ///< of the file
  Vec3 at, scale{1, 1, 1};
  double rotation = 0;  ///< rotation of the inserted DXF block in radians, counter-clockwise about z
  std::int64_t n_columns = 1, n_rows = 1;
  double column_step = 0, row_step = 0;  ///< distances between copies of the DXF block, which are rotated with it
};

/// Content of one block of a DXF file or of its section ENTITIES, with coordinates as in the file.
struct DxfContent {
  std::map<std::string, std::vector<Vec3>> corners;  ///< for each DXF layer: the corners of its triangles, three each
  std::vector<std::pair<std::string, std::vector<Vec3>>> lines;  ///< layer and points
  std::map<std::string, std::vector<Vec3>> points;               ///< by layer
  std::map<std::string, std::size_t> passed_over;  ///< numbers of entities that are not read, by their DXF type
  std::vector<DxfInsert> inserts;
};

struct DxfBlock {
  Vec3 base;  ///< point of the DXF block that is placed at the position of an INSERT
  DxfContent content;
};

/// Replaces the insertions in `content` by copies of the inserted blocks, including nested ones. Items on layer "0" of
/// a block are moved to the layer of its INSERT. Blocks that are not in the file are ignored. Throws
/// Error{invalid_input} for a block that contains itself, or if there are too many copies.
void insert_blocks(const InputFile& file, DxfContent& content, const std::map<std::string, DxfBlock>& blocks);

}  // namespace geomesh::geomodel
