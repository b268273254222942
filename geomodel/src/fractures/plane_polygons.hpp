// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Recognises surfaces of a model that are plane polygons and keep their shape: fractures.
#pragma once

#include <vector>

#include "geomesh/geomodel/model_rules.hpp"

namespace geomesh::geomodel {

/// Returns for each surface whether it is a plane polygon: a fault without points inside its border, plane within the
/// accuracy of fracture files, whose border is not extended (`extend: none`, as for all fractures). Such a surface
/// covers the same area after remeshing if its corners are not moved. O(points).
std::vector<bool> plane_polygons(const std::vector<TriangulatedSurface>& surfaces, const ModelRules& rules);

/// Returns whether all surfaces except sides of the box are plane polygons, as in a network of fractures in a matrix.
/// False if there are no surfaces.
bool is_fracture_network(const std::vector<TriangulatedSurface>& surfaces, const ModelRules& rules);

}  // namespace geomesh::geomodel
