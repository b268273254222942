// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Formats the line before meshing that says how many elements to expect, and what requires them.
#pragma once

#include <string>

#include "geomesh/core/element_estimate.hpp"

namespace geomesh::geomodel {

/// Returns "elements to come: about 97,000, of which 31,000 fill the model with edges of 300 m, 52,000 more to follow
/// bends ...". The last part names the key that changes the largest of these further numbers. Numbers below a twentieth
/// of the total are left out. `size` of the whole model and `tolerance` are the requested values; 0 if there are none.
std::string announcement(const ElementEstimate& estimate, double size, double tolerance, const std::string& unit,
                         bool by_input_edges = false);

}  // namespace geomesh::geomodel
