// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Options for reading a file, for what the file itself does not say.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace geomesh::geomodel {

struct ReadOptions {
  /// One entry of the key `columns`: the meaning of one column of a table ("x", "depth_ft", "formation", "md").
  struct Column {
    std::string meaning;
    std::string column;  ///< name of the column in the header, or its number from 1
  };
  std::vector<Column> columns;  ///< meaning of each column; empty: taken from the header, or the three columns x, y, z
  /// Key `no_data`: a height that means "no value", in addition to what the file declares.
  std::optional<double> no_data;
  /// `no_data: none`: only the value that the header declares means "no value"; others are not recognised.
  bool keep_all_heights = false;
};

}  // namespace geomesh::geomodel
