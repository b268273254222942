// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Writes the head of the HTML report: name of the mesh, date and program version, the request and the result.
#pragma once

#include <string>

#include "geomesh/geomodel/report.hpp"

namespace geomesh::geomodel::page {

/// Returns the head of the HTML report: title, counts, and a list of facts. Facts that the report does not contain are
/// left out. `bounds` are the mesh's. The date is that of the environment variable SOURCE_DATE_EPOCH (seconds since
/// 1970) if it is set, else the current one (UTC).
std::string header_section(const Report& report, const Box3& bounds);

}  // namespace geomesh::geomodel::page
