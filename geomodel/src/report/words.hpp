// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Formats quantities for a person.
#pragma once

#include <cstddef>
#include <string>

namespace geomesh::geomodel {

struct ModelMesh;

/// Returns "5.123 km3" from 1e8 m3 on, "5123 m3" below; "5123 ft3" in other units: four significant digits.
std::string volume_words(double volume, const std::string& unit);

/// "1,234,567".
std::string grouped_words(std::size_t n);

/// Returns "5 units" if each is one region, otherwise "4 units in 12 regions". A unit is all regions with one name
/// before suffixes.
std::string units_words(const ModelMesh& mesh);

}  // namespace geomesh::geomodel
