// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Surfaces of a model that are plane polygons and keep their shape: fractures.
#pragma once

#include <vector>

#include "geomesh/geomodel/model_rules.hpp"

namespace geomesh::geomodel {

/// Returns, per surface, whether it is a fault without points inside of its border, in one plane as far as files of
/// fractures must be, whose border stays as given (`extend: none`, as for all fractures). Such a surface covers the
/// same area after remeshing if its corners stay in their places. O(points).
std::vector<bool> plane_polygons(const std::vector<TriangulatedSurface>& surfaces, const ModelRules& rules);

/// Whether all surfaces but sides of the box are plane polygons: a network of fractures in a matrix. False without any.
bool is_fracture_network(const std::vector<TriangulatedSurface>& surfaces, const ModelRules& rules);

}  // namespace geomesh::geomodel
