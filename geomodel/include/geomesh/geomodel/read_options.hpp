// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Options that say how an input file is read, where the file itself does not say it.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace geomesh::geomodel {

struct ReadOptions {
  /// One entry of the key `columns`: the meaning of one column of a table ("x", "depth_ft", "formation", "md").
  struct Column {
    std::string meaning;
    std::string column;  ///< name of the table column in the header, or its number from 1
  };
  /// Meaning of each table column; if empty, it is taken from the header, or the table has the three columns x, y, z.
  std::vector<Column> columns;
  /// Key `no_data`: a height that means "no value", in addition to what the file declares.
  std::optional<double> no_data;
  /// Set by `no_data: none`: only the value that the header declares means "no value"; no other value does.
  bool keep_all_heights = false;
};

}  // namespace geomesh::geomodel
