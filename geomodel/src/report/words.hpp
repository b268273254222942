// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Formats quantities for a person.
#pragma once

#include <cstddef>
#include <string>

namespace geomesh::geomodel {

struct ModelMesh;

/// Formats a volume with four significant digits: "5.123 km3" from 1e8 m3 on, "5123 m3" below; "5123 ft3" in feet.
std::string volume_words(double volume, const std::string& unit);

/// "1,234,567".
std::string grouped_words(std::size_t n);

/// Returns "5 units" if each is one region, otherwise "4 units in 12 regions". A unit is all regions of one base name.
std::string units_words(const ModelMesh& mesh);

}  // namespace geomesh::geomodel
