// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Which surfaces facets of the complex stand for, in words.
#pragma once

#include <string>
#include <vector>

#include "pipeline/records.hpp"

namespace geomesh::geomodel {

/// The names of the surfaces, in the order of the project, with commas between them.
std::string surfaces_of_facets(const std::vector<Index>& facets, const Arranged& arranged);

}  // namespace geomesh::geomodel
