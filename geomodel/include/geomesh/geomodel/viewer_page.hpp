// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The rotatable picture of a mesh as a web page of its own, for notebooks and for programs that show a mesh in a
/// browser.
#pragma once

#include <string>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// Returns a complete HTML document that loads no other files: the viewer of the report (report.hpp) without its
/// tables. For a mesh with too many faces for a browser, the page says so.
std::string viewer_page(const ModelMesh& mesh);

}  // namespace geomesh::geomodel
