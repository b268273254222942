// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What a project says about the content of a file that the file itself does not say.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace geomesh::geomodel {

struct ReadOptions {
  /// Key `columns`: the meaning of one column of a table ("x", "depth_ft", "formation", "md").
  struct Column {
    std::string meaning;
    std::string column;  ///< its name in the header, or its number from 1
  };
  std::vector<Column> columns;    ///< empty: the header tells, or the table has the three columns x, y, z
  std::optional<double> no_data;  ///< key `no_data`: heights with this value are none, whatever the file says
  bool keep_all_heights = false;  ///< `no_data: none`: only what the header names is no height; nothing is recognised
};

}  // namespace geomesh::geomodel
