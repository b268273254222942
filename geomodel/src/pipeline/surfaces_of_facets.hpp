// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Names the surfaces to which facets of the piecewise linear complex belong.
#pragma once

#include <string>
#include <vector>

#include "pipeline/records.hpp"

namespace geomesh::geomodel {

/// Returns the names of the surfaces to which facets belong, in the order of the project and separated by commas.
std::string surfaces_of_facets(const std::vector<Index>& facets, const Arranged& arranged);

}  // namespace geomesh::geomodel
