// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The part of the page in which the model can be turned.
#pragma once

#include <string>

#include "report_html/model/viewer.hpp"

namespace geomesh::geomodel::page {

/// Controls, the picture for browsers that cannot turn it, the model as data, and the script. Where the mesh is beyond
/// the limits a sentence says how much of it is drawn.
std::string viewer_section(const Report& report, const Box3& bounds, const MeshColours& colours,
                           const DrawingLimits& limits = {});

}  // namespace geomesh::geomodel::page
