// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What VTK's reader of legacy files does not survive (9.1 at least), looked for before it sees a file. Cells whose
/// counts of points run beyond their block make it write beyond its memory. So do blocks that come twice, more or
/// fewer types than cells, and counts whose product is no 64-bit number.
#pragma once

#include <string>
#include <string_view>

namespace geomesh::geomodel::checking {

/// What is wrong with the cells of a legacy VTK file of version 4 or less, "" where they may be read. `content`: the
/// whole file, ASCII or binary.
std::string fault_of_legacy_cells(std::string_view content);

}  // namespace geomesh::geomodel::checking
