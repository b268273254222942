// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Regions of a GOCAD Model3d: signed lists of faces, each of which is a part of a surface identified by its key
/// triangle.
#pragma once

#include <vector>

#include "geomesh/geomodel/surface.hpp"
#include "readers/gocad/gocad_objects.hpp"

namespace geomesh::geomodel {

/// Adds the regions of `model` except Universe to `contents`, whose surfaces came from `objects`, and the kinds of
/// surfaces (fault, horizon) that the model gives. `+` means that the key triangle's normal points out of the region.
/// If a key triangle is not among its surface's triangles, no region is added, with a warning.
void add_model3d_regions(const GocadObject& model, const std::vector<GocadObject>& objects, FileContents& contents);

}  // namespace geomesh::geomodel
