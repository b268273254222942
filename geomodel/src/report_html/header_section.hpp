// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The head of the page: name of the mesh, when and by which program it was made, what was requested and the result.
#pragma once

#include <string>

#include "geomesh/geomodel/report.hpp"

namespace geomesh::geomodel::page {

/// Returns title, counts, and a list of facts; facts that the report does not contain are left out. `bounds` are the
/// mesh's. The date is that of the environment variable SOURCE_DATE_EPOCH (seconds since 1970) if it is set, else the
/// current one (UTC).
std::string header_section(const Report& report, const Box3& bounds);

}  // namespace geomesh::geomodel::page
