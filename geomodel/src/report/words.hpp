// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Quantities as a person reads them.
#pragma once

#include <cstddef>
#include <string>

namespace geomesh::geomodel {

struct ModelMesh;

/// "5.123 km3" from 1e8 m3 on, "5123 m3" below; "5123 ft3" in other units: four significant digits.
std::string volume_words(double volume, const std::string& unit);

/// "1,234,567".
std::string grouped_words(std::size_t n);

/// "5 units" where each is one region, otherwise "4 units in 12 regions". A unit is all regions of one name before
/// suffixes.
std::string units_words(const ModelMesh& mesh);

}  // namespace geomesh::geomodel
