// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The turnable picture of a mesh alone, as a page: for notebooks and for programs that show a mesh in a browser.
#pragma once

#include <string>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// A whole HTML document that loads nothing from elsewhere: the viewer of the report (report.hpp), without its tables.
/// A mesh with too many faces for a browser gives a page that says so.
std::string viewer_page(const ModelMesh& mesh);

}  // namespace geomesh::geomodel
