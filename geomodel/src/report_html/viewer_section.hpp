// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Writes the section of the HTML report in which the model can be rotated.
#pragma once

#include <string>

#include "report_html/model/viewer.hpp"

namespace geomesh::geomodel::page {

/// Returns the viewer's controls, a still picture for browsers that cannot show the rotatable one, the model as data,
/// and the script. If the mesh exceeds the limits of drawing, a sentence says how much of it is drawn.
std::string viewer_section(const Report& report, const Box3& bounds, const MeshColours& colours,
                           const DrawingLimits& limits = {});

}  // namespace geomesh::geomodel::page
