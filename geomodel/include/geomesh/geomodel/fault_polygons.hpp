// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Fault polygons: closed lines on the map around the gap that a fault leaves in a horizon. Between the two cut-offs,
/// the nodes of a grid hold interpolated heights and no data.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// Reads the fault polygons of a file: polylines of any format that has them (GOCAD, DXF, VTP, OMF), else text. Text
/// has lines of x, y, perhaps z and perhaps an id, with or without a first line of names. Lines are separated by blank
/// lines, by `>`, by rows of 999, or by the id. Throws as read_surface_file does, and Error{invalid_input} if no line
/// has three points.
FileContents read_fault_polygons(const std::filesystem::path& file);

/// Result of cutting a horizon at its fault polygons.
struct PolygonCut {
  /// Names of the faults that pass through a fault polygon, in the order of the surfaces.
  std::vector<std::string> faults;
  std::size_t n_nodes = 0, n_triangles = 0;
  std::vector<std::string> notes, warnings;
};

/// Removes the triangles of the horizon that overlap a fault polygon in the map. A polygon is used if a fault passes
/// through it at the height of the horizon. Other polygons are reported with their place and change nothing. Points
/// keep their rows. Cost: polygon edges times the triangles near them, and fault triangles times polygons.
PolygonCut cut_at_polygons(TriangulatedSurface& horizon, const std::vector<Polyline>& polygons,
                           const std::vector<TriangulatedSurface>& surfaces);

}  // namespace geomesh::geomodel
