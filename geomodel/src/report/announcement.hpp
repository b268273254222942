// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// One line before meshing: how many elements to expect, and what requires them.
#pragma once

#include <string>

#include "geomesh/core/element_estimate.hpp"

namespace geomesh::geomodel {

/// Returns "elements to come: about 97,000, of which 31,000 fill the model with edges of 300 m, 52,000 more to follow
/// bends ...". The key that changes the largest of the further parts comes last. Parts below a twentieth are left out.
/// `size` of the whole model and `tolerance` are the requested values; 0: none.
std::string announcement(const ElementEstimate& estimate, double size, double tolerance, const std::string& unit,
                         bool by_input_edges = false);

}  // namespace geomesh::geomodel
