// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Draws the model as a still picture for browsers that cannot show the rotatable one.
#pragma once

#include "geomesh/geomodel/palette.hpp"
#include "report_html/model/drawn_mesh.hpp"
#include "report_html/model/png.hpp"

namespace geomesh::geomodel::page {

/// Draws the initial view of the model: from the south-west, without the vertical quarter in front of `corner`, lit
/// from above. Units have `colours` (indexed by region id - 1), heights are multiplied by `stretch`.
Picture draw_model(const ModelMesh& mesh, const Vec2& corner, double stretch, const std::vector<Colour>& colours);

}  // namespace geomesh::geomodel::page
