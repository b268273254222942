// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Regions of a GOCAD Model3d: signed lists of faces, each face a part of a surface found by its key triangle.
#pragma once

#include <vector>

#include "geomesh/geomodel/surface.hpp"
#include "readers/gocad/gocad_objects.hpp"

namespace geomesh::geomodel {

/// Adds the regions of `model` but Universe to `contents`, whose surfaces came from `objects`. Adds the kinds of the
/// surfaces (fault, horizon) as the model names them. `+` means that the key triangle's normal points out of the
/// region. Where a key triangle is not among its surface's triangles no region is added, and a warning says so.
void add_model3d_regions(const GocadObject& model, const std::vector<GocadObject>& objects, FileContents& contents);

}  // namespace geomesh::geomodel
