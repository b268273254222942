// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The note shown before meshing starts: how many elements to expect, and which sizes require them.
#pragma once

#include <string_view>

namespace geomesh::geomodel {

/// The words with which the note on the number of elements begins.
inline constexpr std::string_view announcement_start = "elements to come: ";

}  // namespace geomesh::geomodel
