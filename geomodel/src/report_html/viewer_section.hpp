// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The part of the page in which the model can be rotated.
#pragma once

#include <string>

#include "report_html/model/viewer.hpp"

namespace geomesh::geomodel::page {

/// Returns controls, the picture for browsers that cannot show the rotatable one, the model as data, and the script. If
/// the mesh exceeds the limits, a sentence says how much of it is drawn.
std::string viewer_section(const Report& report, const Box3& bounds, const MeshColours& colours,
                           const DrawingLimits& limits = {});

}  // namespace geomesh::geomodel::page
