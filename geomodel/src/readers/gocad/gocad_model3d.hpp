// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Regions of a GOCAD Model3d. A region is a list of faces with signs; each face is a part of a surface and is
/// identified by one key triangle.
#pragma once

#include <vector>

#include "geomesh/geomodel/surface.hpp"
#include "readers/gocad/gocad_objects.hpp"

namespace geomesh::geomodel {

/// Adds to `contents` all regions of a GOCAD model except Universe, and the kinds of surfaces (fault, horizon) that the
/// model declares. The surfaces of `contents` came from `objects`. The sign `+` of a face means that the key triangle's
/// normal points out of the region. If a key triangle is not a triangle of its surface, no region is added, with a
/// warning.
void add_model3d_regions(const GocadObject& model, const std::vector<GocadObject>& objects, FileContents& contents);

}  // namespace geomesh::geomodel
