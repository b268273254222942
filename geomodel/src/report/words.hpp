// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Quantities as a person reads them.
#pragma once

#include <string>

namespace geomesh::geomodel {

/// "5.123 km3" from 1e8 m3 on, "5123 m3" below: four significant digits.
std::string volume_words(double cubic_metres);

}  // namespace geomesh::geomodel
