// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Surfaces extruded from lines on a vertical section, and horizons computed from thicknesses.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// The key `extrude` of a surface: its file holds lines on a section, which are extruded along a horizontal axis.
struct ExtrudeSpec {
  int axis = -1;  ///< horizontal axis along which lines are extruded: 0 for x, 1 for y, negative if none is requested
  double from = 0, to = 0;
};

/// Reads the lines of a section: polylines of any format that has them, or text. Each line of text has a position along
/// the section (x, y, s or distance), a height (z, elevation, depth) and perhaps an id. The polylines in a text are
/// separated by blank lines, by `>` or by the id. Positions along the section are returned in y for lines extruded
/// along x, else in x. Throws as read_surface_file does.
FileContents read_section(const std::filesystem::path& file, const ExtrudeSpec& spec);

/// Extrudes lines of a section from spec.from to spec.to along the axis. Closed lines (all lines if `closes` is set)
/// become closed surfaces with outward normals; others become open surfaces. Throws Error{invalid_input} if a closed
/// line crosses itself.
TriangulatedSurface extrude_lines(const std::vector<Polyline>& lines, const ExtrudeSpec& spec, bool closes,
                                  const std::string& name);

struct BelowSurface {
  TriangulatedSurface surface;
  std::size_t n_without = 0;   ///< number of vertices of the surface above, at which no thickness below it is known
  std::size_t n_negative = 0;  ///< number of vertices with a negative thickness, which is taken as zero
  double least = 0, most = 0;  ///< thickness taken
};
/// Returns the surface `above`, lowered at each of its vertices by the value of `thickness` there. Triangles with a
/// corner without thickness are left out. Takes O(n) if triangles are evenly spaced.
BelowSurface surface_below(const TriangulatedSurface& above, const TriangulatedSurface& thickness);
/// Returns a surface lowered by the same thickness everywhere.
BelowSurface surface_below(const TriangulatedSurface& above, double thickness);

}  // namespace geomesh::geomodel
