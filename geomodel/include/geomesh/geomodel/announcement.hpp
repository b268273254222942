// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The note that everybody should see before the work: how many elements will come, and what asks for them.
#pragma once

#include <string_view>

namespace geomesh::geomodel {

/// How that note begins.
inline constexpr std::string_view announcement_start = "elements to come: ";

}  // namespace geomesh::geomodel
