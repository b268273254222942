// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What stands in a DXF file, and blocks put in where INSERT asks for them.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "readers/text/input_file.hpp"

namespace geomesh::geomodel {

/// One INSERT: a block put at a place, in columns and rows.
struct DxfInsert {
  std::string block, layer;
  std::size_t line = 0;  ///< of the file
  Vec3 at, scale{1, 1, 1};
  double rotation = 0;  ///< radians, counter-clockwise about z
  std::int64_t n_columns = 1, n_rows = 1;
  double column_step = 0, row_step = 0;  ///< turned with the block
};

/// Of the section ENTITIES or of one block. Coordinates as in the file.
struct DxfContent {
  std::map<std::string, std::vector<Vec3>> corners;              ///< by layer, three a triangle
  std::vector<std::pair<std::string, std::vector<Vec3>>> lines;  ///< layer and points
  std::map<std::string, std::vector<Vec3>> points;               ///< by layer
  std::map<std::string, std::size_t> passed_over;                ///< entities that are not read, by name
  std::vector<DxfInsert> inserts;
};

struct DxfBlock {
  Vec3 base;  ///< the point of the block that comes to lie at DxfInsert::at
  DxfContent content;
};

/// Puts the blocks that are inserted into `content`, blocks within blocks too. What stands on layer "0" of a block
/// comes onto the layer of its INSERT. Blocks that are not in the file are passed over. Throws Error{invalid_input}: a
/// block that holds itself, or copies without end.
void insert_blocks(const InputFile& file, DxfContent& content, const std::map<std::string, DxfBlock>& blocks);

}  // namespace geomesh::geomodel
