// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Describes the surfaces to which facets of the complex belong.
#pragma once

#include <string>
#include <vector>

#include "pipeline/records.hpp"

namespace geomesh::geomodel {

/// Returns the names of the surfaces in the order of the project, separated by commas.
std::string surfaces_of_facets(const std::vector<Index>& facets, const Arranged& arranged);

}  // namespace geomesh::geomodel
