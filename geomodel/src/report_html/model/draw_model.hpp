// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The page's picture of the model for browsers that cannot turn it.
#pragma once

#include "geomesh/geomodel/palette.hpp"
#include "report_html/model/drawn_mesh.hpp"
#include "report_html/model/png.hpp"

namespace geomesh::geomodel::page {

/// The model from the south-west without the upright quarter before `corner`, lit from above, as the page opens. Units
/// are in `colours` (by region id - 1), heights are `stretch` times as high. Time linear in faces and pixels.
Picture draw_model(const ModelMesh& mesh, const Vec2& corner, double stretch, const std::vector<Colour>& colours);

}  // namespace geomesh::geomodel::page
