// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The page's turnable picture of the model: the faces as data, and the script that draws them.
#pragma once

#include <string>
#include <string_view>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel::page {

/// More faces than this are not put into a page: a browser would not turn them smoothly.
inline constexpr std::size_t most_faces_shown = 300'000;

/// RFC 4648, section 4.
std::string base64(std::string_view bytes);

/// The faces as one JSON object: points (Float32, from the middle of the model, base64), corners (Uint32, base64), per
/// face its surface and the regions of both sides (Int32, base64), and lists of regions and surfaces with names and
/// colours.
std::string viewer_data(const ModelMesh& mesh, const Box3& bounds);

/// JavaScript (WebGL 2) that fills the element with id `viewer` from the JSON text in the element with id `model`.
std::string_view viewer_script();

}  // namespace geomesh::geomodel::page
