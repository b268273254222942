// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The page's turnable picture of the model: the faces as data, and the script that draws them.
#pragma once

#include <string>
#include <string_view>

#include "geomesh/geomodel/model_mesh.hpp"
#include "geomesh/geomodel/report.hpp"

namespace geomesh::geomodel::page {

/// More faces than this are not put into a page: a browser would not turn them smoothly.
inline constexpr std::size_t most_faces_shown = 300'000;

/// RFC 4648, section 4.
std::string base64(std::string_view bytes);

/// Up to this many tetrahedra are in the page too: a plane that cuts the model then shows those that it cuts.
inline constexpr std::size_t most_cells_shown = 200'000;

/// The model as one JSON object. Arrays are base64. Points are Float32, from the middle of the model. Corners of faces
/// and tetrahedra and ends of curve edges are Uint32. Each face has its surface and the regions of both sides, each
/// tetrahedron its region (Int32). Least dihedral angles are there for both sides of each face and for each tetrahedron
/// (Uint8, degrees). Lists of regions, surfaces and curves with names and colours; corners of the worst elements, where
/// `quality` is given.
std::string viewer_data(const ModelMesh& mesh, const Box3& bounds, const QualityReport* quality = nullptr);

/// JavaScript (WebGL 2) that fills the element with id `viewer` from the JSON text in the element with id `model`. It
/// is under the MIT licence, so that a page may be passed on.
std::string_view viewer_script();

}  // namespace geomesh::geomodel::page
