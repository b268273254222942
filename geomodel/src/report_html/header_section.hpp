// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The head of the page: whose mesh it is, when and by what it was made, what was asked for and what came.
#pragma once

#include <string>

#include "geomesh/geomodel/report.hpp"

namespace geomesh::geomodel::page {

/// Title, counts, and a list of facts; facts that the report does not have are left out. `bounds` are the mesh's. The
/// date is that of the environment variable SOURCE_DATE_EPOCH (seconds since 1970) where it is set, else of now (UTC).
std::string header_section(const Report& report, const Box3& bounds);

}  // namespace geomesh::geomodel::page
